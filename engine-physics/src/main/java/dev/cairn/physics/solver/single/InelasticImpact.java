package dev.cairn.physics.solver.single;

import static dev.cairn.physics.solver.row.ConstraintRows.*;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.AxisLocks;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.impact.ImpactStart;
import dev.cairn.physics.solver.impact.Impacts;
import dev.cairn.physics.solver.impact.MultiPointImpact;
import dev.cairn.physics.solver.kernel.RowArithmetic;
import dev.cairn.physics.solver.kernel.ScalarFriction;
import dev.cairn.physics.solver.kernel.ScalarNormals;
import dev.cairn.physics.solver.kernel.WarmStart;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.solver.row.RollingRows;

/**
 * Points that land, of a body that rocks on its only contact, which is with a static body: their
 * impact, without a bounce, at its own time inside the sub-step.
 *
 * <p>Problem: the soft step closes a gap at most to zero, so that an edge that comes down is
 * stopped over two sub-steps, with the levers of before and after, while the edge on which the body
 * rocked still has its warm start. Housner's block kept 5 % too little or too much of its speed.
 *
 * <p>Until the impact at {@code t}, the contact presses as in the last sub-step: it gets that share
 * {@code j = t/h l} of its warm start, and no more of it. Then all points that touch, {@code v'_i
 * >= 0}, and friction, swept until they agree, with normal levers of the pose at t. With {@code dv}
 * the change of velocity by the impact and f that by j, the same path is a start with {@code v + f
 * + dv} at {@code x - t dv - t f/2}, as in {@link Impacts}. Gravity then pulls from the start of
 * the sub-step on, and what landed is held from t on: that is made up for along the normal.
 *
 * <p>Not what lands from flight: its points then lie at a gap of zero but for rounding, and whether
 * they are soft or hard in the next sub-step would hang on that. Only what lands faster than
 * gravity and forces make it in a sub-step, and while gaps close as {@link Impacts} has it. One
 * body at a time, any worker. Does not allocate. Source: G. W. Housner, "The behavior of inverted
 * pendulum structures during earthquakes" (1963), for the law; own study.
 */
final class InelasticImpact {
    /** Change of an impulse over the largest one at which normals and friction agree. */
    private static final double AGREES = 1e-12;

    private final MultiPointImpact impact = new MultiPointImpact();
    private final ImpactStart start = new ImpactStart();

    /** Six zeros for static bodies, then acceleration of the body: without its contact. */
    private final double[] free = new double[12];

    /** The same with its contact as in the last sub-step. */
    private final double[] held = new double[12];

    private final double[] before = new double[6];

    /** By point: separation at the time of the impact. */
    private final double[] reached = new double[ContactStore.POINTS];

    /** By point: its normal lever and mass at the start. */
    private final double[] kept = new double[4 * ContactStore.POINTS];

    // the body in work
    private BodyStore store = new BodyStore();
    private SolverBodies bodies = new SolverBodies();
    private ContactStore contacts = new ContactStore();
    private ConstraintRows rows = new EdgeList().doubles;
    private RollingRows rolling = rows.rolling;
    private int rollingAt;
    private double[] d = {};
    private double[] body = {};
    private int place;
    private int o;
    private int lanes;
    private int slot;
    private int at;
    private boolean isA;
    private int points;

    /** Whether a row has a point that presses, and one that is open and does not. */
    static boolean isAwaited(ConstraintRows rows, int place) {
        int o = rows.base(place);
        int n = rows.points(place);
        boolean opens = false;
        boolean presses = false;
        for (int p = 0; p < n; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * rows.lanes;
            boolean idle = rows.get(q + IMPULSE * rows.lanes) == 0;
            presses |= !idle;
            opens |= idle && rows.get(q + SEPARATION * rows.lanes) > 0;
        }
        return opens && presses;
    }

    /**
     * The impacts of one sub-step, before its kick.
     *
     * @param i slot of the body
     * @param row place of its only row, among rows of doubles
     * @param rowRolling place of that row in {@code rowsRolling}
     * @param rounds most rounds of normals and friction
     * @return whether there was one
     */
    boolean run(
            SolverContext tick,
            ConstraintRows constraintRows,
            RollingRows rowsRolling,
            int row,
            int rowRolling,
            int i,
            double h,
            int rounds) {
        rolling = rowsRolling;
        rollingAt = rowRolling;
        store = tick.bodies;
        bodies = tick.body;
        contacts = tick.contacts;
        rows = constraintRows;
        d = rows.doubles;
        lanes = rows.lanes;
        place = row;
        o = rows.base(place);
        body = bodies.state;
        slot = i;
        at = SolverBodies.offset(i);
        isA = rows.link[place * LINK] == at;
        points = rows.points(place);
        impact.open(rows, place, body);
        boolean any = false;
        for (int n = 0; n < points; n++) {
            accelerate(tick.gravity, 1 / h);
            double time = firstTime(h);
            if (!(time <= h)) {
                break;
            }
            strike(time, h, rounds);
            any = true;
        }
        return any;
    }

    private void accelerate(double[] g, double perSecond) {
        double m = body[at + SolverBodies.MASS];
        double k = body[at + SolverBodies.GRAVITY] * store.gravityScale[slot];
        free[6] = k * g[0] + m * store.forceX[slot];
        free[7] = k * g[1] + m * store.forceY[slot];
        free[8] = k * g[2] + m * store.forceZ[slot];
        double x = store.torqueX[slot];
        double y = store.torqueY[slot];
        double z = store.torqueZ[slot];
        double[] r = bodies.root;
        int q = (slot + 1) * SolverBodies.ROOT;
        int w = (slot + 1) * SolverBodies.HALF;
        for (int c = 0; c < 3; c++) {
            free[9 + c] = r[q + c] * x + r[q + 3 + c] * y + r[q + 6 + c] * z;
        }
        for (int c = 0; c < 6; c++) {
            held[6 + c] = free[6 + c] + perSecond * bodies.warm[w + c];
        }
        AxisLocks.lock(store, free, 6, slot);
        AxisLocks.lock(store, held, 6, slot);
    }

    /** Component of an acceleration along the normal at a point. */
    private double along(int p, double[] acceleration) {
        return impact.along(p, acceleration, isA ? 6 : 0, isA ? 0 : 6);
    }

    /** When the first point lands; infinite if none does. */
    private double firstTime(double h) {
        double least = h * Math.sqrt(free[6] * free[6] + free[7] * free[7] + free[8] * free[8]);
        double time = Double.POSITIVE_INFINITY;
        for (int p = 0; p < points; p++) {
            int q = impact.point(p);
            double s = d[q + SEPARATION * lanes];
            double v = impact.speed(p);
            double a = along(p, held);
            if (s > 0 && d[q + IMPULSE * lanes] == 0 && s + h * (v + h * a) <= 0) {
                double square = v * v - 2 * a * s;
                if (square > least * least) {
                    time = Math.min(time, 2 * s / (Math.sqrt(square) - v));
                }
            }
        }
        return time >= 0 ? time : Double.POSITIVE_INFINITY;
    }

    private void strike(double time, double h, int rounds) {
        double radius = RowArithmetic.reach(d, o, lanes, points);
        for (int p = 0; p < points; p++) {
            double s = d[impact.point(p) + SEPARATION * lanes];
            reached[p] = s + time * (impact.speed(p) + 0.5 * time * along(p, held));
            boolean touches = reached[p] <= Impacts.FLUSH * radius + Impacts.SOON * s;
            impact.goal[p] = touches ? 0 : Double.NaN;
        }
        press(time / h);
        for (int c = 0; c < 6; c++) {
            before[c] = body[at + c] + 0.5 * time * (held[6 + c] - free[6 + c]);
            body[at + c] += time * held[6 + c];
        }
        turnLevers(time);
        impact.uniform(0);
        agree(rounds);
        ScalarFriction.total(d, o, lanes, points);
        for (int c = 0; c < 6; c++) {
            body[at + c] -= time * free[6 + c];
        }
        AxisLocks.lock(store, body, at);
        ImpactStart.shift(store, bodies, at, before, 0, time);
        start.fit(store, bodies, SolverBodies.slot(at), false);
        turnBack();
        lift();
        rows.forget(place);
    }

    /** Gives the contact a share of its warm start; no more of it is left. */
    private void press(double share) {
        WarmStart.addNormals(rows, bodies.warm, place, o, -1);
        WarmStart.addFriction(rows, bodies.warm, place, o, -1);
        rolling.drop(rows, bodies.warm, place, rollingAt);
        for (int p = 0; p < points; p++) {
            d[o + (SUM + p) * lanes] += share * d[impact.point(p) + IMPULSE * lanes];
        }
        for (int k = 0; k < 3; k++) {
            d[o + (TOTAL + k) * lanes] += share * d[o + (LAMBDA + k) * lanes];
        }
        rows.forget(place);
    }

    /** Normals, and friction bounded by them, until no impulse changes. */
    private void agree(int rounds) {
        for (int round = 0; round < rounds; round++) {
            double change = impact.newton(0);
            if (!(d[o + FRICTION * lanes] > 0)) {
                return;
            }
            double x = d[o + LAMBDA * lanes];
            double y = d[o + (LAMBDA + 1) * lanes];
            int link = place * LINK;
            ScalarFriction.solve(d, o, lanes, body, rows.link[link], rows.link[link + 1], points);
            change = Math.max(change, Math.abs(d[o + LAMBDA * lanes] - x));
            change = Math.max(change, Math.abs(d[o + (LAMBDA + 1) * lanes] - y));
            if (!(change > AGREES * RowArithmetic.largest(d, o, lanes, points))) {
                return;
            }
        }
    }

    /**
     * Turns the normal levers with the body, to first order. Seen from the body the normal turns
     * back instead: {@code L^T (r x (n + t n x w))}.
     */
    private void turnLevers(double time) {
        int first = ContactStore.POINTS * rows.link[place * LINK + SOURCE];
        double wx = bodies.world(slot, at + 3, 0);
        double wy = bodies.world(slot, at + 3, 1);
        double wz = bodies.world(slot, at + 3, 2);
        double x = time * (d[o + lanes] * wz - d[o + 2 * lanes] * wy);
        double y = time * (d[o + 2 * lanes] * wx - d[o] * wz);
        double z = time * (d[o] * wy - d[o + lanes] * wx);
        double[] r = bodies.root;
        int k = (slot + 1) * SolverBodies.ROOT;
        for (int p = 0; p < points; p++) {
            int c = first + p;
            double rx = isA ? contacts.anchorAX(c) : contacts.anchorBX(c);
            double ry = isA ? contacts.anchorAY(c) : contacts.anchorBY(c);
            double rz = isA ? contacts.anchorAZ(c) : contacts.anchorBZ(c);
            double u = ry * z - rz * y;
            double v = rz * x - rx * z;
            double w = rx * y - ry * x;
            int q = impact.point(p);
            int lever = q + (isA ? ARM_A : ARM_B) * lanes;
            double inverse = d[o + (isA ? MASS_A : MASS_B) * lanes];
            kept[4 * p] = d[q + MASS * lanes];
            for (int j = 0; j < 3; j++) {
                double old = d[lever + j * lanes];
                double now = old + (r[k + j] * u + r[k + 3 + j] * v + r[k + 6 + j] * w);
                kept[4 * p + 1 + j] = old;
                d[lever + j * lanes] = now;
                inverse += now * now;
            }
            d[q + MASS * lanes] = inverse > 0 ? 1 / inverse : 0;
        }
    }

    private void turnBack() {
        for (int p = 0; p < points; p++) {
            int q = impact.point(p);
            int lever = q + (isA ? ARM_A : ARM_B) * lanes;
            d[q + MASS * lanes] = kept[4 * p];
            for (int j = 0; j < 3; j++) {
                d[lever + j * lanes] = kept[4 * p + 1 + j];
            }
        }
    }

    /** Puts the points that took the impact where they were then, or above. */
    private void lift() {
        int link = place * LINK;
        ScalarNormals.separate(d, o, lanes, body, rows.link[link], rows.link[link + 1], points);
        double height = 0;
        for (int p = 0; p < points; p++) {
            int q = impact.point(p);
            if (d[q + IMPULSE * lanes] > 0) {
                height = Math.max(height, reached[p] - d[q + SEPARATION * lanes]);
            }
        }
        double signed = isA ? -height : height;
        for (int k = 0; k < 3; k++) {
            body[at + SolverBodies.P + k] += signed * d[o + k * lanes];
        }
        for (int p = 0; p < points; p++) {
            d[impact.point(p) + SEPARATION * lanes] += height;
        }
    }
}
