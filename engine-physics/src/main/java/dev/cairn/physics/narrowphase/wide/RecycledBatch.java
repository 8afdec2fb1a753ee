package dev.cairn.physics.narrowphase.wide;

/**
 * Pairs of boxes in neighbouring rows that may have hardly moved, for {@link RecycledWide}: one
 * array, cut into columns, as in {@link BoxBatch}. Place {@code p} is row {@code first + p} with
 * {@code first} a multiple of {@link #ROWS}, so that what is kept of the rows, which lies in groups
 * of so many, is read as it lies. Let the reference be the box whose face carries the contact, the
 * incident box the other one. One per worker.
 */
public final class RecycledBatch {
    /** Rows in a group: as many as the largest vector has lanes. */
    public static final int ROWS = 8;

    /** Numbers that are kept of a row; number {@code n} of a group begins at {@code ROWS * n}. */
    public static final int KEPT = 24;

    /** Of the kept: orientation of the incident box seen from the reference, four numbers. */
    public static final int TURN = 0;

    /** Of the kept: centre of the incident box in the reference's axes, m, three numbers. */
    public static final int CENTRE = 4;

    /** Of the kept: distance of the face's plane from the centre of the reference, m. */
    public static final int PLANE = 7;

    /** Of the kept: 4 R squared, R the outer radius of the incident box, m2. */
    public static final int SPIN = 8;

    /** Of the kept: the square of the allowed move, m2. */
    public static final int LIMIT = 9;

    /** Of the kept: the separation up to which nothing is left out, m. */
    public static final int GAP = 10;

    /** Of the kept: the points on the incident box in its axes, m, three numbers each. */
    public static final int POINT = 12;

    /** Places: a block of 32 rows and what is beside it in the first and last group. */
    public static final int CAPACITY = 40;

    /** Orientations of the reference and of the incident box: columns x, y, z, w. */
    public static final int TURN_R = 0, TURN_I = 4 * CAPACITY;

    /** Centre of the incident box minus that of the reference, world, m. */
    public static final int OFFSET = 8 * CAPACITY;

    /** Difference of the velocities ahead, m/s. */
    public static final int AHEAD = 11 * CAPACITY;

    /** What the turning of A and of B may carry out, m; then the smaller inner radius, m. */
    public static final int ARC_A = 14 * CAPACITY, ARC_B = 15 * CAPACITY, INNER = 16 * CAPACITY;

    /** The face of the reference: axis 0 to 2 and sign. */
    public static final int AXIS = 17 * CAPACITY, SIGN = 18 * CAPACITY;

    /** The speculative margin, m. */
    public static final int MARGIN = 19 * CAPACITY;

    /** 1 where the pair has hardly moved, else 0. */
    public static final int STAYS = 20 * CAPACITY;

    /** Outward normal of the face, world: columns x, y, z. */
    public static final int NORMAL = 21 * CAPACITY;

    /** Turns the incident box's axes into the world's: nine columns, row by row. */
    static final int WORLD = 24 * CAPACITY;

    /**
     * Four points, midway between the surfaces, from the incident box's centre and from the
     * reference's, world, m: columns x, y, z, x, y, z each.
     */
    public static final int ANCHOR = 33 * CAPACITY;

    /** Their separations, m. */
    public static final int SEPARATION = 57 * CAPACITY;

    /** All columns. */
    public final double[] data = new double[61 * CAPACITY];

    /**
     * Fills the columns from {@link #MARGIN} on. Only where {@link BoxAxes#wide}.
     *
     * @param at where the group of the first place begins
     * @param reach of the margin, s
     * @param fraction of the inner radius that the margin has at least
     */
    public void run(int count, double[] kept, int at, double reach, double fraction) {
        RecycledWide.run(data, count, kept, at, reach, fraction);
    }
}
