package dev.cairn.physics.solver;

/**
 * What fills the constraint rows of one colour, the sweeps over them, and what empties them. There
 * is one set for each number of lanes; all give the same bits, because each row's arithmetic is the
 * same, in the same order.
 *
 * <p>Zeros leave a sweep positive: where a wide sweep adds nothing and the scalar one stops early,
 * nothing but the sign of a zero could differ.
 */
interface Sweeps extends RowFiller, RowStore {
    /** Rows to a group. */
    int lanes();

    /** The bias pass: soft normals, which push overlap out and let gaps close; no friction. */
    void bias(ConstraintRows rows, double[] body, SubStep sub, int from, int to, double[] scratch);

    /**
     * The relax pass: separations after the movement, hard normals, which take the push out of the
     * velocities again, then friction; adds up the totals.
     */
    void relax(ConstraintRows rows, double[] body, SubStep sub, int from, int to, double[] scratch);
}
