package dev.cairn.physics.solver.kernel;

import static dev.cairn.physics.solver.body.SolverBodies.P;
import static dev.cairn.physics.solver.row.ConstraintRows.*;
import static dev.cairn.physics.solver.row.Scratch.*;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.SubStep;

/**
 * Normal impulses of one contact in scalar arithmetic.
 *
 * <p>With {@code v} the speed of separation at a point <i>without the impulses of its contact</i>,
 * a sweep gives the point the impulse {@code l = max(goal - gain (v + sum over the others of k_i
 * l_i), 0)}, where {@code k_i = 1/mA + 1/mB + armA.armA_i + armB.armB_i}. Its own old impulse drops
 * out, because mass scale and impulse scale of a soft step add up to 1. So bodies are read before
 * the sweeps and written after them.
 */
public final class ScalarNormals {
    private ScalarNormals() {}

    /** Gain {@code m massScale} and goal {@code -m b} of the soft step. */
    public static void soften(
            double[] d, int o, int lanes, int points, boolean fixed, SubStep sub, double[] st) {
        double rate = fixed ? sub.fixedRate : sub.rate;
        double massScale = fixed ? sub.fixedMassScale : sub.massScale;
        double inverse = sub.inverse;
        double push = -sub.pushSpeed;
        double touch = /*(float)*/ sub.touch;
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * lanes;
            double s = d[q + SEPARATION * lanes];
            double mass = d[q + MASS * lanes];
            double b = s * rate;
            b = b < push ? push : b;
            b = s > touch ? s * inverse : b;
            st[GAIN + p] = mass * (s > touch ? 1 : massScale);
            st[GOAL + p] = -(mass * b);
        }
    }

    /** The same, hard; an open gap without an impulse stays without one. */
    public static void harden(double[] d, int o, int lanes, int points, SubStep sub, double[] st) {
        double inverse = sub.inverse;
        double touch = /*(float)*/ sub.touch;
        double closing = /*(float)*/ sub.closing;
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * lanes;
            double s = d[q + SEPARATION * lanes];
            double mass = d[q + MASS * lanes];
            double impulse = d[q + IMPULSE * lanes];
            boolean stays = s > touch && impulse == 0;
            st[GAIN + p] = stays ? 0 : mass;
            st[GOAL + p] = stays ? impulse : -(mass * (s > touch ? s * inverse : closing));
        }
    }

    /**
     * The same of a contact that is swept until it agrees: also what opened on the way may close.
     */
    public static void hardenAll(
            double[] d, int o, int lanes, int points, SubStep sub, double[] st) {
        double touch = /*(float)*/ sub.touch;
        double closing = /*(float)*/ sub.closing;
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * lanes;
            double s = d[q + SEPARATION * lanes];
            double mass = d[q + MASS * lanes];
            st[GAIN + p] = mass;
            st[GOAL + p] = -(mass * (s > touch ? s * sub.inverse : closing));
        }
    }

    /**
     * Sweeps over the points, after one common step of all.
     *
     * @param step {@link CommonStep#SOFT}, {@code HARD}, or {@code NONE}
     * @return whether the last of the sweeps changed an impulse
     */
    public static boolean sweep(
            double[] d,
            int o,
            int lanes,
            double[] body,
            int a,
            int b,
            int points,
            int sweeps,
            int step,
            double[] st) {
        if (points == 4) {
            ScalarFour.enter(d, o, lanes, body, a, b, st);
        } else {
            enter(d, o, lanes, body, a, b, points, st);
        }
        int q = o + (POINT + IMPULSE) * lanes;
        int next = POINT_FIELDS * lanes;
        if (step != CommonStep.NONE) {
            boolean soft = step == CommonStep.SOFT;
            boolean begins = soft && d[o + COLD * lanes] > 0;
            boolean any =
                    points == 4
                            ? ScalarFour.even(d, q, next, begins, st)
                            : even(d, q, next, points, begins, st);
            if (!any && soft) {
                return false;
            }
        }
        if (points == 4) {
            boolean moved = ScalarFour.sweep(d, q, next, sweeps, st);
            double sum = st[CHANGE] + st[CHANGE + 1] + st[CHANGE + 2] + st[CHANGE + 3];
            int arms = o + (POINT + ARM_A) * lanes;
            ScalarFour.write(d, o, arms, lanes, body, a, -1, sum, st);
            ScalarFour.write(d, o, arms + ARM_B * lanes, lanes, body, b, 1, sum, st);
            return moved;
        }
        boolean moved = sweep(d, q, next, points, sweeps, st);
        double sum = 0;
        for (int p = 0; p < points; p++) {
            st[CHANGE + p] = d[q + p * next] - st[CHANGE + p];
            sum += st[CHANGE + p];
        }
        write(d, o, o + (POINT + ARM_A) * lanes, lanes, body, a, points, -1, sum, st);
        write(d, o, o + (POINT + ARM_B) * lanes, lanes, body, b, points, 1, sum, st);
        return moved;
    }

    private static boolean sweep(double[] d, int q, int next, int points, int sweeps, double[] st) {
        turnIntoGoals(points, st);
        boolean moved = false;
        for (int sweep = 0; sweep < sweeps; sweep++) {
            moved = false;
            for (int p = 0; p < points; p++) {
                double impulse = st[GOAL + p];
                int k = FACTOR + 4 * p;
                for (int i = p + 1; i < points; i++) {
                    impulse -= st[k + i] * d[q + i * next];
                }
                for (int i = 0; i < p; i++) {
                    impulse -= st[k + i] * d[q + i * next];
                }
                impulse = impulse > 0 ? impulse : 0;
                moved |= impulse != d[q + p * next];
                d[q + p * next] = impulse;
            }
            if (!moved) {
                break;
            }
        }
        return moved;
    }

    /** Speeds of separation without the own impulses, and couplings. */
    private static void enter(
            double[] d, int o, int lanes, double[] body, int a, int b, int points, double[] st) {
        double mass = body[a + SolverBodies.MASS] + body[b + SolverBodies.MASS];
        double vn =
                d[o] * (body[b] - body[a])
                        + d[o + lanes] * (body[b + 1] - body[a + 1])
                        + d[o + 2 * lanes] * (body[b + 2] - body[a + 2]);
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * lanes;
            double own = mass + product(d, q, q, lanes);
            st[OWN + p] = own;
            st[CHANGE + p] = d[q + IMPULSE * lanes];
            st[SPEED + p] =
                    vn
                            + RowArithmetic.dot(d, q + ARM_B * lanes, lanes, body, b + 3)
                            - RowArithmetic.dot(d, q, lanes, body, a + 3)
                            - own * st[CHANGE + p];
            for (int i = 0; i < p; i++) {
                int r = o + (POINT + i * POINT_FIELDS) * lanes;
                double k = mass + product(d, q, r, lanes);
                st[FACTOR + 4 * p + i] = k;
                st[FACTOR + 4 * i + p] = k;
            }
        }
    }

    /**
     * Before the points are swept one after the other: the same change of impulse at all that press
     * (or, in a contact that begins, at all that close), such that their mean speed is right. So
     * what is symmetric is answered symmetrically, and the sweeps have only the tilt to solve.
     *
     * <p>With n points, k the mean of their mass scales, K the sum of their own inverse masses and
     * couplings, and {@code r} what a point misses: {@code dl = -sum r/(k K + sum (1 - k_i)/m_i)}.
     *
     * @return false if no point presses or closes: then a sweep has nothing to do
     */
    private static boolean even(
            double[] d, int q, int next, int points, boolean begins, double[] st) {
        int active = 0;
        double n = 0;
        double miss = 0;
        double scale = 0;
        double give = 0;
        double response = 0;
        double least = Double.MAX_VALUE;
        for (int p = 0; p < points; p++) {
            double old = d[q + p * next];
            double alone = st[GOAL + p] - st[GAIN + p] * st[SPEED + p];
            if (begins ? alone > 0 : old > 0) {
                double own = st[OWN + p];
                double k = st[GAIN + p] * own;
                double inner = 0;
                for (int i = 0; i < p; i++) {
                    inner += (active & 1 << i) != 0 ? st[FACTOR + 4 * p + i] : 0;
                }
                active |= 1 << p;
                n += 1;
                miss += (old - alone) * own;
                scale += k;
                give += (1 - k) * own;
                response += own + inner * 2;
                least = old < least ? old : least;
            }
        }
        if (n > 1) {
            double delta = -miss / (response * (scale / n) + give);
            double floor = begins ? 0 : -least;
            delta = delta < floor ? floor : delta;
            for (int p = 0; p < points; p++) {
                if ((active & 1 << p) != 0) {
                    d[q + p * next] += delta;
                }
            }
        }
        return active != 0;
    }

    /** Goals without the impulses of the other points, and couplings times gains. */
    private static void turnIntoGoals(int points, double[] st) {
        for (int p = 0; p < points; p++) {
            double gain = st[GAIN + p];
            double speed = st[SPEED + p];
            for (int i = 0; i < points; i++) {
                if (i != p) {
                    double k = st[FACTOR + 4 * p + i];
                    speed -= k * st[CHANGE + i];
                    st[FACTOR + 4 * p + i] = gain * k;
                }
            }
            st[GOAL + p] -= gain * speed;
        }
    }

    private static void write(
            double[] d,
            int o,
            int arms,
            int lanes,
            double[] body,
            int at,
            int points,
            int sign,
            double sum,
            double[] st) {
        if (at == 0) {
            return;
        }
        double k = sum * body[at + SolverBodies.MASS] * sign;
        body[at] = body[at] + k * d[o] + 0.0;
        body[at + 1] = body[at + 1] + k * d[o + lanes] + 0.0;
        body[at + 2] = body[at + 2] + k * d[o + 2 * lanes] + 0.0;
        double x = body[at + 3];
        double y = body[at + 4];
        double z = body[at + 5];
        for (int p = 0; p < points; p++) {
            double change = sign * st[CHANGE + p];
            int q = arms + p * POINT_FIELDS * lanes;
            x += change * d[q];
            y += change * d[q + lanes];
            z += change * d[q + 2 * lanes];
        }
        body[at + 3] = x + 0.0;
        body[at + 4] = y + 0.0;
        body[at + 5] = z + 0.0;
    }

    /** {@code s = s0 + n.(dpB - dpA) + thB.(rB x n) - thA.(rA x n)}: linear in the movement. */
    public static void separate(
            double[] d, int o, int lanes, double[] body, int a, int b, int points) {
        double moved =
                d[o] * (body[b + P] - body[a + P])
                        + d[o + lanes] * (body[b + P + 1] - body[a + P + 1])
                        + d[o + 2 * lanes] * (body[b + P + 2] - body[a + P + 2]);
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * lanes;
            d[q + SEPARATION * lanes] =
                    moved
                            + d[o + (GAP + p) * lanes]
                            + RowArithmetic.dot(d, q + ARM_B * lanes, lanes, body, b + P + 3)
                            - RowArithmetic.dot(d, q + ARM_A * lanes, lanes, body, a + P + 3);
        }
    }

    /** {@code armA.armA' + armB.armB'} of the points at {@code q} and {@code i}. */
    private static double product(double[] d, int q, int i, int lanes) {
        double a = d[q] * d[i] + d[q + lanes] * d[i + lanes] + d[q + 2 * lanes] * d[i + 2 * lanes];
        int w = q + ARM_B * lanes;
        int x = i + ARM_B * lanes;
        return a
                + (d[w] * d[x] + d[w + lanes] * d[x + lanes] + d[w + 2 * lanes] * d[x + 2 * lanes]);
    }
}
