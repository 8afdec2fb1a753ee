package dev.cairn.physics.solver;

import static dev.cairn.physics.solver.ConstraintRows.ARM_A;
import static dev.cairn.physics.solver.ConstraintRows.ARM_B;
import static dev.cairn.physics.solver.ConstraintRows.COUNT;
import static dev.cairn.physics.solver.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.ConstraintRows.GAP;
import static dev.cairn.physics.solver.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.ConstraintRows.LINK;
import static dev.cairn.physics.solver.ConstraintRows.MASS;
import static dev.cairn.physics.solver.ConstraintRows.MASS_A;
import static dev.cairn.physics.solver.ConstraintRows.MASS_B;
import static dev.cairn.physics.solver.ConstraintRows.POINT;
import static dev.cairn.physics.solver.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.ConstraintRows.REACH;
import static dev.cairn.physics.solver.ConstraintRows.SUM;
import static dev.cairn.physics.solver.ConstraintRows.TOTAL;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

import java.util.Arrays;

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
final class Impacts {
    private static final int ROUNDS = 16;

    /** Few contacts may take more rounds, up to so many visits of a contact in a sub-step. */
    private static final int VISITS = 16384;

    private static final int SWEEPS = 64;

    /**
     * Points within this share of the patch's radius of the surface at the time of impact take part
     * in it.
     */
    private static final double FLUSH = 0.005;

    /**
     * Share of a gap that is rounding, by precision: what the contact solver would take for a
     * contact must be an impact here.
     */
    static final double SOON = 1e-9;

    static final double SOON_SINGLE = 1e-6;

    private final double[] acceleration = new double[6];
    private final BallImpacts balls = new BallImpacts(this);

    /** By slot: time of the body's last impact in this sub-step, s. */
    private double[] since = {};

    /** Velocities of both bodies before the impact. */
    private final double[] before = new double[12];

    /** The wanted speeds after the impact; NaN for points that do not touch then. */
    private final double[] goal = new double[ContactStore.POINTS];

    private double soon;
    private final RowWindow window = new RowWindow();
    private ConstraintRows rows = new RowList().doubles;

    // the contact in work
    private ConstraintRows look = rows;
    private SolverBodies bodies = new SolverBodies();
    private BodyStore store = new BodyStore();
    private double[] d = {};
    private double[] body = {};
    private int place;
    private int o;
    private int lanes;
    private int a;
    private int b;
    private int points;

    /**
     * Handles all impacts of one sub-step, in row order, until none is left.
     *
     * @return whether there was one: bodies have moved
     */
    boolean run(
            ConstraintRows constraintRows,
            SolverBodies solverBodies,
            BodyStore bodyStore,
            ContactStore contacts,
            double[] g,
            double h,
            double threshold) {
        rows = constraintRows;
        bodies = solverBodies;
        store = bodyStore;
        body = bodies.state;
        soon = rows.isSingle ? SOON_SINGLE : SOON;
        balls.begin(constraintRows, solverBodies, bodyStore, contacts, g, h, threshold);
        if (since.length < bodyStore.slotCount) {
            since = new double[bodyStore.kind.length];
        }
        Arrays.fill(since, 0, bodyStore.slotCount, 0.0);
        int n = rows.bouncing;
        boolean any = false;
        boolean again = n > 0;
        int rounds = n == 0 ? 0 : Math.max(ROUNDS, VISITS / n);
        for (int round = 0; again && round < rounds; round++) {
            again = false;
            for (int k = 0; k < n; k++) {
                int row = rows.bouncer[k];
                if (balls.isPair(row)) {
                    again |= balls.visit(k);
                } else {
                    open(row);
                    boolean met =
                            impact(contacts.restitution[rows.list.source[row]], g, h, threshold);
                    if (met) {
                        window.close(rows, rows.list.place[row]);
                    }
                    again |= met;
                }
            }
            any |= again;
        }
        return any;
    }

    /** End of the tick, when the rows are stored. */
    void report() {
        balls.report();
    }

    private void open(int row) {
        look = window.open(rows, rows.list.place[row]);
        place = window.place();
        d = look.doubles;
        lanes = look.lanes;
        o = look.base(place);
        a = look.link[place * LINK];
        b = look.link[place * LINK + 1];
        points = look.link[place * LINK + COUNT];
    }

    private int point(int p) {
        return o + (POINT + p * POINT_FIELDS) * lanes;
    }

    private boolean impact(double restitution, double[] g, double h, double threshold) {
        accelerate(a, g, acceleration, 0);
        accelerate(b, g, acceleration, 3);
        double[] f = acceleration;
        double an =
                d[o] * (f[3] - f[0])
                        + d[o + lanes] * (f[4] - f[1])
                        + d[o + 2 * lanes] * (f[5] - f[2]);
        double time = Double.POSITIVE_INFINITY;
        double radius = 0;
        for (int p = 0; p < points; p++) {
            time = Math.min(time, timeOfImpact(gap(p), speed(p), an, h, threshold));
            radius = Math.max(radius, d[o + (REACH + p) * lanes]);
        }
        if (time == Double.POSITIVE_INFINITY) {
            return false;
        }
        double flush = FLUSH * radius;
        for (int p = 0; p < points; p++) {
            double v = speed(p);
            double now = gap(p);
            double at = now + time * (v + 0.5 * time * an);
            goal[p] =
                    at <= flush + soon * now
                            ? Math.max(0, -restitution * (v + time * an))
                            : Double.NaN;
        }
        strike(time, time * an);
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
     * Acceleration of a body between impacts: its own when it flies, none while contacts carry it.
     */
    void accelerate(int at, double[] g, double[] destination, int out) {
        double m = 0;
        double k = 0;
        if (body[at + SolverBodies.MASS] > 0 && body[at + SolverBodies.LOADED] == 0) {
            m = body[at + SolverBodies.MASS];
            k = body[at + SolverBodies.GRAVITY];
        }
        int slot = Math.max(0, SolverBodies.slot(at));
        k *= store.gravityScale[slot];
        destination[out] = k * g[0] + m * store.forceX[slot];
        destination[out + 1] = k * g[1] + m * store.forceY[slot];
        destination[out + 2] = k * g[2] + m * store.forceZ[slot];
    }

    /**
     * The impulses of one impact, {@code early} the speed that acceleration adds until then, and
     * the shift of the start. The contact starts the sub-step without impulses.
     */
    private void strike(double time, double early) {
        System.arraycopy(body, a, before, 0, 6);
        System.arraycopy(body, b, before, 6, 6);
        WarmStart.addNormals(look, bodies.warm, place, o, -1);
        WarmStart.addFriction(look, bodies.warm, place, o, -1);
        for (int p = 0; p < points; p++) {
            d[point(p) + IMPULSE * lanes] = 0;
        }
        for (int k = 0; k < 3; k++) {
            d[o + (LAMBDA + k) * lanes] = 0;
        }
        uniform(early);
        newton(early);
        for (int p = 0; p < points; p++) {
            d[o + (SUM + p) * lanes] += d[point(p) + IMPULSE * lanes];
        }
        if (d[o + FRICTION * lanes] > 0) {
            ScalarFriction.rub(d, o, lanes, body, a, b, points);
            for (int k = 0; k < 3; k++) {
                d[o + (TOTAL + k) * lanes] += d[o + (LAMBDA + k) * lanes];
                d[o + (LAMBDA + k) * lanes] = 0;
            }
        }
        for (int p = 0; p < points; p++) {
            d[point(p) + IMPULSE * lanes] = 0;
        }
        Restraint.lock(store, bodies.state, a);
        Restraint.lock(store, bodies.state, b);
        shift(a, before, 0, time);
        shift(b, before, 6, time);
    }

    /**
     * First guess: the same impulse at all points that touch, such that their mean speed is right.
     * A flat symmetric impact is solved by it, so that its symmetry does not drown in the order of
     * the points.
     */
    private void uniform(double early) {
        double miss = 0;
        double response = 0;
        int n = 0;
        for (int p = 0; p < points; p++) {
            if (Double.isNaN(goal[p])) {
                continue;
            }
            n++;
            miss += speed(p) + early - goal[p];
            int q = point(p);
            for (int i = 0; i < points; i++) {
                if (!Double.isNaN(goal[i])) {
                    int r = point(i);
                    for (int k = 0; k < 6; k++) {
                        response += d[q + k * lanes] * d[r + k * lanes];
                    }
                }
            }
        }
        response += (double) n * n * (d[o + MASS_A * lanes] + d[o + MASS_B * lanes]);
        double impulse = -miss / response;
        for (int p = 0; impulse > 0 && p < points; p++) {
            if (!Double.isNaN(goal[p])) {
                d[point(p) + IMPULSE * lanes] = impulse;
                push(p, impulse);
            }
        }
    }

    /** {@code v_i + early >= goal_i, l_i >= 0}, complementary, by Gauss-Seidel to convergence. */
    private void newton(double early) {
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            double largest = 0;
            double sum = 0;
            for (int p = 0; p < points; p++) {
                if (Double.isNaN(goal[p])) {
                    continue;
                }
                int q = point(p);
                double v = speed(p) + early;
                double old = d[q + IMPULSE * lanes];
                double next = Math.max(0, old - d[q + MASS * lanes] * (v - goal[p]));
                double delta = next - old;
                d[q + IMPULSE * lanes] = next;
                largest = Math.max(largest, Math.abs(delta));
                sum += next;
                push(p, delta);
            }
            if (largest <= 1e-15 * sum) {
                return;
            }
        }
    }

    private void push(int p, double impulse) {
        int q = point(p);
        double ma = impulse * d[o + MASS_A * lanes];
        double mb = impulse * d[o + MASS_B * lanes];
        for (int k = 0; k < 3; k++) {
            if (a != 0) {
                body[a + k] -= ma * d[o + k * lanes];
                body[a + 3 + k] -= impulse * d[q + (ARM_A + k) * lanes];
            }
            if (b != 0) {
                body[b + k] += mb * d[o + k * lanes];
                body[b + 3 + k] += impulse * d[q + (ARM_B + k) * lanes];
            }
        }
    }

    /**
     * Moves the start of a body's path back by {@code time} times its change of velocity.
     *
     * @param old holds the velocities before, at {@code q}
     */
    void shift(int at, double[] old, int q, double time) {
        if (at == 0) {
            return;
        }
        since[SolverBodies.slot(at)] = time;
        if (!(time > 0)) {
            return;
        }
        int p = at + SolverBodies.P;
        double tu = -time * (body[at + 3] - old[q + 3]);
        double tv = -time * (body[at + 4] - old[q + 4]);
        double tw = -time * (body[at + 5] - old[q + 5]);
        body[p] -= time * (body[at] - old[q]);
        body[p + 1] -= time * (body[at + 1] - old[q + 1]);
        body[p + 2] -= time * (body[at + 2] - old[q + 2]);
        body[p + 3] += tu;
        body[p + 4] += tv;
        body[p + 5] += tw;
        int k = (at >> 4) * SolverBodies.ROOT;
        double[] r = bodies.root;
        Rotation.turn(
                store,
                SolverBodies.slot(at),
                r[k] * tu + r[k + 1] * tv + r[k + 2] * tw,
                r[k + 3] * tu + r[k + 4] * tv + r[k + 5] * tw,
                r[k + 6] * tu + r[k + 7] * tv + r[k + 8] * tw);
    }

    /** Time of the last impact of the body at {@code at} in this sub-step; 0 if there was none. */
    double since(int at) {
        return at == 0 ? 0 : since[SolverBodies.slot(at)];
    }

    private double gap(int p) {
        return d[o + (GAP + p) * lanes] + along(p, a + SolverBodies.P, b + SolverBodies.P);
    }

    private double speed(int p) {
        return along(p, a, b);
    }

    /** {@code n.(yB - yA) + uB.armB - uA.armA} of the pairs (y, u) at {@code i} and {@code j}. */
    private double along(int p, int i, int j) {
        int q = point(p);
        return d[o] * (body[j] - body[i])
                + d[o + lanes] * (body[j + 1] - body[i + 1])
                + d[o + 2 * lanes] * (body[j + 2] - body[i + 2])
                + ScalarNormals.dot(d, q + ARM_B * lanes, lanes, body, j + 3)
                - ScalarNormals.dot(d, q + ARM_A * lanes, lanes, body, i + 3);
    }
}
