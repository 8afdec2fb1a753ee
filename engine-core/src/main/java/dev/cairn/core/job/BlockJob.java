package dev.cairn.core.job;

/**
 * The work of one stage, cut into blocks that are independent of each other.
 *
 * <p>Keep one instance per stage (a {@code final} class, or a lambda stored once in a field) and
 * put the stage's arguments into its fields before {@link Jobs#run}: a lambda that captures at each
 * call would allocate at each call.
 */
@FunctionalInterface
public interface BlockJob {

    /**
     * Does the work of one block. Called exactly once per block and stage, by any worker, in any
     * order, at the same time as other blocks. What it writes must be at places that {@code block}
     * alone determines; else the result would depend on the number of workers.
     *
     * @param block the block, in {@code [0, blocks)}
     * @param worker the worker that runs it, in {@code [0, workers)}; only for the choice of
     *     scratch memory, never for results
     */
    void run(int block, int worker);
}
