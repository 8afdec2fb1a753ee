package dev.cairn.physics.internal;

import dev.cairn.physics.shape.Moved;

/**
 * The turn {@code q m} of what lies within a moved shape: q the orientation of the moved one, m its
 * turn within. A number at a time, so that nothing is allocated.
 */
public final class MovedTurn {
    private MovedTurn() {}

    /** Imaginary part along x. */
    public static double x(Moved m, double x, double y, double z, double w) {
        return w * m.rotationX() + x * m.rotationW() + y * m.rotationZ() - z * m.rotationY();
    }

    /** Imaginary part along y. */
    public static double y(Moved m, double x, double y, double z, double w) {
        return w * m.rotationY() - x * m.rotationZ() + y * m.rotationW() + z * m.rotationX();
    }

    /** Imaginary part along z. */
    public static double z(Moved m, double x, double y, double z, double w) {
        return w * m.rotationZ() + x * m.rotationY() - y * m.rotationX() + z * m.rotationW();
    }

    /** Real part. */
    public static double w(Moved m, double x, double y, double z, double w) {
        return w * m.rotationW() - x * m.rotationX() - y * m.rotationY() - z * m.rotationZ();
    }
}
