package dev.cairn.physics.sweep;

import dev.cairn.physics.narrowphase.pair.Reach;

/**
 * What support functions tell of two shapes that {@link Reach} fits, where their flights left them.
 * One thread; allocates nothing.
 */
final class SupportGaps {
    private final Reach reach = new Reach();
    private final double[] corner = new double[3];

    /**
     * How far apart two are along an axis: a lower bound of their distance.
     *
     * @param x from a's centre to b's, world, m
     * @param nx unit axis, world
     */
    double along(
            Flight a, Flight b, double x, double y, double z, double nx, double ny, double nz) {
        double centres = nx * x + ny * y + nz * z;
        reach.set(a.shape, a.qx, a.qy, a.qz, a.qw);
        double ofA = reach.along(nx, ny, nz);
        reach.set(b.shape, b.qx, b.qy, b.qz, b.qw);
        return centres - ofA - reach.along(-nx, -ny, -nz);
    }

    /**
     * Whether the corner of one that is farthest along an axis is in the other: then they overlap.
     *
     * @param x from the one's centre to the other's, world, m
     * @param nx unit axis, towards the other
     */
    boolean isCornerIn(
            Flight one,
            Flight other,
            double x,
            double y,
            double z,
            double nx,
            double ny,
            double nz) {
        reach.set(one.shape, one.qx, one.qy, one.qz, one.qw);
        if (!reach.corner(nx, ny, nz, corner)) {
            return false;
        }
        reach.set(other.shape, other.qx, other.qy, other.qz, other.qw);
        return reach.holds(corner[0] - x, corner[1] - y, corner[2] - z, 0);
    }
}
