package dev.cairn.physics.solver.wide;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.CommonStep;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * The kernels of a number of lanes, one interface to a class that is made for it.
 *
 * <p>Each goes over the groups from place {@code from} to {@code to} of a colour, a chunk at most.
 * Their bodies are in scratch from lane {@code g} on, which is place {@code from}.
 */
final class LaneKernels {
    private LaneKernels() {}

    /** Copies the bodies of a chunk of rows to scratch, one row to a lane, and back. */
    interface Bodies {
        /** The first 8 numbers of A and B of the rows from {@code from} to {@code to}. */
        void gather(SolverBodies bodies, int[] link, int from, int to, double[] scratch);

        /** Their movements. */
        void gatherMovement(SolverBodies bodies, int[] link, int from, int to, double[] scratch);

        /** Writes what {@link #gather} has read, except to what does not move. */
        void scatter(SolverBodies bodies, int[] link, int from, int to, double[] scratch);
    }

    /** Normal impulses. */
    interface Normals {
        /** Marks the rows that have no impulse to start with, and all groups as busy. */
        void begin(ConstraintRows rows, int from, int to, double[] st, int g);

        /** Gains and goals of the soft step, for the lanes that are marked at {@code marks}. */
        void soften(
                ConstraintRows rows, int from, int to, double[] st, int g, SubStep sub, int marks);

        /** The same, hard. */
        void harden(
                ConstraintRows rows, int from, int to, double[] st, int g, SubStep sub, int marks);

        /**
         * Where the points are after the movement of the sub-step. A group whose points are all
         * open, without an impulse, is marked as idle: the relax pass has nothing to do there,
         * since the bias pass has left no negative zeros.
         *
         * @return whether a group is busy
         */
        boolean separate(ConstraintRows rows, int from, int to, double[] st, int g, SubStep sub);

        /** Marks the bodies that are pressed on. */
        void load(ConstraintRows rows, int from, int to, double[] st, int g);
    }

    /** Sweeps over the points of one group. */
    interface Points {
        /**
         * Sweeps over the points, after one common step of all.
         *
         * @param o index of the group's first field in {@code d}
         * @param k its pack in scratch
         * @param g its first lane there
         * @param step see {@link CommonStep}
         * @return whether a lane that lands needs more sweeps
         */
        boolean sweep(
                double[] d, int o, double[] st, int k, int g, int points, int sweeps, int step);
    }

    /** Friction, and the totals of the tick. */
    interface Friction {
        /**
         * Twist and friction of the lanes that are marked at {@code marks}, in busy groups.
         *
         * @return whether a lane without a warm start presses, and so needs another round
         */
        boolean solve(ConstraintRows rows, int from, int to, double[] st, int g, int marks);

        /** Adds the impulses of the sub-step to those of the tick, in busy groups. */
        void total(ConstraintRows rows, int from, int to, double[] st, int g);
    }
}
