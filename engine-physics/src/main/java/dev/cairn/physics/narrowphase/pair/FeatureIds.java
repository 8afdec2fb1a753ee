package dev.cairn.physics.narrowphase.pair;

/**
 * Feature ids of contact points, as {@link Manifold} defines them, and their summary in a {@link
 * WarmStartKey}: 32 bits, a hash of 8 bits for each of up to four points, in their order, 0 for
 * none. The ids of a pair of boxes have distinct hashes, so that corners near a side plane are
 * treated alike in a mirror image, whose ids are others; two ids of hulls share a hash in one case
 * of 255, which costs persistence of a point, never correctness.
 */
public final class FeatureIds {
    /** Kinds of feature ids: a vertex of A or of B, two edges that cross, or any other point. */
    public static final int VERTEX_A = 0, VERTEX_B = 1 << 30, CROSSING = 2 << 30, CLOSEST = 3 << 30;

    private FeatureIds() {}

    public static int of(Manifold m) {
        int names = 0;
        for (int i = 0; i < m.pointCount; i++) {
            names |= hash(m.feature[i]) << (8 * i);
        }
        return names;
    }

    /** Whether a name is one of the set. */
    public static boolean contains(int names, int feature) {
        // A byte of the difference is zero exactly if subtracting one borrows into its clear top
        // bit.
        int x = names ^ (hash(feature) * 0x01010101);
        return ((x - 0x01010101) & ~x & 0x80808080) != 0;
    }

    /** 1 to 255. */
    public static int hash(int feature) {
        int h = feature * 0x0E16F0F1;
        return (((h >>> 16) * 255) >>> 16) + 1;
    }
}
