package dev.cairn.physics.query;

import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A shape at a pose. Reuse one object: {@link #set} replaces all of it and allocates nothing. One
 * thread at a time.
 */
public final class Placement {
    private static final double TOLERANCE = 1e-6;

    Shape shape = Sphere.of(1);

    /** Centre of mass, world, m; orientation, world from shape. */
    double x, y, z, qx, qy, qz, qw = 1;

    private final Vector3d centre = new Vector3d();

    /** A ball of 1 m around the origin, until it is set. */
    public Placement() {}

    /**
     * Places a shape.
     *
     * @param newShape which one
     * @param originX where the origin of its frame is, world, m, finite
     * @param originY see {@code originX}
     * @param originZ see {@code originX}
     * @param rotationX quaternion, world from shape, of a length within 1e-6 of 1
     * @param rotationY see {@code rotationX}
     * @param rotationZ see {@code rotationX}
     * @param rotationW see {@code rotationX}
     * @return this
     * @throws IllegalArgumentException if a number is not finite or the quaternion is no unit one
     */
    public Placement set(
            Shape newShape,
            double originX,
            double originY,
            double originZ,
            double rotationX,
            double rotationY,
            double rotationZ,
            double rotationW) {
        Checks.notNull("newShape", newShape);
        finite("originX", originX);
        finite("originY", originY);
        finite("originZ", originZ);
        double length =
                Math.sqrt(
                        rotationX * rotationX
                                + rotationY * rotationY
                                + rotationZ * rotationZ
                                + rotationW * rotationW);
        if (!(Math.abs(length - 1) <= TOLERANCE)) {
            throw new IllegalArgumentException(
                    "rotation has length " + length + "; it must be a unit quaternion");
        }
        shape = newShape;
        qx = rotationX / length;
        qy = rotationY / length;
        qz = rotationZ / length;
        qw = rotationW / length;
        shape.centreOfMass(centre);
        double tx = 2 * (qy * centre.z - qz * centre.y);
        double ty = 2 * (qz * centre.x - qx * centre.z);
        double tz = 2 * (qx * centre.y - qy * centre.x);
        x = originX + centre.x + qw * tx + qy * tz - qz * ty;
        y = originY + centre.y + qw * ty + qz * tx - qx * tz;
        z = originZ + centre.z + qw * tz + qx * ty - qy * tx;
        return this;
    }

    /**
     * Places a shape without turning it.
     *
     * @param newShape which one
     * @param originX where the origin of its frame is, world, m, finite
     * @param originY see {@code originX}
     * @param originZ see {@code originX}
     * @return this
     * @throws IllegalArgumentException if a number is not finite
     */
    public Placement set(Shape newShape, double originX, double originY, double originZ) {
        return set(newShape, originX, originY, originZ, 0, 0, 0, 1);
    }

    /**
     * Places a shape without turning it.
     *
     * @param newShape which one
     * @param origin where the origin of its frame is, world, m, finite
     * @return this
     */
    public Placement set(Shape newShape, Vector3dc origin) {
        return set(newShape, origin.x(), origin.y(), origin.z());
    }

    /**
     * Places a shape.
     *
     * @param newShape which one
     * @param origin where the origin of its frame is, world, m, finite
     * @param q quaternion, world from shape, of a length within 1e-6 of 1
     * @return this
     */
    public Placement set(Shape newShape, Vector3dc origin, Quaterniondc q) {
        double x0 = origin.x();
        return set(newShape, x0, origin.y(), origin.z(), q.x(), q.y(), q.z(), q.w());
    }

    /**
     * Places a shape by its centre of mass, as the engine's bodies are.
     *
     * @param newShape which one
     * @param centreX centre of mass, world, m, finite
     * @param centreY see {@code centreX}
     * @param centreZ see {@code centreX}
     * @param rotationX unit quaternion, world from shape, finite, else taken as it is
     * @param rotationY see {@code rotationX}
     * @param rotationZ see {@code rotationX}
     * @param rotationW see {@code rotationX}
     * @return this
     * @throws IllegalArgumentException if the shape is null or a number is not finite
     */
    public Placement setCentre(
            Shape newShape,
            double centreX,
            double centreY,
            double centreZ,
            double rotationX,
            double rotationY,
            double rotationZ,
            double rotationW) {
        Checks.notNull("newShape", newShape);
        finite("centreX", centreX);
        finite("centreY", centreY);
        finite("centreZ", centreZ);
        finite("rotation", rotationX + rotationY + rotationZ + rotationW);
        shape = newShape;
        x = centreX;
        y = centreY;
        z = centreZ;
        qx = rotationX;
        qy = rotationY;
        qz = rotationZ;
        qw = rotationW;
        return this;
    }

    /**
     * The shape.
     *
     * @return the one set last
     */
    public Shape shape() {
        return shape;
    }

    /**
     * The tight box around the placed shape.
     *
     * @param dest receives minX, minY, minZ, maxX, maxY, maxZ, world, m
     */
    public void bounds(double[] dest) {
        shape.bounds(qx, qy, qz, qw, dest, 0);
        dest[0] += x;
        dest[1] += y;
        dest[2] += z;
        dest[3] += x;
        dest[4] += y;
        dest[5] += z;
    }

    /** What lengths of a query about it are proportional to, m. */
    double size() {
        return shape instanceof HalfSpace ? 0 : shape.outerRadius();
    }

    static void finite(String name, double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(name + " is " + value + "; it must be finite");
        }
    }
}
