package dev.cairn.physics.narrowphase.wide;

import dev.cairn.physics.internal.Vectors;

/**
 * The fifteen axes of many pairs of boxes at once (Gottschalk, Lin, Manocha 1996), a pair to a
 * lane, in double precision. The operations and their order are those of the scalar test in {@code
 * narrowphase.Axes}, so the results are the same bits for any number of lanes, none included.
 *
 * <p>Without {@code --add-modules jdk.incubator.vector} the scalar twin runs.
 */
public final class BoxAxes {
    /** Squared sine of edges that count as parallel. */
    static final double PARALLEL = 0x1p-40;

    private static final boolean WIDE =
            Vectors.areThere() && Vectors.areCompiled() && BoxAxesWide.paysOff();

    private BoxAxes() {}

    /**
     * Fills the columns from {@link BoxBatch#WORLD} to {@link BoxBatch#EDGE} of the first pairs of
     * a batch, one pair after another.
     *
     * @param count pairs, 0 to {@link BoxBatch#CAPACITY}
     */
    public static void scalar(BoxBatch batch, int count) {
        BoxAxesScalar.run(batch.data, count);
    }

    /** As {@link #corners(BoxBatch, int)} for the columns of one pair, without lanes. */
    public static void corners(double[] columns, int pair) {
        BoxFacesScalar.corners(columns, pair);
    }

    /**
     * As {@link #world(BoxBatch, int)} for the columns of one pair, without lanes.
     *
     * @param points how many stand in the CORNER columns
     */
    public static void world(double[] columns, int pair, int points) {
        BoxFacesScalar.world(columns, pair, points);
    }

    /**
     * Whether there are lanes. What follows is only for machines that have; all of it overwrites
     * what follows the pairs up to the next multiple of the lanes. Returns false without the Vector
     * API.
     */
    public static boolean wide() {
        return WIDE;
    }

    /**
     * The axes of faces: fills the columns from {@link BoxBatch#WORLD} to {@link BoxBatch#FACE_B}.
     */
    public static void faces(BoxBatch batch, int count) {
        BoxAxesWide.faces(batch.data, count);
    }

    /**
     * The axes of edges: fills {@link BoxBatch#SEPARATION_EDGE} and {@link BoxBatch#EDGE} of some
     * pairs, and perhaps of their neighbours.
     */
    public static void edges(BoxBatch batch, int pairs) {
        BoxAxesWide.edges(batch.data, pairs);
    }

    /**
     * The points of edges that cross: fills the columns from {@link BoxBatch#CROSSING_COSINE} on of
     * some pairs, and perhaps of their neighbours.
     */
    public static void crossings(BoxBatch batch, int pairs) {
        BoxCrossingWide.run(batch.data, pairs);
    }

    /**
     * Chooses the face of pairs that had one of their two best faces in the last tick and are not
     * apart by these: fills {@link BoxBatch#FLIP}, {@link BoxBatch#AXIS} and {@link BoxBatch#SIGN},
     * of other pairs with anything. Returns the others, a bit each.
     */
    public static int choose(BoxBatch batch, int count) {
        return BoxFacesWide.choose(batch.data, count);
    }

    /**
     * The corners of the faces that look at the chosen ones: fills the columns from {@link
     * BoxBatch#INCIDENT} to {@link BoxBatch#CORNER}.
     */
    public static void corners(BoxBatch batch, int count) {
        BoxFacesWide.corners(batch.data, count);
    }

    /**
     * Clips the faces of which no or one side leaves a quadrilateral: fills {@link
     * BoxBatch#ALIGNED} and, where that is not negative, puts points in the place of the corners.
     * The low 32 bits of the result tell of the pairs that were clipped so those whose face {@link
     * #choose} chose and whose contact no axis of edges can change; the high 32 bits those that are
     * only right when no corner that was cut off was a point of the last tick: for the others
     * STRAIGHT must be set to -1 before {@link #world}.
     */
    public static long clipAligned(BoxBatch batch, int count) {
        return BoxAlignedWide.run(batch.data, count);
    }

    /**
     * Turns what stands in the {@link BoxBatch#CORNER} columns into world axes, and fills {@link
     * BoxBatch#NORMAL}.
     */
    public static void world(BoxBatch batch, int count) {
        BoxFacesWide.world(batch.data, count);
    }
}
