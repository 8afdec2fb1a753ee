package dev.cairn.physics.solver.kernel;

/** What fills the constraint rows of one colour, the sweeps over them, and what empties them. */
public interface Sweeps extends RowFiller, Sweep, RowStore {
    /** Rows to a group. */
    int lanes();
}
