package dev.cairn.physics.narrowphase.hull;

import dev.cairn.physics.narrowphase.gjk.Polytope;

/**
 * What {@code NarrowPhase} keeps of a pair with a hull between ticks, beside the {@code
 * WarmStartKey}: the polytope that the last search ended with (vertices by their numbers and faces
 * by their corners, no place), two edges that separated best though a face held the contact, and a
 * {@link DistanceCertificate}. What was left at another pose costs time, never correctness; what
 * other shapes left has to be forgotten.
 */
public final class PairMemory {
    private PairMemory() {}

    /** Numbers to a pair. */
    public static final int SIZE = Polytope.SIZE + 1 + DistanceCertificate.SIZE;

    /** Where the edges and the certificate are. */
    public static final int CROSSING = Polytope.SIZE, CERTIFICATE = CROSSING + 1;

    /** Empties a place. */
    public static void forget(long[] memory, int at) {
        Polytope.forget(memory, at);
        memory[at + CROSSING] = 0;
        DistanceCertificate.forget(memory, at + CERTIFICATE);
    }
}
