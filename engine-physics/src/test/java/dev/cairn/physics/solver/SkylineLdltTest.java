package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.solver.direct.SkylineLdlt;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

/** Solutions of systems in an envelope, against the product of the matrix that was put in. */
class SkylineLdltTest {
    private static final long SEED = 20261123;

    private static double[] draw(Random random) {
        double[] p = new double[SkylineLdlt.BLOCK];
        for (int k = 0; k < p.length; k++) {
            p[k] = random.nextGaussian();
        }
        return p;
    }

    /** Chains, with ties to bodies further back: what is multiplied out again is what was asked. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7, 60})
    void solvesWhatWasPutIn(int bodies) {
        System.out.println("seed " + SEED);
        Random random = new Random(SEED);
        SkylineLdlt matrix = new SkylineLdlt();
        int n = SkylineLdlt.BLOCK * bodies;
        for (int round = 0; round < 20; round++) {
            int[] firstBlock = new int[bodies + 3];
            double[][] dense = new double[n][n];
            for (int i = 0; i < bodies; i++) {
                firstBlock[3 + i] = Math.max(0, i - random.nextInt(4));
            }
            matrix.begin(bodies, firstBlock, 3);
            matrix.clear();
            for (int i = 0; i < n; i++) {
                dense[i][i] = 1;
            }
            double[] wanted = new double[n];
            for (int i = 0; i < bodies; i++) {
                for (int j = firstBlock[3 + i]; j < i; j++) {
                    double weight = Math.pow(10, 8 * random.nextDouble() - 2);
                    double[] p = draw(random);
                    double[] q = draw(random);
                    matrix.add(i, p, i, p, weight);
                    matrix.add(j, q, j, q, weight);
                    matrix.add(i, p, j, q, weight);
                    put(dense, i, p, j, q, weight);
                }
                double[] r = draw(random);
                matrix.push(i, r, 1);
                System.arraycopy(r, 0, wanted, SkylineLdlt.BLOCK * i, SkylineLdlt.BLOCK);
            }
            assertTrue(matrix.factor());
            matrix.solve();
            for (int i = 0; i < n; i++) {
                double sum = 0;
                double size = 0;
                for (int j = 0; j < n; j++) {
                    sum += dense[i][j] * matrix.x[j];
                    size += Math.abs(dense[i][j] * matrix.x[j]);
                }
                assertEquals(wanted[i], sum, 1e-12 * (size + 1), "row " + i);
            }
        }
    }

    private static void put(double[][] dense, int i, double[] p, int j, double[] q, double weight) {
        double[] row = new double[dense.length];
        System.arraycopy(p, 0, row, SkylineLdlt.BLOCK * i, SkylineLdlt.BLOCK);
        System.arraycopy(q, 0, row, SkylineLdlt.BLOCK * j, SkylineLdlt.BLOCK);
        for (int k = 0; k < row.length; k++) {
            for (int l = 0; l < row.length; l++) {
                dense[k][l] += weight * row[k] * row[l];
            }
        }
    }

    @Test
    void tellsWhatIsNotPositiveOrNoNumber() {
        double[] p = {1, 0, 0, 0, 0, 0};
        for (double weight : new double[] {-1, -2, Double.NaN}) {
            SkylineLdlt matrix = new SkylineLdlt();
            matrix.begin(1, new int[1], 0);
            matrix.add(0, p, 0, p, weight);
            assertFalse(matrix.factor(), "1 + " + weight);
        }
    }
}
