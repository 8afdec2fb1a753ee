package dev.cairn.physics.shape.mesh;

/** Whether a ray meets a box. Stateless. */
final class Boxes {
    private Boxes() {}

    /**
     * By slabs: the ray is between the two planes of each axis for some time, and for all three at
     * once.
     *
     * @param ray origin x, y, z and direction x, y, z
     * @param limit how far it goes, in lengths of the direction; may be infinite
     * @param pad how far beside the ray the box may be, per axis
     */
    static boolean meets(
            double x0,
            double y0,
            double z0,
            double x1,
            double y1,
            double z1,
            double[] ray,
            double limit,
            double[] pad) {
        double enter = 0;
        double leave = limit;
        for (int axis = 0; axis < 3; axis++) {
            double low = (axis == 0 ? x0 : axis == 1 ? y0 : z0) - pad[axis] - ray[axis];
            double high = (axis == 0 ? x1 : axis == 1 ? y1 : z1) + pad[axis] - ray[axis];
            double d = ray[3 + axis];
            if (d == 0) {
                if (low > 0 || high < 0) {
                    return false;
                }
            } else {
                double a = low / d;
                double c = high / d;
                // with room for the rounding of the division
                enter = Math.max(enter, Math.min(a, c) * (1 - 0x1p-50));
                leave = Math.min(leave, Math.max(a, c) * (1 + 0x1p-50));
            }
        }
        return enter <= leave;
    }
}
