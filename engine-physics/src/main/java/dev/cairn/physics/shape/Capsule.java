package dev.cairn.physics.shape;

import dev.cairn.physics.shape.revolution.Discs;
import dev.cairn.physics.shape.revolution.Revolved;

import org.joml.Vector3d;

/**
 * All points within a radius of a segment: a cylinder with round ends. The segment lies along the y
 * axis of the shape frame, its middle at the origin.
 */
public final class Capsule extends Revolved implements Shape {
    /** m. */
    private final double radius, halfLength;

    private Capsule(double radius, double halfLength) {
        super(new Discs(-halfLength, 0, halfLength, 0, radius));
        this.radius = radius;
        this.halfLength = halfLength;
    }

    /**
     * A capsule; its whole height is {@code 2 (halfLength + radius)}.
     *
     * @param radius m, in [1e-50, 1e50]
     * @param halfLength half the length of the segment, m, in [1e-50, 1e50]; without a segment use
     *     {@link Sphere}
     * @return the shape
     * @throws DegenerateShapeException if a length is NaN, infinite or out of range
     */
    public static Capsule of(double radius, double halfLength) {
        Checks.length("Capsule radius", radius);
        Checks.length("Capsule halfLength", halfLength);
        return new Capsule(radius, halfLength);
    }

    /**
     * The radius of the ends and of the side.
     *
     * @return m
     */
    public double radius() {
        return radius;
    }

    /**
     * Half the length of the segment inside, from centre to centre of the round ends.
     *
     * @return m
     */
    public double halfLength() {
        return halfLength;
    }

    @Override
    public double volume() {
        return Math.PI * (radius * radius) * (2 * halfLength + 4.0 / 3.0 * radius);
    }

    /**
     * A cylinder and two half balls whose centres of mass are 3/8 of the radius beyond its ends.
     */
    @Override
    public MassProperties massProperties(double density) {
        Checks.density(density);
        double r2 = radius * radius;
        double h2 = halfLength * halfLength;
        double side = density * (Math.PI * r2 * (2 * halfLength));
        double ends = density * (4.0 / 3.0 * Math.PI * (r2 * radius));
        double axial = 0.5 * side * r2 + 0.4 * ends * r2;
        double across =
                side * (r2 / 4 + h2 / 3) + ends * (0.4 * r2 + h2 + 0.75 * (halfLength * radius));
        return new MassProperties(side + ends, 0, 0, 0, across, axial, across, 0, 0, 0);
    }

    @Override
    public double innerRadius() {
        return radius;
    }

    @Override
    public double outerRadius() {
        return radius + halfLength;
    }

    @Override
    public Vector3d centreOfMass(Vector3d dest) {
        return dest.zero();
    }

    @Override
    public void bounds(double qx, double qy, double qz, double qw, double[] dest, int offset) {
        double x = Math.abs(2 * (qx * qy - qz * qw)) * halfLength + radius;
        double y = Math.abs(1 - 2 * (qx * qx + qz * qz)) * halfLength + radius;
        double z = Math.abs(2 * (qy * qz + qx * qw)) * halfLength + radius;
        dest[offset] = -x;
        dest[offset + 1] = -y;
        dest[offset + 2] = -z;
        dest[offset + 3] = x;
        dest[offset + 4] = y;
        dest[offset + 5] = z;
    }

    @Override
    public String toString() {
        return "Capsule[radius=" + radius + ", halfLength=" + halfLength + "]";
    }
}
