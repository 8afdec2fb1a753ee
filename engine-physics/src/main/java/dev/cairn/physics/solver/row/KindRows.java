package dev.cairn.physics.solver.row;

import dev.cairn.physics.solver.body.SolverContext;

/**
 * Rows of a {@link ConstraintKind} in one precision, with a stride of their own, and the kernels
 * that sweep them.
 *
 * <p>Each kernel gets a range of places within one colour: no two of these rows move the same body,
 * so they may be solved in any order, or all at once. Ranges start at a multiple of {@link
 * EdgePlaces#group}, and run on any worker, whose scratch is free from {@link Scratch#PACKED} on.
 * Nothing may allocate.
 *
 * <p>No kernel is needed for the warm start of a sub-step: the bodies remember what the impulses of
 * the last one did to them, whichever kind they were of.
 */
public interface KindRows extends EdgePlaces {
    /**
     * Begin of the tick: fills rows from the kind's store, and adds to the warm start of the bodies
     * what the impulses of the last tick do to them.
     */
    void prepare(SolverContext tick, SubStep sub, int from, int to);

    /** First sweep of a sub-step, before the bodies move: what is out of place is pulled back. */
    void bias(SolverContext tick, SubStep sub, int from, int to, Scratch scratch);

    /** Second sweep, after the bodies have moved: takes back the speed that the pull has added. */
    void relax(SolverContext tick, SubStep sub, int from, int to, Scratch scratch);

    /** End of the tick: writes impulses back to the kind's store. */
    void store(SolverContext tick, SubStep sub, int from, int to);
}
