package dev.cairn.physics.solver.refresh;

import static dev.cairn.physics.solver.row.ConstraintRows.COUNT;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.SOURCE;
import static dev.cairn.physics.solver.row.ConstraintRows.SUM;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * A ball of half the inner radius, about the centre of mass of a body of one shape, does not go
 * into static bodies that it touches.
 *
 * <p>Problem: a contact is soft and has the points of the tick's start. A plate of a tenth of a
 * millimetre under a heavy body, or in ticks of very different lengths, sinks a little in each,
 * until its middle is below the floor; a small stick that falls by more than its length in a
 * sub-step lands on one tip, turns about it by more than linear levers know of, and has its other
 * end, which is in no point, and its middle far below the floor. But in whatever pose, the body
 * holds its inner ball.
 *
 * <p>With n the normal from the static body, g the gap of the ball and v the velocity of the centre
 * of mass, the middle may close that gap at most: {@code n.v h >= -max(g, 0)}. What is missing is
 * an impulse along n through the centre of mass. It is inelastic, {@code |n.v|} only falls, so it
 * takes energy out; it is no part of the warm start. What overlaps by less than half of its inner
 * radius knows nothing of it.
 */
public final class CoreGuard {
    /** Of the inner radius: the ball. The other half is left to the contact, which is soft. */
    private static final double CORE = 0.5;

    /** By place: gap of the ball at the tick's start, m; infinite where nothing is guarded. */
    private double[] gap = {};

    /** By place: a point overlaps by more than the ball leaves room for. */
    private boolean[] deep = {};

    public void ensurePlaces(int places) {
        if (gap.length < places) {
            gap = new double[places];
            deep = new boolean[places];
        }
    }

    /** Measures the gaps at the tick's start; ranges of places. */
    public void look(ConstraintRows rows, ContactStore c, BodyStore b, int from, int to) {
        for (int j = from; j < to; j++) {
            int l = LINK * j;
            int a = rows.link[l];
            int other = rows.link[l + 1];
            gap[j] = Double.POSITIVE_INFINITY;
            if (rows.link[l + COUNT] == 0 || (a != 0 && other != 0)) {
                continue;
            }
            int slot = SolverBodies.slot(a + other);
            // of several shapes, the one that is touched need not hold the centre of mass
            if (b.collider[slot] == slot) {
                int source = rows.link[l + SOURCE];
                gap[j] = height(c, source, a == 0) - CORE * b.innerRadius[slot];
                deep[j] = isDeep(c, source, CORE * b.innerRadius[slot]);
            }
        }
    }

    /**
     * Guards the bodies of rows, before bodies move. Any range of places: each row changes its own
     * body alone, and such rows of one body are in the order of places.
     */
    public void keepOut(
            ConstraintRows rows, SolverBodies s, BodyStore b, SubStep sub, int from, int to) {
        double[] v = s.state;
        for (int j = from; j < to; j++) {
            if (gap[j] == Double.POSITIVE_INFINITY) {
                continue;
            }
            int a = rows.link[j * LINK];
            int o = a + rows.link[j * LINK + 1];
            int k = rows.base(j);
            double sign = a == 0 ? 1 : -1;
            double nx = sign * rows.get(k);
            double ny = sign * rows.get(k + rows.lanes);
            double nz = sign * rows.get(k + 2 * rows.lanes);
            double speed = nx * v[o] + ny * v[o + 1] + nz * v[o + 2];
            int p = o + SolverBodies.P;
            double now = gap[j] + nx * v[p] + ny * v[p + 1] + nz * v[p + 2];
            double change = -Math.max(now, 0) * sub.inverse - speed;
            boolean closes = speed < 0 && change > 0;
            double least = Math.min(gap[j], 0);
            double end = now + sub.seconds * (closes ? speed + change : speed);
            boolean sinks = v[o + SolverBodies.LOADED] != 0 && end < least;
            if (!(closes || sinks) || !(deep[j] || presses(rows, j))) {
                continue;
            }
            if (closes) {
                push(rows, s, j, o, change * nx, change * ny, change * nz, change);
            }
            if (sinks) {
                v[p] += (least - end) * nx;
                v[p + 1] += (least - end) * ny;
                v[p + 2] += (least - end) * nz;
            }
            // the closed forms for a body on one contact know nothing of this
            int slot = SolverBodies.slot(o);
            if (s.guide[slot] >= 0) {
                s.guide[slot] = SolverBodies.LOST;
            }
            b.lostGuide[slot] = true;
        }
    }

    private static void push(
            ConstraintRows rows,
            SolverBodies s,
            int j,
            int o,
            double x,
            double y,
            double z,
            double change) {
        double[] v = s.state;
        double[] mark = s.mark;
        int w = o / SolverBodies.STRIDE * SolverBodies.HALF;
        v[o] += x;
        v[o + 1] += y;
        v[o + 2] += z;
        mark[w] += x;
        mark[w + 1] += y;
        mark[w + 2] += z;
        int sum = rows.base(j) + SUM * rows.lanes;
        rows.put(sum, rows.get(sum) + change / v[o + SolverBodies.MASS]);
    }

    /** Whether the row has had an impulse in this tick. */
    private static boolean presses(ConstraintRows rows, int j) {
        int o = rows.base(j);
        for (int i = 0; i < rows.points(j); i++) {
            if (rows.get(o + (POINT + i * POINT_FIELDS + IMPULSE) * rows.lanes) > 0
                    || rows.get(o + (SUM + i) * rows.lanes) > 0) {
                return true;
            }
        }
        return false;
    }

    private static boolean isDeep(ContactStore c, int source, double overlap) {
        int first = ContactStore.POINTS * source;
        boolean is = false;
        for (int p = first; p < first + c.pointCount[source]; p++) {
            is |= c.separation[p] < -overlap;
        }
        return is;
    }

    /**
     * How high the centre of mass is over the surface. Anchors lie midway in the gap s, so it is
     * {@code s/2 - n.r}, r the anchor seen from the centre.
     */
    private static double height(ContactStore c, int source, boolean isB) {
        double sign = isB ? 1 : -1;
        double nx = sign * c.normalX(source);
        double ny = sign * c.normalY(source);
        double nz = sign * c.normalZ(source);
        double most = Double.NEGATIVE_INFINITY;
        int first = ContactStore.POINTS * source;
        for (int p = first; p < first + c.pointCount[source]; p++) {
            int r = ContactStore.anchor(p) + (isB ? 3 : 0);
            double along = nx * c.anchors[r] + ny * c.anchors[r + 1] + nz * c.anchors[r + 2];
            most = Math.max(most, 0.5 * c.separation[p] - along);
        }
        return most;
    }
}
