package dev.cairn.physics.narrowphase;

/**
 * What {@link NarrowPhase} keeps of a pair with a hull between ticks, beside the {@link Word}: the
 * polytope that the last search ended with (vertices by their numbers and faces by their corners,
 * no place), then two edges that separated best though a face held the contact. What was left by
 * other shapes or at another pose costs time, never correctness.
 */
public final class PairMemory {
    private PairMemory() {}

    /** Numbers to a pair. */
    public static final int SIZE = Polytope.SIZE + 1;

    /**
     * Empties a place.
     *
     * @param memory of many pairs
     * @param at where the pair's begins
     */
    public static void forget(long[] memory, int at) {
        Polytope.forget(memory, at);
        memory[at + Polytope.SIZE] = 0;
    }
}
