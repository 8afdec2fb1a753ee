package dev.cairn.physics.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

import java.math.BigDecimal;
import java.util.Random;

/** The side of a plane, beside the determinant in decimal numbers without rounding. */
class OrientationTest {
    private static final long SEED = 20261201;

    @Test
    void pointsNearAPlaneAreOnTheirSideAtAnySize() {
        Random random = new Random(SEED);
        int[] counts = new int[3];
        for (int round = 0; round < 3000; round++) {
            double size = Math.scalb(1.0, random.nextInt(500) - 250);
            double[] p = new double[12];
            for (int i = 0; i < 9; i++) {
                p[i] = random.nextInt(4) == 0 ? 0 : size * random.nextGaussian();
            }
            double s = random.nextInt(5) - 2;
            double t = random.nextInt(5) - 2;
            for (int i = 0; i < 3; i++) {
                p[9 + i] = p[i] + s * (p[3 + i] - p[i]) + t * (p[6 + i] - p[i]);
                if (p[9 + i] != 0 && random.nextInt(3) == 0) {
                    p[9 + i] = Math.nextUp(p[9 + i]);
                }
            }
            int sign = Orientation.sign(p, 0, 1, 2, 3);
            assertEquals(oracle(p), sign, "seed " + SEED + ", round " + round);
            counts[1 + sign]++;
        }
        for (int count : counts) {
            assertEquals(1000, count, 900, "some of each: " + counts[0] + ", " + counts[1]);
        }
    }

    private static int oracle(double[] p) {
        BigDecimal[] v = new BigDecimal[9];
        for (int i = 0; i < 9; i++) {
            v[i] = new BigDecimal(p[i]).subtract(new BigDecimal(p[9 + i % 3]));
        }
        BigDecimal det =
                v[2].multiply(v[3].multiply(v[7]).subtract(v[6].multiply(v[4])))
                        .add(v[5].multiply(v[6].multiply(v[1]).subtract(v[0].multiply(v[7]))))
                        .add(v[8].multiply(v[0].multiply(v[4]).subtract(v[3].multiply(v[1]))));
        return -det.signum();
    }
}
