package dev.cairn.physics.contact.impact;

/**
 * The energy that an impact would make.
 *
 * <p>The work of all impulses is their sum times the mean of the velocities before and after: with
 * the velocities v and their change c, in the metric of mass, {@code 2 v.c + c²}, which is least
 * where the impact is scaled by {@code -v.c / c²}. Of what a moving wall does, as seen from the
 * wall.
 */
final class ImpactEnergy {
    /** What is rounding, over the energy. */
    private static final double ROUNDING = 1e-12;

    private ImpactEnergy() {}

    /**
     * Which share of an impact makes no energy.
     *
     * @param mass by side: inverse, 1/kg
     * @param inverse by side: inverse inertia, world, 9 numbers
     * @param before by side: velocity and angular velocity
     * @param after the same after the impact
     * @param mid by side: from the body's centre to the middle of the impulses
     * @return 1, or less
     */
    static double share(
            double[] mass, double[] inverse, double[] before, double[] after, double[] mid) {
        double along = 0;
        double square = 0;
        double energy = 0;
        // as seen from a side that does not answer
        int wall = mass[0] == 0 ? 0 : mass[1] == 0 ? 6 : -1;
        for (int side = 0; side < 2; side++) {
            if (mass[side] == 0) {
                continue;
            }
            int at = 6 * side;
            int p = 3 * side;
            int q = 3 - p;
            for (int c = 0; c < 3; c++) {
                double base = 0;
                if (wall >= 0) {
                    int d = (c + 1) % 3;
                    int f = (c + 2) % 3;
                    // velocity of the wall where it is struck, carried to the body's centre
                    base =
                            before[wall + c]
                                    + before[wall + 3 + d] * (mid[q + f] - mid[p + f])
                                    - before[wall + 3 + f] * (mid[q + d] - mid[p + d]);
                }
                double v = before[at + c] - base;
                double change = after[at + c] - before[at + c];
                energy += v * v / mass[side];
                along += v * change / mass[side];
                square += change * change / mass[side];
            }
            along += spun(inverse, before, after, side, true, wall);
            square += spun(inverse, before, after, side, false, wall);
        }
        if (!(2 * along + square > ROUNDING * (energy + square))) {
            return 1;
        }
        return Math.max(0, -along / square);
    }

    /** L . w or L . dw of the change L = I dw of angular momentum; I is solved from its inverse. */
    private static double spun(
            double[] inverse,
            double[] before,
            double[] after,
            int side,
            boolean isAlong,
            int wall) {
        int j = 9 * side;
        double a = inverse[j];
        double b = inverse[j + 1];
        double c = inverse[j + 2];
        double d = inverse[j + 4];
        double e = inverse[j + 5];
        double f = inverse[j + 8];
        double det = a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d);
        if (!(det > 0)) {
            return 0;
        }
        int at = 6 * side + 3;
        double x = after[at] - before[at];
        double y = after[at + 1] - before[at + 1];
        double z = after[at + 2] - before[at + 2];
        double lx = ((d * f - e * e) * x + (c * e - b * f) * y + (b * e - c * d) * z) / det;
        double ly = ((c * e - b * f) * x + (a * f - c * c) * y + (b * c - a * e) * z) / det;
        double lz = ((b * e - c * d) * x + (b * c - a * e) * y + (a * d - b * b) * z) / det;
        if (!isAlong) {
            return lx * x + ly * y + lz * z;
        }
        double wx = before[at] - (wall >= 0 ? before[wall + 3] : 0);
        double wy = before[at + 1] - (wall >= 0 ? before[wall + 4] : 0);
        double wz = before[at + 2] - (wall >= 0 ? before[wall + 5] : 0);
        return lx * wx + ly * wy + lz * wz;
    }
}
