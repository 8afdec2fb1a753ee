package dev.cairn.physics.solver.load;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

/** Leaps from sweep to sweep, on maps whose end is known. */
class SweepMixingTest {
    private static final int ROWS = 3;
    private static final int COUNTED = SweepLeaps.COUNTED * ROWS;

    /** Impulses, twists, and the velocity of one body. */
    private static final int SIZE = COUNTED + ROWS + SweepLeaps.SPEEDS;

    /** A sweep: {@code end + H D H (x - end)} with a reflection H. */
    private static double[] sweep(double[] x, double[] end, double[] mirror, double[] shares) {
        double[] y = new double[SIZE];
        for (int i = 0; i < SIZE; i++) {
            y[i] = x[i] - end[i];
        }
        reflect(y, mirror);
        for (int i = 0; i < SIZE; i++) {
            y[i] *= shares[i];
        }
        reflect(y, mirror);
        for (int i = 0; i < SIZE; i++) {
            y[i] += end[i];
        }
        return y;
    }

    private static void reflect(double[] y, double[] mirror) {
        double along = 0;
        double square = 0;
        for (int i = 0; i < SIZE; i++) {
            along += y[i] * mirror[i];
            square += mirror[i] * mirror[i];
        }
        for (int i = 0; i < SIZE; i++) {
            y[i] -= 2 * along / square * mirror[i];
        }
    }

    private static SweepMixing mixing(int memory, double[] start) {
        SweepMixing mixing = new SweepMixing(memory);
        mixing.begin(ROWS, 1);
        mixing.rows = ROWS;
        mixing.bodies = 1;
        for (int i = 0; i < SIZE; i++) {
            mixing.start(i, start[i]);
        }
        return mixing;
    }

    /**
     * A linear map whose error has k shares ends after k + 1 sweeps, whatever the shares: the next
     * start is where a polynomial of degree k in the map is least (Walker and Ni 2011, theorem
     * 2.2). Plain sweeps leave 0.97 of the error; 1e-6 of it is rounding, of numbers a thousand
     * times as large, by products of differences that are nearly alike.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void endsAfterAsManySweepsAsThereAreShares(int k) {
        Random random = new Random(17 + k);
        double[] end = random.doubles(SIZE, 1000, 1001).toArray();
        double[] mirror = random.doubles(SIZE, -1, 1).toArray();
        double[] shares = new double[SIZE];
        for (int i = 0; i < SIZE; i++) {
            shares[i] = 0.995 - 0.9 * (i % k) / k;
        }
        SweepMixing mixing = mixing(16, random.doubles(SIZE, 1000, 1001).toArray());
        double[] x = new double[SIZE];
        for (int n = 0; n < k + 1; n++) {
            for (int i = 0; i < SIZE; i++) {
                x[i] = mixing.next(i);
            }
            double[] y = sweep(x, end, mirror, shares);
            for (int i = 0; i < SIZE; i++) {
                mixing.end(i, y[i]);
            }
            mixing.leap(0);
        }
        for (int i = 0; i < SIZE; i++) {
            assertEquals(end[i], mixing.next(i), 1e-6, "number " + i);
        }
    }

    /** A leap that would draw normals below 0 ends where the first of them is 0. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void normalsStayAboveZero(long seed) {
        Random random = new Random(seed);
        double[] end = random.doubles(SIZE, -3, 1).toArray();
        SweepMixing mixing = mixing(5, random.doubles(SIZE, 0, 5).toArray());
        for (int n = 0; n < 30; n++) {
            for (int i = 0; i < SIZE; i++) {
                boolean isNormal = i < COUNTED && i % SweepLeaps.COUNTED < 4;
                double next = end[i] + (0.9 - 0.02 * i) * (mixing.next(i) - end[i]);
                mixing.end(i, isNormal ? Math.max(0, next) : next);
            }
            mixing.leap(0);
            for (int i = 0; i < COUNTED; i++) {
                boolean isNormal = i % SweepLeaps.COUNTED < 4;
                double next = mixing.next(i);
                assertTrue(!isNormal || next >= -1e-15, "normal " + i + " is " + next);
            }
        }
    }
}
