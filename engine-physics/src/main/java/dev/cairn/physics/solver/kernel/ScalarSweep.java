package dev.cairn.physics.solver.kernel;

import static dev.cairn.physics.solver.body.SolverBodies.LOADED;
import static dev.cairn.physics.solver.body.SolverBodies.MASS;
import static dev.cairn.physics.solver.kernel.CommonStep.HARD;
import static dev.cairn.physics.solver.kernel.CommonStep.NONE;
import static dev.cairn.physics.solver.kernel.CommonStep.SOFT;
import static dev.cairn.physics.solver.row.ConstraintRows.COLD;
import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

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
public final class ScalarSweep implements ScalarPasses {
    /** Normals and friction of a row agree after some ten rounds, or here. */
    private static final int ROUNDS = 64;

    /** Change of a friction impulse, over itself, that is rounding. */
    private static final double AGREED = 1e-14;

    @Override
    public void bias(
            ConstraintRows rows,
            SolverBodies bodies,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        double[] d = rows.doubles;
        double[] st = scratch.doubles;
        double[] body = bodies.state;
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
            boolean fixed = body[a + MASS] == 0 || body[b + MASS] == 0;
            boolean cold = RowArithmetic.sum(d, o, lanes, n) == 0;
            d[o + COLD * lanes] = cold ? 1 : 0;
            ScalarNormals.soften(d, o, lanes, n, fixed, sub, st);
            boolean moved = ScalarNormals.sweep(d, o, lanes, body, a, b, n, sub.sweeps, SOFT, st);
            int more = sub.landingSweeps - sub.sweeps;
            if (cold && moved && more > 0) {
                ScalarNormals.soften(d, o, lanes, n, fixed, sub, st);
                ScalarNormals.sweep(d, o, lanes, body, a, b, n, more, NONE, st);
            }
            if (RowArithmetic.sum(d, o, lanes, n) > 0) {
                body[a + LOADED] = a == 0 ? 0 : 1;
                body[b + LOADED] = b == 0 ? 0 : 1;
            }
        }
    }

    @Override
    public void relax(
            ConstraintRows rows,
            SolverBodies bodies,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        double[] d = rows.doubles;
        double[] st = scratch.doubles;
        double[] body = bodies.state;
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
            ScalarNormals.separate(d, o, lanes, body, a, b, n);
            // a contact without a warm start, or with that of an impact, has its normals and its
            // friction still to agree on what each of them stops
            boolean cold = d[o + COLD * lanes] > 0;
            boolean moved = hard(d, o, lanes, body, a, b, n, sub, sub.sweeps, HARD, st);
            if (cold && moved) {
                int more = sub.landingSweeps - sub.sweeps;
                hard(d, o, lanes, body, a, b, n, sub, more, NONE, st);
            }
            if (d[o + FRICTION * lanes] > 0) {
                cold |= ScalarFriction.isStale(d, o, lanes, n);
                double normal = ScalarFriction.solve(d, o, lanes, body, a, b, n);
                for (int round = 1; cold && normal > 0 && round < sub.coldRounds; round++) {
                    hard(d, o, lanes, body, a, b, n, sub, sub.landingSweeps, NONE, st);
                    normal = ScalarFriction.solve(d, o, lanes, body, a, b, n);
                }
            }
            ScalarFriction.total(d, o, lanes, n);
        }
    }

    /** Hard normals; whether the last sweep changed an impulse. */
    public static boolean hard(
            double[] d,
            int o,
            int lanes,
            double[] body,
            int a,
            int b,
            int points,
            SubStep sub,
            int sweeps,
            int step,
            double[] st) {
        ScalarNormals.harden(d, o, lanes, points, sub, st);
        return ScalarNormals.sweep(d, o, lanes, body, a, b, points, sweeps, step, st);
    }

    @Override
    public void settle(
            ConstraintRows rows,
            SolverBodies bodies,
            SubStep sub,
            int rounds,
            int from,
            int to,
            Scratch scratch) {
        double[] d = rows.doubles;
        double[] st = scratch.doubles;
        double[] body = bodies.state;
        int[] link = rows.link;
        int lanes = rows.lanes;
        for (int round = 0; round < rounds; round++) {
            for (int j = from; j < to; j++) {
                if (rows.settleMark[j] != 1) {
                    continue;
                }
                int l = j * LINK;
                int n = link[l + ConstraintRows.COUNT];
                int o = rows.base(j);
                int a = link[l];
                int b = link[l + 1];
                hard(d, o, lanes, body, a, b, n, sub, sub.sweeps, NONE, st);
                if (d[o + FRICTION * lanes] > 0) {
                    ScalarFriction.solve(d, o, lanes, body, a, b, n);
                }
            }
        }
    }

    @Override
    public void carry(
            ConstraintRows rows, SolverBodies bodies, SubStep sub, int place, Scratch scratch) {
        double[] d = rows.doubles;
        double[] st = scratch.doubles;
        double[] body = bodies.state;
        int[] link = rows.link;
        int lanes = rows.lanes;
        int l = place * LINK;
        int n = link[l + ConstraintRows.COUNT];
        int o = rows.base(place);
        int a = link[l];
        int b = link[l + 1];
        int f = o + ConstraintRows.LAMBDA * lanes;
        for (int round = 0; n > 0 && d[o + FRICTION * lanes] > 0 && round < ROUNDS; round++) {
            double x = d[f];
            double y = d[f + lanes];
            ScalarFriction.solve(d, o, lanes, body, a, b, n);
            double change = Math.abs(d[f] - x) + Math.abs(d[f + lanes] - y);
            if (!(change > AGREED * (Math.abs(x) + Math.abs(y)))) {
                return;
            }
            ScalarNormals.soften(d, o, lanes, n, true, sub, st);
            ScalarNormals.sweep(d, o, lanes, body, a, b, n, sub.landingSweeps, NONE, st);
        }
    }

    @Override
    public void calm(ConstraintRows rows, SolverBodies bodies, int from, int to) {
        RollingFriction.calm(rows, bodies, from, to);
    }

    @Override
    public void roll(ConstraintRows rows, SolverBodies bodies, int from, int to) {
        RollingFriction.sweep(rows, bodies, from, to);
    }

    @Override
    public void drag(ConstraintRows rows, SolverBodies bodies, int from, int to) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        for (int j = from; j < to; j++) {
            if (!rows.drags.has(j)) {
                continue;
            }
            int o = rows.base(j);
            int l = j * LINK;
            double u1 = /*(float)*/ rows.drags.speed(rows, j, 0);
            double u2 = /*(float)*/ rows.drags.speed(rows, j, 1);
            ScalarFriction.solve(
                    d,
                    o,
                    lanes,
                    bodies.state,
                    rows.link[l],
                    rows.link[l + 1],
                    rows.link[l + ConstraintRows.COUNT],
                    u1,
                    u2);
            for (int k = 0; k < 3; k++) {
                d[o + (ConstraintRows.TOTAL + k) * lanes] +=
                        d[o + (ConstraintRows.LAMBDA + k) * lanes];
            }
        }
    }

    @Override
    public void learn(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int place,
            int times) {
        int source = rows.link[place * LINK + ConstraintRows.SOURCE];
        Offsets.update(rows, bodies, contacts, source, place, sub, times);
    }

    @Override
    public void separate(ConstraintRows rows, SolverBodies bodies, int from, int to) {
        double[] body = bodies.state;
        int[] link = rows.link;
        for (int j = from; j < to; j++) {
            int l = j * LINK;
            int n = link[l + ConstraintRows.COUNT];
            int a = link[l];
            int b = link[l + 1];
            if (n > 0 && (bodies.isShifted(a) || bodies.isShifted(b))) {
                ScalarNormals.separate(rows.doubles, rows.base(j), rows.lanes, body, a, b, n);
            }
        }
    }
}
