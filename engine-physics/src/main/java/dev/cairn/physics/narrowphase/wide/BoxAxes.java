package dev.cairn.physics.narrowphase.wide;

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
            ModuleLayer.boot().findModule("jdk.incubator.vector").isPresent()
                    && vectorsAreCompiled()
                    && BoxAxesWide.paysOff();

    private BoxAxes() {}

    /** Without the C2 compiler every vector is an object on the heap, for good. */
    private static boolean vectorsAreCompiled() {
        String mode = System.getProperty("java.vm.info", "");
        return !(mode.contains("emulated-client") || mode.contains("interpreted"));
    }

    /**
     * Fills the result columns of the first pairs of a batch; what follows them up to the next
     * multiple of the lanes is overwritten too.
     *
     * @param batch whose input columns are filled
     * @param count pairs, 0 to {@link BoxBatch#CAPACITY}
     * @param wide whether to use lanes; only where {@link #wide()}
     */
    public static void run(BoxBatch batch, int count, boolean wide) {
        if (wide) {
            BoxAxesWide.run(batch.data, count);
        } else {
            BoxAxesScalar.run(batch.data, count);
        }
    }

    /**
     * Whether there are lanes. {@link #corners} and {@link #world} are only for machines that have.
     *
     * @return false without the Vector API
     */
    public static boolean wide() {
        return WIDE;
    }

    /**
     * The corners of the faces that look at the chosen ones: fills the columns from {@link
     * BoxBatch#INCIDENT} to {@link BoxBatch#CORNER}.
     *
     * @param batch whose columns FLIP, AXIS and SIGN are filled
     * @param count pairs
     */
    public static void corners(BoxBatch batch, int count) {
        BoxFacesWide.corners(batch.data, count);
    }

    /**
     * Clips what one or two sides cut straight: fills {@link BoxBatch#STRAIGHT} and, where that is
     * not negative, puts the points in the {@link BoxBatch#CORNER} columns.
     *
     * @param batch after {@link #corners}
     * @param count pairs
     */
    public static void cutStraight(BoxBatch batch, int count) {
        BoxStraightWide.run(batch.data, count);
    }

    /**
     * Turns what stands in the {@link BoxBatch#CORNER} columns into world axes, and fills {@link
     * BoxBatch#NORMAL}.
     *
     * @param batch after {@link #corners}
     * @param count pairs
     */
    public static void world(BoxBatch batch, int count) {
        BoxFacesWide.world(batch.data, count);
    }
}
