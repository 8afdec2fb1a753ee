package dev.cairn.physics.narrowphase.wide;

/**
 * Up to {@link #CAPACITY} pairs of boxes for {@link BoxAxes}: one array, cut into columns, so that
 * a kernel keeps one base address. Entry {@code i} of column {@code c} is at {@code c + i}. One per
 * worker.
 */
public final class BoxBatch {
    /** Pairs in a batch; a multiple of every number of lanes. */
    public static final int CAPACITY = 32;

    /** Orientation of A, world from body, unit quaternion: columns x, y, z, w. */
    public static final int TURN_A = 0;

    /** Orientation of B, likewise. */
    public static final int TURN_B = 4 * CAPACITY;

    /** Centre of B minus centre of A, world axes, m: columns x, y, z. */
    public static final int OFFSET = 8 * CAPACITY;

    /** Half extents of A, m: columns x, y, z. */
    public static final int HALF_A = 11 * CAPACITY;

    /** Half extents of B, m: columns x, y, z. */
    public static final int HALF_B = 14 * CAPACITY;

    /** Turns A's axes into the world's: nine columns, row by row. */
    public static final int WORLD = 17 * CAPACITY;

    /** Turns B's axes into A's: nine columns, row by row. */
    public static final int RELATIVE = 26 * CAPACITY;

    /** Centre of B in A's frame, m: columns x, y, z. */
    public static final int CENTRE = 35 * CAPACITY;

    /** Largest separation along a face normal of A, m, and the face. */
    public static final int SEPARATION_A = 38 * CAPACITY, FACE_A = 39 * CAPACITY;

    /** Largest separation along a face normal of B, m, and the face. */
    public static final int SEPARATION_B = 40 * CAPACITY, FACE_B = 41 * CAPACITY;

    /**
     * Largest separation along the common perpendicular of two edges, m, and 3 i + j of the edge
     * directions i of A and j of B; {@code -Double.MAX_VALUE} and -1 when all are parallel.
     */
    public static final int SEPARATION_EDGE = 42 * CAPACITY, EDGE = 43 * CAPACITY;

    /** Of the best edge axis: separation times its size, and squared length, before the root. */
    static final int SIGNED_SQUARE = 44 * CAPACITY, SQUARE = 45 * CAPACITY;

    /**
     * The chosen face: 1 when it is B's, its axis 0 to 2, and its sign. Input of {@link
     * BoxFacesWide}.
     */
    public static final int FLIP = 46 * CAPACITY, AXIS = 47 * CAPACITY, SIGN = 48 * CAPACITY;

    /** The face of the other box that looks most against it. */
    public static final int INCIDENT = 49 * CAPACITY;

    /**
     * How far the outermost corner of the incident face is outside of each side of the chosen one,
     * m, negative inside: four columns, for the high and the low side along its first axis, then
     * along the other.
     */
    public static final int OUTSIDE = 50 * CAPACITY;

    /**
     * Half extents of the box of the chosen face: along its normal, then the other two in order.
     */
    public static final int HALF = 54 * CAPACITY;

    /**
     * Turns the other box's axes into those of the chosen face's box, in that order of rows: nine
     * columns.
     */
    static final int ROWS = 57 * CAPACITY;

    /**
     * The corners of the incident face in the frame of the chosen face's box, in that order of
     * axes: {@link #POINT} columns each, the last one for a separation. Corner bits 0 and 1 are the
     * signs on the two axes beside the face's own. What is written there in their place, up to four
     * points, is turned into world axes.
     */
    public static final int CORNER = 66 * CAPACITY;

    /** From a point to the next one. */
    public static final int POINT = 4 * CAPACITY;

    /** Unit normal from A to B, world: columns x, y, z. */
    public static final int NORMAL = 82 * CAPACITY;

    /** Points up to this far apart are contacts, m. */
    public static final int MARGIN = 85 * CAPACITY;

    /** The smaller inner radius, m. */
    public static final int INNER = 86 * CAPACITY;

    /**
     * Of the key of the last tick: {@link #KIND} times its kind (1 face of A, 2 face of B) plus its
     * face.
     */
    public static final int LAST = 87 * CAPACITY;

    /** More than any number of a face. */
    public static final int KIND = 1 << 15;

    /** The separation along the chosen face, and the larger one of both boxes' faces, m. */
    static final int SEPARATION = 88 * CAPACITY, SEPARATION_FACES = 89 * CAPACITY;

    /**
     * -1, or how no or one side clips the incident face to a quadrilateral, together with both
     * faces: {@link #entry}. The four points are then in place of the corners.
     */
    public static final int ALIGNED = 90 * CAPACITY;

    /** Ways to clip it so: none, or one of 16. */
    public static final int WAYS = 17;

    /** The least separation of those points, m. */
    public static final int DEEPEST = 91 * CAPACITY;

    /** By how much {@link #DEEPEST} may differ from the signed distance, m. */
    public static final int BOUND = 92 * CAPACITY;

    /** Of the side that cuts: its sign and its offset, m. */
    static final int SIDE = 93 * CAPACITY;

    /** 1 when that is on the first axis beside the face's own. */
    static final int ON_U = 95 * CAPACITY;

    /** 1 when the side cuts off the corner p, else -1; 0 when none cuts. */
    static final int LOW = 96 * CAPACITY;

    /** The points, as {@link #CORNER}. */
    static final int ALIGNED_POINT = 97 * CAPACITY;

    /** 1 when a corner that was cut off would have stayed as a point of the last tick. */
    static final int SOFT = 113 * CAPACITY;

    /** The unit axis of the edges that separate best, from A to B, in A's frame: x, y, z. */
    static final int CROSSING_AXIS = 114 * CAPACITY;

    /** Its cosine with the normal of the chosen face, from A to B. */
    public static final int CROSSING_COSINE = 117 * CAPACITY;

    /** The point midway between these edges and the unit normal, world: columns x, y, z. */
    public static final int CROSSING_POINT = 118 * CAPACITY, CROSSING_NORMAL = 121 * CAPACITY;

    /**
     * 8 v + w for the edges from vertex v of A and from w of B; -1 where they do not cross within
     * the margin.
     */
    public static final int CROSSING_ENDS = 124 * CAPACITY;

    /** Half the edge of B, in A's frame: columns x, y, z. */
    static final int CROSSING_LINES = 125 * CAPACITY;

    /** 1 when a side cuts; 1 when it cuts edges along the second axis. */
    static final int CUTS = 128 * CAPACITY, ALONG = 129 * CAPACITY;

    /** Where a side cuts the two edges that it crosses, from their ends inside: shares of them. */
    static final int CUT = 130 * CAPACITY;

    /** The largest separation of the points that were clipped so, m. */
    static final int HIGHEST = 132 * CAPACITY;

    /** All columns. */
    public final double[] data = new double[133 * CAPACITY];

    /**
     * The number of a way to cut a face.
     *
     * @param way 0 when no side cuts; else 1, plus 4 times the side (0 high, 1 low on the first
     *     axis, 2 and 3 on the second), plus 2 when it cuts edges along the second axis of the
     *     incident face, plus 1 when it cuts their low ends
     * @return 0 to 72 {@link #WAYS} - 1
     */
    public static int entry(boolean flip, int face, int incident, int way) {
        return (((flip ? 6 : 0) + face) * 6 + incident) * WAYS + way;
    }

    /** A batch of unit quaternions and zeros. */
    public BoxBatch() {
        java.util.Arrays.fill(data, TURN_A + 3 * CAPACITY, TURN_B, 1);
        java.util.Arrays.fill(data, TURN_B + 3 * CAPACITY, OFFSET, 1);
    }
}
