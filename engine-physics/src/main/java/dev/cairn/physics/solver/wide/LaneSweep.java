package dev.cairn.physics.solver.wide;

import static dev.cairn.physics.solver.kernel.CommonStep.HARD;
import static dev.cairn.physics.solver.kernel.CommonStep.NONE;
import static dev.cairn.physics.solver.kernel.CommonStep.SOFT;
import static dev.cairn.physics.solver.row.Scratch.LANDS;
import static dev.cairn.physics.solver.row.Scratch.ONES;
import static dev.cairn.physics.solver.row.Scratch.SLIDES;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.Sweep;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

/**
 * The sweeps with one row to a lane, by the Vector API. The arithmetic of a lane is that of {@link
 * ScalarSweep}, operation by operation; a lane that has to do no more gets a gain of zero.
 *
 * <p>The kernels' classes are made once for each number of lanes, as hidden classes, so that their
 * species is a constant. They call the Vector API directly and keep vectors in locals: a helper
 * that takes or returns one would box it as soon as it is not inlined. A chunk of rows is gathered
 * into scratch, solved there group by group, and scattered; kernels hand numbers on in scratch.
 */
final class LaneSweep implements Sweep {
    private final int lanes;
    private final LaneKernels.Bodies bodies;
    private final LaneKernels.Normals normals;
    private final LaneKernels.Points four;
    private final LaneKernels.Points few;
    private final LaneKernels.Friction friction;

    LaneSweep(
            int lanes,
            LaneKernels.Bodies bodies,
            LaneKernels.Normals normals,
            LaneKernels.Points four,
            LaneKernels.Points few,
            LaneKernels.Friction friction) {
        this.lanes = lanes;
        this.bodies = bodies;
        this.normals = normals;
        this.four = four;
        this.few = few;
        this.friction = friction;
    }

    @Override
    public void bias(
            ConstraintRows rows,
            SolverBodies body,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        double[] st = scratch.doubles;
        bodies.gather(body, rows.link, from, to, st);
        normals.begin(rows, from, to, st, 0);
        normals.soften(rows, from, to, st, 0, sub, ONES);
        int more = sub.landingSweeps - sub.sweeps;
        if (sweep(rows, from, to, st, 0, sub.sweeps, SOFT) && more > 0) {
            for (int j = from; j < to; j += lanes) {
                int g = j - from;
                if (any(st, LANDS + g)) {
                    normals.soften(rows, j, j + lanes, st, g, sub, LANDS);
                    sweep(rows, j, j + lanes, st, g, more, NONE);
                }
            }
        }
        normals.load(rows, from, to, st, 0);
        bodies.scatter(body, rows.link, from, to, st);
    }

    @Override
    public void relax(
            ConstraintRows rows,
            SolverBodies body,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        double[] st = scratch.doubles;
        bodies.gather(body, rows.link, from, to, st);
        bodies.gatherMovement(body, rows.link, from, to, st);
        if (!normals.separate(rows, from, to, st, 0, sub)) {
            return;
        }
        normals.harden(rows, from, to, st, 0, sub, ONES);
        if (sweep(rows, from, to, st, 0, sub.sweeps, HARD)) {
            for (int j = from; j < to; j += lanes) {
                int g = j - from;
                if (any(st, LANDS + g)) {
                    normals.harden(rows, j, j + lanes, st, g, sub, LANDS);
                    sweep(rows, j, j + lanes, st, g, sub.landingSweeps - sub.sweeps, NONE);
                }
            }
        }
        if (friction.solve(rows, from, to, st, 0, ONES)) {
            for (int j = from; j < to; j += lanes) {
                moreFriction(rows, sub, j, st, j - from);
            }
        }
        friction.total(rows, from, to, st, 0);
        bodies.scatter(body, rows.link, from, to, st);
    }

    /** Sweeps over the points of the busy groups; whether a lane that lands needs more. */
    private boolean sweep(
            ConstraintRows rows, int from, int to, double[] st, int g, int sweeps, int step) {
        boolean lands = false;
        for (int j = from, l = g; j < to; j += lanes, l += lanes) {
            if (st[Scratch.IDLE + l] == 0) {
                int n = rows.points[j / lanes];
                int o = ConstraintRows.START + j * ConstraintRows.FIELDS;
                int k = Scratch.PACKED + l * Scratch.PACK;
                LaneKernels.Points points = n > 2 ? four : few;
                lands |= points.sweep(rows.doubles, o, st, k, l, n, sweeps, step);
            }
        }
        return lands;
    }

    /** Friction without a warm start has its normals still to agree with. */
    private void moreFriction(ConstraintRows rows, SubStep sub, int j, double[] st, int g) {
        int end = j + lanes;
        boolean again = any(st, SLIDES + g);
        for (int round = 1; again && round < sub.coldRounds; round++) {
            normals.harden(rows, j, end, st, g, sub, SLIDES);
            sweep(rows, j, end, st, g, sub.landingSweeps, NONE);
            again = friction.solve(rows, j, end, st, g, SLIDES);
        }
    }

    private boolean any(double[] st, int marks) {
        for (int i = marks; i < marks + lanes; i++) {
            if (st[i] > 0) {
                return true;
            }
        }
        return false;
    }
}
