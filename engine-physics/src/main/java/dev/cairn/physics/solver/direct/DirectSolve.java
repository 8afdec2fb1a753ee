package dev.cairn.physics.solver.direct;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * Solves the contacts of an island together, after a pass has swept them one by one: which points
 * press and which stick is as the sweeps left it; with these all impulses are found at once.
 *
 * <p>Problem: a column of 200 boxes leans a little, and its lowest contacts must answer within the
 * tick. A sweep moves that knowledge on by a contact or so, so that the column falls, however stiff
 * its springs are. With {@code J} the Jacobian of the active constraints, {@code r} the speeds that
 * they miss and {@code E} their give, {@code (J J^T + E) dl = -r} has as many unknowns as there are
 * constraints, and of four points of a face one too many. So it is solved by bodies:
 *
 * <pre>
 *   (1 + J^T E^-1 J) du = -J^T E^-1 r,    dl = -E^-1 (r + J du)
 * </pre>
 *
 * <p>which is positive definite, six unknowns to a body, see {@link SkylineLdlt}. A normal impulse
 * that would pull becomes 0; then one sweep brings friction back into its circle and presses what
 * would close. If the largest speed that is missed is not less than before, all is as if nothing
 * had been done. A soft pass has the give of its springs, so that they are solved exactly; in a
 * hard one it is small.
 *
 * <p>Scalar code, in the order of the list of contacts: the same bits for all lanes and workers.
 * Any worker, one to an island. Allocates only to grow. Source: M. Silcowitz, S. Niebe, K. Erleben,
 * "Projected Gauss-Seidel subspace minimization method for interactive rigid body dynamics" (GRAPP
 * 2010), for sweeps that choose what is active and a solve that follows.
 */
public final class DirectSolve {
    /**
     * Speed that is missed, over what gravity adds in a sub-step, from which on an island is
     * solved. With 1e-4 tall columns fall: sweeps then have what is small, and it grows.
     */
    private static final double WORTH = 1e-6;

    /** Numbers to a contact that a solve may change: impulses and their totals. */
    private static final int KEPT = 2 * DirectRow.COUNT;

    private final DirectRow row = new DirectRow();

    private double[] miss = {};
    private double[] stiffness = {};

    /** What was before. */
    private double[] kept = {};

    private DirectIslands islands = new DirectIslands();
    private SkylineLdlt matrix = new SkylineLdlt();
    private double[] body = {};
    private int head;
    private int bodies;
    private int from;
    private int to;

    /**
     * Solves an island.
     *
     * @param island of {@code all}
     * @param renewed whether levers may have changed since the last sub-step
     * @param soft whether after the bias pass; else after the relax pass
     * @param gain what gravity adds to a speed in the sub-step, m/s
     * @param scratch of the worker
     */
    public void run(
            ConstraintRows rows,
            double[] state,
            SubStep sub,
            DirectIslands all,
            int island,
            boolean renewed,
            boolean soft,
            double gain,
            double[] scratch) {
        islands = all;
        body = state;
        head = all.firstBody[island];
        bodies = all.firstBody[island + 1] - head;
        from = all.firstRow[island];
        to = all.firstRow[island + 1];
        double before = look(rows, sub, soft);
        if (!(before > WORTH * gain)) {
            return;
        }
        keep(rows, false);
        DirectFactors factors = all.factors(island, soft);
        matrix = factors.matrix;
        boolean same = factors.matches(stiffness, DirectRow.COUNT * (to - from)) && !renewed;
        assemble(rows, !same);
        if (!same && !matrix.factor()) {
            factors.forget();
            return;
        }
        matrix.solve();
        apply(rows, soft);
        for (int e = from; e < to; e++) {
            open(rows, e);
            if (soft) {
                row.sweepSoft(sub, scratch);
            } else {
                row.sweepHard(sub, scratch);
            }
        }
        if (!(look(rows, sub, soft) < before)) {
            keep(rows, true);
        }
    }

    /** What the contacts of an island have learnt of their loads, at the end of a tick. */
    public void learn(
            SolverContext tick, ConstraintRows rows, SubStep sub, DirectIslands of, int island) {
        islands = of;
        body = tick.body.state;
        from = islands.firstRow[island];
        to = islands.firstRow[island + 1];
        for (int e = from; e < to; e++) {
            int source = rows.list.source[islands.row[e]];
            open(rows, e);
            row.learn(tick.contacts, source, sub);
        }
    }

    /**
     * Makes room for any of these islands. Simulation thread: which worker meets the largest one is
     * left to timing, and what a tick allocates is not.
     */
    public void reserve(DirectIslands all) {
        int contacts = all.mostRows();
        int bodies = all.mostBodies();
        if (miss.length < DirectRow.COUNT * contacts) {
            miss = new double[2 * DirectRow.COUNT * contacts];
            stiffness = new double[miss.length];
        }
        int size = KEPT * contacts + SolverBodies.HALF * bodies;
        if (kept.length < size) {
            kept = new double[2 * size];
        }
    }

    private void open(ConstraintRows rows, int e) {
        row.open(rows, rows.list.place[islands.row[e]], body);
    }

    /** What each constraint misses, and its stiffness; returns the largest speed that is missed. */
    private double look(ConstraintRows rows, SubStep sub, boolean soft) {
        double worst = 0;
        for (int e = from; e < to; e++) {
            open(rows, e);
            int at = DirectRow.COUNT * (e - from);
            worst = Math.max(worst, row.points(sub, soft, miss, stiffness, at));
            if (!soft) {
                worst = Math.max(worst, row.friction(miss, stiffness, at));
            }
        }
        return worst;
    }

    /** The row of blocks of a body, -1 if it does not move. */
    private int block(int offset) {
        return row.moves(offset) ? islands.local[SolverBodies.slot(offset)] : -1;
    }

    /** {@code -J^T E^-1 r}, and {@code 1 + J^T E^-1 J} if it is another one. */
    private void assemble(ConstraintRows rows, boolean anew) {
        if (anew) {
            matrix.begin(bodies, islands.firstBlock, head);
        }
        matrix.clear();
        for (int e = from; e < to; e++) {
            open(rows, e);
            int i = block(row.a);
            int j = block(row.b);
            for (int f = 0; f < DirectRow.COUNT; f++) {
                double k = stiffness[DirectRow.COUNT * (e - from) + f];
                if (k == 0) {
                    continue;
                }
                double r = -k * miss[DirectRow.COUNT * (e - from) + f];
                row.load(f);
                if (anew) {
                    add(i, j, k);
                }
                if (i >= 0) {
                    matrix.push(i, row.jacobianA, r);
                }
                if (j >= 0) {
                    matrix.push(j, row.jacobianB, r);
                }
            }
        }
    }

    private void add(int i, int j, double k) {
        if (i >= 0) {
            matrix.add(i, row.jacobianA, i, row.jacobianA, k);
        }
        if (j >= 0) {
            matrix.add(j, row.jacobianB, j, row.jacobianB, k);
        }
        if (i > j && j >= 0) {
            matrix.add(i, row.jacobianA, j, row.jacobianB, k);
        } else if (i >= 0 && j >= 0) {
            matrix.add(j, row.jacobianB, i, row.jacobianA, k);
        }
    }

    /** {@code dl = -E^-1 (r + J du)}. */
    private void apply(ConstraintRows rows, boolean soft) {
        for (int e = from; e < to; e++) {
            open(rows, e);
            int i = block(row.a);
            int j = block(row.b);
            for (int f = 0; f < DirectRow.COUNT; f++) {
                double k = stiffness[DirectRow.COUNT * (e - from) + f];
                if (k == 0) {
                    continue;
                }
                row.load(f);
                double v = miss[DirectRow.COUNT * (e - from) + f];
                v += i >= 0 ? matrix.dot(i, row.jacobianA) : 0;
                v += j >= 0 ? matrix.dot(j, row.jacobianB) : 0;
                row.change(-k * v, f < 4, !soft);
            }
        }
    }

    /** Remembers impulses and velocities, or brings them back. */
    private void keep(ConstraintRows rows, boolean back) {
        int k = 0;
        for (int e = from; e < to; e++) {
            open(rows, e);
            for (int f = 0; f < DirectRow.COUNT; f++) {
                row.load(f);
                keep(rows.doubles, row.impulse, k++, back);
                keep(rows.doubles, row.total, k++, back);
            }
        }
        for (int i = head; i < head + bodies; i++) {
            int o = SolverBodies.offset(islands.body[i]);
            for (int f = 0; f <= SolverBodies.LOADED; f++) {
                keep(body, o + f, k++, back);
            }
        }
    }

    private void keep(double[] of, int at, int k, boolean back) {
        if (back) {
            of[at] = kept[k];
        } else {
            kept[k] = of[at];
        }
    }
}
