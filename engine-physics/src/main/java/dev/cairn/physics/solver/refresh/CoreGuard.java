package dev.cairn.physics.solver.refresh;

import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.SUM;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * The ball inside of a body, about its centre of mass, does not go into what does not move and what
 * the body touches.
 *
 * <p>Problem: a contact has the points of the tick's start. A small stick that falls by more than
 * its length in a sub-step lands on one tip, turns about it by more than linear levers know of, and
 * has its other end, which is in no point, and its middle far below the floor; a thin floor it
 * leaves on the other side. But in whatever pose, the body holds its inner ball.
 *
 * <p>With n the normal from what does not move, g the gap of the ball and v the velocity of the
 * centre of mass, the middle may close that gap at most: {@code n.v h >= -max(g, 0)}. What is
 * missing is an impulse along n through the centre of mass. It is inelastic, {@code |n.v|} only
 * falls, so it takes energy out; it is no part of the warm start. Only where the middle would cover
 * more than the inner radius in the sub-step, so that what rests, rolls or rocks has no such point.
 */
final class CoreGuard {
    private CoreGuard() {}

    /**
     * Guards the body of one row.
     *
     * @param record of the row at the tick's start, from {@code k} on
     */
    static void keepOut(
            ConstraintRows rows,
            SolverBodies s,
            BodyStore b,
            SubStep sub,
            int j,
            double[] record,
            int k) {
        int a = rows.link[j * LINK];
        int other = rows.link[j * LINK + 1];
        if (a != 0 && other != 0) {
            return;
        }
        int o = a + other;
        double sign = a == 0 ? 1 : -1;
        double[] v = s.state;
        double nx = sign * record[k];
        double ny = sign * record[k + 1];
        double nz = sign * record[k + 2];
        double speed = nx * v[o] + ny * v[o + 1] + nz * v[o + 2];
        double radius = b.innerRadius[SolverBodies.slot(o)];
        if (!(speed * sub.seconds * sub.count < -radius) || !presses(rows, j)) {
            return;
        }
        int p = o + SolverBodies.P;
        double moved = nx * v[p] + ny * v[p + 1] + nz * v[p + 2];
        double gap = moved + height(rows, j, record, k, a == 0 ? 3 : 0, nx, ny, nz) - radius;
        double least = -Math.max(gap, 0) * sub.inverse;
        if (speed >= least) {
            return;
        }
        double change = least - speed;
        int w = o / SolverBodies.STRIDE * SolverBodies.HALF;
        double[] mark = s.mark;
        v[o] += change * nx;
        v[o + 1] += change * ny;
        v[o + 2] += change * nz;
        mark[w] += change * nx;
        mark[w + 1] += change * ny;
        mark[w + 2] += change * nz;
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

    /**
     * How high the centre of mass was over the surface when the tick began. Anchors lie midway in
     * the gap s, so it is {@code s/2 - n.r}, r the anchor seen from the centre.
     */
    private static double height(
            ConstraintRows rows,
            int j,
            double[] record,
            int k,
            int side,
            double nx,
            double ny,
            double nz) {
        double most = Double.NEGATIVE_INFINITY;
        int q = k + RefreshRow.POINTS;
        for (int i = 0; i < rows.points(j); i++, q += RefreshRow.NUMBERS) {
            int r = q + side;
            double along = nx * record[r] + ny * record[r + 1] + nz * record[r + 2];
            most = Math.max(most, 0.5 * record[q + RefreshRow.GAPS] - along);
        }
        return most;
    }
}
