package dev.cairn.physics.shape.mesh;

/**
 * A surface of triangles, numbered from 0: which of them are in a box, where their corners are, and
 * what can be touched of them. Immutable; any thread.
 */
public abstract class TriangleSet {
    /**
     * Of {@link #flags}: bit e says that edge e, from corner e to the next, stands out towards the
     * front: two faces meet there in a ridge.
     */
    public static final int CONVEX = 1;

    /** The same for an edge that is hollow from the front. */
    public static final int HOLLOW = 1 << 3;

    /** The same for an edge without one neighbour that is turned like this triangle. */
    public static final int OPEN = 1 << 6;

    /** Bit c says that a ridge or an open edge, seen from the front, ends at corner c. */
    public static final int CORNER = 1 << 9;

    /** The same, seen from the back. */
    public static final int CORNER_BACK = 1 << 12;

    /** Three edges, or three corners. */
    public static final int ALL = 7;

    /** Whether bodies meet both sides of each triangle. */
    public final boolean isTwoSided;

    TriangleSet(boolean isTwoSided) {
        this.isTwoSided = isTwoSided;
    }

    /** The triangles of a shape that has such. */
    public static TriangleSet of(Meshed shape) {
        return shape.triangles;
    }

    /** How many triangles there are. */
    public abstract int count();

    /**
     * The triangles whose boxes overlap a box.
     *
     * @param box minX, minY, minZ, maxX, maxY, maxZ, shape frame, m
     * @param out receives them, ascending, from 0 on; grown when it is too small
     */
    public abstract void find(double[] box, Found out);

    /**
     * The triangles that a ray may meet.
     *
     * @param ray origin x, y, z and direction x, y, z; shape frame
     * @param limit how far it goes, in lengths of the direction; may be infinite
     * @param pad how far beside the ray a box may be, per axis, m: a moving body's extent
     * @param out receives them, ascending
     */
    public abstract void along(double[] ray, double limit, double[] pad, Found out);

    /**
     * The corners of a triangle, counter-clockwise seen from the front.
     *
     * @param out receives three times x, y, z, shape frame, m
     */
    public abstract void corners(int triangle, double[] out);

    /** The number of a vertex: corners at one place have the same. */
    public abstract int vertex(int triangle, int corner);

    /** What can be touched of a triangle: {@link #CONVEX} and the other bits. */
    public abstract int flags(int triangle);

    /** The same of its edges; bits of corners may be among them. */
    public int edges(int triangle) {
        return flags(triangle);
    }

    /** The number by which the user knows a triangle. */
    public abstract int source(int triangle);

    /**
     * The triangle above a place that is inside, for surfaces that have one.
     *
     * @return -1 if it is outside, or deeper than bodies are pushed out from
     */
    public int above(double x, double y, double z) {
        return -1;
    }

    /** The number of a triangle's material, 0..254. */
    public abstract int material(int triangle);

    /** The lower or upper end of the surface along an axis, m. */
    public abstract double end(int axis, boolean upper);

    /**
     * The triangles that a question has found. One thread's; grows when there are more than ever.
     */
    public static final class Found {
        /** Triangles, ascending; only the first {@link #count} count. */
        public int[] triangle = new int[64];

        /** How many there are. */
        public int count;

        /** Nothing yet. */
        public Found() {}

        /** One triangle and nothing else. */
        public void only(int number) {
            triangle[0] = number;
            count = 1;
        }

        void add(int number) {
            if (count == triangle.length) {
                triangle = java.util.Arrays.copyOf(triangle, 2 * count);
            }
            triangle[count++] = number;
        }
    }
}
