package dev.cairn.physics.internal;

/** Quaternions as users pass them, and the rotation of a vector. */
public final class Rotations {
    /** How far from 1 the length of a quaternion may be to be taken as rounding. */
    public static final double TOLERANCE = 1e-6;

    /** Four units in the last place of 1. */
    private static final double ROUNDING = 0x1p-50;

    private Rotations() {}

    /**
     * The factor that makes a quaternion a unit one, if it is one but for rounding.
     *
     * @return the factor, 1 if the length is 1 but for the last bits
     */
    public static double inverseLength(String name, double x, double y, double z, double w) {
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
        // A quaternion that is normalised but for rounding is kept bit for bit, so that what one
        // body says of its orientation turns another one into exactly the same.
        return Math.abs(length - 1) <= ROUNDING ? 1 : 1 / length;
    }

    /**
     * Rotates (vx, vy, vz) by the unit quaternion: v + 2 w (q x v) + 2 q x (q x v).
     *
     * @param out receives the vector, from index 0 on
     */
    public static void rotate(
            double qx,
            double qy,
            double qz,
            double qw,
            double vx,
            double vy,
            double vz,
            double[] out) {
        double tx = 2 * (qy * vz - qz * vy);
        double ty = 2 * (qz * vx - qx * vz);
        double tz = 2 * (qx * vy - qy * vx);
        out[0] = vx + qw * tx + (qy * tz - qz * ty);
        out[1] = vy + qw * ty + (qz * tx - qx * tz);
        out[2] = vz + qw * tz + (qx * ty - qy * tx);
    }
}
