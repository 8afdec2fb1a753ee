package dev.cairn.physics.narrowphase.pair;

/**
 * The names of up to four points in 32 bits: a byte each, in the order of the points, 0 for none.
 * The names of boxes have a byte each, so that soft corners are told alike in a mirror, which has
 * other names; two names of hulls share one in some case of 255, which costs calmness, never
 * correctness.
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
