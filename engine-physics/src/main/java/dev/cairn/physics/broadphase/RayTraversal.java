package dev.cairn.physics.broadphase;

/**
 * Leaves by the distance after which a moving box enters theirs; see {@link TreeTraversal}.
 *
 * <p>The moving box is shrunk to a point and the leaf grown by it, and the ray that is left is
 * clipped against three slabs (Kay and Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986). Leaves
 * are taken larger by what rounding may take away.
 */
public final class RayTraversal extends TreeTraversal {
    private final double[] box = new double[6];
    private final double[] direction = new double[3];

    /** Without a ray. */
    public RayTraversal() {}

    /**
     * Begins.
     *
     * @param movingBox where the moving box starts: minX, minY, minZ, maxX, maxY, maxZ; world, m,
     *     finite; a point for a ray; copied
     * @param dx unit direction, world
     * @param dy see {@code dx}
     * @param dz see {@code dx}
     */
    public void start(AabbTree tree, double[] movingBox, double dx, double dy, double dz) {
        System.arraycopy(movingBox, 0, box, 0, 6);
        direction[0] = dx;
        direction[1] = dy;
        direction[2] = dz;
        begin(tree);
    }

    @Override
    double entry(double[] bounds, int at) {
        double in = 0;
        double out = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double low = bounds[at + axis] - box[axis + 3];
            double high = bounds[at + axis + 3] - box[axis];
            double slack =
                    0x1p-44
                            * (Math.abs(bounds[at + axis])
                                    + Math.abs(bounds[at + axis + 3])
                                    + Math.abs(box[axis])
                                    + Math.abs(box[axis + 3]));
            low -= slack;
            high += slack;
            double d = direction[axis];
            if (d == 0) {
                if (low > 0 || high < 0) {
                    return Double.POSITIVE_INFINITY;
                }
            } else {
                in = Math.max(in, (d > 0 ? low : high) / d);
                out = Math.min(out, (d > 0 ? high : low) / d);
            }
        }
        return in * (1 - 0x1p-40) <= out ? in * (1 - 0x1p-40) : Double.POSITIVE_INFINITY;
    }
}
