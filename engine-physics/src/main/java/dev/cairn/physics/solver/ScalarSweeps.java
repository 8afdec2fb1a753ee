package dev.cairn.physics.solver;

import static dev.cairn.physics.solver.ConstraintRows.ARM_A;
import static dev.cairn.physics.solver.ConstraintRows.ARM_B;
import static dev.cairn.physics.solver.ConstraintRows.BLOCK;
import static dev.cairn.physics.solver.ConstraintRows.COLD;
import static dev.cairn.physics.solver.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.ConstraintRows.GAP;
import static dev.cairn.physics.solver.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.ConstraintRows.LEVER;
import static dev.cairn.physics.solver.ConstraintRows.LINK;
import static dev.cairn.physics.solver.ConstraintRows.MASS;
import static dev.cairn.physics.solver.ConstraintRows.MASS_A;
import static dev.cairn.physics.solver.ConstraintRows.MASS_B;
import static dev.cairn.physics.solver.ConstraintRows.POINT;
import static dev.cairn.physics.solver.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.ConstraintRows.REACH;
import static dev.cairn.physics.solver.ConstraintRows.SEPARATION;
import static dev.cairn.physics.solver.ConstraintRows.SUM;
import static dev.cairn.physics.solver.ConstraintRows.TANGENT1;
import static dev.cairn.physics.solver.ConstraintRows.TOTAL;
import static dev.cairn.physics.solver.ConstraintRows.TWIST;
import static dev.cairn.physics.solver.ConstraintRows.TWIST_MASS;
import static dev.cairn.physics.solver.SolverBodies.LOADED;
import static dev.cairn.physics.solver.SolverBodies.P;

import dev.cairn.physics.internal.ContactStore;

/**
 * The sweeps in scalar arithmetic: what runs without the Vector API, and what the wide ones are
 * held to, bit by bit.
 *
 * <p>With {@code s} the separation now, {@code vn} the speed of separation, {@code m} the effective
 * mass, a normal impulse changes by {@code dl = -m (massScale vn + b) - impulseScale l; l' = max(l
 * + dl, 0)}. A gap closes at most to zero ({@code b = s/h}, hard); overlap is soft with {@code b =
 * max(massScale biasRate s, -pushSpeed)} in the bias pass, and {@code b = 0}, hard, in the relax
 * pass. There an open gap without an impulse is the next sub-step's matter: impacts want the speed
 * as it is.
 *
 * <p>Source: E. Catto, Soft Step solver (2023).
 */
final class ScalarSweeps implements Sweeps {
    private final RowFiller filler = new PrepareRow();

    @Override
    public int lanes() {
        return 1;
    }

    @Override
    public void fill(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            double scale,
            int from,
            int to,
            double[] scratch) {
        filler.fill(rows, bodies, contacts, sub, scale, from, to, scratch);
    }

    @Override
    public void bias(
            ConstraintRows rows, double[] body, SubStep sub, int from, int to, double[] scratch) {
        double[] d = rows.row;
        int[] link = rows.link;
        int lanes = rows.lanes;
        for (int j = from; j < to; j++) {
            int l = j * LINK;
            int n = link[l + ConstraintRows.COUNT];
            if (n == 0) {
                continue;
            }
            int o = rows.base(j);
            double sum = sum(d, o, lanes, n);
            boolean cold = sum == 0;
            d[o + COLD * lanes] = cold ? 1 : 0;
            if (!even(d, o, lanes, body, link[l], link[l + 1], n, sub, true)) {
                continue;
            }
            boolean moved = bias(d, o, lanes, body, link[l], link[l + 1], n, sub, sub.sweeps);
            if (cold && moved && sub.landing > sub.sweeps) {
                bias(d, o, lanes, body, link[l], link[l + 1], n, sub, sub.landing - sub.sweeps);
            }
            if (sum(d, o, lanes, n) > 0) {
                body[link[l] + LOADED] = link[l] == 0 ? 0 : 1;
                body[link[l + 1] + LOADED] = link[l + 1] == 0 ? 0 : 1;
            }
        }
    }

    private static double sum(double[] d, int o, int lanes, int points) {
        double sum = 0;
        for (int p = 0; p < points; p++) {
            sum += d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes];
        }
        return sum;
    }

    /**
     * Before the points are swept one after the other: the same change of impulse at all that press
     * (or, in a contact that begins, at all that close), such that their mean speed is right. So
     * what is symmetric is answered symmetrically, and the sweeps have only the tilt to solve.
     *
     * <p>With the sum {@code r} of what the points miss, n points, and the sums of their arms:
     * {@code dl = -r/(k (n² (1/mA + 1/mB) + |sum armA|² + |sum armB|²) + sum leak/m)}.
     *
     * @return false if no point presses or closes: then a sweep has nothing to do
     */
    private static boolean even(
            double[] d,
            int o,
            int lanes,
            double[] body,
            int a,
            int b,
            int points,
            SubStep sub,
            boolean isSoft) {
        double ma = d[o + MASS_A * lanes];
        double mb = d[o + MASS_B * lanes];
        boolean fixed = ma == 0 || mb == 0;
        double rate = isSoft ? fixed ? sub.fixedRate : sub.rate : 0;
        double massScale = isSoft ? fixed ? sub.fixedMassScale : sub.massScale : 1;
        double impulseScale = fixed ? sub.fixedImpulseScale : sub.impulseScale;
        double nx = d[o];
        double ny = d[o + lanes];
        double nz = d[o + 2 * lanes];
        double vn =
                nx * (body[b] - body[a])
                        + ny * (body[b + 1] - body[a + 1])
                        + nz * (body[b + 2] - body[a + 2]);
        boolean begins = isSoft && d[o + COLD * lanes] > 0;
        int active = 0;
        double n = 0;
        double miss = 0;
        double scale = 0;
        double give = 0;
        double least = Double.MAX_VALUE;
        double ax = 0;
        double ay = 0;
        double az = 0;
        double bx = 0;
        double by = 0;
        double bz = 0;
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * lanes;
            double s = d[q + SEPARATION * lanes];
            double old = d[q + IMPULSE * lanes];
            double speed =
                    vn
                            + dot(d, q + ARM_B * lanes, lanes, body, b + 3)
                            - dot(d, q, lanes, body, a + 3);
            double k = s > 0 ? 1 : massScale;
            double r = k * speed + (s > 0 ? s * sub.inverse : Math.max(s * rate, -sub.pushSpeed));
            if (begins ? r < 0 : old > 0) {
                active |= 1 << p;
                n += 1;
                miss += r;
                scale += k;
                least = Math.min(least, old);
                ax += d[q];
                ay += d[q + lanes];
                az += d[q + 2 * lanes];
                bx += d[q + ARM_B * lanes];
                by += d[q + (ARM_B + 1) * lanes];
                bz += d[q + (ARM_B + 2) * lanes];
                if (isSoft) {
                    double leak = (s > 0 ? 0 : impulseScale) / d[q + MASS * lanes];
                    miss += leak * old;
                    give += leak;
                }
            }
        }
        double delta = 0;
        if (n > 1) {
            double response =
                    n * n * (ma + mb)
                            + (ax * ax + ay * ay + az * az)
                            + (bx * bx + by * by + bz * bz);
            delta = Math.max(-miss / (response * (scale / n) + give), begins ? 0 : -least);
        }
        for (int p = 0; p < points; p++) {
            if ((active & 1 << p) != 0) {
                d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes] += delta;
            }
        }
        double change = n * delta;
        double ta = -delta;
        write(
                body,
                a,
                -ma,
                change,
                nx,
                ny,
                nz,
                body[a + 3] + ta * ax,
                body[a + 4] + ta * ay,
                body[a + 5] + ta * az);
        write(
                body,
                b,
                mb,
                change,
                nx,
                ny,
                nz,
                body[b + 3] + delta * bx,
                body[b + 4] + delta * by,
                body[b + 5] + delta * bz);
        return active != 0;
    }

    /** Soft normals; whether the last sweep changed an impulse. */
    private static boolean bias(
            double[] d,
            int o,
            int lanes,
            double[] body,
            int a,
            int b,
            int points,
            SubStep sub,
            int sweeps) {
        double ma = d[o + MASS_A * lanes];
        double mb = d[o + MASS_B * lanes];
        boolean fixed = ma == 0 || mb == 0;
        double rate = fixed ? sub.fixedRate : sub.rate;
        double massScale = fixed ? sub.fixedMassScale : sub.massScale;
        double impulseScale = fixed ? sub.fixedImpulseScale : sub.impulseScale;
        double nx = d[o];
        double ny = d[o + lanes];
        double nz = d[o + 2 * lanes];
        double vn =
                nx * (body[b] - body[a])
                        + ny * (body[b + 1] - body[a + 1])
                        + nz * (body[b + 2] - body[a + 2]);
        double ax = body[a + 3];
        double ay = body[a + 4];
        double az = body[a + 5];
        double bx = body[b + 3];
        double by = body[b + 4];
        double bz = body[b + 5];
        double change = 0;
        boolean moved = false;
        for (int sweep = 0; sweep < sweeps; sweep++) {
            moved = false;
            for (int p = 0; p < points; p++) {
                int q = o + (POINT + p * POINT_FIELDS) * lanes;
                double ux = d[q];
                double uy = d[q + lanes];
                double uz = d[q + 2 * lanes];
                double wx = d[q + ARM_B * lanes];
                double wy = d[q + (ARM_B + 1) * lanes];
                double wz = d[q + (ARM_B + 2) * lanes];
                double s = d[q + SEPARATION * lanes];
                double b0 = s > 0 ? s * sub.inverse : Math.max(s * rate, -sub.pushSpeed);
                double k = s > 0 ? 1 : massScale;
                double leak = s > 0 ? 0 : impulseScale;
                double speed =
                        vn
                                + change * (ma + mb)
                                + (wx * bx + wy * by + wz * bz)
                                - (ux * ax + uy * ay + uz * az);
                double old = d[q + IMPULSE * lanes];
                double next =
                        Math.max(old - d[q + MASS * lanes] * (k * speed + b0) - leak * old, 0);
                double delta = next - old;
                d[q + IMPULSE * lanes] = next;
                moved |= delta != 0;
                change += delta;
                ax -= delta * ux;
                ay -= delta * uy;
                az -= delta * uz;
                bx += delta * wx;
                by += delta * wy;
                bz += delta * wz;
            }
            if (!moved) {
                break;
            }
        }
        write(body, a, -ma, change, nx, ny, nz, ax, ay, az);
        write(body, b, mb, change, nx, ny, nz, bx, by, bz);
        return moved;
    }

    private static void write(
            double[] body,
            int o,
            double mass,
            double change,
            double nx,
            double ny,
            double nz,
            double wx,
            double wy,
            double wz) {
        if (o != 0) {
            body[o] = body[o] + mass * (change * nx) + 0.0;
            body[o + 1] = body[o + 1] + mass * (change * ny) + 0.0;
            body[o + 2] = body[o + 2] + mass * (change * nz) + 0.0;
            body[o + 3] = wx + 0.0;
            body[o + 4] = wy + 0.0;
            body[o + 5] = wz + 0.0;
        }
    }

    @Override
    public void relax(
            ConstraintRows rows, double[] body, SubStep sub, int from, int to, double[] scratch) {
        double[] d = rows.row;
        int[] link = rows.link;
        int lanes = rows.lanes;
        for (int j = from; j < to; j++) {
            int l = j * LINK;
            int n = link[l + ConstraintRows.COUNT];
            if (n == 0) {
                continue;
            }
            int o = rows.base(j);
            int a = link[l];
            int b = link[l + 1];
            separations(d, o, lanes, body, a, b, n);
            // a contact without a warm start has its normals and its friction still to agree on who
            // stops what
            boolean cold = d[o + COLD * lanes] > 0;
            even(d, o, lanes, body, a, b, n, sub, false);
            boolean moved = hard(d, o, lanes, body, a, b, n, sub.inverse, sub.sweeps);
            if (cold && moved) {
                hard(d, o, lanes, body, a, b, n, sub.inverse, sub.landing - sub.sweeps);
            }
            if (d[o + FRICTION * lanes] > 0) {
                double normal = friction(d, o, lanes, body, a, b, n);
                for (int round = 1; cold && normal > 0 && round < sub.coldRounds; round++) {
                    hard(d, o, lanes, body, a, b, n, sub.inverse, sub.landing);
                    normal = friction(d, o, lanes, body, a, b, n);
                }
            }
            total(d, o, lanes, n);
        }
    }

    /**
     * Hard normals and friction of the rows that are marked as unloaded, over and over; no totals:
     * the sweeps only correct the first guess of the sub-step.
     */
    static void settle(ConstraintRows rows, double[] body, SubStep sub, int rounds) {
        double[] d = rows.row;
        int[] link = rows.link;
        int lanes = rows.lanes;
        for (int round = 0; round < rounds; round++) {
            for (int j = 0; j < rows.places; j++) {
                if (rows.unloaded[j] == 0) {
                    continue;
                }
                int l = j * LINK;
                int n = link[l + ConstraintRows.COUNT];
                int o = rows.base(j);
                hard(d, o, lanes, body, link[l], link[l + 1], n, sub.inverse, sub.sweeps);
                if (d[o + FRICTION * lanes] > 0) {
                    friction(d, o, lanes, body, link[l], link[l + 1], n);
                }
            }
        }
    }

    /** Brings the separations of all rows up to date with the bodies. */
    static void separations(ConstraintRows rows, double[] body) {
        for (int j = 0; j < rows.places; j++) {
            int l = j * LINK;
            int n = rows.link[l + ConstraintRows.COUNT];
            if (n > 0) {
                int o = rows.base(j);
                separations(rows.row, o, rows.lanes, body, rows.link[l], rows.link[l + 1], n);
            }
        }
    }

    /** {@code s = s0 + n.(dpB - dpA) + thB.(rB x n) - thA.(rA x n)}: linear in the movement. */
    private static void separations(
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
                            + dot(d, q + ARM_B * lanes, lanes, body, b + P + 3)
                            - dot(d, q + ARM_A * lanes, lanes, body, a + P + 3);
        }
    }

    static double dot(double[] d, int o, int lanes, double[] v, int i) {
        return d[o] * v[i] + d[o + lanes] * v[i + 1] + d[o + 2 * lanes] * v[i + 2];
    }

    /** Hard normals; whether the last sweep changed an impulse. */
    private static boolean hard(
            double[] d,
            int o,
            int lanes,
            double[] body,
            int a,
            int b,
            int points,
            double inverse,
            int sweeps) {
        double ma = d[o + MASS_A * lanes];
        double mb = d[o + MASS_B * lanes];
        double nx = d[o];
        double ny = d[o + lanes];
        double nz = d[o + 2 * lanes];
        double vn =
                nx * (body[b] - body[a])
                        + ny * (body[b + 1] - body[a + 1])
                        + nz * (body[b + 2] - body[a + 2]);
        double ax = body[a + 3];
        double ay = body[a + 4];
        double az = body[a + 5];
        double bx = body[b + 3];
        double by = body[b + 4];
        double bz = body[b + 5];
        double change = 0;
        boolean moved = false;
        for (int sweep = 0; sweep < sweeps; sweep++) {
            moved = false;
            for (int p = 0; p < points; p++) {
                int q = o + (POINT + p * POINT_FIELDS) * lanes;
                double ux = d[q];
                double uy = d[q + lanes];
                double uz = d[q + 2 * lanes];
                double wx = d[q + ARM_B * lanes];
                double wy = d[q + (ARM_B + 1) * lanes];
                double wz = d[q + (ARM_B + 2) * lanes];
                double s = d[q + SEPARATION * lanes];
                double old = d[q + IMPULSE * lanes];
                double speed =
                        vn
                                + change * (ma + mb)
                                + (wx * bx + wy * by + wz * bz)
                                - (ux * ax + uy * ay + uz * az);
                double next =
                        s > 0 && old == 0
                                ? 0
                                : Math.max(
                                        old
                                                - d[q + MASS * lanes]
                                                        * (speed + (s > 0 ? s * inverse : 0)),
                                        0);
                double delta = next - old;
                d[q + IMPULSE * lanes] = next;
                moved |= delta != 0;
                change += delta;
                ax -= delta * ux;
                ay -= delta * uy;
                az -= delta * uz;
                bx += delta * wx;
                by += delta * wy;
                bz += delta * wz;
            }
            if (!moved) {
                break;
            }
        }
        write(body, a, -ma, change, nx, ny, nz, ax, ay, az);
        write(body, b, mb, change, nx, ny, nz, bx, by, bz);
        return moved;
    }

    /**
     * Friction of one contact at the patch's centre: the twist and the 2 x 2 tangent block that
     * would stop it, {@code t' = t - w/K, l' = l - K^-1 vt}, drawn back to what the patch can do,
     * see {@link Rub}. Returns the sum of the normal impulses.
     */
    static double friction(double[] d, int o, int lanes, double[] body, int a, int b, int points) {
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
        double speed = dot(d, t + three, lanes, body, b + 3) - dot(d, t, lanes, body, a + 3);
        double next = bound > 0 ? old - d[o + TWIST_MASS * lanes] * speed : 0;
        turn(d, t, lanes, body, a, old - next);
        turn(d, t + three, lanes, body, b, next - old);
        slide(d, o, lanes, body, a, b, mu * normal, bound, next);
        return normal;
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
            double twist) {
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
                        + dot(d, lever + 2 * three, lanes, body, b + 3)
                        - dot(d, lever, lanes, body, a + 3);
        double v2 =
                dx * d[t2]
                        + dy * d[t2 + lanes]
                        + dz * d[t2 + 2 * lanes]
                        + dot(d, lever + 3 * three, lanes, body, b + 3)
                        - dot(d, lever + three, lanes, body, a + 3);
        double f1 = d[l] - (d[k] * v1 + d[k + lanes] * v2);
        double f2 = d[l + lanes] - (d[k + lanes] * v1 + d[k + 2 * lanes] * v2);
        double size = f1 * f1 + f2 * f2;
        // the square of a very small impulse is 0
        double scale = limit > 0 ? 1 : 0;
        double twistScale = bound > 0 ? 1 : 0;
        double square = twist * twist;
        if (limit > 0 && !Rub.holds(size, square, limit * limit, bound * bound)) {
            double mass = 0.5 * (d[k] + d[k + 2 * lanes]);
            double inertia = d[o + TWIST_MASS * lanes];
            double reach = bound / limit;
            double r2 = Rub.REACH * (reach * reach);
            double share = Rub.share(size, square, r2, mass, inertia);
            double give = Rub.give(size, square, r2, mass, inertia, limit, share);
            double whole = (Rub.FAR + Rub.NEAR * share) * r2 * limit;
            scale = limit / (mass * give + limit);
            twistScale = whole / (inertia * give + whole + Rub.LEAST);
        }
        f1 = f1 * scale + 0.0;
        f2 = f2 * scale + 0.0;
        double d1 = f1 - d[l];
        double d2 = f2 - d[l + lanes];
        double d3 = twist * twistScale + 0.0;
        d[l] = f1;
        d[l + lanes] = f2;
        d[l + 2 * lanes] = d3;
        d3 -= twist;
        double px = d1 * d[t1] + d2 * d[t2];
        double py = d1 * d[t1 + lanes] + d2 * d[t2 + lanes];
        double pz = d1 * d[t1 + 2 * lanes] + d2 * d[t2 + 2 * lanes];
        int t = o + TWIST * lanes;
        if (a != 0) {
            double ma = d[o + MASS_A * lanes];
            body[a] = body[a] - ma * px + 0.0;
            body[a + 1] = body[a + 1] - ma * py + 0.0;
            body[a + 2] = body[a + 2] - ma * pz + 0.0;
            turn(d, t, lanes, body, a, -d3);
            turn(d, lever, lever + three, lanes, body, a, -d1, -d2);
        }
        if (b != 0) {
            double mb = d[o + MASS_B * lanes];
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

    private static void total(double[] d, int o, int lanes, int points) {
        for (int f = 0; f < 3; f++) {
            d[o + (TOTAL + f) * lanes] += d[o + (LAMBDA + f) * lanes];
        }
        for (int p = 0; p < points; p++) {
            d[o + (SUM + p) * lanes] += d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes];
        }
    }
}
