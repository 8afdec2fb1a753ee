package dev.cairn.physics.joint;

import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.joint.JointMath;

/** What a joint's rows measure, for readers between steps. */
final class JointValues {
    private static final double[] STILL = new double[32];
    private final JointMath math = new JointMath();

    double of(Joints joints, int j, JointAxis axis) {
        int law =
                switch (axis) {
                    case X, Y, Z -> JointStore.SLIDE + axis.index;
                    case TWIST -> JointStore.TWIST;
                    case SWING_Y -> JointStore.SWING;
                    case SWING_Z -> JointStore.SWING + 1;
                    case CONE -> JointStore.CONE;
                    case DISTANCE -> JointStore.DISTANCE;
                    case PATH -> JointStore.ALONG;
                };
        math.look(joints.bodies, STILL, joints.store, j, 0, 0);
        return math.measure(joints.store, j, law);
    }

    double gap(Joints joints, int j) {
        JointStore s = joints.store;
        math.look(joints.bodies, STILL, s, j, 0, 0);
        double worst = 0;
        for (int r = s.firstRow[j]; r < s.firstRow[j] + s.rows[j]; r++) {
            double c = math.measure(s, j, s.law[r]);
            double gap = 0;
            if (s.role[r] == JointStore.LOCK) {
                gap = Math.abs(c - s.target[r]);
            } else if (s.role[r] == JointStore.LIMIT) {
                gap = Math.max(0, Math.max(s.lower[r] - c, c - s.upper[r]));
            }
            worst = Math.max(worst, gap);
        }
        return worst;
    }
}
