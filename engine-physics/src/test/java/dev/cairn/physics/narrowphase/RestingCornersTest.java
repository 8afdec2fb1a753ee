package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.clip.Clipper;
import dev.cairn.physics.narrowphase.clip.CornerOrder;
import dev.cairn.physics.narrowphase.clip.Reduction;

import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/**
 * Four corners of an uneven underside, against all triangles: a body can rest only on one that is
 * around its weight and below which no corner is.
 */
class RestingCornersTest {
    private static final double TIE = 1e-9;
    private static final int TRIALS = 2000;

    private final Clipper clipper = new Clipper();
    private final Reduction reduction = new Reduction();
    private final CornerOrder order = new CornerOrder();
    private double[] x = {}, z = {}, gap = {};
    private double weightX, weightZ;

    @Test
    void theFourHoldTheTriangleThatABodyRestsOn() {
        SplittableRandom random = new SplittableRandom(20261201);
        int settled = 0;
        for (int trial = 0; trial < TRIALS; trial++) {
            int count = 5 + random.nextInt(8);
            x = new double[count];
            z = new double[count];
            gap = new double[count];
            clipper.count = 0;
            for (int i = 0; i < count; i++) {
                double angle = 2 * StrictMath.PI * (i + 0.9 * random.nextDouble()) / count;
                double wide = 0.3 + 0.7 * random.nextDouble();
                x[i] = wide * StrictMath.cos(angle);
                z[i] = wide * StrictMath.sin(angle);
                gap[i] = 1e-2 * random.nextDouble() + 0.1 * x[i];
                clipper.add(x[i], gap[i], z[i], gap[i], i);
            }
            weightX = 0.1 * (random.nextDouble() - 0.5);
            weightZ = 0.1 * (random.nextDouble() - 0.5);
            order.sort(clipper, 0, 1, 0, 1);
            reduction.reduceUneven(clipper, 0, 1, 0, TIE, 1e-6, 0, weightX, 3, weightZ);
            assertEquals(4, clipper.count);
            boolean holds = false;
            for (int without = 0; without < 4; without++) {
                int[] t = new int[3];
                for (int i = 0, n = 0; i < 4; i++) {
                    if (i != without) {
                        t[n++] = clipper.feature[i];
                    }
                }
                holds |= isAround(t) && nothingIsBelow(t);
            }
            settled += holds ? 1 : 0;
            assertTrue(holds || !isAround(clipper.feature), "trial " + trial);
        }
        System.out.println("settled " + settled + " of " + TRIALS);
        assertTrue(settled > 0.95 * TRIALS, "settled: " + settled);
    }

    /** Whether the weight is within the triangle, or the four, of some names. */
    private boolean isAround(int[] names) {
        int corners = Math.min(names.length, 4);
        int left = 0;
        for (int i = 0; i < corners; i++) {
            int a = names[i];
            int b = names[(i + 1) % corners];
            double turn = (x[a] - weightX) * (z[b] - weightZ) - (z[a] - weightZ) * (x[b] - weightX);
            left += turn > 0 ? 1 : -1;
        }
        return Math.abs(left) == corners;
    }

    private boolean nothingIsBelow(int[] t) {
        int a = t[0];
        double ux = x[t[1]] - x[a];
        double uz = z[t[1]] - z[a];
        double vx = x[t[2]] - x[a];
        double vz = z[t[2]] - z[a];
        double det = ux * vz - uz * vx;
        for (int i = 0; i < x.length; i++) {
            double px = x[i] - x[a];
            double pz = z[i] - z[a];
            double s = (px * vz - pz * vx) / det;
            double r = (ux * pz - uz * px) / det;
            double plane = gap[a] + s * (gap[t[1]] - gap[a]) + r * (gap[t[2]] - gap[a]);
            if (gap[i] < plane - 2 * TIE) {
                return false;
            }
        }
        return true;
    }
}
