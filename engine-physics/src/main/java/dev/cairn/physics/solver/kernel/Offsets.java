package dev.cairn.physics.solver.kernel;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * The offset that removes sag: the outer loop of an augmented Lagrangian, once a tick.
 *
 * <p>A soft contact holds the load {@code l} only with the overlap {@code l / k}. While a point
 * rests, a small share of its overlap, or of its gap, moves into an offset of its separation, kept
 * as the load {@code k offset} that it stands for, so that it stays right when the effective mass
 * changes. The point ends with no overlap and an offset that holds its whole load, {@code l' =
 * max(0, l - k gain gap)}: it never pulls, and what has lost a load comes down again. It does not
 * grow beyond the impulse that the point gives: bodies that were put into each other are pushed out
 * at rest, and their overlap says nothing about a load; they would hover by a part of it. While a
 * point moves, the offset fades; when it opens, fast.
 *
 * <p><b>Inclined contacts.</b> Problem: what lifts a body off an inclined contact also moves it
 * aside, against the friction of its other contacts; these hold it, so the overlap stays while the
 * offset grows, until something slips. In a heap that goes on for ever: forces rose by a half
 * within ten seconds, the heap gave way, and all began again. (A controller that integrates its
 * error hunts like this where there is dry friction.) So the offset of an inclined contact holds
 * {@link #INCLINED} of its load, as if its spring were so much stiffer; a level contact moves
 * nothing aside and holds all. A body whose only contact is with a static one has nothing to push
 * against.
 *
 * <p>Source: own study; the idea is Powell's and Hestenes' method of multipliers (1969).
 */
public final class Offsets {
    /**
     * What is left of an offset after a tick with an open point, and after one with a moving one.
     */
    public static final double OPEN = 0.5;

    public static final double MOVING = 0.98;

    /** A contact is level if its normal is nearer than 8 degrees to the direction of gravity. */
    private static final double LEVEL = 0.99;

    /** Share of its load that the offset of an inclined contact holds at most. */
    private static final double INCLINED = 0.5;

    private Offsets() {}

    /** The share of its load that the offsets of the row at place {@code j} may hold. */
    public static double share(ConstraintRows rows, SolverBodies bodies, int j, SubStep sub) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int o = rows.base(j);
        double x = /*(float)*/ sub.upX;
        double y = /*(float)*/ sub.upY;
        double z = /*(float)*/ sub.upZ;
        double up = x * d[o] + y * d[o + lanes] + z * d[o + 2 * lanes];
        int a = rows.link[j * ConstraintRows.LINK];
        int b = rows.link[j * ConstraintRows.LINK + 1];
        boolean isAlone = (a == 0 || b == 0) && bodies.isAlone(SolverBodies.slot(a + b));
        return isAlone || Math.abs(up) > LEVEL ? 1 : INCLINED;
    }

    /**
     * Writes the preloads of contact {@code c}, the row at place {@code j}, for the next tick.
     *
     * @param times how many times the usual share a tick moves
     */
    static void update(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            int c,
            int j,
            SubStep sub,
            int times) {
        double gain = times * sub.offsetGain;
        double still = sub.still;
        double touch = /*(float)*/ sub.touch;
        double share = share(rows, bodies, j, sub);
        double[] body = bodies.state;
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int o = rows.base(j);
        int a = rows.link[j * ConstraintRows.LINK];
        int b = rows.link[j * ConstraintRows.LINK + 1];
        double vx = body[b] - body[a];
        double vy = body[b + 1] - body[a + 1];
        double vz = body[b + 2] - body[a + 2];
        boolean rests = slip(d, o, lanes, body, a, b, vx, vy, vz) < still;
        double vn = vx * d[o] + vy * d[o + lanes] + vz * d[o + 2 * lanes];
        double stiffness =
                sub.stiffness(body[a + SolverBodies.MASS] == 0 || body[b + SolverBodies.MASS] == 0);
        for (int i = 0; i < contacts.pointCount[c]; i++) {
            int p = ContactStore.POINTS * c + i;
            int q = o + (ConstraintRows.POINT + i * ConstraintRows.POINT_FIELDS) * lanes;
            double impulse = d[q + ConstraintRows.IMPULSE * lanes];
            double gap = contacts.separation[p];
            double k = d[q + ConstraintRows.MASS * lanes] * stiffness;
            double known = k * (gap - d[o + (ConstraintRows.GAP + i) * lanes]);
            double speed =
                    vn
                            + RowArithmetic.dot(
                                    d, q + ConstraintRows.ARM_B * lanes, lanes, body, b + 3)
                            - RowArithmetic.dot(
                                    d, q + ConstraintRows.ARM_A * lanes, lanes, body, a + 3);
            if (impulse > 0 && rests && Math.abs(speed) < still) {
                double learnt = known - k * ((gap < 0 || gap > touch ? gap : 0) * gain);
                // l' <= max(l, share N): what overlaps beyond the sag of the load N is being pushed
                // out
                known = Math.min(learnt, Math.max(known, share * impulse));
            } else {
                known *= impulse == 0 && gap > 0 ? OPEN : MOVING;
            }
            contacts.preload[p] = known > 0 ? known : 0;
        }
    }

    private static double slip(
            double[] d,
            int o,
            int lanes,
            double[] body,
            int a,
            int b,
            double x,
            double y,
            double z) {
        if (!(d[o + ConstraintRows.FRICTION * lanes] > 0)) {
            return 0;
        }
        int t1 = o + ConstraintRows.TANGENT1 * lanes;
        int t2 = o + ConstraintRows.TANGENT2 * lanes;
        int v = o + ConstraintRows.LEVER * lanes;
        double s1 =
                x * d[t1]
                        + y * d[t1 + lanes]
                        + z * d[t1 + 2 * lanes]
                        + RowArithmetic.dot(d, v + 6 * lanes, lanes, body, b + 3)
                        - RowArithmetic.dot(d, v, lanes, body, a + 3);
        double s2 =
                x * d[t2]
                        + y * d[t2 + lanes]
                        + z * d[t2 + 2 * lanes]
                        + RowArithmetic.dot(d, v + 9 * lanes, lanes, body, b + 3)
                        - RowArithmetic.dot(d, v + 3 * lanes, lanes, body, a + 3);
        return Math.sqrt(s1 * s1 + s2 * s2);
    }
}
