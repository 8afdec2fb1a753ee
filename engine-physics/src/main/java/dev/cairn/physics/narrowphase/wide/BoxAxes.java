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
                    && BoxAxesWide.paysOff();

    private BoxAxes() {}

    /**
     * Fills the result columns of the first pairs of a batch; what follows them up to the next
     * multiple of the lanes is overwritten too.
     *
     * @param batch whose input columns are filled
     * @param count pairs, 0 to {@link BoxBatch#CAPACITY}
     */
    public static void run(BoxBatch batch, int count) {
        if (WIDE) {
            BoxAxesWide.run(batch.data, count);
        } else {
            BoxAxesScalar.run(batch.data, count);
        }
    }
}
