package dev.cairn.physics.solver.row;

import static dev.cairn.physics.solver.row.ConstraintRows.BLOCK;
import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;
import static dev.cairn.physics.solver.row.ConstraintRows.MASS_A;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.TANGENT1;
import static dev.cairn.physics.solver.row.ConstraintRows.TANGENT2;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.RollingFriction;

import java.util.Arrays;

/**
 * Rolling friction of the rows whose materials have an arm b: levers, impulses and warm start,
 * beside the rows. {@link RollingFriction} solves it.
 *
 * <p>Two impulses to a row, along the tangents: torques on B about axes in the contact plane, and
 * their opposites on A. With r the weighted tangents {@code L^T t} of both bodies and f the levers
 * of friction, {@code K_rr = r.r, K_rf = r.f, K_ff = f.f}. A roll that friction keeps from slipping
 * has the inverse inertia {@code K_rr - K_rf K_ff^-1 K_fr}, of a ball {@code 1/(I + m R²)}; one
 * that slips has {@code K_rr}.
 *
 * <p>What several points hold by their normals, as those of a face hold a tilt, is not rolling
 * friction's to hold: else both would share it at random. So K is made softer by {@code S/b²}, in
 * its own size, with S the variance of where the points press, across the axis: a wheel's axis
 * keeps its K, the other axis has hardly any rolling friction, a face none but about an edge that
 * carries all. A ball has one point and no S.
 *
 * <p>A third impulse is about the normal, where there is one point: a patch has friction against a
 * spin by its size, a point has none, and a ball would spin where it lies for ever, and carry round
 * what lies on it. What rolls with an arm b stands on a disc of that radius.
 *
 * <p>Doubles, for rows of either precision. By place; only once a material with an arm has been in
 * the world. Does not allocate but for that.
 */
public final class RollingRows {
    /** Arm, m; 0 where there is no rolling friction, and then nothing else is current. */
    public static final int ARM = 0;

    /** Rolling impulses of the sub-step along the tangents, N m s. */
    public static final int LAMBDA = 1;

    /** K_rr: 11, 12, 22. */
    public static final int FREE = 3;

    /** The same where friction holds; 0 where there is no friction. */
    public static final int HELD = 6;

    /** K_rf: 11, 12, 21, 22. */
    public static final int COUPLING = 9;

    /** Weighted tangents: A t1, A t2, B t1, B t2. */
    public static final int LEVER = 13;

    /** The impulses to come. */
    public static final int NEXT = 25;

    /** {@code S/b²} now: 11, 12, 22. */
    private static final int SOFT = 27;

    /** By point: where it is along the tangents, m. */
    private static final int PLACE = 30;

    /** Sum of the normal impulses when the sub-step began, N s. */
    public static final int BEFORE = 38;

    /** Impulse about the normal, of a row of one point, N m s. */
    public static final int SPIN = 39;

    /** Weighted normals: of A, of B. */
    public static final int AXIS = 40;

    private static final int STRIDE = 46;

    /** Determinant over the square of the trace of a block that is as good as singular. */
    private static final double SINGULAR = 1e-12;

    /** What is added to the diagonal of such a one, over its trace. */
    private static final double EASE = 1e-9;

    /** A contact whose normal impulse is so many times that before has had an impact. */
    private static final double JUMP = 4;

    /** The bound of rolling friction but for rounding. */
    private static final double FULL = 1 - 1e-9;

    /** Whether there is any. */
    public boolean isUsed;

    private double[] data = {};

    /** Before a tick. */
    public void begin(boolean used, int places) {
        isUsed = used;
        if (used && data.length < STRIDE * places) {
            data = new double[STRIDE * places];
        }
    }

    /** Whether the row at a place has rolling friction. */
    public boolean has(int place) {
        return isUsed && data[STRIDE * place] > 0;
    }

    public double get(int place, int field) {
        return data[STRIDE * place + field];
    }

    public void put(int place, int field, double value) {
        data[STRIDE * place + field] = value;
    }

    /**
     * Fills what belongs to a range of rows, after them, and adds the last impulses to the warm
     * start.
     */
    public void fill(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore c,
            double scale,
            int from,
            int to) {
        for (int j = from; j < to; j++) {
            int source = rows.link[j * LINK + ConstraintRows.SOURCE];
            double arm = rows.points(j) > 0 ? c.rollingArm[source] : 0;
            data[STRIDE * j] = arm;
            if (arm > 0) {
                levers(rows, bodies, c, j);
                put(j, BEFORE, normal(rows, j));
                for (int k = 0; k < 2; k++) {
                    data[STRIDE * j + LAMBDA + k] = scale * along(rows, j, k, c, source);
                }
                put(j, SPIN, rows.points(j) == 1 ? scale * about(rows, j, c, source) : 0);
                addWarm(rows, bodies.warm, j, j, 1);
            }
        }
    }

    public static double normal(ConstraintRows rows, int j) {
        int o = rows.base(j) + (POINT + ConstraintRows.IMPULSE) * rows.lanes;
        double sum = 0;
        for (int p = 0; p < rows.points(j); p++) {
            sum += rows.get(o + p * POINT_FIELDS * rows.lanes);
        }
        return sum;
    }

    /**
     * Share of its rolling impulse that a contact starts the next sub-step with: the impulse of a
     * impact is no guess for what comes after it.
     *
     * @param normal sum of the normal impulses now
     */
    public double carried(int at, double normal) {
        double before = get(at, BEFORE);
        return normal > JUMP * before ? before / normal : 1;
    }

    private static double along(ConstraintRows rows, int j, int k, ContactStore c, int source) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            sum += tangent(rows, j, k, axis) * c.rollingImpulse[3 * source + axis];
        }
        return sum;
    }

    private static double about(ConstraintRows rows, int j, ContactStore c, int source) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            sum += normal(rows, j, axis) * c.rollingImpulse[3 * source + axis];
        }
        return sum;
    }

    private static double normal(ConstraintRows rows, int j, int axis) {
        return rows.get(rows.base(j) + axis * rows.lanes);
    }

    private static double tangent(ConstraintRows rows, int j, int k, int axis) {
        int t = (k == 0 ? TANGENT1 : TANGENT2) + axis;
        return rows.get(rows.base(j) + t * rows.lanes);
    }

    /** After the row at place {@code j} has been renewed; its impulses were taken out before. */
    public void renew(ConstraintRows rows, SolverBodies bodies, ContactStore c, int j) {
        levers(rows, bodies, c, j);
        addWarm(rows, bodies.warm, j, j, 1);
    }

    /** Takes the impulses of a row out of the warm start, and forgets them. */
    public void drop(ConstraintRows rows, double[] warm, int place, int at) {
        if (has(at)) {
            addWarm(rows, warm, place, at, -1);
            scale(at, 0);
        }
    }

    /** Scales the impulses of a row, if it has some. */
    public void scale(int at, double share) {
        put(at, LAMBDA, share * get(at, LAMBDA));
        put(at, LAMBDA + 1, share * get(at, LAMBDA + 1));
        put(at, SPIN, share * get(at, SPIN));
    }

    /** As {@link #drop}, of a row that has been turned to another normal. */
    public void aim(ConstraintRows rows, SolverBodies bodies, ContactStore c, int j) {
        drop(rows, bodies.warm, j, j);
        if (has(j)) {
            levers(rows, bodies, c, j);
        }
    }

    /**
     * Adds what the impulses of a row do to its bodies, times {@code sign}.
     *
     * @param rows has the row at {@code place}
     * @param at its place here
     */
    public void addWarm(ConstraintRows rows, double[] warm, int place, int at, double sign) {
        double f1 = sign * get(at, LAMBDA);
        double f2 = sign * get(at, LAMBDA + 1);
        double f3 = sign * get(at, SPIN);
        int q = STRIDE * at + LEVER;
        int n = STRIDE * at + AXIS;
        for (int side = 0; side < 2; side++, q += 6, n += 3) {
            int body = rows.link[place * LINK + side];
            int w = (body >> 1) + 3;
            for (int k = 0; k < 3 && body != 0; k++) {
                double change = f1 * data[q + k] + f2 * data[q + 3 + k] + f3 * data[n + k];
                warm[w + k] += side == 0 ? -change : change;
            }
        }
    }

    /** Writes the impulses of a range of rows to their contacts. */
    public void store(ConstraintRows rows, ContactStore c, int from, int to) {
        for (int j = from; j < to; j++) {
            if (has(j)) {
                int source = rows.link[j * LINK + ConstraintRows.SOURCE];
                double share = carried(j, normal(rows, j));
                for (int axis = 0; axis < 3; axis++) {
                    c.rollingImpulse[3 * source + axis] =
                            share
                                    * (get(j, LAMBDA) * tangent(rows, j, 0, axis)
                                            + get(j, LAMBDA + 1) * tangent(rows, j, 1, axis)
                                            + get(j, SPIN) * normal(rows, j, axis));
                }
            }
        }
    }

    private void levers(ConstraintRows rows, SolverBodies bodies, ContactStore c, int j) {
        int q = STRIDE * j;
        places(rows, c, j);
        for (int side = 0; side < 2; side++) {
            int k = (rows.link[j * LINK + side] >> 4) * SolverBodies.ROOT;
            for (int i = 0; i < 3; i++) {
                double first = 0;
                double second = 0;
                double third = 0;
                for (int axis = 0; axis < 3; axis++) {
                    double root = bodies.root[k + 3 * axis + i];
                    first += root * tangent(rows, j, 0, axis);
                    second += root * tangent(rows, j, 1, axis);
                    third += root * normal(rows, j, axis);
                }
                data[q + LEVER + 6 * side + i] = first;
                data[q + LEVER + 6 * side + 3 + i] = second;
                data[q + AXIS + 3 * side + i] = third;
            }
        }
        for (int n = 0; n < 3; n++) {
            data[q + FREE + n] = product(q, n / 2, (n + 1) / 2);
            data[q + HELD + n] = 0;
        }
        int o = rows.base(j);
        if (rows.get(o + FRICTION * rows.lanes) > 0) {
            hold(rows, o, q);
        }
    }

    /** Where the points are, from the first one: on a body that moves, with which they turn. */
    private void places(ConstraintRows rows, ContactStore c, int j) {
        int first =
                ContactStore.anchor(
                        ContactStore.POINTS * rows.link[j * LINK + ConstraintRows.SOURCE]);
        if (rows.get(rows.base(j) + MASS_A * rows.lanes) == 0) {
            first += ContactStore.ANCHORS / 2;
        }
        for (int p = 0; p < rows.points(j); p++) {
            int q = first + p * (ContactStore.anchor(1) - ContactStore.anchor(0));
            double x = c.anchors[q] - c.anchors[first];
            double y = c.anchors[q + 1] - c.anchors[first + 1];
            double z = c.anchors[q + 2] - c.anchors[first + 2];
            for (int k = 0; k < 2; k++) {
                data[STRIDE * j + PLACE + 2 * p + k] =
                        x * tangent(rows, j, k, 0)
                                + y * tangent(rows, j, k, 1)
                                + z * tangent(rows, j, k, 2);
            }
        }
    }

    /** K where friction holds. */
    private void hold(ConstraintRows rows, int o, int q) {
        for (int n = 0; n < 4; n++) {
            data[q + COUPLING + n] = coupling(rows, o, q, n / 2, n % 2);
        }
        double b11 = rows.get(o + BLOCK * rows.lanes);
        double b12 = rows.get(o + (BLOCK + 1) * rows.lanes);
        double b22 = rows.get(o + (BLOCK + 2) * rows.lanes);
        double c11 = data[q + COUPLING];
        double c12 = data[q + COUPLING + 1];
        double c21 = data[q + COUPLING + 2];
        double c22 = data[q + COUPLING + 3];
        // K_ff^-1 K_fr
        double g11 = b11 * c11 + b12 * c12;
        double g21 = b12 * c11 + b22 * c12;
        double g12 = b11 * c21 + b12 * c22;
        double g22 = b12 * c21 + b22 * c22;
        data[q + HELD] = data[q + FREE] - (c11 * g11 + c12 * g21);
        data[q + HELD + 1] = data[q + FREE + 1] - (c11 * g12 + c12 * g22);
        data[q + HELD + 2] = data[q + FREE + 2] - (c21 * g12 + c22 * g22);
    }

    private double product(int q, int m, int n) {
        double sum = 0;
        for (int side = 0; side < 12; side += 6) {
            int i = q + LEVER + side + 3 * m;
            int k = q + LEVER + side + 3 * n;
            sum += data[i] * data[k] + data[i + 1] * data[k + 1] + data[i + 2] * data[k + 2];
        }
        return sum;
    }

    /** Of rolling about tangent m with the lever of friction along tangent n. */
    private double coupling(ConstraintRows rows, int o, int q, int m, int n) {
        double sum = 0;
        for (int side = 0; side < 12; side += 6) {
            for (int c = 0; c < 3; c++) {
                int lever = ConstraintRows.LEVER + side + 3 * n + c;
                sum += data[q + LEVER + side + 3 * m + c] * rows.get(o + lever * rows.lanes);
            }
        }
        return sum;
    }

    /**
     * Finds how much normals hold by themselves, and what rolling friction may hold.
     *
     * @param rows has the row at {@code place}
     * @return b N, N m s
     */
    public double bound(ConstraintRows rows, int place, int at) {
        int q = STRIDE * at;
        int points = rows.points(place);
        int o = rows.base(place) + (POINT + ConstraintRows.IMPULSE) * rows.lanes;
        int next = POINT_FIELDS * rows.lanes;
        double normal = normal(rows, place);
        double xx = 0;
        double xy = 0;
        double yy = 0;
        // sum over pairs, so that one point that presses has no variance at all
        for (int m = 1; m < points; m++) {
            for (int n = 0; n < m; n++) {
                double l = rows.get(o + m * next) * rows.get(o + n * next);
                double x = data[q + PLACE + 2 * m] - data[q + PLACE + 2 * n];
                double y = data[q + PLACE + 2 * m + 1] - data[q + PLACE + 2 * n + 1];
                xx += l * x * x;
                xy += l * x * y;
                yy += l * y * y;
            }
        }
        double bound = data[q + ARM] * normal;
        double k = bound > 0 ? 1 / (bound * bound) : 0;
        // about the first tangent a shift along the second counts
        data[q + SOFT] = k * yy;
        data[q + SOFT + 1] = -k * xy;
        data[q + SOFT + 2] = k * xx;
        return bound;
    }

    /**
     * The torque on a body of a row if rolling friction does all it can, so that the body rolls.
     *
     * @param rows has the row at {@code place}
     * @param at its place here
     * @param side 1 for the second body, -1 for the first
     * @param torque receives it, world, N m s
     * @return whether it does; without rolling friction it does nothing, and that is all
     */
    public boolean slips(ConstraintRows rows, int place, int at, double side, double[] torque) {
        Arrays.fill(torque, 0.0);
        if (!has(at)) {
            return true;
        }
        double bound = bound(rows, place, at);
        double l1 = get(at, LAMBDA);
        double l2 = get(at, LAMBDA + 1);
        for (int axis = 0; axis < 3; axis++) {
            double t1 = tangent(rows, place, 0, axis);
            double t2 = tangent(rows, place, 1, axis);
            torque[axis] = side * (l1 * t1 + l2 * t2 + get(at, SPIN) * normal(rows, place, axis));
        }
        return Math.sqrt(l1 * l1 + l2 * l2) >= FULL * bound;
    }

    /**
     * By how much rolling friction could change the speed of a body beyond what it did: {@code |df|
     * / m} for the friction that follows a torque to its bound.
     *
     * @param share of its bound that friction took
     * @param other what is returned if friction took more of its bound than rolling friction did
     * @return m/s
     */
    public double left(
            ConstraintRows rows, int place, int at, double mass, double share, double other) {
        double bound = bound(rows, place, at);
        double l1 = get(at, LAMBDA);
        double l2 = get(at, LAMBDA + 1);
        double size = Math.sqrt(l1 * l1 + l2 * l2);
        if (!(size > bound * share)) {
            return other;
        }
        double y1 = get(at, COUPLING) * l1 + get(at, COUPLING + 2) * l2;
        double y2 = get(at, COUPLING + 1) * l1 + get(at, COUPLING + 3) * l2;
        int k = rows.base(place) + BLOCK * rows.lanes;
        double f1 = rows.get(k) * y1 + rows.get(k + rows.lanes) * y2;
        double f2 = rows.get(k + rows.lanes) * y1 + rows.get(k + 2 * rows.lanes) * y2;
        return Math.sqrt(f1 * f1 + f2 * f2) * mass * (bound / size - 1);
    }

    /**
     * The impulses that stop a roll, drawn back to the bound: {@code l' = l - (K + S)^-1 (w + S
     * l)}.
     *
     * @param block {@link #FREE} or {@link #HELD}
     * @param w1 speed about the first tangent, rad/s
     * @return whether there is such a block
     */
    public boolean next(int at, int block, double w1, double w2, double bound) {
        int q = STRIDE * at;
        double l1 = data[q + LAMBDA];
        double l2 = data[q + LAMBDA + 1];
        double trace = data[q + block] + data[q + block + 2];
        double s11 = 0.5 * trace * data[q + SOFT];
        double s12 = 0.5 * trace * data[q + SOFT + 1];
        double s22 = 0.5 * trace * data[q + SOFT + 2];
        double k11 = data[q + block] + s11;
        double k12 = data[q + block + 1] + s12;
        double k22 = data[q + block + 2] + s22;
        double all = k11 + k22;
        if (!(k11 * k22 - k12 * k12 > SINGULAR * (all * all))) {
            // a body that may not turn about some axis
            k11 += EASE * all;
            k22 += EASE * all;
        }
        double determinant = k11 * k22 - k12 * k12;
        if (!(trace > 0 && determinant > 0)) {
            data[q + NEXT] = 0;
            data[q + NEXT + 1] = 0;
            return false;
        }
        double inverse = 1 / determinant;
        double u = w1 + (s11 * l1 + s12 * l2);
        double v = w2 + (s12 * l1 + s22 * l2);
        double n1 = l1 - inverse * (k22 * u - k12 * v);
        double n2 = l2 - inverse * (k11 * v - k12 * u);
        double size = Math.sqrt(n1 * n1 + n2 * n2);
        double scale = size > bound ? bound / size : 1;
        data[q + NEXT] = n1 * scale;
        data[q + NEXT + 1] = n2 * scale;
        return true;
    }
}
