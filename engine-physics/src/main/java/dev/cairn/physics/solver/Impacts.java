package dev.cairn.physics.solver;

import static dev.cairn.physics.solver.ConstraintRows.GAP;
import static dev.cairn.physics.solver.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.ConstraintRows.LINK;
import static dev.cairn.physics.solver.ConstraintRows.POINT;
import static dev.cairn.physics.solver.ConstraintRows.ROW;
import static dev.cairn.physics.solver.ConstraintRows.STRIKE;
import static dev.cairn.physics.solver.ConstraintRows.TOTAL;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

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
    private static final int SWEEPS = 64;

    /**
     * Points within this share of the patch's radius of the surface at the time of impact take part
     * in it.
     */
    private static final double FLUSH = 0.005;

    /** Share of a gap that is rounding. */
    private static final double SOON = 1e-9;

    private final double[] acceleration = new double[6];

    /** Handles all impacts of one sub-step, in row order, until none is left. */
    void run(
            ConstraintRows rows,
            SolverBodies bodies,
            BodyStore store,
            double[] g,
            double h,
            double threshold) {
        int n = rows.bouncing;
        boolean again = n > 0;
        for (int round = 0; again && round < ROUNDS; round++) {
            again = false;
            for (int k = 0; k < n; k++) {
                again |= impact(rows, rows.bouncer[k], bodies, store, g, h, threshold);
            }
        }
    }

    private boolean impact(
            ConstraintRows rows,
            int m,
            SolverBodies bodies,
            BodyStore store,
            double[] g,
            double h,
            double threshold) {
        double[] d = rows.row;
        double[] q = rows.point;
        double[] body = bodies.state;
        int r = m * ROW;
        int a = rows.link[m * LINK];
        int b = rows.link[m * LINK + 1];
        accelerate(body, store, a, g, 0);
        accelerate(body, store, b, g, 3);
        double[] f = acceleration;
        double an = d[r] * (f[3] - f[0]) + d[r + 1] * (f[4] - f[1]) + d[r + 2] * (f[5] - f[2]);
        int first = ContactStore.POINTS * m * POINT;
        int end = first + rows.link[m * LINK + ConstraintRows.COUNT] * POINT;
        double time = Double.POSITIVE_INFINITY;
        for (int o = first; o < end; o += POINT) {
            time =
                    Math.min(
                            time,
                            timeOfImpact(
                                    gap(d, r, q, o, body, a, b),
                                    speed(d, r, q, o, body, a, b),
                                    an,
                                    h,
                                    threshold));
        }
        if (time == Double.POSITIVE_INFINITY) {
            return false;
        }
        double flush = FLUSH * d[r + ConstraintRows.RADIUS];
        for (int o = first; o < end; o += POINT) {
            double v = speed(d, r, q, o, body, a, b);
            double now = gap(d, r, q, o, body, a, b);
            double at = now + time * (v + 0.5 * time * an);
            // the wanted speed after the impact; NaN for points that do not touch then
            q[o + STRIKE] =
                    at <= flush + SOON * now
                            ? Math.max(0, -d[r + ConstraintRows.RESTITUTION] * (v + time * an))
                            : Double.NaN;
        }
        strike(rows, m, body, store, time, time * an);
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
    private static double timeOfImpact(double s, double v, double a, double h, double threshold) {
        if (v >= 0) {
            return Double.POSITIVE_INFINITY;
        }
        if (s <= 0) {
            return v < -threshold ? 0 : Double.POSITIVE_INFINITY;
        }
        if (s + h * (v + h * a) > SOON * s) {
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
    private void accelerate(double[] body, BodyStore store, int o, double[] g, int out) {
        boolean flies = body[o + SolverBodies.MASS] > 0 && body[o + SolverBodies.LOADED] == 0;
        double m = flies ? body[o + SolverBodies.MASS] : 0;
        double k = flies ? body[o + SolverBodies.GRAVITY] : 0;
        int slot = o / SolverBodies.STRIDE;
        acceleration[out] = k * g[0] + m * store.forceX[slot];
        acceleration[out + 1] = k * g[1] + m * store.forceY[slot];
        acceleration[out + 2] = k * g[2] + m * store.forceZ[slot];
    }

    /**
     * The impulses of one impact, {@code early} the speed that acceleration adds until then, and
     * the shift of the start.
     */
    private static void strike(
            ConstraintRows rows, int m, double[] body, BodyStore store, double time, double early) {
        double[] d = rows.row;
        double[] q = rows.point;
        int r = m * ROW;
        int a = rows.link[m * LINK];
        int b = rows.link[m * LINK + 1];
        double ax = body[a];
        double ay = body[a + 1];
        double az = body[a + 2];
        double au = body[a + 3];
        double av = body[a + 4];
        double aw = body[a + 5];
        double bx = body[b];
        double by = body[b + 1];
        double bz = body[b + 2];
        double bu = body[b + 3];
        double bv = body[b + 4];
        double bw = body[b + 5];
        int first = ContactStore.POINTS * m * POINT;
        int end = first + rows.link[m * LINK + ConstraintRows.COUNT] * POINT;
        for (int o = first; o < end; o += POINT) {
            q[o + IMPULSE] = 0;
        }
        uniform(rows, m, body, first, end, early);
        newton(rows, m, body, first, end, early);
        double normal = 0;
        for (int o = first; o < end; o += POINT) {
            normal += q[o + IMPULSE];
            q[o + ConstraintRows.SUM] += q[o + IMPULSE];
        }
        d[r + LAMBDA] = 0;
        d[r + LAMBDA + 1] = 0;
        d[r + LAMBDA + 2] = 0;
        if (d[r + ConstraintRows.FRICTION] > 0) {
            RowKernels.friction(rows, m, body, normal);
            for (int k = 0; k < 3; k++) {
                d[r + TOTAL + k] += d[r + LAMBDA + k];
                d[r + LAMBDA + k] = 0;
            }
        }
        for (int o = first; o < end; o += POINT) {
            q[o + IMPULSE] = 0;
        }
        shift(body, store, a, ax, ay, az, au, av, aw, time);
        shift(body, store, b, bx, by, bz, bu, bv, bw, time);
    }

    /**
     * First guess: the same impulse at all points that touch, such that their mean speed is right.
     * A flat symmetric impact is solved by it, so that its symmetry does not drown in the order of
     * the points.
     */
    private static void uniform(
            ConstraintRows rows, int m, double[] body, int first, int end, double early) {
        double[] d = rows.row;
        double[] q = rows.point;
        int r = m * ROW;
        int a = rows.link[m * LINK];
        int b = rows.link[m * LINK + 1];
        double miss = 0;
        double response = 0;
        int n = 0;
        for (int o = first; o < end; o += POINT) {
            if (Double.isNaN(q[o + STRIKE])) {
                continue;
            }
            n++;
            miss += speed(d, r, q, o, body, a, b) + early - q[o + STRIKE];
            for (int k = first; k < end; k += POINT) {
                if (!Double.isNaN(q[k + STRIKE])) {
                    response += PrepareRow.dot(q, o, q, k + 6) + PrepareRow.dot(q, o + 3, q, k + 9);
                }
            }
        }
        response += (double) n * n * (d[r + ConstraintRows.MASS_A] + d[r + ConstraintRows.MASS_B]);
        double impulse = -miss / response;
        for (int o = first; impulse > 0 && o < end; o += POINT) {
            if (!Double.isNaN(q[o + STRIKE])) {
                q[o + IMPULSE] = impulse;
                push(d, r, q, o, body, a, b, impulse);
            }
        }
    }

    /** {@code v_i + early >= goal_i, l_i >= 0}, complementary, by Gauss-Seidel to convergence. */
    private static void newton(
            ConstraintRows rows, int m, double[] body, int first, int end, double early) {
        double[] d = rows.row;
        double[] q = rows.point;
        int r = m * ROW;
        int a = rows.link[m * LINK];
        int b = rows.link[m * LINK + 1];
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            double largest = 0;
            double sum = 0;
            for (int o = first; o < end; o += POINT) {
                double goal = q[o + STRIKE];
                if (Double.isNaN(goal)) {
                    continue;
                }
                double v = speed(d, r, q, o, body, a, b) + early;
                double old = q[o + IMPULSE];
                double next = Math.max(0, old - q[o + ConstraintRows.MASS] * (v - goal));
                double delta = next - old;
                q[o + IMPULSE] = next;
                largest = Math.max(largest, Math.abs(delta));
                sum += next;
                push(d, r, q, o, body, a, b, delta);
            }
            if (largest <= 1e-15 * sum) {
                return;
            }
        }
    }

    private static void push(
            double[] d, int r, double[] q, int o, double[] body, int a, int b, double impulse) {
        double ma = impulse * d[r + ConstraintRows.MASS_A];
        double mb = impulse * d[r + ConstraintRows.MASS_B];
        for (int k = 0; k < 3; k++) {
            body[a + k] -= ma * d[r + k];
            body[a + 3 + k] -= impulse * q[o + 6 + k];
            body[b + k] += mb * d[r + k];
            body[b + 3 + k] += impulse * q[o + 9 + k];
        }
    }

    /** Moves the start of a body's path back by {@code time} times its change of velocity. */
    private static void shift(
            double[] body,
            BodyStore store,
            int o,
            double x,
            double y,
            double z,
            double u,
            double v,
            double w,
            double time) {
        if (!(time > 0) || body[o + SolverBodies.MASS] == 0) {
            return;
        }
        body[o + SolverBodies.P] -= time * (body[o] - x);
        body[o + SolverBodies.P + 1] -= time * (body[o + 1] - y);
        body[o + SolverBodies.P + 2] -= time * (body[o + 2] - z);
        double tu = -time * (body[o + 3] - u);
        double tv = -time * (body[o + 4] - v);
        double tw = -time * (body[o + 5] - w);
        body[o + SolverBodies.P + 3] += tu;
        body[o + SolverBodies.P + 4] += tv;
        body[o + SolverBodies.P + 5] += tw;
        Rotation.turn(store, o / SolverBodies.STRIDE, tu, tv, tw);
    }

    private static double gap(double[] d, int r, double[] q, int o, double[] body, int a, int b) {
        return q[o + GAP] + along(d, r, q, o, body, a + SolverBodies.P, b + SolverBodies.P);
    }

    private static double speed(double[] d, int r, double[] q, int o, double[] body, int a, int b) {
        return along(d, r, q, o, body, a, b);
    }

    /**
     * {@code n.(yB - yA) + uB.(rB x n) - uA.(rA x n)} of the pairs (y, u) at {@code a} and {@code
     * b}.
     */
    private static double along(double[] d, int r, double[] q, int o, double[] body, int a, int b) {
        return d[r] * (body[b] - body[a])
                + d[r + 1] * (body[b + 1] - body[a + 1])
                + d[r + 2] * (body[b + 2] - body[a + 2])
                + PrepareRow.dot(body, b + 3, q, o + 3)
                - PrepareRow.dot(body, a + 3, q, o);
    }
}
