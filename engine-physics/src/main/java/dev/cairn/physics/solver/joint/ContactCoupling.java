package dev.cairn.physics.solver.joint;

import static dev.cairn.physics.solver.row.ConstraintRows.ARM_B;
import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.row.ConstraintRows.LEVER;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.SEPARATION;
import static dev.cairn.physics.solver.row.ConstraintRows.SUM;
import static dev.cairn.physics.solver.row.ConstraintRows.TANGENT1;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

import java.util.Arrays;

/**
 * What an assembly stands on or falls on, and what lies on it or falls on it, is solved with it.
 *
 * <p>Problem: a sweep gives a light wheel what stops the wheel. The heavy cart above it goes on,
 * and joints, which have the last word, push the wheel into the floor: of what is missing a round
 * of sweep and joints brings the share {@code m/M}. A cart of 200 times its wheels' mass went
 * through the floor with them.
 *
 * <p>With u the velocities that are scaled so that the mass matrix is 1, and J those of the joints,
 * an impulse l along the row n of a contact changes
 *
 * <pre>
 * du = (1 - J^T (J J^T + E)^-1 J) n^T l
 * </pre>
 *
 * <p>that is, all bodies at once and so that joints still hold: one solve with the factors of the
 * assembly. {@code k_pq = n_p du_q} couples the points of its contacts, and they are swept by
 * projected Gauss-Seidel until they agree. A body that no joint holds adds what it answers itself,
 * {@code n_p M^-1 n_q^T}; what else it touches is left to the sweeps. Points keep the goals that
 * they have in the sweeps; a soft one gives as much as k wants. Nothing is done where sweeps left
 * nothing to do.
 *
 * <p>Source: the operational-space inertia of articulated bodies (O. Khatib, 1987), of which k is
 * the inverse, as in D. Baraff, "Linear-time dynamics using Lagrange multipliers" (1996), section
 * 7.
 */
abstract class ContactCoupling extends PositionCorrection {
    private static final int SWEEPS = 100;

    /** Give of a hard point over the inverse of the whole mass. */
    private static final double HARD = 1e-3;

    /** Share of a change, of the largest impulse, at which points agree. */
    private static final double AGREES = 1e-9;

    /** Of the speed that gravity adds in a sub-step: what may be left to the next sweeps. */
    private static final double LEFT = 0.5;

    /** Points for which there is room at first: most assemblies never have more. */
    private static final int ROOM = 16;

    private int points;

    /** By point: where it is among the fields, side of the body, the body among those of s. */
    private int[] field = new int[ROOM];

    private int[] normal = new int[ROOM];
    private int[] sum = new int[ROOM];
    private int[] link = new int[ROOM];
    private int[] node = new int[ROOM];
    private int[] place = new int[ROOM];

    /** By point: where the body lies that no joint holds, negative as A; 0 for none. */
    private int[] free = new int[ROOM];

    private double[] miss = new double[ROOM];
    private double[] give = new double[ROOM];
    private double[] change = new double[ROOM];

    /** {@code k_pq} at {@code p points + q}. */
    private double[] coupling = new double[ROOM * ROOM];

    /**
     * Whether sweeps and joints have left contacts of the assembly less than solved. Not of what a
     * kinematic body moves by a joint: if it presses the assembly against something, no impulse
     * solves that, and the sweeps' own, which yield, are as large as they should be.
     *
     * @param soft as in the bias pass, before the movement; else as in the relax pass
     */
    boolean misses(ConstraintRows rows, SubStep sub, boolean soft) {
        return s.touchCount > 0
                && s.carriedRoot == 0
                && !rows.isSingle
                && gather(rows, sub, soft) > LEFT * tick.weight() * sub.seconds;
    }

    /**
     * Solves them. Points yield by at least what the whole mass would, a hard one by a share of
     * that: joints may leave a point no way at all, and what cannot be reached, as where a body is
     * wedged, would ask for impulses without end.
     */
    void carry(ConstraintRows rows, SubStep sub, boolean soft) {
        gather(rows, sub, soft);
        factor(soft);
        couple(rows.doubles, rows.lanes);
        double least = 1 / mass(rows);
        Arrays.fill(give, 0, points, HARD * least);
        if (soft) {
            soften(rows, sub, least);
        }
        sweep(rows.doubles, rows.lanes);
        apply(rows.doubles, rows.lanes, !soft);
    }

    /**
     * Takes what was given here out of the next warm start, at the end of a sub-step. It was an
     * impact or is still to be found by the sweeps; given again as if it were a load, it would
     * throw the assembly off. So would the friction of an impact, which stopped a wheel that spun:
     * it is left what the normal impulses that stay allow.
     *
     * @return share of what was given here that may be a load: no more than the assembly weighs
     */
    double forget(ConstraintRows rows, double seconds) {
        double given = 0;
        for (int e = 0; e < s.touchCount && s.gives; e++) {
            for (int p = 0; p < rows.points(rows.list.place[s.stand[e]]); p++) {
                given += Math.max(0, s.impactImpulses[Assembly.POINTS * e + p]);
            }
        }
        double load = given > 0 ? mass(rows) * tick.weight() * seconds : 0;
        double share = given > load ? load / given : 1;
        for (int e = 0; e < s.touchCount && s.gives; e++) {
            forgetNormals(rows, e);
            if (share < 1) {
                forgetFriction(rows, s.stand[e]);
            }
        }
        s.gives = false;
        return share;
    }

    private void forgetNormals(ConstraintRows rows, int e) {
        int m = s.stand[e];
        int j = rows.list.place[m];
        int o = rows.base(j);
        for (int p = 0; p < rows.points(j); p++) {
            int q = o + (POINT + p * POINT_FIELDS) * rows.lanes;
            int l = q + IMPULSE * rows.lanes;
            double part = Math.min(s.impactImpulses[Assembly.POINTS * e + p], rows.doubles[l]);
            if (part > 0) {
                rows.doubles[l] -= part;
                takeBack(rows, m, o, q, ARM_B, part);
            }
        }
    }

    /** Draws friction back into the cone {@code |f| <= mu N} of the impulses that are left. */
    private void forgetFriction(ConstraintRows rows, int m) {
        int j = rows.list.place[m];
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int o = rows.base(j);
        double limit = 0;
        for (int p = 0; p < rows.points(j); p++) {
            limit += d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes];
        }
        limit *= d[o + FRICTION * lanes];
        double f1 = d[o + LAMBDA * lanes];
        double f2 = d[o + (LAMBDA + 1) * lanes];
        double f = Math.sqrt(f1 * f1 + f2 * f2);
        double goes = f > limit ? 1 - limit / f : 0;
        for (int t = 0; t < 2 && goes > 0; t++) {
            int l = o + (LAMBDA + t) * lanes;
            double part = goes * d[l];
            d[l] -= part;
            int lever = o + (LEVER + 3 * t) * lanes;
            takeBack(rows, m, o + (TANGENT1 + 3 * t) * lanes, lever, 6, part);
        }
    }

    /**
     * Takes an impulse of a row out of the warm start of its bodies.
     *
     * @param arm of A; B's is {@code toB} fields behind it
     */
    private void takeBack(
            ConstraintRows rows, int m, int direction, int arm, int toB, double impulse) {
        for (int side = 0; side < 2; side++) {
            int body = rows.link[rows.list.place[m] * LINK + side];
            if ((side == 0 ? rows.list.slotA[m] : rows.list.slotB[m]) >= 0) {
                int at = body / SolverBodies.STRIDE * SolverBodies.HALF;
                double signed = side == 0 ? -impulse : impulse;
                int of = arm + side * toB * rows.lanes;
                add(rows.doubles, rows.lanes, direction, of, body, signed, tick.body.mark, at);
            }
        }
    }

    /** Masses of the assembly and of what it is solved with. */
    double mass(ConstraintRows rows) {
        double sum = 0;
        for (int i : s.body) {
            sum += 1 / tick.body.state[SolverBodies.offset(i) + SolverBodies.MASS];
        }
        for (int e = s.standCount; e < s.touchCount; e++) {
            int slot = freeSlot(rows, s.stand[e]);
            double m = 1 / tick.body.state[SolverBodies.offset(slot) + SolverBodies.MASS];
            sum += isFirst(rows, e, slot) ? m : 0;
        }
        return sum;
    }

    /** Whether no contact before one of those with a free body is with the same body. */
    boolean isFirst(ConstraintRows rows, int e, int slot) {
        for (int k = s.standCount; k < e; k++) {
            if (freeSlot(rows, s.stand[k]) == slot) {
                return false;
            }
        }
        return true;
    }

    /** Begins to note what is given to contacts, see {@link #unload}. */
    void noteImpacts() {
        int n = Assembly.POINTS * s.touchCount;
        System.arraycopy(s.impactImpulses, 0, s.firstImpacts, 0, n);
    }

    /**
     * Takes back what was given to contacts since {@link #noteImpacts}, but for the assembly's own
     * velocities.
     */
    void unload(ConstraintRows rows, SubStep sub, boolean soft) {
        gather(rows, sub, true);
        double[] d = rows.doubles;
        for (int p = 0; p < points; p++) {
            double l = s.firstImpacts[place[p]] - s.impactImpulses[place[p]];
            s.impactImpulses[place[p]] = s.firstImpacts[place[p]];
            d[field[p] + IMPULSE * rows.lanes] += l;
            d[sum[p]] += soft ? 0 : l;
            if (free[p] != 0) {
                int other = Math.abs(free[p]);
                double signed = free[p] < 0 ? -l : l;
                int arm = freeArm(p, rows.lanes);
                add(d, rows.lanes, normal[p], arm, other, signed, tick.body.state, other);
            }
        }
    }

    /** The body of a contact between two that move that is not of the assembly. */
    int freeSlot(ConstraintRows rows, int m) {
        int a = rows.list.slotA[m];
        return Arrays.binarySearch(s.body, a) < 0 ? a : rows.list.slotB[m];
    }

    /** Adds what an impulse does to the velocities of a body, or to what stands beside them. */
    private void add(
            double[] d, int lanes, int n, int arm, int body, double impulse, double[] to, int at) {
        double k = impulse * tick.body.state[body + SolverBodies.MASS];
        for (int c = 0; c < 3; c++) {
            to[at + c] += k * d[n + c * lanes];
            to[at + 3 + c] += impulse * d[arm + c * lanes];
        }
    }

    /** Lists the points that may press; the largest speed that one of them misses, m/s. */
    private double gather(ConstraintRows rows, SubStep sub, boolean soft) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        double worst = 0;
        points = 0;
        for (int e = 0; e < s.touchCount; e++) {
            int m = s.stand[e];
            int j = rows.list.place[m];
            int o = rows.base(j);
            boolean isFixed = e < s.standCount;
            int n = Arrays.binarySearch(s.body, rows.list.slotA[m]);
            int side = n >= 0 ? 0 : 1;
            n = n >= 0 ? n : Arrays.binarySearch(s.body, rows.list.slotB[m]);
            int other = isFixed ? 0 : rows.link[j * LINK + 1 - side];
            ensure(points + rows.points(j));
            for (int p = 0; p < rows.points(j); p++) {
                int q = o + (POINT + p * POINT_FIELDS) * lanes;
                double gap = d[q + SEPARATION * lanes];
                double l = d[q + IMPULSE * lanes];
                boolean isOpen = gap > sub.touch;
                if (!soft && isOpen && l == 0) {
                    continue;
                }
                double v = speed(d, lanes, o, q, j * LINK, rows.link);
                v += isOpen ? gap * sub.inverse : soft ? 0 : sub.closing;
                double lift = soft && !isOpen ? push(sub, gap, isFixed) : 0;
                worst = Math.max(worst, l > 0 && !soft ? Math.abs(v) : -(v + lift));
                field[points] = q;
                normal[points] = o;
                sum[points] = o + (SUM + p) * lanes;
                link[points] = rows.link[j * LINK + side] * (side == 0 ? -1 : 1);
                free[points] = side == 0 ? other : -other;
                node[points] = n;
                place[points] = Assembly.POINTS * e + p;
                miss[points] = v;
                give[points++] = 0;
            }
        }
        return worst;
    }

    /** Speed at which a point opens, m/s. */
    private double speed(double[] d, int lanes, int o, int q, int l, int[] links) {
        double[] v = tick.body.state;
        int a = links[l];
        int b = links[l + ConstraintRows.BODY_B];
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            sum += d[o + c * lanes] * (v[b + c] - v[a + c]);
            sum += d[q + (ARM_B + c) * lanes] * v[b + 3 + c] - d[q + c * lanes] * v[a + 3 + c];
        }
        return sum;
    }

    /** Solves for what each point does to all bodies, and what of that the others feel. */
    private void couple(double[] d, int lanes) {
        BlockFactors f = s.factors;
        for (int q = 0; q < points; q++) {
            Arrays.fill(f.x(), 0.0);
            load(d, lanes, q, 1);
            f.solve();
            for (int p = 0; p < points; p++) {
                coupling[p * points + q] = speedAt(d, lanes, p) + answer(d, lanes, p, q);
            }
        }
    }

    /** Adds an impulse at a point to the right-hand side. */
    private void load(double[] d, int lanes, int p, double impulse) {
        double[] x = s.factors.x();
        int u = s.factors.unknown(node[p]);
        int arm = arm(p, lanes);
        double l = link[p] < 0 ? -impulse : impulse;
        double root = l * Math.sqrt(tick.body.state[Math.abs(link[p]) + SolverBodies.MASS]);
        for (int c = 0; c < 3; c++) {
            x[u + c] += root * d[normal[p] + c * lanes];
            x[u + 3 + c] += l * d[arm + c * lanes];
        }
    }

    /** Speed that the solution gives a point along its normal, m/s. */
    private double speedAt(double[] d, int lanes, int p) {
        double[] x = s.factors.x();
        int u = s.factors.unknown(node[p]);
        int arm = arm(p, lanes);
        double root = Math.sqrt(tick.body.state[Math.abs(link[p]) + SolverBodies.MASS]);
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            sum += root * d[normal[p] + c * lanes] * x[u + c];
            sum += d[arm + c * lanes] * x[u + 3 + c];
        }
        return link[p] < 0 ? -sum : sum;
    }

    /** What a point feels of an impulse at another one as both are of the same free body, m/s. */
    private double answer(double[] d, int lanes, int p, int q) {
        int o = Math.abs(free[p]);
        if (o == 0 || o != Math.abs(free[q])) {
            return 0;
        }
        double k = tick.body.state[o + SolverBodies.MASS];
        int armP = freeArm(p, lanes);
        int armQ = freeArm(q, lanes);
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            sum += k * d[normal[p] + c * lanes] * d[normal[q] + c * lanes];
            sum += d[armP + c * lanes] * d[armQ + c * lanes];
        }
        return free[p] < 0 == free[q] < 0 ? sum : -sum;
    }

    private int freeArm(int p, int lanes) {
        return field[p] + (free[p] < 0 ? 0 : ARM_B * lanes);
    }

    private int arm(int p, int lanes) {
        return field[p] + (link[p] < 0 ? 0 : ARM_B * lanes);
    }

    /**
     * Goals of points that overlap: {@code v + rate s/massScale + give l = 0}, with the give of the
     * mass that the whole assembly is to the point.
     */
    private void soften(ConstraintRows rows, SubStep sub, double least) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        for (int p = 0; p < points; p++) {
            double gap = d[field[p] + SEPARATION * lanes];
            if (!(gap > sub.touch)) {
                double k = Math.max(coupling[p * points + p], least);
                boolean isFixed = free[p] == 0;
                give[p] =
                        isFixed
                                ? sub.fixedImpulseScale * k / sub.fixedMassScale
                                : sub.impulseScale * k / sub.massScale;
                miss[p] += push(sub, gap, isFixed) + give[p] * d[field[p] + IMPULSE * lanes];
            }
        }
    }

    /** Speed at which an overlap is to close, negative, m/s. */
    private static double push(SubStep sub, double gap, boolean isFixed) {
        double rate = isFixed ? sub.fixedRate : sub.rate;
        return Math.max(gap * rate, -sub.pushSpeed)
                / (isFixed ? sub.fixedMassScale : sub.massScale);
    }

    /** Projected Gauss-Seidel: {@code l = max(l - miss/(k + give), 0)}, point by point. */
    private void sweep(double[] d, int lanes) {
        Arrays.fill(change, 0, points, 0.0);
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            double moved = 0;
            double largest = 0;
            for (int p = 0; p < points; p++) {
                double own = coupling[p * points + p] + give[p];
                if (!(own > 0)) {
                    continue;
                }
                double lacks = miss[p] + give[p] * change[p];
                for (int q = 0; q < points; q++) {
                    lacks += coupling[p * points + q] * change[q];
                }
                double old = d[field[p] + IMPULSE * lanes];
                double next = Math.max(change[p] - lacks / own, -old);
                moved = Math.max(moved, Math.abs(next - change[p]));
                largest = Math.max(largest, old + next);
                change[p] = next;
            }
            if (!(moved > AGREES * largest)) {
                return;
            }
        }
    }

    /** Adds the impulses of points and joints. */
    private void apply(double[] d, int lanes, boolean isLast) {
        BlockFactors f = s.factors;
        double[] v = tick.body.state;
        Arrays.fill(f.x(), 0.0);
        s.gives = true;
        for (int p = 0; p < points; p++) {
            double l = change[p];
            load(d, lanes, p, l);
            d[field[p] + IMPULSE * lanes] += l;
            d[sum[p]] += isLast ? l : 0;
            s.impactImpulses[place[p]] += l;
            int o = Math.abs(link[p]);
            add(d, lanes, normal[p], arm(p, lanes), o, link[p] < 0 ? -l : l, v, o);
            if (free[p] != 0) {
                int other = Math.abs(free[p]);
                double signed = free[p] < 0 ? -l : l;
                add(d, lanes, normal[p], freeArm(p, lanes), other, signed, v, other);
            }
        }
        f.solve();
        addImpulses();
    }

    private void ensure(int count) {
        if (count > field.length) {
            int n = 2 * count;
            field = Arrays.copyOf(field, n);
            normal = Arrays.copyOf(normal, n);
            sum = Arrays.copyOf(sum, n);
            link = Arrays.copyOf(link, n);
            node = Arrays.copyOf(node, n);
            place = Arrays.copyOf(place, n);
            free = Arrays.copyOf(free, n);
            miss = Arrays.copyOf(miss, n);
            give = Arrays.copyOf(give, n);
            change = Arrays.copyOf(change, n);
            coupling = new double[n * n];
        }
    }
}
