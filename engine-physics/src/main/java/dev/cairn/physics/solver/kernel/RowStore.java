package dev.cairn.physics.solver.kernel;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

/** Empties constraint rows; {@link StoreRow} and the wide stores give the same bits. */
public interface RowStore {
    /**
     * Writes the impulses of the places from {@code from} to {@code to}, a chunk at most and both
     * at the bounds of groups, to their contacts, and what the contacts know of their load.
     */
    void store(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int from,
            int to,
            Scratch scratch);
}
