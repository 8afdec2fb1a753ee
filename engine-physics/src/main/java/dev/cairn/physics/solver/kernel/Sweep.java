package dev.cairn.physics.solver.kernel;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

/**
 * The two passes over the constraint rows of one colour. There is one for each number of lanes; all
 * of one precision give the same bits, because each row's arithmetic is the same, in the same
 * order.
 *
 * <p>Zeros leave a sweep positive: where a wide sweep adds nothing and the scalar one stops early,
 * nothing but the sign of a zero could differ.
 */
public interface Sweep {
    /** The bias pass: soft normals, which push overlap out and let gaps close; no friction. */
    void bias(
            ConstraintRows rows,
            SolverBodies bodies,
            SubStep sub,
            int from,
            int to,
            Scratch scratch);

    /**
     * The relax pass: separations after the movement, hard normals, which take the push out of the
     * velocities again, then friction; adds up the totals.
     */
    void relax(
            ConstraintRows rows,
            SolverBodies bodies,
            SubStep sub,
            int from,
            int to,
            Scratch scratch);
}
