package dev.cairn.physics.solver;

/** What is done to the rows of islands that start at rest. */
interface StartPass {
    /**
     * Hard normals and friction of the rows that are marked with {@link StaticStart#MARK}, over and
     * over until they agree; what they then hold is in the offsets of their points.
     */
    void start(
            ConstraintRows rows,
            SolverBodies bodies,
            SubStep sub,
            StaticStart islands,
            int from,
            int to,
            Scratch scratch);
}
