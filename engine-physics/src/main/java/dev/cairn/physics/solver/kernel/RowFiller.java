package dev.cairn.physics.solver.kernel;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

/** Fills constraint rows; {@link PrepareRow} and the wide fillers give the same bits. */
public interface RowFiller {
    /**
     * Fills the places from {@code from} to {@code to} of one colour, both at the bounds of groups,
     * and adds the last impulses to the bodies' warm start.
     *
     * @param scratch of the worker, see {@link Scratch}
     */
    void fill(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int from,
            int to,
            Scratch scratch);
}
