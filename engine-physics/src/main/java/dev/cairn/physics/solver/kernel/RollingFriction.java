package dev.cairn.physics.solver.kernel;

import static dev.cairn.physics.solver.row.ConstraintRows.*;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.RollingRows;

/**
 * Rolling friction in scalar arithmetic, at the end of the relax pass of a row, for rows of any
 * number of lanes.
 *
 * <p>Problem: the torque that stops a roll and the friction that stops a slip each undo a part of
 * what the other did, of a ball 5/7, so taking turns they would stop it slowly. So the roll is
 * stopped together with the slip, {@code l' = l - K^-1 (w - K_rf K_ff^-1 v)} with K that of a roll
 * without slip, see {@link RollingRows}, and drawn back to {@code |l'| <= b N}. If friction can
 * hold what that asks of it, this is the answer: friction then finds it at once. If not, the
 * contact slips, friction is at its bound, and {@code l' = l - K_rr^-1 w}. After either, friction
 * has the last word.
 *
 * <p>Both are {@code -s K^-1 w0}, s from 0 to 1 and w0 the roll without any torque, and so take
 * energy and never give it. A contact of one point also resists a spin about its normal, as an
 * evenly pressed disc of radius b does, {@code |l3| <= 2/3 mu b N}.
 */
public final class RollingFriction {
    /** Torque of an evenly pressed disc against a spin, over mu N and its radius. */
    private static final double DISC = 2.0 / 3;

    private RollingFriction() {}

    /** The rolling friction of a range of rows of one colour. */
    static void sweep(ConstraintRows rows, SolverBodies bodies, int from, int to) {
        for (int j = from; j < to; j++) {
            if (rows.rolling.has(j)) {
                row(rows, j, bodies.state, rows.rolling, j);
            }
        }
    }

    /**
     * Takes what an impact has left out of the start of a sub-step, of a range of rows of one
     * colour before their bias pass: bodies turn with it before the relax pass could take it out.
     */
    static void calm(ConstraintRows rows, SolverBodies bodies, int from, int to) {
        double[] body = bodies.state;
        RollingRows r = rows.rolling;
        for (int j = from; j < to; j++) {
            if (!r.has(j)) {
                continue;
            }
            double normal =
                    RowArithmetic.sum(rows.doubles, rows.base(j), rows.lanes, rows.points(j));
            double share = /*(float)*/ r.carried(j, normal);
            r.put(j, RollingRows.BEFORE, normal);
            if (share < 1) {
                double l1 = /*(float)*/ r.get(j, RollingRows.LAMBDA);
                double l2 = /*(float)*/ r.get(j, RollingRows.LAMBDA + 1);
                r.put(j, RollingRows.LAMBDA, share * l1);
                r.put(j, RollingRows.LAMBDA + 1, share * l2);
                double d1 = share * l1 - l1;
                double d2 = share * l2 - l2;
                double spin = /*(float)*/ r.get(j, RollingRows.SPIN);
                spinBy(
                        r,
                        j,
                        body,
                        rows.link[j * LINK],
                        rows.link[j * LINK + 1],
                        share * spin - spin);
                turn(r, j, RollingRows.LEVER, body, rows.link[j * LINK], -d1, -d2);
                turn(r, j, RollingRows.LEVER + 6, body, rows.link[j * LINK + 1], d1, d2);
            }
        }
    }

    /**
     * Rolling friction of one row, then its friction, and their totals.
     *
     * @param at place of the row in {@code r}
     * @return the largest change of an impulse, N s; of a torque's, over the radius of gyration
     */
    public static double row(ConstraintRows rows, int place, double[] body, RollingRows r, int at) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int o = rows.base(place);
        int a = rows.link[place * LINK];
        int b = rows.link[place * LINK + 1];
        int points = rows.points(place);
        double normal = RowArithmetic.sum(d, o, lanes, points);
        double bound = /*(float)*/ r.bound(rows, place, at);
        double l1 = /*(float)*/ r.get(at, RollingRows.LAMBDA);
        double l2 = /*(float)*/ r.get(at, RollingRows.LAMBDA + 1);
        double l3 = /*(float)*/ r.get(at, RollingRows.SPIN);
        if (bound == 0 && l1 == 0 && l2 == 0 && l3 == 0) {
            return 0;
        }
        if (points == 1) {
            spin(r, at, body, a, b, DISC * d[o + FRICTION * lanes] * bound);
        }
        double w1 = speed(r, at, 0, body, a, b);
        double w2 = speed(r, at, 3, body, a, b);
        if (!holds(d, o, lanes, body, a, b, points, normal, r, at, w1, w2, bound)) {
            r.next(at, RollingRows.FREE, w1, w2, bound);
        }
        double d1 = /*(float)*/ r.get(at, RollingRows.NEXT);
        double d2 = /*(float)*/ r.get(at, RollingRows.NEXT + 1);
        r.put(at, RollingRows.LAMBDA, d1);
        r.put(at, RollingRows.LAMBDA + 1, d2);
        d1 -= l1;
        d2 -= l2;
        turn(r, at, RollingRows.LEVER, body, a, -d1, -d2);
        turn(r, at, RollingRows.LEVER + 6, body, b, d1, d2);
        double inverse = /*(float)*/
                (r.get(at, RollingRows.FREE) + r.get(at, RollingRows.FREE + 2));
        double mass = d[o + MASS_A * lanes] + d[o + MASS_B * lanes];
        double size = Math.max(Math.abs(d1), Math.abs(d2));
        double worst = mass > 0 ? size * Math.sqrt(inverse / (2 * mass)) : 0;
        return d[o + FRICTION * lanes] > 0
                ? Math.max(worst, solve(d, o, lanes, body, a, b, points))
                : worst;
    }

    /** The impulse that stops a spin about the normal, {@code l' = l - w/K}, up to a bound. */
    private static void spin(RollingRows r, int at, double[] body, int a, int b, double bound) {
        double w = 0;
        double k = 0;
        for (int c = 0; c < 3; c++) {
            double n = /*(float)*/ r.get(at, RollingRows.AXIS + c);
            double m = /*(float)*/ r.get(at, RollingRows.AXIS + 3 + c);
            w += m * body[b + 3 + c] - n * body[a + 3 + c];
            k += n * n + m * m;
        }
        double old = /*(float)*/ r.get(at, RollingRows.SPIN);
        double next = k > 0 ? Math.max(-bound, Math.min(old - w / k, bound)) : 0;
        spinBy(r, at, body, a, b, next - old);
    }

    /** Adds to the impulse about the normal, and turns the bodies. */
    private static void spinBy(RollingRows r, int at, double[] body, int a, int b, double change) {
        double now = /*(float)*/ r.get(at, RollingRows.SPIN);
        now += change;
        r.put(at, RollingRows.SPIN, now);
        for (int c = 0; c < 3; c++) {
            double n = /*(float)*/ r.get(at, RollingRows.AXIS + c);
            double m = /*(float)*/ r.get(at, RollingRows.AXIS + 3 + c);
            body[a + 3 + c] -= a != 0 ? change * n : 0;
            body[b + 3 + c] += b != 0 ? change * m : 0;
        }
    }

    /** Friction once more, with its totals; returns its largest change. */
    public static double solve(
            double[] d, int o, int lanes, double[] body, int a, int b, int points) {
        double x = d[o + LAMBDA * lanes];
        double y = d[o + (LAMBDA + 1) * lanes];
        double twist = d[o + (LAMBDA + 2) * lanes];
        ScalarFriction.solve(d, o, lanes, body, a, b, points);
        x = d[o + LAMBDA * lanes] - x;
        y = d[o + (LAMBDA + 1) * lanes] - y;
        twist = d[o + (LAMBDA + 2) * lanes] - twist;
        d[o + TOTAL * lanes] += x;
        d[o + (TOTAL + 1) * lanes] += y;
        d[o + (TOTAL + 2) * lanes] += twist;
        return Math.max(Math.abs(x), Math.abs(y));
    }

    /** Finds the impulses that stop the roll without slip; whether friction can hold that. */
    private static boolean holds(
            double[] d,
            int o,
            int lanes,
            double[] body,
            int a,
            int b,
            int points,
            double normal,
            RollingRows r,
            int at,
            double w1,
            double w2,
            double bound) {
        double limit = d[o + FRICTION * lanes] * normal;
        if (!(limit > 0)) {
            return false;
        }
        int three = 3 * lanes;
        double v1 = slip(d, o + TANGENT1 * lanes, o + LEVER * lanes, lanes, body, a, b);
        double v2 = slip(d, o + TANGENT2 * lanes, o + LEVER * lanes + three, lanes, body, a, b);
        double b11 = d[o + BLOCK * lanes];
        double b12 = d[o + (BLOCK + 1) * lanes];
        double b22 = d[o + (BLOCK + 2) * lanes];
        double g1 = b11 * v1 + b12 * v2;
        double g2 = b12 * v1 + b22 * v2;
        double c11 = /*(float)*/ r.get(at, RollingRows.COUPLING);
        double c12 = /*(float)*/ r.get(at, RollingRows.COUPLING + 1);
        double c21 = /*(float)*/ r.get(at, RollingRows.COUPLING + 2);
        double c22 = /*(float)*/ r.get(at, RollingRows.COUPLING + 3);
        double e1 = w1 - (c11 * g1 + c12 * g2);
        double e2 = w2 - (c21 * g1 + c22 * g2);
        if (!r.next(at, RollingRows.HELD, e1, e2, bound)) {
            return false;
        }
        double d1 = /*(float)*/
                r.get(at, RollingRows.NEXT) - /*(float)*/ r.get(at, RollingRows.LAMBDA);
        double d2 =
                /*(float)*/ r.get(at, RollingRows.NEXT + 1)
                        - /*(float)*/ r.get(at, RollingRows.LAMBDA + 1);
        double y1 = c11 * d1 + c21 * d2;
        double y2 = c12 * d1 + c22 * d2;
        double f1 = d[o + LAMBDA * lanes] - g1 - (b11 * y1 + b12 * y2);
        double f2 = d[o + (LAMBDA + 1) * lanes] - g2 - (b12 * y1 + b22 * y2);
        double rim = d[o + FRICTION * lanes] * reach(d, o, lanes, points);
        double spin = Math.abs(d[o + (LAMBDA + 2) * lanes]);
        return PatchFriction.holds(f1 * f1 + f2 * f2, spin, limit * limit, rim, rim / limit);
    }

    /** Normal impulses times how far from the middle they press. */
    private static double reach(double[] d, int o, int lanes, int points) {
        double sum = 0;
        for (int p = 0; p < points; p++) {
            double impulse = d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes];
            sum += impulse * d[o + (REACH + p) * lanes];
        }
        return sum;
    }

    /** Speed of B against A about a tangent, rad/s. */
    private static double speed(RollingRows r, int at, int tangent, double[] body, int a, int b) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            int lever = RollingRows.LEVER + tangent + k;
            sum += /*(float)*/ r.get(at, lever + 6) * body[b + 3 + k];
            sum -= /*(float)*/ r.get(at, lever) * body[a + 3 + k];
        }
        return sum;
    }

    /** Speed of B against A along a tangent at the patch's centre. */
    private static double slip(
            double[] d, int t, int lever, int lanes, double[] body, int a, int b) {
        double dx = body[b] - body[a];
        double dy = body[b + 1] - body[a + 1];
        double dz = body[b + 2] - body[a + 2];
        return dx * d[t]
                + dy * d[t + lanes]
                + dz * d[t + 2 * lanes]
                + RowArithmetic.dot(d, lever + 6 * lanes, lanes, body, b + 3)
                - RowArithmetic.dot(d, lever, lanes, body, a + 3);
    }

    /** Adds to the impulses of a row, and turns its bodies. */
    public static void give(
            RollingRows r, int at, double[] body, int a, int b, double d1, double d2) {
        double l1 = /*(float)*/ r.get(at, RollingRows.LAMBDA);
        double l2 = /*(float)*/ r.get(at, RollingRows.LAMBDA + 1);
        l1 += d1;
        l2 += d2;
        r.put(at, RollingRows.LAMBDA, l1);
        r.put(at, RollingRows.LAMBDA + 1, l2);
        turn(r, at, RollingRows.LEVER, body, a, -d1, -d2);
        turn(r, at, RollingRows.LEVER + 6, body, b, d1, d2);
    }

    private static void turn(
            RollingRows r, int at, int lever, double[] body, int o, double d1, double d2) {
        for (int k = 0; k < 3 && o != 0; k++) {
            double change =
                    d1 * /*(float)*/ r.get(at, lever + k)
                            + d2 * /*(float)*/ r.get(at, lever + 3 + k);
            body[o + 3 + k] = body[o + 3 + k] + change + 0.0;
        }
    }
}
