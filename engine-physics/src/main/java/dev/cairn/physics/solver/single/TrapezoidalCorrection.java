package dev.cairn.physics.solver.single;

import static dev.cairn.physics.solver.body.SolverBodies.LOADED;
import static dev.cairn.physics.solver.body.SolverBodies.MASS;
import static dev.cairn.physics.solver.body.SolverBodies.P;
import static dev.cairn.physics.solver.body.SolverBodies.V;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.MotionRecord;
import dev.cairn.physics.solver.body.Rotation;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.RowArithmetic;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.RollingRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * Guided bodies, whose only contact is with a static body: at the end of a sub-step they are put
 * where the mean of their velocities before and after leads.
 *
 * <p>Problem: a body with contacts moves by the velocity of the end of a sub-step, which is what
 * its contacts were solved for. That is a scheme of the first order: a slide is half a sub-step
 * ahead, and so is a block that rocks on its edge. A body on one contact is free in all but one
 * direction, so it can be corrected when its impulses are known: by the trapezoid along the contact
 * plane and in its turn, and along the normal by what keeps the points that press where they are.
 * What is still and lies with an edge in the ground is not corrected: there the correction would
 * take back each push of the bias pass.
 *
 * <p>Errors at 4 sub-steps without and with: a slide 4e-3 and 1e-14; Housner's block, time to its
 * first impact, 9.3e-3 and 1.4e-3. Any worker, one to a body. Does not allocate.
 */
final class TrapezoidalCorrection {
    /** Square of the share of its speed that is left of a body that friction has stopped. */
    private static final double STOPPED = 1e-12;

    /** Square of a turn, rad, that is too small to make up for. */
    private static final double LEAST_TURN = 1e-24;

    /** Square of the share of the bias pass's turning up to which a body is still. */
    private static final double STILL = 1e-6;

    /** Share of the deepest overlap that counts as pushed out. */
    private static final double LEAST_PUSH = 1e-6;

    /** Over the inner radius: what overlaps so far beyond the sag of its load is deep. */
    private static final double DEEP = 0.05;

    /**
     * Square of a body's turn in a sub-step, rad, beyond which the mean of two velocities is not
     * the motion between them: a rod that lands on its tip begins to turn within the sub-step, and
     * half of that turn, added to its pose, is an overlap that nothing paid for.
     */
    private static final double MOST_TURN = 0.01;

    /**
     * Share of a sub-step after which nothing lands in it. A relax pass lets an open point come as
     * near as it is, {@code v = -s/h}: it touches at the end, by as much as rounding says.
     */
    private static final double LATE = 1 - 0x1p-20;

    private TrapezoidalCorrection() {}

    /**
     * End of a sub-step of a guided body, its row at {@code place}: along the contact plane it
     * moves by the mean of the velocities before and after, {@code x += h ((v0 + v1)/2 - v)}
     * without its part along the normal. So a slide follows the parabola, and a body that friction
     * holds does not move at all. A slide or a roll that friction ends within the sub-step ends at
     * its own time t, {@code x += t v0/2}.
     *
     * @param at place of the row in {@code rolling}
     */
    static void end(
            BodyStore b,
            SolverBodies s,
            int i,
            ConstraintRows rows,
            RollingRows rolling,
            int place,
            int at,
            SubStep sub) {
        double[] v = s.state;
        double h = sub.seconds;
        int o = SolverBodies.offset(i);
        if (v[o + LOADED] == 0) {
            return;
        }
        int g = MotionRecord.STRIDE * i;
        double[] d = s.motion;
        int r = rows.base(place);
        double nx = rows.doubles[r];
        double ny = rows.doubles[r + rows.lanes];
        double nz = rows.doubles[r + 2 * rows.lanes];
        double lands = d[g + MotionRecord.LANDS];
        boolean isBlow = MotionRecord.hasLanded(s, i);
        double before = isBlow ? lands : 0.5;
        double after = 1 - before;
        double span = isBlow ? h : h * stopping(s, i, rows, rolling, place, at);
        double x = span * (before * d[g] + after * v[o + V]) - h * d[g + 3];
        double y = span * (before * d[g + 1] + after * v[o + V + 1]) - h * d[g + 4];
        double z = span * (before * d[g + 2] + after * v[o + V + 2]) - h * d[g + 5];
        double n = x * nx + y * ny + z * nz;
        n += rock(b, s, i, rows, place, sub, before);
        v[o + P] += x - n * nx;
        v[o + P + 1] += y - n * ny;
        v[o + P + 2] += z - n * nz;
    }

    /**
     * When a point lands that bears nothing at the start of a sub-step, as the body goes then. A
     * blow changes the velocity there and not evenly: half of each is not the motion between them.
     *
     * @param row place of the body's only row
     * @param gain what gravity adds to a speed in the sub-step, m/s: what is no faster is no blow
     * @return share of the sub-step, of the first point; {@link MotionRecord#NEVER} if none does
     */
    static double landing(
            ConstraintRows rows, int row, SolverBodies s, int i, double h, double gain) {
        int o = SolverBodies.offset(i);
        int r = rows.base(row);
        boolean isA = rows.link[row * ConstraintRows.LINK] == o;
        double side = isA ? -1 : 1;
        int arm = isA ? ConstraintRows.ARM_A : ConstraintRows.ARM_B;
        double first = MotionRecord.NEVER;
        for (int p = 0; p < rows.points(row); p++) {
            int q = r + (ConstraintRows.POINT + p * ConstraintRows.POINT_FIELDS) * rows.lanes;
            if (rows.get(q + ConstraintRows.IMPULSE * rows.lanes) > 0) {
                continue;
            }
            double gap = Math.max(0, rows.get(q + ConstraintRows.SEPARATION * rows.lanes));
            double speed = 0;
            for (int k = 0; k < 3; k++) {
                speed += s.state[o + V + k] * rows.get(r + k * rows.lanes);
                speed += s.state[o + V + 3 + k] * rows.get(q + (arm + k) * rows.lanes);
            }
            double closing = -side * speed;
            double share = gap / (closing * h);
            if (closing > gain && share < LATE) {
                first = first == MotionRecord.NEVER ? share : Math.min(first, share);
            }
        }
        return first;
    }

    /**
     * The same for the turn: {@code h/2 (w1 - w' - (w - w0))} with w' the velocity that turned the
     * body, after free rotation. Returns by how much that lowers the points that press.
     */
    private static double rock(
            BodyStore b,
            SolverBodies s,
            int i,
            ConstraintRows rows,
            int place,
            SubStep sub,
            double before) {
        double[] d = s.motion;
        double h = sub.seconds;
        int g = MotionRecord.STRIDE * i;
        int o = SolverBodies.offset(i);
        double after = 1 - before;
        double x = h * (after * (s.world(i, o + V + 3, 0) - d[g + 9]) - before * d[g + 6]);
        double y = h * (after * (s.world(i, o + V + 3, 1) - d[g + 10]) - before * d[g + 7]);
        double z = h * (after * (s.world(i, o + V + 3, 2) - d[g + 11]) - before * d[g + 8]);
        double turns =
                h * h * (d[g + 9] * d[g + 9] + d[g + 10] * d[g + 10] + d[g + 11] * d[g + 11]);
        if (!(x * x + y * y + z * z > LEAST_TURN) || turns > MOST_TURN) {
            return 0;
        }
        double[] root = s.root;
        int k = (i + 1) * SolverBodies.ROOT;
        double[] v = s.state;
        double[] w = s.motion;
        for (int c = 0; c < 3; c++) {
            w[g + c] =
                    root[k + 9 + c] * (root[k + c] * x + root[k + 3 + c] * y + root[k + 6 + c] * z);
        }
        int r = rows.base(place);
        int arm =
                rows.link[place * ConstraintRows.LINK] == o
                        ? ConstraintRows.ARM_A
                        : ConstraintRows.ARM_B;
        if (isStill(s, i, STILL * turns / (h * h))
                && lowersDeepest(b, i, rows, place, arm, w, g, sub)) {
            return 0;
        }
        Rotation.turn(b, i, x, y, z);
        for (int c = 0; c < 3; c++) {
            v[o + P + 3 + c] += w[g + c];
        }
        double sum = 0;
        double low = 0;
        for (int p = 0; p < rows.points(place); p++) {
            int q = r + (ConstraintRows.POINT + p * ConstraintRows.POINT_FIELDS) * rows.lanes;
            double l = rows.doubles[q + ConstraintRows.IMPULSE * rows.lanes];
            sum += l;
            low += l * RowArithmetic.dot(rows.doubles, q + arm * rows.lanes, rows.lanes, w, g);
        }
        return sum > 0 ? low / sum : 0;
    }

    /**
     * Whether the square of a body's turning before and after the sub-step is below a bound. Before
     * is what the contact has not changed: what turned the body has precessed since.
     */
    private static boolean isStill(SolverBodies s, int i, double most) {
        int o = SolverBodies.offset(i);
        int free = MotionRecord.STRIDE * i + MotionRecord.FREE + 3;
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            int k = (i + 1) * SolverBodies.ROOT + 3 * c;
            double after = s.world(i, o + V + 3, c);
            double before = 0;
            for (int e = 0; e < 3; e++) {
                before += s.root[k + e] * s.motion[free + e];
            }
            sum += before * before + after * after;
        }
        return sum < most;
    }

    /**
     * Whether a turn, weighted, at {@code turn[g]}, is that of a push which it takes back: it
     * lowers the point that overlaps most, or, by {@link #DEEP}, most beyond the sag of its load. A
     * plate may stand on three corners of which one bears a fiftieth of its weight, and that one is
     * deep.
     */
    private static boolean lowersDeepest(
            BodyStore b,
            int i,
            ConstraintRows rows,
            int place,
            int arm,
            double[] turn,
            int g,
            SubStep sub) {
        double deepest = 0;
        double change = 0;
        double beyond = -DEEP * b.innerRadius[i];
        double changeBeyond = 0;
        double side = arm == ConstraintRows.ARM_A ? -1 : 1;
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        for (int p = 0; p < rows.points(place); p++) {
            int q =
                    rows.base(place)
                            + (ConstraintRows.POINT + p * ConstraintRows.POINT_FIELDS) * lanes;
            double gap = d[q + ConstraintRows.SEPARATION * lanes];
            double stiffness = d[q + ConstraintRows.MASS * lanes] * sub.stiffness(true);
            double load = d[q + ConstraintRows.IMPULSE * lanes];
            double excess = gap + (stiffness > 0 ? load / stiffness : 0);
            double rise = side * RowArithmetic.dot(d, q + arm * lanes, lanes, turn, g);
            if (gap < deepest) {
                deepest = gap;
                change = rise;
            }
            if (excess < beyond) {
                beyond = excess;
                changeBeyond = rise;
            }
        }
        return change < LEAST_PUSH * deepest || changeBeyond < LEAST_PUSH * beyond;
    }

    /**
     * Share of the sub-step after which friction has stopped a guided body, or 1 if it still moves.
     * With {@code u} the direction of {@code v0}, the impulse {@code l} that stopped it and the
     * {@code L} that friction could give, {@code v0 + h a = l/m} and {@code v0 + t a = t/h L/m}, so
     * {@code t/h = v0/(v0 + (L - l)/m)}. Where rolling friction is nearer to its bound, it is what
     * stopped the body, see {@link RollingRows#left}.
     */
    private static double stopping(
            SolverBodies s, int i, ConstraintRows rows, RollingRows rolling, int place, int at) {
        int r = rows.base(place);
        double[] v = s.state;
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int o = SolverBodies.offset(i);
        int t1 = r + ConstraintRows.TANGENT1 * lanes;
        int t2 = r + ConstraintRows.TANGENT2 * lanes;
        double b1 = RowArithmetic.dot(d, t1, lanes, s.motion, MotionRecord.STRIDE * i);
        double b2 = RowArithmetic.dot(d, t2, lanes, s.motion, MotionRecord.STRIDE * i);
        double a1 = RowArithmetic.dot(d, t1, lanes, v, o + V);
        double a2 = RowArithmetic.dot(d, t2, lanes, v, o + V);
        double before = b1 * b1 + b2 * b2;
        if (!(a1 * a1 + a2 * a2 < STOPPED * before)) {
            return 1;
        }
        double speed = Math.sqrt(before);
        double l1 = d[r + ConstraintRows.LAMBDA * lanes];
        double l2 = d[r + (ConstraintRows.LAMBDA + 1) * lanes];
        double taken = Math.abs(l1 * b1 + l2 * b2) / speed;
        int points = rows.points(place);
        double limit =
                d[r + ConstraintRows.FRICTION * lanes] * RowArithmetic.sum(d, r, lanes, points);
        double left = (limit - taken) * v[o + MASS];
        if (rolling.has(at)) {
            left = rolling.left(rows, place, at, v[o + MASS], taken / limit, left);
        }
        return left > 0 ? speed / (speed + left) : 1;
    }
}
