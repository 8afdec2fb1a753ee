package dev.cairn.physics.solver.single;

import static dev.cairn.physics.solver.row.ConstraintRows.ARM_A;
import static dev.cairn.physics.solver.row.ConstraintRows.ARM_B;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.row.ConstraintRows.LEVER;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.SUM;
import static dev.cairn.physics.solver.row.ConstraintRows.TANGENT1;
import static dev.cairn.physics.solver.row.ConstraintRows.TOTAL;
import static dev.cairn.physics.solver.row.ConstraintRows.TWIST;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.RollingFriction;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.RollingRows;

/**
 * Anderson's mixing with two steps of memory, for the sweeps of one row: where they come nearer to
 * their end by the same shares each time, it leaps there.
 *
 * <p>Problem: normals tilt a sliding block, friction follows the normals, and each sweep leaves a
 * share of the error of the one before, from a sixth at friction 0.05 to a third at 0.6. To agree
 * within 1e-12 took 13 to 27 sweeps, which were half the tick of bodies that slide alone. With
 * leaps it takes 6 to 8: a block tilts about two axes, so the error has two directions.
 *
 * <p>Let a sweep lead from the impulses x to g(x), and f = g(x) - x, with differences to the sweep
 * before {@code df, dg}, and those of that sweep {@code df', dg'}. If f were linear, the leap
 *
 * <pre>  x' = g - s dg - s' dg',   with s, s' that make |f - s df - s' df'| least</pre>
 *
 * would lead to the end. It is taken as impulses on the bodies, so momentum stays; what counts as
 * the answer is still a sweep that changes nothing. No leap is made where one sweep leads away, nor
 * a long one, nor where a point begins or ends to press: which ones do is not for a leap to decide.
 *
 * <p>Sweeps may lead away for ever. A corner that trails behind a cube which slides fast is lifted
 * by its friction: normals stop the corner, friction lifts it, so that normals let go, and friction
 * with them, and so on. With {@code mu k_nt > k_nn} that does not end, and a cube with friction of
 * 1.4 slid on through the floor without an impulse. So where two sweeps lead no nearer, the leap is
 * made, or, if that cannot be as all points begin or end to press, half of the second sweep is
 * taken back.
 *
 * <p>One to a worker. Does not allocate. Source: D. G. Anderson, "Iterative procedures for
 * nonlinear integral equations", Journal of the ACM 12 (1965), with M = 2.
 */
final class AndersonStep {
    private static final int NORMALS = 4;

    /** Of the unknowns: four normal impulses, friction along both tangents, twist, roll. */
    private static final int FRICTION = NORMALS, SPIN = NORMALS + 2, ROLL = NORMALS + 3;

    private static final int SIZE = ROLL + 2;

    /** Square of the sine between two differences up to which they are one. */
    private static final double ALIKE = 1e-8;

    /**
     * Square of how many times as far as the last sweep a leap leads at most. What leaps farther
     * does so along a direction in which sweeps hardly lead back, as where four points share their
     * load.
     */
    private static final double FAR = 16;

    /** Square of the share of a sweep's change that the next one leaves if it leads nearer. */
    private static final double NEARER = 0.9;

    private final double[] start = new double[SIZE];
    private final double[] end = new double[SIZE];
    private final double[] change = new double[SIZE];
    private final double[] leap = new double[SIZE];

    /** By sweep, the last one first: {@code g - g_before} and {@code f - f_before}. */
    private double[] ends = new double[SIZE], endsBefore = new double[SIZE];

    private double[] changes = new double[SIZE], changesBefore = new double[SIZE];
    private final double[] lastEnd = new double[SIZE], lastChange = new double[SIZE];

    /** Sweeps so far. */
    private int sweeps;

    /** The last ones that led no nearer. */
    private int astray;

    /** Another row. */
    void begin() {
        sweeps = 0;
        astray = 0;
    }

    /**
     * Before a sweep of the row at {@code place}.
     *
     * @param at its place in {@code rolling}
     */
    void start(ConstraintRows rows, int place, RollingRows rolling, int at) {
        read(rows, place, rolling, at, start);
    }

    /** After the sweep: leaps to where its change would be 0. */
    void leap(ConstraintRows rows, int place, RollingRows rolling, int at, double[] body) {
        read(rows, place, rolling, at, end);
        double[] oldest = endsBefore;
        endsBefore = ends;
        ends = oldest;
        oldest = changesBefore;
        changesBefore = changes;
        changes = oldest;
        double now = 0;
        double before = 0;
        for (int i = 0; i < SIZE; i++) {
            change[i] = end[i] - start[i];
            ends[i] = end[i] - lastEnd[i];
            changes[i] = change[i] - lastChange[i];
            if (i < SPIN) {
                now += change[i] * change[i];
                before += lastChange[i] * lastChange[i];
            }
            lastEnd[i] = end[i];
            lastChange[i] = change[i];
        }
        sweeps++;
        astray = sweeps == 1 || now < NEARER * before ? 0 : astray + 1;
        if (sweeps > 1 && (now < before || astray > 1) && find(rows.points(place))) {
            give(rows, place, rolling, at, body);
        } else if (astray > 1 && (isNone(start) || isNone(end))) {
            halve();
            give(rows, place, rolling, at, body);
        }
    }

    private static double dot(double[] x, double[] y) {
        double sum = 0;
        for (int i = 0; i < SPIN; i++) {
            sum += x[i] * y[i];
        }
        return sum;
    }

    private static void read(
            ConstraintRows rows, int place, RollingRows rolling, int at, double[] to) {
        double[] d = rows.doubles;
        int o = rows.base(place);
        int lanes = rows.lanes;
        int points = rows.points(place);
        for (int p = 0; p < NORMALS; p++) {
            to[p] = p < points ? d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes] : 0;
        }
        for (int f = 0; f < 3; f++) {
            to[FRICTION + f] = d[o + (LAMBDA + f) * lanes];
        }
        boolean rolls = rolling.has(at);
        for (int k = 0; k < 2; k++) {
            to[ROLL + k] = rolls ? rolling.get(at, RollingRows.LAMBDA + k) : 0;
        }
    }

    /** Finds the leap; false if there is none. Torques have another unit, and no say. */
    private boolean find(int points) {
        double k11 = dot(changes, changes);
        if (!(k11 > 0)) {
            return false;
        }
        double r1 = dot(changes, change);
        double share = r1 / k11;
        double shareBefore = 0;
        if (sweeps > 2) {
            double k12 = dot(changes, changesBefore);
            double k22 = dot(changesBefore, changesBefore);
            double r2 = dot(changesBefore, change);
            double det = k11 * k22 - k12 * k12;
            if (det > ALIKE * k11 * k22) {
                share = (r1 * k22 - r2 * k12) / det;
                shareBefore = (r2 * k11 - r1 * k12) / det;
            }
        }
        for (int i = 0; i < SIZE; i++) {
            leap[i] = -share * ends[i] - shareBefore * endsBefore[i];
        }
        if (!(dot(leap, leap) <= FAR * dot(change, change))) {
            return false;
        }
        for (int p = 0; p < points; p++) {
            boolean presses = end[p] > 0 && start[p] > 0 && end[p] + leap[p] > 0;
            boolean isOpen = end[p] == 0 && start[p] == 0 && leap[p] == 0;
            if (!(presses || isOpen)) {
                return false;
            }
        }
        return true;
    }

    /** Whether no point presses. */
    private static boolean isNone(double[] impulses) {
        return impulses[0] + impulses[1] + impulses[2] + impulses[3] == 0;
    }

    /** Takes half of the sweep back. */
    private void halve() {
        for (int i = 0; i < SIZE; i++) {
            leap[i] = -0.5 * change[i];
        }
    }

    private void give(ConstraintRows rows, int place, RollingRows rolling, int at, double[] body) {
        double[] d = rows.doubles;
        int o = rows.base(place);
        int lanes = rows.lanes;
        int points = rows.points(place);
        int a = rows.link[place * ConstraintRows.LINK];
        int b = rows.link[place * ConstraintRows.LINK + ConstraintRows.BODY_B];
        for (int p = 0; p < points; p++) {
            d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes] += leap[p];
            d[o + (SUM + p) * lanes] += leap[p];
        }
        for (int f = 0; f < 3; f++) {
            d[o + (LAMBDA + f) * lanes] += leap[FRICTION + f];
            d[o + (TOTAL + f) * lanes] += leap[FRICTION + f];
        }
        give(d, o, lanes, body, a, points, -1, 0);
        give(d, o, lanes, body, b, points, 1, 1);
        if (rolling.has(at)) {
            RollingFriction.give(rolling, at, body, a, b, leap[ROLL], leap[ROLL + 1]);
        }
    }

    /** {@code v += m (n sum(l) + t1 f1 + t2 f2)} and what their levers do, on one side. */
    private void give(
            double[] d, int o, int lanes, double[] body, int at, int points, int sign, int side) {
        if (at == 0) {
            return;
        }
        double sum = leap[0] + leap[1] + leap[2] + leap[3];
        double mass = sign * body[at + SolverBodies.MASS];
        int arm = side == 0 ? ARM_A : ARM_B;
        for (int axis = 0; axis < 3; axis++) {
            int x = o + axis * lanes;
            double straight = sum * d[x];
            double turn = leap[SPIN] * d[x + (TWIST + 3 * side) * lanes];
            for (int f = 0; f < 2; f++) {
                straight += leap[FRICTION + f] * d[x + (TANGENT1 + 3 * f) * lanes];
                turn += leap[FRICTION + f] * d[x + (LEVER + 6 * side + 3 * f) * lanes];
            }
            for (int p = 0; p < points; p++) {
                turn += leap[p] * d[x + (POINT + p * POINT_FIELDS + arm) * lanes];
            }
            body[at + axis] = body[at + axis] + mass * straight + 0.0;
            body[at + 3 + axis] = body[at + 3 + axis] + sign * turn + 0.0;
        }
    }
}
