package dev.cairn.physics.broadphase;

/** Leaves by their distance from a box; see {@link TreeTraversal}. */
public final class BoxTraversal extends TreeTraversal {
    private final double[] from = new double[6];

    /** Without a box. */
    public BoxTraversal() {}

    /**
     * Begins.
     *
     * @param box minX, minY, minZ, maxX, maxY, maxZ; world, m; copied; may be endless
     */
    public void start(AabbTree tree, double[] box) {
        System.arraycopy(box, 0, from, 0, 6);
        begin(tree);
    }

    @Override
    double entry(double[] bounds, int at) {
        // The least distance of two boxes, a little less for what rounding may take away.
        double x = gap(bounds, at, 0);
        double y = gap(bounds, at, 1);
        double z = gap(bounds, at, 2);
        return Math.sqrt(x * x + y * y + z * z) * (1 - 0x1p-40);
    }

    private double gap(double[] bounds, int at, int axis) {
        return Math.max(
                0,
                Math.max(bounds[at + axis] - from[axis + 3], from[axis] - bounds[at + axis + 3]));
    }
}
