package dev.cairn.physics.solver.direct;

import static dev.cairn.physics.solver.row.ConstraintRows.ARM_B;
import static dev.cairn.physics.solver.row.ConstraintRows.BLOCK;
import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.row.ConstraintRows.LEVER;
import static dev.cairn.physics.solver.row.ConstraintRows.MASS;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.REACH;
import static dev.cairn.physics.solver.row.ConstraintRows.SEPARATION;
import static dev.cairn.physics.solver.row.ConstraintRows.SUM;
import static dev.cairn.physics.solver.row.ConstraintRows.TANGENT1;
import static dev.cairn.physics.solver.row.ConstraintRows.TOTAL;
import static dev.cairn.physics.solver.row.ConstraintRows.TWIST;
import static dev.cairn.physics.solver.row.ConstraintRows.TWIST_MASS;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.CommonStep;
import dev.cairn.physics.solver.kernel.Offsets;
import dev.cairn.physics.solver.kernel.PatchFriction;
import dev.cairn.physics.solver.kernel.RollingFriction;
import dev.cairn.physics.solver.kernel.RowArithmetic;
import dev.cairn.physics.solver.kernel.ScalarNormals;
import dev.cairn.physics.solver.kernel.ScalarSweep;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

/**
 * What a direct solve reads of a contact: seven constraints (four points, two tangents, the twist),
 * each with the speed that it misses and its stiffness, and its weighted Jacobian.
 *
 * <p>A body's unknown is {@code u = (v/sqrt(1/m), L^-1 w)}, so that the mass matrix is the unit
 * matrix: a constraint along n with the weighted arm a has the row {@code (sqrt(1/m) n, a)} for B
 * and its negative for A.
 *
 * <p>One thread. Does not allocate.
 */
final class DirectRow {
    /** Constraints to a contact. */
    static final int COUNT = 7;

    /**
     * Give of a hard constraint, over that of its effective mass: enough for the points of a face,
     * of which three would do, to share a load that two of them tell otherwise; the next sweeps and
     * sub-steps take what is left.
     */
    private static final double GIVE = 1e-6;

    /** Jacobians of the constraint last loaded. */
    final double[] jacobianA = new double[SkylineLdlt.BLOCK];

    final double[] jacobianB = new double[SkylineLdlt.BLOCK];

    /** Roots of the inverse masses. */
    private double rootA;

    private double rootB;

    /** Contact in work: its row, lanes, field 0, and its bodies in the state. */
    private double[] d = {};

    private double[] body = {};
    private int lanes;
    private int o;
    int a;
    int b;
    private int points;

    /** Of the constraint last loaded: where its impulse is, and the total of the tick. */
    int impulse;

    int total;

    void open(ConstraintRows rows, int place, double[] state) {
        d = rows.doubles;
        lanes = rows.lanes;
        o = rows.base(place);
        body = state;
        a = rows.link[place * ConstraintRows.LINK];
        b = rows.link[place * ConstraintRows.LINK + 1];
        points = rows.points(place);
        rootA = Math.sqrt(body[a + SolverBodies.MASS]);
        rootB = Math.sqrt(body[b + SolverBodies.MASS]);
    }

    /** Whether a body moves. */
    boolean moves(int offset) {
        return body[offset + SolverBodies.MASS] > 0;
    }

    /**
     * Of the points that press: the speed that each misses, and 1/give, which is 0 for others.
     *
     * <p>Soft, at its goal, a point has {@code v + rate s/massScale + give l = 0}, {@code give =
     * impulseScale/(m massScale)}: see {@link ScalarNormals}. An open gap may close, no more.
     *
     * @param at where those of this contact start
     * @return the largest speed that is missed, m/s
     */
    double points(SubStep sub, boolean soft, double[] miss, double[] stiffness, int at) {
        boolean fixed = !moves(a) || !moves(b);
        double massScale = fixed ? sub.fixedMassScale : sub.massScale;
        double impulseScale = fixed ? sub.fixedImpulseScale : sub.impulseScale;
        double rate = fixed ? sub.fixedRate : sub.rate;
        double worst = 0;
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * lanes;
            double s = d[q + SEPARATION * lanes];
            double mass = d[q + MASS * lanes];
            double l = d[q + IMPULSE * lanes];
            double speed = speed(o, q, q + ARM_B * lanes);
            stiffness[at + p] = l > 0 ? mass / GIVE : 0;
            if (s > sub.touch) {
                speed = soft || l > 0 ? speed + s * sub.inverse : 0;
            } else if (soft) {
                double give = impulseScale / (mass * massScale);
                speed += Math.max(s * rate, -sub.pushSpeed) / massScale + give * l;
                stiffness[at + p] = l > 0 ? 1 / give : 0;
            } else {
                speed += sub.closing;
            }
            miss[at + p] = speed;
            worst = Math.max(worst, l > 0 ? Math.abs(speed) : -speed);
        }
        for (int f = points; f < COUNT; f++) {
            stiffness[at + f] = 0;
        }
        return worst;
    }

    /** The same for friction that sticks, after the points; what slips stays as sweeps left it. */
    double friction(double[] miss, double[] stiffness, int at) {
        double normal = 0;
        double reach = 0;
        for (int p = 0; p < points; p++) {
            double l = d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes];
            normal += l;
            reach += l * d[o + (REACH + p) * lanes];
        }
        double mu = d[o + FRICTION * lanes];
        if (!(mu * normal > 0) || !sticks(mu * normal, mu * reach)) {
            return 0;
        }
        double worst = 0;
        for (int t = 0; t < 2; t++) {
            int arm = o + (LEVER + 3 * t) * lanes;
            double speed = speed(o + (TANGENT1 + 3 * t) * lanes, arm, arm + 6 * lanes);
            miss[at + 4 + t] = speed;
            stiffness[at + 4 + t] = d[o + (BLOCK + 2 * t) * lanes] / GIVE;
            worst = Math.max(worst, Math.abs(speed));
        }
        int twist = o + TWIST * lanes;
        miss[at + 6] =
                RowArithmetic.dot(d, twist + 3 * lanes, lanes, body, b + 3)
                        - RowArithmetic.dot(d, twist, lanes, body, a + 3);
        stiffness[at + 6] = d[o + TWIST_MASS * lanes] / GIVE;
        return worst;
    }

    private boolean sticks(double limit, double bound) {
        double f1 = d[o + LAMBDA * lanes];
        double f2 = d[o + (LAMBDA + 1) * lanes];
        double spin = Math.abs(d[o + (LAMBDA + 2) * lanes]);
        double size = f1 * f1 + f2 * f2;
        double square = limit * limit;
        return PatchFriction.isStuck(size, spin, square, bound)
                || PatchFriction.holds(size, spin, square, bound, bound / limit);
    }

    /** Speed of B against A along what is at {@code n}. */
    private double speed(int n, int armA, int armB) {
        return d[n] * (body[b] - body[a])
                + d[n + lanes] * (body[b + 1] - body[a + 1])
                + d[n + 2 * lanes] * (body[b + 2] - body[a + 2])
                + RowArithmetic.dot(d, armB, lanes, body, b + 3)
                - RowArithmetic.dot(d, armA, lanes, body, a + 3);
    }

    /** Loads the Jacobians of a constraint: a point, from 4 on a tangent, 6 the twist. */
    void load(int f) {
        int n = o;
        double linear = 1;
        int armA = o + (POINT + f * POINT_FIELDS) * lanes;
        int armB = armA + ARM_B * lanes;
        impulse = armA + IMPULSE * lanes;
        total = o + (SUM + f) * lanes;
        if (f >= 4) {
            impulse = o + (LAMBDA + f - 4) * lanes;
            total = o + (TOTAL + f - 4) * lanes;
            boolean twists = f == 6;
            linear = twists ? 0 : 1;
            n = o + (TANGENT1 + (twists ? 0 : 3 * (f - 4))) * lanes;
            armA = o + (twists ? TWIST : LEVER + 3 * (f - 4)) * lanes;
            armB = armA + (twists ? 3 : 6) * lanes;
        }
        for (int k = 0; k < 3; k++) {
            double direction = linear * d[n + k * lanes];
            jacobianA[k] = -rootA * direction;
            jacobianB[k] = rootB * direction;
            jacobianA[3 + k] = -d[armA + k * lanes];
            jacobianB[3 + k] = d[armB + k * lanes];
        }
    }

    /**
     * Changes the impulse of the constraint last loaded, and with it the bodies.
     *
     * @param pushes whether it may not become negative
     * @param counts whether the change is one of the tick's total
     */
    void change(double delta, boolean pushes, boolean counts) {
        double old = d[impulse];
        double now = old + delta;
        d[impulse] = pushes && !(now > 0) ? 0 : now;
        double change = d[impulse] - old;
        if (counts) {
            d[total] += change;
        }
        if (moves(a)) {
            move(a, rootA, jacobianA, change);
        }
        if (moves(b)) {
            move(b, rootB, jacobianB, change);
        }
    }

    private void move(int offset, double root, double[] jacobian, double change) {
        for (int k = 0; k < 3; k++) {
            body[offset + k] += root * jacobian[k] * change;
            body[offset + 3 + k] += jacobian[3 + k] * change;
        }
    }

    /**
     * What the points that press have learnt of their load, at the end of a tick, instead of what
     * {@link Offsets} says: a share of the mean gap, open or closed, is taken out of all. Where a
     * column is solved exactly it gives way as slowly as its whole mass moves, so that a share of
     * what overlaps would overshoot; and a share of its tilt would drive it as it sways.
     */
    void learn(ContactStore c, int source, SubStep sub) {
        double stiffness = sub.stiffness(!moves(a) || !moves(b));
        double sum = 0;
        int pressing = 0;
        for (int p = 0; p < points; p++) {
            if (d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes] > 0) {
                sum += c.separation[ContactStore.POINTS * source + p];
                pressing++;
            }
        }
        double share = pressing > 0 ? sub.offsetGain * sum / pressing : 0;
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * lanes;
            if (d[q + IMPULSE * lanes] > 0) {
                double k = d[q + MASS * lanes] * stiffness;
                int at = ContactStore.POINTS * source + p;
                double known = k * (c.separation[at] - d[o + (ConstraintRows.GAP + p) * lanes]);
                double learnt = known - k * share;
                c.preload[at] = learnt > 0 ? learnt : 0;
            }
        }
    }

    /** One more sweep of the bias pass. */
    void sweepSoft(SubStep sub, double[] st) {
        boolean fixed = !moves(a) || !moves(b);
        ScalarNormals.soften(d, o, lanes, points, fixed, sub, st);
        ScalarNormals.sweep(d, o, lanes, body, a, b, points, sub.sweeps, CommonStep.NONE, st);
        if (RowArithmetic.sum(d, o, lanes, points) > 0) {
            body[a + SolverBodies.LOADED] = a == 0 ? 0 : 1;
            body[b + SolverBodies.LOADED] = b == 0 ? 0 : 1;
        }
    }

    /** One more sweep of the relax pass. */
    void sweepHard(SubStep sub, double[] st) {
        ScalarSweep.hard(d, o, lanes, body, a, b, points, sub, sub.sweeps, CommonStep.NONE, st);
        for (int p = 0; p < points; p++) {
            d[o + (SUM + p) * lanes] += st[Scratch.CHANGE + p];
        }
        if (d[o + FRICTION * lanes] > 0) {
            RollingFriction.solve(d, o, lanes, body, a, b, points);
        }
    }
}
