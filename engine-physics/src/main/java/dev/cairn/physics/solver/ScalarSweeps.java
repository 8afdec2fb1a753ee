package dev.cairn.physics.solver;

import static dev.cairn.physics.solver.ConstraintRows.COLD;
import static dev.cairn.physics.solver.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.ConstraintRows.LINK;
import static dev.cairn.physics.solver.LaneKernels.Points.HARD;
import static dev.cairn.physics.solver.LaneKernels.Points.NONE;
import static dev.cairn.physics.solver.LaneKernels.Points.SOFT;
import static dev.cairn.physics.solver.SolverBodies.LOADED;
import static dev.cairn.physics.solver.SolverBodies.MASS;

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
    private final RowStore store = new StoreRow();

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
    public void store(
            ConstraintRows rows,
            double[] body,
            ContactStore contacts,
            SubStep sub,
            double gain,
            double still,
            int from,
            int to,
            double[] scratch) {
        store.store(rows, body, contacts, sub, gain, still, from, to, scratch);
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
            int a = link[l];
            int b = link[l + 1];
            boolean fixed = body[a + MASS] == 0 || body[b + MASS] == 0;
            boolean cold = ScalarNormals.sum(d, o, lanes, n) == 0;
            d[o + COLD * lanes] = cold ? 1 : 0;
            ScalarNormals.soften(d, o, lanes, n, fixed, sub, scratch);
            boolean moved =
                    ScalarNormals.sweep(d, o, lanes, body, a, b, n, sub.sweeps, SOFT, scratch);
            int more = sub.landing - sub.sweeps;
            if (cold && moved && more > 0) {
                ScalarNormals.soften(d, o, lanes, n, fixed, sub, scratch);
                ScalarNormals.sweep(d, o, lanes, body, a, b, n, more, NONE, scratch);
            }
            if (ScalarNormals.sum(d, o, lanes, n) > 0) {
                body[a + LOADED] = a == 0 ? 0 : 1;
                body[b + LOADED] = b == 0 ? 0 : 1;
            }
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
            ScalarNormals.separate(d, o, lanes, body, a, b, n);
            // a contact without a warm start, or with that of a blow, has its normals and its
            // friction still to agree on who stops what
            boolean cold = d[o + COLD * lanes] > 0;
            boolean moved =
                    hard(d, o, lanes, body, a, b, n, sub.inverse, sub.sweeps, HARD, scratch);
            if (cold && moved) {
                int more = sub.landing - sub.sweeps;
                hard(d, o, lanes, body, a, b, n, sub.inverse, more, NONE, scratch);
            }
            if (d[o + FRICTION * lanes] > 0) {
                cold |= ScalarFriction.isStale(d, o, lanes, n);
                double normal = ScalarFriction.rub(d, o, lanes, body, a, b, n);
                for (int round = 1; cold && normal > 0 && round < sub.coldRounds; round++) {
                    hard(d, o, lanes, body, a, b, n, sub.inverse, sub.landing, NONE, scratch);
                    normal = ScalarFriction.rub(d, o, lanes, body, a, b, n);
                }
            }
            ScalarFriction.total(d, o, lanes, n);
        }
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
            int sweeps,
            int step,
            double[] scratch) {
        ScalarNormals.harden(d, o, lanes, points, inverse, scratch);
        return ScalarNormals.sweep(d, o, lanes, body, a, b, points, sweeps, step, scratch);
    }

    /** One more sweep of the relax pass over a row; returns the largest change of an impulse. */
    static double again(ConstraintRows rows, double[] body, SubStep sub, int j, double[] scratch) {
        double[] d = rows.row;
        int lanes = rows.lanes;
        int l = j * LINK;
        int a = rows.link[l];
        int b = rows.link[l + 1];
        int n = rows.link[l + ConstraintRows.COUNT];
        int o = rows.base(j);
        hard(d, o, lanes, body, a, b, n, sub.inverse, sub.sweeps, HARD, scratch);
        double worst = 0;
        for (int p = 0; p < n; p++) {
            double change = scratch[Scratch.CHANGE + p];
            d[o + (ConstraintRows.SUM + p) * lanes] += change;
            worst = Math.max(worst, Math.abs(change));
        }
        if (d[o + FRICTION * lanes] > 0) {
            double x = d[o + ConstraintRows.LAMBDA * lanes];
            double y = d[o + (ConstraintRows.LAMBDA + 1) * lanes];
            double twist = d[o + (ConstraintRows.LAMBDA + 2) * lanes];
            ScalarFriction.rub(d, o, lanes, body, a, b, n);
            x = d[o + ConstraintRows.LAMBDA * lanes] - x;
            y = d[o + (ConstraintRows.LAMBDA + 1) * lanes] - y;
            twist = d[o + (ConstraintRows.LAMBDA + 2) * lanes] - twist;
            d[o + ConstraintRows.TOTAL * lanes] += x;
            d[o + (ConstraintRows.TOTAL + 1) * lanes] += y;
            d[o + (ConstraintRows.TOTAL + 2) * lanes] += twist;
            worst = Math.max(worst, Math.max(Math.abs(x), Math.abs(y)));
        }
        return worst;
    }

    /**
     * Hard normals and friction of the rows that are marked as unloaded, over and over; no totals:
     * the sweeps only correct the first guess of the sub-step.
     */
    static void settle(
            ConstraintRows rows,
            double[] body,
            SubStep sub,
            int rounds,
            int from,
            int to,
            double[] scratch) {
        double[] d = rows.row;
        int[] link = rows.link;
        int lanes = rows.lanes;
        for (int round = 0; round < rounds; round++) {
            for (int j = from; j < to; j++) {
                if (rows.unloaded[j] == 0) {
                    continue;
                }
                int l = j * LINK;
                int a = link[l];
                int b = link[l + 1];
                int n = link[l + ConstraintRows.COUNT];
                int o = rows.base(j);
                hard(d, o, lanes, body, a, b, n, sub.inverse, sub.sweeps, NONE, scratch);
                if (d[o + FRICTION * lanes] > 0) {
                    ScalarFriction.rub(d, o, lanes, body, a, b, n);
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
                int a = rows.link[l];
                ScalarNormals.separate(rows.row, o, rows.lanes, body, a, rows.link[l + 1], n);
            }
        }
    }
}
