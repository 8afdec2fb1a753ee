package dev.cairn.samples.scenefile;

/**
 * An orientation: the quaternion worldFromBody, of a length within 1e-6 of 1. Immutable; kept as it
 * was written, the world normalises it.
 *
 * @param x imaginary part
 * @param y imaginary part
 * @param z imaginary part
 * @param w real part
 */
public record Turn(double x, double y, double z, double w) {
    /** Not turned. */
    public static final Turn NONE = new Turn(0, 0, 0, 1);

    /** The tolerance of the world. */
    private static final double TOLERANCE = 1e-6;

    /** Checks the length. */
    public Turn {
        double length = Math.sqrt(x * x + y * y + z * z + w * w);
        if (!(Math.abs(length - 1) <= TOLERANCE)) {
            throw new IllegalArgumentException(
                    "quaternion (%s, %s, %s, %s) has length %s; expected 1 +- %s"
                            .formatted(x, y, z, w, length, TOLERANCE));
        }
    }

    /**
     * A turn about an axis.
     *
     * @param axis any length above 0
     * @param degrees angle by the right-hand rule
     * @return its unit quaternion
     */
    public static Turn about(Xyz axis, double degrees) {
        double largest =
                Math.max(Math.abs(axis.x()), Math.max(Math.abs(axis.y()), Math.abs(axis.z())));
        if (!(largest > 0) || !Double.isFinite(degrees)) {
            throw new IllegalArgumentException(
                    "axis %s, %s degrees: expected an axis of a length above 0 and a finite angle"
                            .formatted(axis, degrees));
        }
        double ax = axis.x() / largest;
        double ay = axis.y() / largest;
        double az = axis.z() / largest;
        double half = StrictMath.toRadians(degrees) / 2;
        double scale = StrictMath.sin(half) / Math.sqrt(ax * ax + ay * ay + az * az);
        return new Turn(ax * scale, ay * scale, az * scale, StrictMath.cos(half));
    }
}
