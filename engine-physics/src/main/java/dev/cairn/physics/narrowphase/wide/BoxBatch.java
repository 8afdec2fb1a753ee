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
     * axes: three columns each. Corner bits 0 and 1 are the signs on the two axes beside the face's
     * own. What is written there in their place, up to four points, is turned into world axes.
     */
    public static final int CORNER = 66 * CAPACITY;

    /** Unit normal from A to B, world: columns x, y, z. */
    public static final int NORMAL = 78 * CAPACITY;

    /** Points up to this far apart are contacts, m. Input of {@link BoxStraightWide}. */
    public static final int MARGIN = 81 * CAPACITY;

    /**
     * How near a corner must be to a side plane to count as on it, m; and the same for a corner
     * that was a point of the last tick.
     */
    public static final int NEAR = 82 * CAPACITY, STILL_NEAR = 83 * CAPACITY;

    /**
     * -1, or how one or two sides cut the incident face straight: {@link #SECOND_WAYS} times the
     * way of the first, plus 0 or 1 plus that of the second. A way is the last corner of the loop
     * that stays, plus 4 for a low side; and of the first plus 8 for a side on the second axis. The
     * four points are then in place of the corners.
     */
    public static final int STRAIGHT = 84 * CAPACITY;

    /** Ways in which a second side can cut, or none. */
    public static final int SECOND_WAYS = 9;

    /** The least separation of those points, m. */
    public static final int DEEPEST = 85 * CAPACITY;

    /** The last corner that stays before a side, 0 to 3; -1 when it does not cut two off. */
    static final int STAYS = 86 * CAPACITY;

    /** Where on its edge either corner comes to lie, two columns; then {@link #CUT_SEPARATION}. */
    static final int CUT = 87 * CAPACITY;

    /** The separations of those points, m: four columns. */
    public static final int CUT_SEPARATION = CUT + 2 * CAPACITY;

    /** 1 when the side that cuts first is on the first axis. */
    static final int FIRST_ON_U = 93 * CAPACITY;

    /** Of the side that cuts first, then of the second: its sign, 0 for none, and its offset, m. */
    static final int SIDES = 94 * CAPACITY;

    /** The points, as {@link #CORNER}. */
    static final int STRAIGHT_POINT = 98 * CAPACITY;

    /** All columns. */
    public final double[] data = new double[110 * CAPACITY];

    /** A batch of unit quaternions and zeros. */
    public BoxBatch() {
        java.util.Arrays.fill(data, TURN_A + 3 * CAPACITY, TURN_B, 1);
        java.util.Arrays.fill(data, TURN_B + 3 * CAPACITY, OFFSET, 1);
    }
}
