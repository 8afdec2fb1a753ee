package dev.cairn.physics.solver.kernel;

import static dev.cairn.physics.solver.body.SolverBodies.MASS;
import static dev.cairn.physics.solver.row.ConstraintRows.*;

/** Friction of one contact, and the totals of the tick, in scalar arithmetic. */
public final class ScalarFriction {
    private ScalarFriction() {}

    /**
     * Friction of one contact at the patch's centre: the twist and the 2 x 2 tangent block that
     * would stop it, {@code t' = t - w/K, l' = l - K^-1 vt}, drawn back to what the patch can do,
     * see {@link PatchFriction}. Returns the sum of the normal impulses.
     */
    public static double solve(
            double[] d, int o, int lanes, double[] body, int a, int b, int points) {
        return solve(d, o, lanes, body, a, b, points, 0, 0);
    }

    /**
     * The same of surfaces that run along: it would stop {@code vt + u}.
     *
     * @param u1 by how much B's surface runs faster than A's, first tangent, m/s
     * @param u2 the same, second tangent
     */
    static double solve(
            double[] d,
            int o,
            int lanes,
            double[] body,
            int a,
            int b,
            int points,
            double u1,
            double u2) {
        double mu = d[o + FRICTION * lanes];
        double bound = 0;
        double normal = 0;
        for (int p = 0; p < points; p++) {
            double impulse = d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes];
            normal += impulse;
            bound += impulse * d[o + (REACH + p) * lanes];
        }
        bound *= mu;
        int t = o + TWIST * lanes;
        int three = 3 * lanes;
        double old = d[o + (LAMBDA + 2) * lanes];
        double speed =
                RowArithmetic.dot(d, t + three, lanes, body, b + 3)
                        - RowArithmetic.dot(d, t, lanes, body, a + 3);
        double next = bound > 0 ? old - d[o + TWIST_MASS * lanes] * speed : 0;
        // The slide is that of the spin which the patch leaves. Were it that of a spin stopped
        // whole, a top that leans on its tip would be driven by its friction.
        double held = Math.max(-bound, Math.min(next, bound));
        turn(d, t, lanes, body, a, old - held);
        turn(d, t + three, lanes, body, b, held - old);
        slide(d, o, lanes, body, a, b, mu * normal, bound, next, held, u1, u2);
        return normal;
    }

    /** Whether friction has the warm start of an impact, see {@link PatchFriction#STALE}. */
    static boolean isStale(double[] d, int o, int lanes, int points) {
        double limit = d[o + FRICTION * lanes] * RowArithmetic.sum(d, o, lanes, points);
        double f1 = d[o + LAMBDA * lanes];
        double f2 = d[o + (LAMBDA + 1) * lanes];
        return f1 * f1 + f2 * f2 > limit * limit * PatchFriction.STALE;
    }

    private static void slide(
            double[] d,
            int o,
            int lanes,
            double[] body,
            int a,
            int b,
            double limit,
            double bound,
            double twist,
            double held,
            double u1,
            double u2) {
        int three = 3 * lanes;
        int t1 = o + TANGENT1 * lanes;
        int t2 = t1 + three;
        int lever = o + LEVER * lanes;
        int l = o + LAMBDA * lanes;
        int k = o + BLOCK * lanes;
        double dx = body[b] - body[a];
        double dy = body[b + 1] - body[a + 1];
        double dz = body[b + 2] - body[a + 2];
        // vt = (vB + wB x rB - vA - wA x rA).t, with (w x r).t = w.(r x t)
        double v1 =
                dx * d[t1]
                        + dy * d[t1 + lanes]
                        + dz * d[t1 + 2 * lanes]
                        + RowArithmetic.dot(d, lever + 2 * three, lanes, body, b + 3)
                        - RowArithmetic.dot(d, lever, lanes, body, a + 3)
                        + u1;
        double v2 =
                dx * d[t2]
                        + dy * d[t2 + lanes]
                        + dz * d[t2 + 2 * lanes]
                        + RowArithmetic.dot(d, lever + 3 * three, lanes, body, b + 3)
                        - RowArithmetic.dot(d, lever + three, lanes, body, a + 3)
                        + u2;
        double f1 = d[l] - (d[k] * v1 + d[k + lanes] * v2);
        double f2 = d[l + lanes] - (d[k + lanes] * v1 + d[k + 2 * lanes] * v2);
        double size = f1 * f1 + f2 * f2;
        // the square of a very small impulse is 0
        double scale = limit > 0 ? 1 : 0;
        double twistScale = bound > 0 ? 1 : 0;
        double spin = Math.abs(twist);
        if (limit > 0 && !PatchFriction.isStuck(size, spin, limit * limit, bound)) {
            double reach = bound / limit;
            if (!PatchFriction.holds(size, spin, limit * limit, bound, reach)) {
                double mean = 0.5 * (d[k] + d[k + 2 * lanes]);
                double half = 0.5 * (d[k] - d[k + 2 * lanes]);
                double skew = d[k + lanes];
                double inertia = d[o + TWIST_MASS * lanes];
                double radius = PatchFriction.RADIUS * reach;
                double share = PatchFriction.share(Math.sqrt(size), spin, reach, mean, inertia);
                double whole =
                        (PatchFriction.FAR + PatchFriction.NEAR * share)
                                * (radius * radius)
                                * limit;
                double across =
                        Math.sqrt(PatchFriction.FAR + PatchFriction.CLOSE * share) * spin * radius;
                double give =
                        PatchFriction.give(f1, f2, across, whole, mean, half, skew, inertia, limit);
                double u = 1 / (mean * give + limit);
                double w = 1 / (inertia * give + whole + PatchFriction.LEAST);
                double b1 = give * u * half;
                double b2 = give * u * skew;
                double one = u / (1 - (b1 * b1 + b2 * b2));
                double p1 = one * ((1 - b1) * f1 - b2 * f2);
                double p2 = one * ((1 + b1) * f2 - b2 * f1);
                double q = across * w;
                // what three steps have left
                double rest = 1 / Math.sqrt(p1 * p1 + p2 * p2 + q * q);
                f1 = p1 * (limit * rest);
                f2 = p2 * (limit * rest);
                twistScale = whole * w * rest;
            }
        }
        f1 = f1 * scale + 0.0;
        f2 = f2 * scale + 0.0;
        double d1 = f1 - d[l];
        double d2 = f2 - d[l + lanes];
        double d3 = twist * twistScale + 0.0;
        d[l] = f1;
        d[l + lanes] = f2;
        d[l + 2 * lanes] = d3;
        d3 -= held;
        double px = d1 * d[t1] + d2 * d[t2];
        double py = d1 * d[t1 + lanes] + d2 * d[t2 + lanes];
        double pz = d1 * d[t1 + 2 * lanes] + d2 * d[t2 + 2 * lanes];
        int t = o + TWIST * lanes;
        if (a != 0) {
            double ma = body[a + MASS];
            body[a] = body[a] - ma * px + 0.0;
            body[a + 1] = body[a + 1] - ma * py + 0.0;
            body[a + 2] = body[a + 2] - ma * pz + 0.0;
            turn(d, t, lanes, body, a, -d3);
            turn(d, lever, lever + three, lanes, body, a, -d1, -d2);
        }
        if (b != 0) {
            double mb = body[b + MASS];
            body[b] = body[b] + mb * px + 0.0;
            body[b + 1] = body[b + 1] + mb * py + 0.0;
            body[b + 2] = body[b + 2] + mb * pz + 0.0;
            turn(d, t + three, lanes, body, b, d3);
            turn(d, lever + 2 * three, lever + 3 * three, lanes, body, b, d1, d2);
        }
    }

    private static void turn(double[] d, int t, int lanes, double[] body, int o, double delta) {
        if (o != 0) {
            body[o + 3] += delta * d[t];
            body[o + 4] += delta * d[t + lanes];
            body[o + 5] += delta * d[t + 2 * lanes];
        }
    }

    private static void turn(
            double[] d, int i, int j, int lanes, double[] body, int o, double d1, double d2) {
        body[o + 3] = body[o + 3] + (d1 * d[i] + d2 * d[j]) + 0.0;
        body[o + 4] = body[o + 4] + (d1 * d[i + lanes] + d2 * d[j + lanes]) + 0.0;
        body[o + 5] = body[o + 5] + (d1 * d[i + 2 * lanes] + d2 * d[j + 2 * lanes]) + 0.0;
    }

    public static void total(double[] d, int o, int lanes, int points) {
        for (int f = 0; f < 3; f++) {
            d[o + (TOTAL + f) * lanes] += d[o + (LAMBDA + f) * lanes];
        }
        for (int p = 0; p < points; p++) {
            d[o + (SUM + p) * lanes] += d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes];
        }
    }
}
