package dev.cairn.physics.narrowphase.wide;

/**
 * Up to {@link #CAPACITY} pairs of balls and capsules for {@link RoundWide}: one array, cut into
 * columns, as in {@link BoxBatch}. A ball has half length 0; its orientation is not read. One per
 * worker.
 */
public final class RoundBatch {
    /** Pairs in a batch; a multiple of every number of lanes. */
    public static final int CAPACITY = 32;

    /** Orientation of A, world from body, unit quaternion: columns x, y, z, w. */
    public static final int TURN_A = 0;

    /** Orientation of B, likewise. */
    public static final int TURN_B = 4 * CAPACITY;

    /** Centre of B minus centre of A, world axes, m: columns x, y, z. */
    public static final int OFFSET = 8 * CAPACITY;

    /** Radii, m. */
    public static final int RADIUS_A = 11 * CAPACITY, RADIUS_B = 12 * CAPACITY;

    /** Half lengths of the segments, m. */
    public static final int HALF_A = 13 * CAPACITY, HALF_B = 14 * CAPACITY;

    /** Velocity of B minus that of A, world, m/s: columns x, y, z. */
    public static final int AHEAD = 15 * CAPACITY;

    /** What turning adds to the margin, m. */
    public static final int ARC_A = 18 * CAPACITY, ARC_B = 19 * CAPACITY;

    /** Axis of A, world, zero for a ball; and of B. */
    public static final int AXIS_A = 20 * CAPACITY, AXIS_B = 23 * CAPACITY;

    /** From the core of A to that of B, m. */
    public static final int ACROSS = 26 * CAPACITY;

    /** Where on A's core that begins, m. */
    public static final int ON_A = 29 * CAPACITY;

    /** Cosine squared of the angle of the axes. */
    static final int ALIGNED = 30 * CAPACITY;

    /** {@link #APART}, {@link #ONE_POINT}, {@link #LINES} or {@link #OTHER}. */
    public static final int KIND = 31 * CAPACITY;

    /** Unit normal from A to B, world: columns x, y, z. */
    public static final int NORMAL = 32 * CAPACITY;

    /** The point, relative to A's centre, world, m: columns x, y, z; and its separation, m. */
    public static final int POINT = 35 * CAPACITY, SEPARATION = 38 * CAPACITY;

    /** What {@link dev.cairn.physics.narrowphase.pair.Manifold#bound} is a fixed part of, m. */
    public static final int SCALE = 39 * CAPACITY;

    /** Points up to this far apart are contacts, m. */
    public static final int MARGIN = 40 * CAPACITY;

    /** The pair is farther apart than its margin. */
    public static final double APART = 0;

    /** It has one point. */
    public static final double ONE_POINT = 1;

    /** It is two capsules that touch, nearly parallel and level: they may lie side by side. */
    public static final double LINES = 2;

    /** It is none of this class. */
    public static final double OTHER = 3;

    /** Squares of lengths in this range lose nothing to underflow or overflow. */
    public static final double LEAST = 0x1p-900, MOST = 0x1p900;

    /** Of the squared scale: cores that are nearer have no direction. */
    public static final double TOUCHING = 0x1p-80;

    /** Cosine squared of the angle below which capsules may lie side by side. */
    public static final double PARALLEL = 0.9;

    /** Sine of 0.1 rad: lines that are nearer to being at right angles to the normal are level. */
    public static final double LEVEL = 0.1;

    /** Of the squared sine: axes that cross by less are tried at all their ends. */
    public static final double CROSSING = 0x1p-10;

    /** Of the squared sine: axes that cross by less do not cross. */
    public static final double NEVER = 0x1p-60;

    /** All columns. */
    public final double[] data = new double[41 * CAPACITY];

    /**
     * Fills the columns from {@link #AXIS_A} on. Only where {@link BoxAxes#wide}. The margin is
     * {@code reach} times the relative speed, both arcs, and {@code fraction} of the smaller
     * radius.
     *
     * @param count pairs, 0 to {@link #CAPACITY}
     */
    public void run(
            int count, boolean capsulesA, boolean capsulesB, double reach, double fraction) {
        RoundWide.run(data, count, capsulesA, capsulesB, reach, fraction);
    }
}
