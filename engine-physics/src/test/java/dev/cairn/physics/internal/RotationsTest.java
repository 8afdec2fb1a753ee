package dev.cairn.physics.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

class RotationsTest {
    private static final int SEED = 20261125;

    /** Against the library's sine and cosine, from a millionth of a turn to thousands. */
    @Test
    void aTurnIsThatOfItsAngleHoweverFar() {
        SplittableRandom r = new SplittableRandom(SEED);
        double[] q = new double[4];
        for (int i = 0; i < 20_000; i++) {
            double x = r.nextDouble(-1, 1);
            double y = r.nextDouble(-1, 1);
            double z = r.nextDouble(-1, 1);
            double size = Math.sqrt(x * x + y * y + z * z);
            double spin = Math.pow(10, r.nextDouble(-6, 4));
            double t = r.nextDouble(-1, 1);
            double k = spin / size;
            Rotations.turn(k * x, k * y, k * z, spin, t, q);
            double half = 0.5 * spin * t;
            double sine = StrictMath.sin(half) / size;
            // of a product of thousands the rounding is 1e-16 times as much
            double bound = 1e-15 * (1 + Math.abs(half));
            assertEquals(sine * x, q[0], bound, "seed " + SEED + ", " + i);
            assertEquals(sine * y, q[1], bound, "seed " + SEED + ", " + i);
            assertEquals(sine * z, q[2], bound, "seed " + SEED + ", " + i);
            assertEquals(StrictMath.cos(half), q[3], bound, "seed " + SEED + ", " + i);
        }
    }
}
