package dev.cairn.physics;

/** Checks on quaternions that users pass. */
final class Rotations {
    /** How far from 1 the length of a quaternion may be to be taken as rounding. */
    static final double TOLERANCE = 1e-6;

    private Rotations() {}

    /** The factor that makes the quaternion a unit one, if it is one but for rounding. */
    static double inverseLength(String name, double x, double y, double z, double w) {
        double length = Math.sqrt(x * x + y * y + z * z + w * w);
        if (!(Math.abs(length - 1) <= TOLERANCE)) {
            throw new IllegalArgumentException(
                    name
                            + " is the quaternion ("
                            + x
                            + ", "
                            + y
                            + ", "
                            + z
                            + ", "
                            + w
                            + ") of length "
                            + length
                            + "; the length must be within "
                            + TOLERANCE
                            + " of 1: normalise it first");
        }
        return 1 / length;
    }
}
