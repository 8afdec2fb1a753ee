package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.SolverBodies;

/**
 * Rows that tie a motion of one body to one of the other: gears, a rack, a pulley.
 *
 * <p><b>Gears</b> with n and m teeth (negative: inside) touch at a point of the line of their
 * centres, D long, with direction u from A to B; their pitch radii are {@code n D/(n + m)} and
 * {@code m D/(n + m)}. With a and b the angles of their marks against u, teeth stay in mesh while
 *
 * <pre>
 * c = -D/(n + m) wrap(n a + m b) = 0,    c' = (x × u) (v of B - v of A at the touch)
 * </pre>
 *
 * <p>A whole turn of either changes the sum by whole turns, so nothing is counted, and the ratio is
 * kept for ever. The force passes at the touch, as that of teeth does.
 *
 * <p><b>A rack</b> is a gear of infinite radius: {@code c = r wrap(y/r - twist)}, y the way of B
 * along its own y axis. <b>A pulley</b>'s rope runs over two points of the world: {@code c = |a -
 * p| + k |b - q|}.
 */
final class Gearing {
    private final double[] e = new double[3];
    private final double[] arm = new double[3];

    static double measure(JointMath m, JointStore s, int j, int law) {
        int p = JointStore.PARAMETERS * j;
        return switch (law) {
            case JointStore.GEAR -> {
                double sum = s.parameter[p] + s.parameter[p + 1];
                double d = across(m);
                double a = -Angles.of(dot(m.gap, m.axesA, 6), dot(m.gap, m.axesA, 3));
                double b = -Angles.of(dot(m.gap, m.axesB, 6), dot(m.gap, m.axesB, 3));
                yield -d / sum * Angles.wrap(s.parameter[p] * a + s.parameter[p + 1] * b);
            }
            case JointStore.RACK -> {
                double r = s.parameter[p];
                yield r * Angles.wrap(dot(m.gap, m.axesB, 3) / r - m.twist());
            }
            default -> rope(m, s, p, 0) + s.parameter[p + 6] * rope(m, s, p, 3);
        };
    }

    /** Distance of the centres of two gears at a right angle to their axis. */
    private static double across(JointMath m) {
        double y = dot(m.gap, m.axesA, 3);
        double z = dot(m.gap, m.axesA, 6);
        return Math.sqrt(y * y + z * z);
    }

    /** Length of a pulley's rope at A (0) or B (3). */
    private static double rope(JointMath m, JointStore s, int p, int side) {
        double[] at = side == 0 ? m.placeA : m.placeB;
        return SolverBodies.norm(
                at[0] - s.parameter[p + side],
                at[1] - s.parameter[p + side + 1],
                at[2] - s.parameter[p + side + 2]);
    }

    void derive(JointMath m, JointStore s, int j, int law, double[] d, int o) {
        int p = JointStore.PARAMETERS * j;
        if (law == JointStore.PULLEY) {
            rope(m, s, p, 0, m.armA, -1, d, o);
            rope(m, s, p, 3, m.armB, s.parameter[p + 6], d, o + 6);
            return;
        }
        double at;
        if (law == JointStore.GEAR) {
            double across = Math.max(across(m), JointMath.SMALL);
            double y = dot(m.gap, m.axesA, 3) / across;
            double z = dot(m.gap, m.axesA, 6) / across;
            at = s.parameter[p] / (s.parameter[p] + s.parameter[p + 1]) * across;
            for (int k = 0; k < 3; k++) {
                // x × (y, z) = (-z, y)
                e[k] = y * m.axesA[6 + k] - z * m.axesA[3 + k];
                arm[k] = m.armA[k] + at * (y * m.axesA[3 + k] + z * m.axesA[6 + k]);
            }
        } else {
            for (int k = 0; k < 3; k++) {
                e[k] = m.axesB[3 + k];
                arm[k] = m.armA[k] + s.parameter[p] * m.axesB[6 + k];
            }
        }
        write(e, arm, d, o);
        for (int k = 0; k < 3; k++) {
            arm[k] += m.armB[k] - m.reach[k];
        }
        write(e, arm, d, o + 6);
    }

    /** The derivative of the length of a rope at one body. */
    private void rope(
            JointMath m,
            JointStore s,
            int p,
            int side,
            double[] lever,
            double k,
            double[] d,
            int o) {
        double[] at = side == 0 ? m.placeA : m.placeB;
        double length = Math.max(rope(m, s, p, side), JointMath.SMALL);
        for (int c = 0; c < 3; c++) {
            e[c] = k * (at[c] - s.parameter[p + side + c]) / length;
        }
        write(e, lever, d, o);
    }

    /** A force, and its torque at an arm. */
    private static void write(double[] force, double[] r, double[] d, int o) {
        for (int k = 0; k < 3; k++) {
            d[o + k] = force[k];
            d[o + 3 + k] =
                    r[(k + 1) % 3] * force[(k + 2) % 3] - r[(k + 2) % 3] * force[(k + 1) % 3];
        }
    }

    private static double dot(double[] a, double[] b, int j) {
        return a[0] * b[j] + a[1] * b[j + 1] + a[2] * b[j + 2];
    }
}
