package dev.cairn.physics.narrowphase.pair;

/**
 * The warm-start key of a pair, 64 bits that one tick hands to the next: bits 63..62 the kind of
 * contact (0 none, 1 face of A, 2 face of B, 3 edges or points), bits 61..47 the reference face,
 * bits 31..0 the {@link FeatureIds} of the points. For pairs with a hull, bits 46..32 are a vertex
 * near the face; for two edges that cross, they are the edge of B, and bits 61..47 the edge of A. A
 * stale or random key costs time, never correctness.
 */
public final class WarmStartKey {
    /** Kinds of contact: a face of A or of B is the reference; edges or points. */
    public static final long FACE_A = 1, FACE_B = 2, EDGES = 3;

    /** In place of an edge of A: no two edges cross. */
    public static final long NO_EDGE = 0x7FFF;

    private WarmStartKey() {}

    /** The warm-start key of a kind of contact, a face and the names of the points. */
    public static long of(long kind, long face, int names) {
        return kind << 62 | face << 47 | (names & 0xFFFFFFFFL);
    }

    /** Adds where to look in the next tick. */
    public static long withHint(long key, long hint) {
        return key | hint << 32;
    }

    /** See {@link #withHint}. */
    public static int hint(long key) {
        return (int) (key >>> 32) & 0x7FFF;
    }

    /** The face in a warm-start key of kind face, as its number on its shape. */
    public static int faceOf(long key) {
        return (int) (key >>> 47) & 0x7FFF;
    }

    /**
     * Whether a face of B carried or separated the pair; false for a face of A and for other
     * contacts.
     */
    public static boolean onFaceOfB(long key) {
        return key >>> 62 == FACE_B;
    }
}
