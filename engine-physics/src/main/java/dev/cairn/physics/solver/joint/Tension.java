package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;

import java.util.Arrays;

/**
 * How fast the links of an assembly swing under the tension that they bear.
 *
 * <p>A force F at the arm r of a body turns it back, as a weight does a pendulum, with the torque
 * {@code -G d} for a small turn d, {@code G = (F.r) 1 - (F r^T + r F^T)/2}. With {@code I^-1 = L
 * L^T} the largest frequency squared is at most the norm of {@code L^T G L}. A scheme of second
 * order that takes constraint forces from the step's ends, as RATTLE does, is stable up to a
 * frequency of 2/h.
 */
final class Tension {
    /** What is left of a frequency after a tick, if forces tell of a smaller one. */
    private static final double FADES = 0.95;

    /** Frequency times step up to which a step is accurate; beyond 2 it would be unstable. */
    private static final double SLOW = 0.4;

    /**
     * The same of what touches nothing: chains with a ball of 100 and 1000 times a link's mass keep
     * their energy to 2e-5 in ten seconds.
     */
    private static final double SLOW_ALONE = 0.8;

    private static final int MOST = 26;

    private final JointMath math = new JointMath();
    private final double[] part = new double[9];

    /** The largest frequency of a body, rad/s, by the forces of the last sub-step; all of them. */
    double quickest(SolverContext tick, JointStore store, Assembly s) {
        Arrays.fill(s.taut, 0.0);
        for (int k = 0; k < s.joint.length; k++) {
            int j = s.joint[k];
            int a = s.end[2 * k];
            int b = s.end[2 * k + 1];
            math.look(
                    tick.bodies,
                    tick.body.state,
                    store,
                    j,
                    a < 0 ? 0 : SolverBodies.offset(s.body[a]),
                    b < 0 ? 0 : SolverBodies.offset(s.body[b]));
            if (a >= 0) {
                // the force of a rod turns with the rod, not with A
                boolean isRod = store.law[store.firstRow[j]] == JointStore.DISTANCE;
                double[] arm = isRod ? math.armA : math.reach;
                add(store.reaction, 6 * j, -1, arm, s.taut, 9 * a);
            }
            if (b >= 0) {
                add(store.reaction, 6 * j, 1, math.armB, s.taut, 9 * b);
            }
        }
        double worst = 0;
        for (int n = 0; n < s.body.length; n++) {
            double square = norm(s.taut, 9 * n, tick.body.root, s.body[n] + 1);
            s.quick[n] = Math.max(FADES * s.quick[n], Math.sqrt(Math.sqrt(square)));
            worst = Math.max(worst, s.quick[n]);
        }
        return worst;
    }

    /** Steps to a sub-step of a taut assembly that touches something. */
    static int parts(Assembly s, double quick) {
        return s.isDirect && !s.keepsFailing() ? parts(quick, SLOW) : 1;
    }

    /** The same of one that touches nothing. */
    static int partsAlone(double quick) {
        return parts(quick, SLOW_ALONE);
    }

    /**
     * Steps to a sub-step. More than one only where a taut link swings so fast that it must be; few
     * numbers, so that a tension that changes a little does not change them.
     */
    private static int parts(double quick, double slow) {
        int parts = 1;
        while (parts < MOST && quick > slow * parts) {
            parts += parts / 2 + 1;
        }
        return parts;
    }

    private static void add(double[] f, int at, double sign, double[] r, double[] g, int o) {
        double dot = f[at] * r[0] + f[at + 1] * r[1] + f[at + 2] * r[2];
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                double mixed = 0.5 * (f[at + i] * r[k] + f[at + k] * r[i]);
                g[o + 3 * i + k] += sign * ((i == k ? dot : 0) - mixed);
            }
        }
    }

    /** Square of the Frobenius norm of {@code L^T G L}. */
    private double norm(double[] g, int o, double[] root, int body) {
        int q = body * SolverBodies.ROOT;
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                part[3 * i + k] =
                        g[o + 3 * i] * root[q + k]
                                + g[o + 3 * i + 1] * root[q + 3 + k]
                                + g[o + 3 * i + 2] * root[q + 6 + k];
            }
        }
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                double e =
                        root[q + i] * part[k]
                                + root[q + 3 + i] * part[3 + k]
                                + root[q + 6 + i] * part[6 + k];
                sum += e * e;
            }
        }
        return sum;
    }
}
