package dev.cairn.physics.solver;

import static dev.cairn.physics.solver.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.ConstraintRows.LEVER;
import static dev.cairn.physics.solver.ConstraintRows.LINK;
import static dev.cairn.physics.solver.ConstraintRows.MASS_A;
import static dev.cairn.physics.solver.ConstraintRows.MASS_B;
import static dev.cairn.physics.solver.ConstraintRows.POINT;
import static dev.cairn.physics.solver.ConstraintRows.REACH;
import static dev.cairn.physics.solver.ConstraintRows.ROW;
import static dev.cairn.physics.solver.ConstraintRows.TANGENT1;
import static dev.cairn.physics.solver.ConstraintRows.TANGENT2;
import static dev.cairn.physics.solver.ConstraintRows.TURN;

import dev.cairn.physics.internal.ContactStore;

/**
 * The sweeps over constraint rows: Gauss-Seidel in row order, scalar, in double. The impulse on A
 * is the exact negative of the impulse on B: both come from one number.
 */
final class RowKernels {
    private RowKernels() {}

    /**
     * Applies the impulses of the sub-step before as a first guess: {@code v += M^-1 J^T lambda}.
     */
    static void warmStart(ConstraintRows rows, double[] body) {
        double[] d = rows.row;
        double[] q = rows.point;
        for (int m = 0; m < rows.count; m++) {
            int r = m * ROW;
            int l = m * LINK;
            int a = rows.link[l];
            int b = rows.link[l + 1];
            double sum = 0;
            double ax = 0;
            double ay = 0;
            double az = 0;
            double bx = 0;
            double by = 0;
            double bz = 0;
            int end = ContactStore.POINTS * m + rows.link[l + ConstraintRows.COUNT];
            for (int p = ContactStore.POINTS * m; p < end; p++) {
                int o = p * POINT;
                double impulse = q[o + IMPULSE];
                sum += impulse;
                ax += impulse * q[o + 6];
                ay += impulse * q[o + 7];
                az += impulse * q[o + 8];
                bx += impulse * q[o + 9];
                by += impulse * q[o + 10];
                bz += impulse * q[o + 11];
            }
            rows.link[l + ConstraintRows.COLD] = sum == 0 ? 1 : 0;
            double px = sum * d[r];
            double py = sum * d[r + 1];
            double pz = sum * d[r + 2];
            if (d[r + ConstraintRows.FRICTION] > 0) {
                double f1 = d[r + LAMBDA];
                double f2 = d[r + LAMBDA + 1];
                double tw = d[r + LAMBDA + 2];
                px += f1 * d[r + TANGENT1] + f2 * d[r + TANGENT2];
                py += f1 * d[r + TANGENT1 + 1] + f2 * d[r + TANGENT2 + 1];
                pz += f1 * d[r + TANGENT1 + 2] + f2 * d[r + TANGENT2 + 2];
                int t = r + TURN;
                ax += f1 * d[t] + f2 * d[t + 3] + tw * d[t + 12];
                ay += f1 * d[t + 1] + f2 * d[t + 4] + tw * d[t + 13];
                az += f1 * d[t + 2] + f2 * d[t + 5] + tw * d[t + 14];
                bx += f1 * d[t + 6] + f2 * d[t + 9] + tw * d[t + 15];
                by += f1 * d[t + 7] + f2 * d[t + 10] + tw * d[t + 16];
                bz += f1 * d[t + 8] + f2 * d[t + 11] + tw * d[t + 17];
            }
            double ma = d[r + MASS_A];
            double mb = d[r + MASS_B];
            body[a] -= ma * px;
            body[a + 1] -= ma * py;
            body[a + 2] -= ma * pz;
            body[a + 3] -= ax;
            body[a + 4] -= ay;
            body[a + 5] -= az;
            body[b] += mb * px;
            body[b + 1] += mb * py;
            body[b + 2] += mb * pz;
            body[b + 3] += bx;
            body[b + 4] += by;
            body[b + 5] += bz;
        }
    }

    /** The bias pass: soft normals, which push overlap out and let gaps close; no friction. */
    static void bias(
            ConstraintRows rows,
            double[] body,
            double h,
            double pushSpeed,
            int sweeps,
            int coldSweeps) {
        int landing = Math.max(sweeps, coldSweeps / 2);
        for (int m = 0; m < rows.count; m++) {
            boolean cold = rows.link[m * LINK + ConstraintRows.COLD] != 0;
            normals(rows, m, body, h, pushSpeed, true, cold ? landing : sweeps);
        }
    }

    /**
     * The relax pass: hard normals, which take the push out of the velocities again, then friction;
     * adds up the totals.
     */
    static void relax(
            ConstraintRows rows,
            double[] body,
            double h,
            double pushSpeed,
            int sweeps,
            int coldSweeps) {
        int landing = Math.max(sweeps, coldSweeps / 2);
        for (int m = 0; m < rows.count; m++) {
            boolean rough = rows.row[m * ROW + ConstraintRows.FRICTION] > 0;
            // a contact without a warm start has its normals and its friction still to agree on who
            // stops what
            boolean cold = rows.link[m * LINK + ConstraintRows.COLD] != 0;
            int rounds = cold && rough ? coldSweeps : 1;
            for (int round = 0; round < rounds; round++) {
                double normal =
                        normals(rows, m, body, h, pushSpeed, false, cold ? landing : sweeps);
                if (normal == 0) {
                    rounds = 1;
                }
                if (rough) {
                    friction(rows, m, body, normal);
                }
            }
            total(rows, m);
        }
    }

    /**
     * Hard normals and friction of the rows marked {@link ConstraintRows#UNLOADED}, over and over;
     * no totals: the sweeps only correct the first guess of the sub-step.
     */
    static void settle(ConstraintRows rows, double[] body, double h, int rounds, int sweeps) {
        for (int round = 0; round < rounds; round++) {
            for (int m = 0; m < rows.count; m++) {
                if (rows.link[m * LINK + ConstraintRows.UNLOADED] != 0) {
                    double normal = normals(rows, m, body, h, 0, false, sweeps);
                    if (rows.row[m * ROW + ConstraintRows.FRICTION] > 0) {
                        friction(rows, m, body, normal);
                    }
                }
            }
        }
    }

    /**
     * Normals of one contact.
     *
     * <p>With {@code s} the separation now, {@code vn} the speed of separation, {@code m} the
     * effective mass: {@code dl = -m (massScale vn + b) - impulseScale l; l' = max(l + dl, 0)}. A
     * gap closes at most to zero ({@code b = s/h}, hard); overlap is soft with {@code b =
     * max(massScale biasRate s, -pushSpeed)} in the bias pass, and {@code b = 0}, hard, in the
     * relax pass.
     *
     * @return sum of the impulses
     */
    private static double normals(
            ConstraintRows rows,
            int m,
            double[] body,
            double h,
            double pushSpeed,
            boolean push,
            int sweeps) {
        double[] d = rows.row;
        double[] q = rows.point;
        int r = m * ROW;
        int a = rows.link[m * LINK];
        int b = rows.link[m * LINK + 1];
        double nx = d[r];
        double ny = d[r + 1];
        double nz = d[r + 2];
        double ma = d[r + MASS_A];
        double mb = d[r + MASS_B];
        double massScale = push ? d[r + ConstraintRows.MASS_SCALE] : 1;
        double impulseScale = push ? d[r + ConstraintRows.IMPULSE_SCALE] : 0;
        double biasRate = push ? d[r + ConstraintRows.BIAS_RATE] * massScale : 0;
        double vn =
                nx * (body[b] - body[a])
                        + ny * (body[b + 1] - body[a + 1])
                        + nz * (body[b + 2] - body[a + 2]);
        double moved =
                nx * (body[b + 6] - body[a + 6])
                        + ny * (body[b + 7] - body[a + 7])
                        + nz * (body[b + 8] - body[a + 8]);
        double ax = body[a + 3];
        double ay = body[a + 4];
        double az = body[a + 5];
        double bx = body[b + 3];
        double by = body[b + 4];
        double bz = body[b + 5];
        double change = 0;
        double sum = 0;
        int first = ContactStore.POINTS * m * POINT;
        int end = first + rows.link[m * LINK + ConstraintRows.COUNT] * POINT;
        for (int sweep = 0; sweep < sweeps; sweep++) {
            sum = 0;
            for (int o = first; o < end; o += POINT) {
                // s = s0 + n.(dpB - dpA) + thB.(rB x n) - thA.(rA x n): linear in the movement of
                // the tick
                double s =
                        q[o + ConstraintRows.GAP]
                                + moved
                                + (body[b + 9] * q[o + 3]
                                        + body[b + 10] * q[o + 4]
                                        + body[b + 11] * q[o + 5])
                                - (body[a + 9] * q[o]
                                        + body[a + 10] * q[o + 1]
                                        + body[a + 11] * q[o + 2]);
                double speed =
                        vn
                                + change * (ma + mb)
                                + (bx * q[o + 3] + by * q[o + 4] + bz * q[o + 5])
                                - (ax * q[o] + ay * q[o + 1] + az * q[o + 2]);
                double old = q[o + IMPULSE];
                double next;
                if (s > 0 && !push && old == 0) {
                    // an open gap is the next sub-step's matter: impacts want the speed as it is
                    continue;
                } else if (s > 0) {
                    next = old - q[o + ConstraintRows.MASS] * (speed + s / h);
                } else {
                    double b0 = Math.max(biasRate * s, -pushSpeed);
                    next =
                            old
                                    - q[o + ConstraintRows.MASS] * (massScale * speed + b0)
                                    - impulseScale * old;
                }
                next = Math.max(next, 0);
                double delta = next - old;
                q[o + IMPULSE] = next;
                sum += next;
                change += delta;
                ax -= delta * q[o + 6];
                ay -= delta * q[o + 7];
                az -= delta * q[o + 8];
                bx += delta * q[o + 9];
                by += delta * q[o + 10];
                bz += delta * q[o + 11];
            }
        }
        body[a] -= ma * (change * nx);
        body[a + 1] -= ma * (change * ny);
        body[a + 2] -= ma * (change * nz);
        body[a + 3] = ax;
        body[a + 4] = ay;
        body[a + 5] = az;
        body[b] += mb * (change * nx);
        body[b + 1] += mb * (change * ny);
        body[b + 2] += mb * (change * nz);
        body[b + 3] = bx;
        body[b + 4] = by;
        body[b + 5] = bz;
        if (push && sum > 0) {
            body[a + SolverBodies.LOADED] = 1;
            body[b + SolverBodies.LOADED] = 1;
        }
        return sum;
    }

    /**
     * Friction of one contact at the patch's centre: twist first, {@code |twist| <= mu sum(reach_i
     * l_i)}, then the 2 x 2 tangent block, {@code l' = l - K^-1 vt} drawn back to the circle {@code
     * |l'| <= mu sum(l_i)}.
     */
    static void friction(ConstraintRows rows, int m, double[] body, double normal) {
        double[] d = rows.row;
        int r = m * ROW;
        int t = r + TURN;
        int v = r + LEVER;
        int a = rows.link[m * LINK];
        int b = rows.link[m * LINK + 1];
        double mu = d[r + ConstraintRows.FRICTION];
        if (d[r + ConstraintRows.TWIST_MASS] > 0) {
            twist(rows, m, body);
        }
        double dx = body[b] - body[a];
        double dy = body[b + 1] - body[a + 1];
        double dz = body[b + 2] - body[a + 2];
        // vt = (vB + wB x rB - vA - wA x rA).t, with (w x r).t = w.(r x t)
        double v1 =
                dx * d[r + TANGENT1]
                        + dy * d[r + TANGENT1 + 1]
                        + dz * d[r + TANGENT1 + 2]
                        + PrepareRow.dot(body, b + 3, d, v + 6)
                        - PrepareRow.dot(body, a + 3, d, v);
        double v2 =
                dx * d[r + TANGENT2]
                        + dy * d[r + TANGENT2 + 1]
                        + dz * d[r + TANGENT2 + 2]
                        + PrepareRow.dot(body, b + 3, d, v + 9)
                        - PrepareRow.dot(body, a + 3, d, v + 3);
        int k = r + ConstraintRows.BLOCK;
        double f1 = d[r + LAMBDA] - (d[k] * v1 + d[k + 1] * v2);
        double f2 = d[r + LAMBDA + 1] - (d[k + 1] * v1 + d[k + 2] * v2);
        double bound = mu * normal;
        double size = f1 * f1 + f2 * f2;
        if (size > bound * bound) {
            double scale = bound / Math.sqrt(size);
            f1 *= scale;
            f2 *= scale;
        }
        double d1 = f1 - d[r + LAMBDA];
        double d2 = f2 - d[r + LAMBDA + 1];
        d[r + LAMBDA] = f1;
        d[r + LAMBDA + 1] = f2;
        double px = d1 * d[r + TANGENT1] + d2 * d[r + TANGENT2];
        double py = d1 * d[r + TANGENT1 + 1] + d2 * d[r + TANGENT2 + 1];
        double pz = d1 * d[r + TANGENT1 + 2] + d2 * d[r + TANGENT2 + 2];
        double ma = d[r + MASS_A];
        double mb = d[r + MASS_B];
        body[a] -= ma * px;
        body[a + 1] -= ma * py;
        body[a + 2] -= ma * pz;
        body[a + 3] -= d1 * d[t] + d2 * d[t + 3];
        body[a + 4] -= d1 * d[t + 1] + d2 * d[t + 4];
        body[a + 5] -= d1 * d[t + 2] + d2 * d[t + 5];
        body[b] += mb * px;
        body[b + 1] += mb * py;
        body[b + 2] += mb * pz;
        body[b + 3] += d1 * d[t + 6] + d2 * d[t + 9];
        body[b + 4] += d1 * d[t + 7] + d2 * d[t + 10];
        body[b + 5] += d1 * d[t + 8] + d2 * d[t + 11];
    }

    private static void twist(ConstraintRows rows, int m, double[] body) {
        double[] d = rows.row;
        int r = m * ROW;
        int t = r + TURN + 12;
        int a = rows.link[m * LINK];
        int b = rows.link[m * LINK + 1];
        double bound = 0;
        int first = ContactStore.POINTS * m * POINT;
        int end = first + rows.link[m * LINK + ConstraintRows.COUNT] * POINT;
        for (int o = first; o < end; o += POINT) {
            bound += rows.point[o + REACH] * rows.point[o + IMPULSE];
        }
        bound *= d[r + ConstraintRows.FRICTION];
        double speed = PrepareRow.dot(d, r, body, b + 3) - PrepareRow.dot(d, r, body, a + 3);
        double old = d[r + LAMBDA + 2];
        double next =
                Math.max(-bound, Math.min(bound, old - d[r + ConstraintRows.TWIST_MASS] * speed));
        double delta = next - old;
        d[r + LAMBDA + 2] = next;
        body[a + 3] -= delta * d[t];
        body[a + 4] -= delta * d[t + 1];
        body[a + 5] -= delta * d[t + 2];
        body[b + 3] += delta * d[t + 3];
        body[b + 4] += delta * d[t + 4];
        body[b + 5] += delta * d[t + 5];
    }

    private static void total(ConstraintRows rows, int m) {
        double[] d = rows.row;
        int r = m * ROW;
        d[r + ConstraintRows.TOTAL] += d[r + LAMBDA];
        d[r + ConstraintRows.TOTAL + 1] += d[r + LAMBDA + 1];
        d[r + ConstraintRows.TOTAL + 2] += d[r + LAMBDA + 2];
        int first = ContactStore.POINTS * m * POINT;
        int end = first + rows.link[m * LINK + ConstraintRows.COUNT] * POINT;
        for (int o = first; o < end; o += POINT) {
            rows.point[o + ConstraintRows.SUM] += rows.point[o + IMPULSE];
        }
    }
}
