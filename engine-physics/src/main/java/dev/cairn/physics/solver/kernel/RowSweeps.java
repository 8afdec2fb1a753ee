package dev.cairn.physics.solver.kernel;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

/** Sweeps of one number of lanes and one precision, put together. */
public final class RowSweeps implements Sweeps {
    private final int lanes;
    private final RowFiller filler;
    private final Sweep sweep;
    private final RowStore store;

    public RowSweeps(int lanes, RowFiller filler, Sweep sweep, RowStore store) {
        this.lanes = lanes;
        this.filler = filler;
        this.sweep = sweep;
        this.store = store;
    }

    /** The scalar ones: what runs without the Vector API, and what wide ones are held to. */
    public static Sweeps scalar(boolean isSingle) {
        return isSingle
                ? new RowSweeps(
                        1, new SinglePrepareRow(), new SingleScalarSweep(), new SingleStoreRow())
                : new RowSweeps(1, new PrepareRow(), new ScalarSweep(), new StoreRow());
    }

    @Override
    public int lanes() {
        return lanes;
    }

    @Override
    public void fill(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        filler.fill(rows, bodies, contacts, sub, from, to, scratch);
    }

    @Override
    public void bias(
            ConstraintRows rows,
            SolverBodies bodies,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        sweep.bias(rows, bodies, sub, from, to, scratch);
    }

    @Override
    public void relax(
            ConstraintRows rows,
            SolverBodies bodies,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        sweep.relax(rows, bodies, sub, from, to, scratch);
    }

    @Override
    public void store(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        store.store(rows, bodies, contacts, sub, from, to, scratch);
    }
}
