package dev.cairn.physics.solver.row;

import dev.cairn.physics.solver.body.SolverContext;

/**
 * The places of joints among the rows that are swept: nothing is done there, as an assembly of
 * {@code solver.joint} solves all joints that hang together at once. They tell islands and batches
 * which bodies are bound to each other.
 */
public final class JointRows implements KindRows {
    /** Rows of either precision. */
    public JointRows() {}

    @Override
    public int group() {
        return 1;
    }

    @Override
    public void ensurePlaces(int places) {}

    @Override
    public void bind(int place, int source, int offsetA, int offsetB, int variant) {}

    @Override
    public void pad(int place) {}

    @Override
    public void prepare(SolverContext tick, SubStep sub, int from, int to) {}

    @Override
    public void bias(SolverContext tick, SubStep sub, int from, int to, Scratch scratch) {}

    @Override
    public void relax(SolverContext tick, SubStep sub, int from, int to, Scratch scratch) {}

    @Override
    public void store(SolverContext tick, SubStep sub, int from, int to) {}
}
