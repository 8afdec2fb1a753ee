package dev.cairn.physics.solver.impact;

import static dev.cairn.physics.solver.row.ConstraintRows.COUNT;
import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;
import static dev.cairn.physics.solver.row.ConstraintRows.SUM;
import static dev.cairn.physics.solver.row.ConstraintRows.TOTAL;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.AxisLocks;
import dev.cairn.physics.solver.body.DrivenSides;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.kernel.RowArithmetic;
import dev.cairn.physics.solver.kernel.ScalarFriction;
import dev.cairn.physics.solver.kernel.WarmStart;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.solver.row.RowWindow;
import dev.cairn.physics.tuning.Tunable;

import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * Impacts that bounce, before the contacts of a sub-step are solved.
 *
 * <p>A contact with restitution {@code e > 0} whose surfaces meet within the sub-step at time
 * {@code t}, faster than the threshold, takes its impulse at that time: Newton's law for all points
 * of the manifold that touch then, {@code v'_i >= -e v_i}, solved to convergence, and then friction
 * bounded by that impulse. The speed is the one at the impact, {@code v_i = -sqrt(v² - 2 a s)}, so
 * gravity within the sub-step neither adds nor takes energy. A velocity change {@code dv} at time t
 * is the same path as a change now and a shift of the start by {@code -t dv}: so the rest of the
 * sub-step is flown without a loss of time, and impacts may follow each other in any order. The
 * contact solver then finds the contact parting, and adds only what other bodies press onto it; so
 * it does with what still closes after the last round, without a bounce.
 *
 * <p>With one restitution for a manifold, the law never adds energy: {@code dE = (1 - e)/2 l.v <=
 * 0}.
 */
public final class Impacts {
    /**
     * Points within this share of the patch's radius of the surface at the time of impact take part
     * in it.
     */
    public static final double FLUSH = 0.005;

    /**
     * Share of a gap that is rounding, by precision: what the contact solver would take for a
     * contact must be an impact here.
     */
    public static final double SOON = 1e-9;

    static final double SOON_SINGLE = 1e-6;

    private final double[] acceleration = new double[6];
    private final BallImpacts balls = new BallImpacts(this);

    /** By contact of the batch: its impacts in this sub-step. */
    private int[] met = {};

    /** Velocities of both bodies before the impact. */
    private final double[] before = new double[12];

    private final MultiPointImpact impact = new MultiPointImpact();
    private final ImpactLevers levers = new ImpactLevers();

    private double soon;

    /** A gain of energy that is rounding, over the energy. */
    private static final double GAIN = 1e-12;

    /**
     * Share of its own acceleration that contacts take from a body that they carry. What leans on a
     * wall falls as if the wall were not there; of what lies on the ground nothing is left.
     */
    private static final double CARRIED = 0.1;

    private final RowWindow window = new RowWindow();
    private ConstraintRows rows = new EdgeList().doubles;

    /** Whether joints may carry a body, by slot. */
    private IntPredicate isJointed = slot -> false;

    /** Size of gravity, m/s², and length of the sub-step in work, s. */
    private double gravity;

    private double subStep;

    // the contact in work
    private ConstraintRows look = rows;
    private SolverBodies bodies = new SolverBodies();
    private BodyStore store = new BodyStore();
    private ContactStore contacts = new ContactStore();
    private double[] d = {};
    private double[] body = {};

    /** Of the row in work, in the rows that were opened. */
    private int rowPlace;

    private int place;
    private int o;
    private int lanes;
    private int a;
    private int b;
    private int points;

    /**
     * Handles all impacts of one sub-step of a batch, in the order of the list, until none is left.
     * What one contact does depends on those of its island alone.
     *
     * @param bouncer contacts with restitution, among others
     * @param impactLimits of each, in a sub-step, at most
     * @param from where those of the batch start
     * @param h length of the sub-step, s
     * @param jointed whether joints may carry a body, by slot
     * @return whether there was one: bodies have moved
     */
    public boolean run(
            SolverContext tick,
            ConstraintRows constraintRows,
            int[] bouncer,
            int[] impactLimits,
            int from,
            int to,
            double h,
            IntPredicate jointed) {
        rows = constraintRows;
        isJointed = jointed;
        bodies = tick.body;
        store = tick.bodies;
        contacts = tick.contacts;
        body = bodies.state;
        soon = rows.isSingle ? SOON_SINGLE : SOON;
        gravity = tick.weight();
        subStep = h;
        double threshold = tick.settings.get(Tunable.RESTITUTION_THRESHOLD);
        balls.begin(constraintRows, tick, bouncer, to, h, threshold);
        if (met.length < to - from) {
            met = new int[bouncer.length];
        }
        Arrays.fill(met, 0, to - from, 0);
        boolean any = false;
        boolean again = true;
        while (again) {
            again = false;
            for (int k = from; k < to; k++) {
                if (met[k - from] < impactLimits[k] && meets(tick, bouncer[k], k, h, threshold)) {
                    met[k - from]++;
                    again = true;
                }
            }
            any |= again;
        }
        for (int k = from; k < to && any; k++) {
            if (met[k - from] > 0 && !balls.isPair(bouncer[k])) {
                open(bouncer[k]);
                lift(tick.gravity, h);
            }
        }
        return any;
    }

    /**
     * Starts a body higher that an impact has left closing with something static, so that the
     * contact will press before the sub-step ends. Its start is that of the parabola which leads to
     * the surface at the time t of the impact; but what presses moves in a straight line, and would
     * come to lie {@code a t²/2} below.
     */
    private void lift(double[] g, double h) {
        if (a != 0 && b != 0) {
            return;
        }
        int at = a + b;
        if (!bodies.isMoved(at)) {
            return;
        }
        double an = along(g);
        double time = bodies.impactTime[SolverBodies.slot(at)];
        double height = -0.5 * an * time * time;
        if (!(height > 0)) {
            return;
        }
        boolean presses = false;
        for (int p = 0; p < points; p++) {
            double v = impact.speed(p) + h * an;
            double gap = impact.gap(p) + height;
            presses |= (gap > 0 ? gap + h * v : v) < 0;
        }
        double up = b == 0 ? -height : height;
        for (int c = 0; c < 3 && presses; c++) {
            body[at + SolverBodies.P + c] += up * d[o + c * lanes];
        }
    }

    /** Relative acceleration along the normal of the row in work. */
    private double along(double[] g) {
        accelerate(a, g, acceleration, 0);
        accelerate(b, g, acceleration, 3);
        double[] f = acceleration;
        return d[o] * (f[3] - f[0])
                + d[o + lanes] * (f[4] - f[1])
                + d[o + 2 * lanes] * (f[5] - f[2]);
    }

    private boolean meets(SolverContext tick, int row, int k, double h, double threshold) {
        if (balls.isPair(row)) {
            return balls.visit(k);
        }
        if (isSlow(row, threshold)) {
            return false;
        }
        open(row);
        double restitution = tick.contacts.restitution[rows.list.source[row]];
        if (!impact(restitution, tick.gravity, h, threshold)) {
            return false;
        }
        int at = rows.list.place[row];
        window.close(rows, at);
        rows.rolling.drop(rows, bodies.warm, at, at);
        return true;
    }

    /** Whether no two points of the bodies of a row meet faster than the threshold. */
    private boolean isSlow(int row, double threshold) {
        int i = rows.list.slotA[row];
        int j = rows.list.slotB[row];
        double side = DrivenSides.fastest(bodies, rows.list.side[row]);
        double first = i < 0 ? side : bodies.fastest[i];
        double second = j < 0 ? side : bodies.fastest[j];
        return first + second < threshold;
    }

    /**
     * Whether a batch has impacts of two balls, whose gaps are mended even where they do not meet.
     *
     * @param bouncer contacts with restitution, among others
     * @param from where those of the batch start
     */
    public static boolean hasBalls(
            SolverContext tick, EdgeList list, int[] bouncer, int from, int to) {
        for (int k = from; k < to; k++) {
            if (BallImpacts.isPair(tick.bodies, tick.contacts, list.source[bouncer[k]])) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether a body of a batch is fast enough to bounce in the next sub-step.
     *
     * @param sides kinematic bodies that move
     * @param head first of its bodies, see {@link SolverContext#order}
     */
    public static boolean isFast(SolverContext tick, DrivenSides sides, int head, int tail) {
        double slow = 0.5 * tick.settings.get(Tunable.RESTITUTION_THRESHOLD);
        if (sides.isFast(tick.body, slow)) {
            return true;
        }
        for (int k = head; k < tail; k++) {
            if (!(tick.body.fastest[tick.order[k]] < slow)) {
                return true;
            }
        }
        return false;
    }

    /** End of the tick, when the rows are stored. */
    public void report() {
        balls.report();
    }

    private void open(int row) {
        look = window.open(rows, rows.list.place[row]);
        rowPlace = rows.list.place[row];
        place = window.place();
        d = look.doubles;
        lanes = look.lanes;
        o = look.base(place);
        a = look.link[place * LINK];
        b = look.link[place * LINK + 1];
        points = look.link[place * LINK + COUNT];
        impact.open(look, place, body);
    }

    private boolean impact(double restitution, double[] g, double h, double threshold) {
        double an = along(g);
        double time = Double.POSITIVE_INFINITY;
        for (int p = 0; p < points; p++) {
            time = Math.min(time, timeOfImpact(impact.gap(p), impact.speed(p), an, h, threshold));
        }
        if (time == Double.POSITIVE_INFINITY) {
            return false;
        }
        double flush = FLUSH * RowArithmetic.reach(d, o, lanes, points);
        for (int p = 0; p < points; p++) {
            double v = impact.speed(p);
            double now = impact.gap(p);
            double at = now + time * (v + 0.5 * time * an);
            impact.goal[p] = at <= flush + soon * now ? 0 : Double.NaN;
        }
        takeOut();
        boolean met =
                levers.open(look, place, store, contacts, bodies, impact.goal, time, acceleration);
        for (int p = 0; p < points; p++) {
            if (!Double.isNaN(impact.goal[p])) {
                impact.goal[p] = Math.max(0, -restitution * (impact.speed(p) + time * an));
            }
        }
        strike(time, time * an);
        if (met) {
            bodies.collided[SolverBodies.slot(a)] = true;
            bodies.collided[SolverBodies.slot(b)] = true;
            levers.close();
        }
        return true;
    }

    /**
     * Root of {@code s + v t + a t²/2}, or infinity where the surfaces do not meet faster than the
     * threshold.
     *
     * <p>The contact solver foresees the movement {@code h (v + h a)}, a little more than the path
     * itself; what it would stop is an impact of this sub-step, though the root may lie a little
     * beyond its end.
     */
    private double timeOfImpact(double s, double v, double a, double h, double threshold) {
        if (v >= 0) {
            return Double.POSITIVE_INFINITY;
        }
        if (s <= 0) {
            return v < -threshold ? 0 : Double.POSITIVE_INFINITY;
        }
        if (s + h * (v + h * a) > soon * s) {
            return Double.POSITIVE_INFINITY;
        }
        double square = v * v - 2 * a * s;
        if (!(square > threshold * threshold)) {
            return Double.POSITIVE_INFINITY;
        }
        return 2 * s / (Math.sqrt(square) - v);
    }

    /**
     * Acceleration of a body between impacts: its own, less what its contacts have taken along it
     * in the last sub-step; none while they carry it, or joints do.
     */
    void accelerate(int at, double[] g, double[] destination, int out) {
        double m = body[at + SolverBodies.MASS];
        int slot = bodies.isMoved(at) ? SolverBodies.slot(at) : 0;
        double k = m > 0 ? body[at + SolverBodies.GRAVITY] * store.gravityScale[slot] : 0;
        double x = k * g[0] + m * store.forceX[slot];
        double y = k * g[1] + m * store.forceY[slot];
        double z = k * g[2] + m * store.forceZ[slot];
        double left = 1;
        if (body[at + SolverBodies.LOADED] != 0) {
            // a.a_c/a^2, with what the contacts did to the velocity, h a_c
            int w = at >> 1;
            double along =
                    (bodies.warm(w) * x + bodies.warm(w + 1) * y + bodies.warm(w + 2) * z)
                            / subStep;
            double square = x * x + y * y + z * z;
            boolean carried = !(Math.abs(along) < CARRIED * square) || isJointed.test(slot);
            left = carried ? 0 : 1 + along / square;
        }
        destination[out] = left * x;
        destination[out + 1] = left * y;
        destination[out + 2] = left * z;
    }

    /** The contact starts the sub-step without impulses. */
    private void takeOut() {
        rows.drags.give(look, place, rowPlace);
        WarmStart.addNormals(look, bodies.warm, place, o, -1);
        WarmStart.addFriction(look, bodies.warm, place, o, -1);
        for (int p = 0; p < points; p++) {
            d[impact.point(p) + IMPULSE * lanes] = 0;
        }
        for (int k = 0; k < 3; k++) {
            d[o + (LAMBDA + k) * lanes] = 0;
        }
    }

    /**
     * The impulses of one impact, {@code early} the speed that acceleration adds until then, and
     * the shift of the start.
     */
    private void strike(double time, double early) {
        System.arraycopy(body, a, before, 0, 6);
        System.arraycopy(body, b, before, 6, 6);
        impact.uniform(early);
        impact.newton(early);
        boolean hasFriction = d[o + FRICTION * lanes] > 0;
        if (hasFriction) {
            ScalarFriction.solve(d, o, lanes, body, a, b, points);
        }
        double share = shareWithoutGain(time);
        for (int p = 0; p < points; p++) {
            d[o + (SUM + p) * lanes] += share * d[impact.point(p) + IMPULSE * lanes];
            d[impact.point(p) + IMPULSE * lanes] = 0;
        }
        for (int k = 0; k < 3 && hasFriction; k++) {
            d[o + (TOTAL + k) * lanes] += share * d[o + (LAMBDA + k) * lanes];
            d[o + (LAMBDA + k) * lanes] = 0;
        }
        AxisLocks.lock(store, bodies.state, a);
        AxisLocks.lock(store, bodies.state, b);
        shift(a, before, 0, time);
        shift(b, before, 6, time);
    }

    /**
     * An impact adds no energy: with the velocities {@code v} when it meets and their change {@code
     * c}, in coordinates in which the kinetic energy is half a square, a gain {@code 2 v.c + c² >
     * 0} is cut to where the energy is least, {@code v + s c}, {@code s = max(0, -v.c/c²)}.
     * Newton's law with one coefficient gains nothing if it is solved to the end; several points of
     * a slender body may need more rounds than there are.
     *
     * @return s, by which the bodies' changes have been scaled
     */
    private double shareWithoutGain(double time) {
        double energy = 0;
        double along = 0;
        double square = 0;
        for (int side = 0; side < 2; side++) {
            int at = side == 0 ? a : b;
            double mass = at == 0 ? 0 : 1 / body[at + SolverBodies.MASS];
            for (int c = 0; c < 6 && at != 0; c++) {
                double old = before[6 * side + c];
                double v = c < 3 ? old + time * acceleration[3 * side + c] : old;
                double change = body[at + c] - old;
                double weight = c < 3 ? mass : 1;
                energy += weight * (v * v);
                along += weight * (v * change);
                square += weight * (change * change);
            }
        }
        if (!(2 * along + square > GAIN * energy)) {
            return 1;
        }
        double share = Math.max(0, -along / square);
        for (int side = 0; side < 2; side++) {
            int at = side == 0 ? a : b;
            for (int c = 0; c < 6 && at != 0; c++) {
                double old = before[6 * side + c];
                body[at + c] = old + share * (body[at + c] - old);
            }
        }
        return share;
    }

    /**
     * Moves the start of a body's path back by {@code time} times its change of velocity.
     *
     * @param old holds the velocities before, at {@code q}
     */
    public void shift(int at, double[] old, int q, double time) {
        if (!bodies.isMoved(at)) {
            return;
        }
        int slot = SolverBodies.slot(at);
        bodies.impactTime[slot] = time;
        // what was slow may meet its next neighbour fast now
        bodies.limit(store, slot, gravity, subStep);
        ImpactStart.shift(store, bodies, at, old, q, time);
    }

    /** Time of the last impact of the body at {@code at} in this sub-step; 0 if there was none. */
    double since(int at) {
        return at == 0 ? 0 : bodies.impactTime[SolverBodies.slot(at)];
    }
}
