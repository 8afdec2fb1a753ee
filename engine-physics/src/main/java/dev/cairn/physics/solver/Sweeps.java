package dev.cairn.physics.solver;

/** What fills the constraint rows of one colour, the sweeps over them, and what empties them. */
interface Sweeps extends RowFiller, Sweep, RowStore {
    /** Rows to a group. */
    int lanes();
}
