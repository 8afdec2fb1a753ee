package dev.cairn.physics.solver;

import dev.cairn.physics.internal.ContactStore;

/**
 * The offset that removes sag: the outer loop of an augmented Lagrangian, once a tick.
 *
 * <p>A soft contact holds the load {@code l} only with the overlap {@code l / k}. While a point
 * rests, a small share of its overlap moves into an offset of its separation, kept as the load
 * {@code k offset} that it stands for, so that it stays right when the effective mass changes. The
 * point ends with no overlap and an offset that holds its whole load. One-sided: it never pulls.
 * While a point moves, the offset fades; when it opens, fast.
 *
 * <p>Source: own study; the idea is Powell's and Hestenes' method of multipliers (1969).
 */
final class Offsets {
    private static final double OPEN = 0.5;
    private static final double MOVING = 0.98;

    private Offsets() {}

    /**
     * Writes the preloads of contact {@code c}, which is row {@code m}, for the next tick.
     *
     * @param gain share of the overlap per tick
     * @param still speed below which a point rests, m/s
     */
    static void update(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            int c,
            int m,
            double gain,
            double still) {
        double[] d = rows.row;
        double[] q = rows.point;
        double[] body = bodies.state;
        int a = rows.link[m * ConstraintRows.LINK];
        int b = rows.link[m * ConstraintRows.LINK + 1];
        int r = m * ConstraintRows.ROW;
        double slip = slip(d, r, body, a, b);
        boolean rests = slip < still;
        for (int i = 0; i < contacts.pointCount[c]; i++) {
            int p = ContactStore.POINTS * c + i;
            int o = (ContactStore.POINTS * m + i) * ConstraintRows.POINT;
            double impulse = q[o + ConstraintRows.IMPULSE];
            double gap = contacts.separation[p];
            double known = q[o + ConstraintRows.STIFFNESS] * (gap - q[o + ConstraintRows.GAP]);
            double speed =
                    d[r] * (body[b] - body[a])
                            + d[r + 1] * (body[b + 1] - body[a + 1])
                            + d[r + 2] * (body[b + 2] - body[a + 2])
                            + PrepareRow.dot(body, b + 3, q, o + 3)
                            - PrepareRow.dot(body, a + 3, q, o);
            if (impulse > 0 && rests && Math.abs(speed) < still) {
                known -= q[o + ConstraintRows.STIFFNESS] * gain * Math.min(0, gap);
            } else {
                known *= impulse == 0 && gap > 0 ? OPEN : MOVING;
            }
            contacts.preload[p] = Math.max(0, known);
        }
    }

    private static double slip(double[] d, int r, double[] body, int a, int b) {
        if (!(d[r + ConstraintRows.FRICTION] > 0)) {
            return 0;
        }
        double x = body[b] - body[a];
        double y = body[b + 1] - body[a + 1];
        double z = body[b + 2] - body[a + 2];
        int t = r + ConstraintRows.TANGENT1;
        int v = r + ConstraintRows.LEVER;
        double s1 =
                x * d[t]
                        + y * d[t + 1]
                        + z * d[t + 2]
                        + PrepareRow.dot(body, b + 3, d, v + 6)
                        - PrepareRow.dot(body, a + 3, d, v);
        double s2 =
                x * d[t + 3]
                        + y * d[t + 4]
                        + z * d[t + 5]
                        + PrepareRow.dot(body, b + 3, d, v + 9)
                        - PrepareRow.dot(body, a + 3, d, v + 3);
        return Math.sqrt(s1 * s1 + s2 * s2);
    }
}
