package dev.cairn.physics.solver.load;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

/** What is done to the rows of islands that start at rest. */
public interface StartPass {
    /**
     * Hard normals and friction of the rows that are swept, over and over until they agree; what
     * they then hold is in the offsets of their points.
     *
     * @param index of the sub-step
     */
    void start(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int index,
            StaticStart islands,
            int from,
            int to,
            Scratch scratch);
}
