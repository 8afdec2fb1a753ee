package dev.cairn.physics.solver.kernel;

import static dev.cairn.physics.solver.row.ConstraintRows.ARM_B;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.row.Scratch.*;

import dev.cairn.physics.solver.body.SolverBodies;

/**
 * The inner loops of {@link ScalarNormals} for contacts of four points, written out: the same
 * operations in the same order, without loops over points and without a product for each index.
 * Most contacts of boxes have four points.
 */
final class ScalarFour {
    private ScalarFour() {}

    /** Speeds of separation without the own impulses, and couplings. */
    static void enter(double[] d, int o, int lanes, double[] body, int a, int b, double[] st) {
        double mass = body[a + SolverBodies.MASS] + body[b + SolverBodies.MASS];
        double vn =
                d[o] * (body[b] - body[a])
                        + d[o + lanes] * (body[b + 1] - body[a + 1])
                        + d[o + 2 * lanes] * (body[b + 2] - body[a + 2]);
        double ua = body[a + 3];
        double va = body[a + 4];
        double wa = body[a + 5];
        double ub = body[b + 3];
        double vb = body[b + 4];
        double wb = body[b + 5];
        int next = POINT_FIELDS * lanes;
        int q0 = o + POINT * lanes;
        int q1 = q0 + next;
        int q2 = q1 + next;
        int q3 = q2 + next;
        double xa0 = d[q0];
        double ya0 = d[q0 + lanes];
        double za0 = d[q0 + 2 * lanes];
        double xb0 = d[q0 + ARM_B * lanes];
        double yb0 = d[q0 + (ARM_B + 1) * lanes];
        double zb0 = d[q0 + (ARM_B + 2) * lanes];
        double xa1 = d[q1];
        double ya1 = d[q1 + lanes];
        double za1 = d[q1 + 2 * lanes];
        double xb1 = d[q1 + ARM_B * lanes];
        double yb1 = d[q1 + (ARM_B + 1) * lanes];
        double zb1 = d[q1 + (ARM_B + 2) * lanes];
        double xa2 = d[q2];
        double ya2 = d[q2 + lanes];
        double za2 = d[q2 + 2 * lanes];
        double xb2 = d[q2 + ARM_B * lanes];
        double yb2 = d[q2 + (ARM_B + 1) * lanes];
        double zb2 = d[q2 + (ARM_B + 2) * lanes];
        double xa3 = d[q3];
        double ya3 = d[q3 + lanes];
        double za3 = d[q3 + 2 * lanes];
        double xb3 = d[q3 + ARM_B * lanes];
        double yb3 = d[q3 + (ARM_B + 1) * lanes];
        double zb3 = d[q3 + (ARM_B + 2) * lanes];
        double own0 =
                mass + (xa0 * xa0 + ya0 * ya0 + za0 * za0 + (xb0 * xb0 + yb0 * yb0 + zb0 * zb0));
        double old0 = d[q0 + IMPULSE * lanes];
        st[OWN + 0] = own0;
        st[CHANGE + 0] = old0;
        st[SPEED + 0] =
                vn
                        + (xb0 * ub + yb0 * vb + zb0 * wb)
                        - (xa0 * ua + ya0 * va + za0 * wa)
                        - own0 * old0;
        double own1 =
                mass + (xa1 * xa1 + ya1 * ya1 + za1 * za1 + (xb1 * xb1 + yb1 * yb1 + zb1 * zb1));
        double old1 = d[q1 + IMPULSE * lanes];
        st[OWN + 1] = own1;
        st[CHANGE + 1] = old1;
        st[SPEED + 1] =
                vn
                        + (xb1 * ub + yb1 * vb + zb1 * wb)
                        - (xa1 * ua + ya1 * va + za1 * wa)
                        - own1 * old1;
        double own2 =
                mass + (xa2 * xa2 + ya2 * ya2 + za2 * za2 + (xb2 * xb2 + yb2 * yb2 + zb2 * zb2));
        double old2 = d[q2 + IMPULSE * lanes];
        st[OWN + 2] = own2;
        st[CHANGE + 2] = old2;
        st[SPEED + 2] =
                vn
                        + (xb2 * ub + yb2 * vb + zb2 * wb)
                        - (xa2 * ua + ya2 * va + za2 * wa)
                        - own2 * old2;
        double own3 =
                mass + (xa3 * xa3 + ya3 * ya3 + za3 * za3 + (xb3 * xb3 + yb3 * yb3 + zb3 * zb3));
        double old3 = d[q3 + IMPULSE * lanes];
        st[OWN + 3] = own3;
        st[CHANGE + 3] = old3;
        st[SPEED + 3] =
                vn
                        + (xb3 * ub + yb3 * vb + zb3 * wb)
                        - (xa3 * ua + ya3 * va + za3 * wa)
                        - own3 * old3;
        double k10 =
                mass + (xa1 * xa0 + ya1 * ya0 + za1 * za0 + (xb1 * xb0 + yb1 * yb0 + zb1 * zb0));
        st[FACTOR + 4] = k10;
        st[FACTOR + 1] = k10;
        double k20 =
                mass + (xa2 * xa0 + ya2 * ya0 + za2 * za0 + (xb2 * xb0 + yb2 * yb0 + zb2 * zb0));
        st[FACTOR + 8] = k20;
        st[FACTOR + 2] = k20;
        double k21 =
                mass + (xa2 * xa1 + ya2 * ya1 + za2 * za1 + (xb2 * xb1 + yb2 * yb1 + zb2 * zb1));
        st[FACTOR + 9] = k21;
        st[FACTOR + 6] = k21;
        double k30 =
                mass + (xa3 * xa0 + ya3 * ya0 + za3 * za0 + (xb3 * xb0 + yb3 * yb0 + zb3 * zb0));
        st[FACTOR + 12] = k30;
        st[FACTOR + 3] = k30;
        double k31 =
                mass + (xa3 * xa1 + ya3 * ya1 + za3 * za1 + (xb3 * xb1 + yb3 * yb1 + zb3 * zb1));
        st[FACTOR + 13] = k31;
        st[FACTOR + 7] = k31;
        double k32 =
                mass + (xa3 * xa2 + ya3 * ya2 + za3 * za2 + (xb3 * xb2 + yb3 * yb2 + zb3 * zb2));
        st[FACTOR + 14] = k32;
        st[FACTOR + 11] = k32;
    }

    /**
     * The common step, see {@link ScalarNormals}; what does not take part adds zeros.
     *
     * @return false if no point presses or closes
     */
    static boolean even(double[] d, int q, int next, boolean begins, double[] st) {
        int q0 = q;
        int q1 = q + next;
        int q2 = q + 2 * next;
        int q3 = q + 3 * next;
        double old0 = d[q0];
        double gain0 = st[GAIN + 0];
        double alone0 = st[GOAL + 0] - gain0 * st[SPEED + 0];
        boolean on0 = begins ? alone0 > 0 : old0 > 0;
        double old1 = d[q1];
        double gain1 = st[GAIN + 1];
        double alone1 = st[GOAL + 1] - gain1 * st[SPEED + 1];
        boolean on1 = begins ? alone1 > 0 : old1 > 0;
        double old2 = d[q2];
        double gain2 = st[GAIN + 2];
        double alone2 = st[GOAL + 2] - gain2 * st[SPEED + 2];
        boolean on2 = begins ? alone2 > 0 : old2 > 0;
        double old3 = d[q3];
        double gain3 = st[GAIN + 3];
        double alone3 = st[GOAL + 3] - gain3 * st[SPEED + 3];
        boolean on3 = begins ? alone3 > 0 : old3 > 0;
        if (!(on0 || on1 || on2 || on3)) {
            return false;
        }
        double n = 0;
        double miss = 0;
        double scale = 0;
        double give = 0;
        double response = 0;
        double least = Double.MAX_VALUE;
        if (on0) {
            double own = st[OWN + 0];
            double k = gain0 * own;
            n += 1;
            miss += (old0 - alone0) * own;
            scale += k;
            give += (1 - k) * own;
            response += own;
            least = old0 < least ? old0 : least;
        }
        if (on1) {
            double own = st[OWN + 1];
            double k = gain1 * own;
            n += 1;
            miss += (old1 - alone1) * own;
            scale += k;
            give += (1 - k) * own;
            response += own + (on0 ? st[FACTOR + 4] : 0) * 2;
            least = old1 < least ? old1 : least;
        }
        if (on2) {
            double own = st[OWN + 2];
            double k = gain2 * own;
            n += 1;
            miss += (old2 - alone2) * own;
            scale += k;
            give += (1 - k) * own;
            response += own + ((on0 ? st[FACTOR + 8] : 0) + (on1 ? st[FACTOR + 9] : 0)) * 2;
            least = old2 < least ? old2 : least;
        }
        if (on3) {
            double own = st[OWN + 3];
            double k = gain3 * own;
            n += 1;
            miss += (old3 - alone3) * own;
            scale += k;
            give += (1 - k) * own;
            response +=
                    own
                            + ((on0 ? st[FACTOR + 12] : 0)
                                            + (on1 ? st[FACTOR + 13] : 0)
                                            + (on2 ? st[FACTOR + 14] : 0))
                                    * 2;
            least = old3 < least ? old3 : least;
        }
        if (n > 1) {
            double delta = -miss / (response * (scale / n) + give);
            double floor = begins ? 0 : -least;
            delta = delta < floor ? floor : delta;
            d[q0] = on0 ? old0 + delta : old0;
            d[q1] = on1 ? old1 + delta : old1;
            d[q2] = on2 ? old2 + delta : old2;
            d[q3] = on3 ? old3 + delta : old3;
        }
        return true;
    }

    /**
     * Sweeps over the four points, whose first impulse is at {@code q}.
     *
     * @return whether the last of the sweeps changed an impulse
     */
    static boolean sweep(double[] d, int q, int next, int sweeps, double[] st) {
        double old0 = st[CHANGE + 0];
        double x0 = d[q];
        double old1 = st[CHANGE + 1];
        double x1 = d[q + next];
        double old2 = st[CHANGE + 2];
        double x2 = d[q + 2 * next];
        double old3 = st[CHANGE + 3];
        double x3 = d[q + 3 * next];
        double gain0 = st[GAIN + 0];
        double k01 = st[FACTOR + 1];
        double k02 = st[FACTOR + 2];
        double k03 = st[FACTOR + 3];
        double goal0 =
                st[GOAL + 0] - gain0 * (st[SPEED + 0] - k01 * old1 - k02 * old2 - k03 * old3);
        k01 = gain0 * k01;
        k02 = gain0 * k02;
        k03 = gain0 * k03;
        double gain1 = st[GAIN + 1];
        double k10 = st[FACTOR + 4];
        double k12 = st[FACTOR + 6];
        double k13 = st[FACTOR + 7];
        double goal1 =
                st[GOAL + 1] - gain1 * (st[SPEED + 1] - k10 * old0 - k12 * old2 - k13 * old3);
        k10 = gain1 * k10;
        k12 = gain1 * k12;
        k13 = gain1 * k13;
        double gain2 = st[GAIN + 2];
        double k20 = st[FACTOR + 8];
        double k21 = st[FACTOR + 9];
        double k23 = st[FACTOR + 11];
        double goal2 =
                st[GOAL + 2] - gain2 * (st[SPEED + 2] - k20 * old0 - k21 * old1 - k23 * old3);
        k20 = gain2 * k20;
        k21 = gain2 * k21;
        k23 = gain2 * k23;
        double gain3 = st[GAIN + 3];
        double k30 = st[FACTOR + 12];
        double k31 = st[FACTOR + 13];
        double k32 = st[FACTOR + 14];
        double goal3 =
                st[GOAL + 3] - gain3 * (st[SPEED + 3] - k30 * old0 - k31 * old1 - k32 * old2);
        k30 = gain3 * k30;
        k31 = gain3 * k31;
        k32 = gain3 * k32;
        boolean moved = false;
        for (int sweep = 0; sweep < sweeps; sweep++) {
            double y0 = goal0 - k01 * x1 - k02 * x2 - k03 * x3;
            y0 = y0 > 0 ? y0 : 0;
            moved = y0 != x0;
            x0 = y0;
            double y1 = goal1 - k12 * x2 - k13 * x3 - k10 * x0;
            y1 = y1 > 0 ? y1 : 0;
            moved |= y1 != x1;
            x1 = y1;
            double y2 = goal2 - k23 * x3 - k20 * x0 - k21 * x1;
            y2 = y2 > 0 ? y2 : 0;
            moved |= y2 != x2;
            x2 = y2;
            double y3 = goal3 - k30 * x0 - k31 * x1 - k32 * x2;
            y3 = y3 > 0 ? y3 : 0;
            moved |= y3 != x3;
            x3 = y3;
            if (!moved) {
                break;
            }
        }
        d[q] = x0;
        st[CHANGE + 0] = x0 - old0;
        d[q + next] = x1;
        st[CHANGE + 1] = x1 - old1;
        d[q + 2 * next] = x2;
        st[CHANGE + 2] = x2 - old2;
        d[q + 3 * next] = x3;
        st[CHANGE + 3] = x3 - old3;
        return moved;
    }

    /** Gives a body its part of the changes; its first arm is at {@code q}. */
    static void write(
            double[] d,
            int o,
            int q,
            int lanes,
            double[] body,
            int at,
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
        double c0 = sign * st[CHANGE];
        double c1 = sign * st[CHANGE + 1];
        double c2 = sign * st[CHANGE + 2];
        double c3 = sign * st[CHANGE + 3];
        int q1 = q + POINT_FIELDS * lanes;
        int q2 = q1 + POINT_FIELDS * lanes;
        int q3 = q2 + POINT_FIELDS * lanes;
        body[at + 3] = body[at + 3] + c0 * d[q] + c1 * d[q1] + c2 * d[q2] + c3 * d[q3] + 0.0;
        body[at + 4] =
                body[at + 4]
                        + c0 * d[q + lanes]
                        + c1 * d[q1 + lanes]
                        + c2 * d[q2 + lanes]
                        + c3 * d[q3 + lanes]
                        + 0.0;
        body[at + 5] =
                body[at + 5]
                        + c0 * d[q + 2 * lanes]
                        + c1 * d[q1 + 2 * lanes]
                        + c2 * d[q2 + 2 * lanes]
                        + c3 * d[q3 + 2 * lanes]
                        + 0.0;
    }
}
