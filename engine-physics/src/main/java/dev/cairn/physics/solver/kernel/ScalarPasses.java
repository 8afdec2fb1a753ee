package dev.cairn.physics.solver.kernel;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

/** What is done to rows one by one only. */
public interface ScalarPasses extends Sweep {
    /**
     * Hard normals and friction of the rows that are marked as unloaded, over and over; no totals:
     * the sweeps only correct the first guess of the sub-step.
     */
    void settle(
            ConstraintRows rows,
            SolverBodies bodies,
            SubStep sub,
            int rounds,
            int from,
            int to,
            Scratch scratch);

    /**
     * Friction of a row with a kinematic body, before the bodies move: else what stands on one that
     * speeds up would begin each tick a sub-step late.
     */
    void carry(ConstraintRows rows, SolverBodies bodies, SubStep sub, int place, Scratch scratch);

    /** Rolling impulses that a sub-step does not start with, before the bias pass of a range. */
    void calm(ConstraintRows rows, SolverBodies bodies, int from, int to);

    /** Rolling friction of a range of rows of one colour, after their relax pass. */
    void roll(ConstraintRows rows, SolverBodies bodies, int from, int to);

    /** Friction of the rows of a range whose surfaces run along, after their relax pass. */
    void drag(ConstraintRows rows, SolverBodies bodies, int from, int to);

    /** Brings the separations of a range of rows up to date whose bodies an impact has shifted. */
    void separate(ConstraintRows rows, SolverBodies bodies, int from, int to);

    /** Offsets of a row once more, after it has been stored: so many times as fast as others. */
    void learn(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int place,
            int times);
}
