package dev.cairn.physics.shape;

import dev.cairn.physics.shape.revolution.Discs;
import dev.cairn.physics.shape.revolution.Revolved;

import org.joml.Vector3d;

/** A round cylinder along the y axis of the shape frame, its middle at the origin. */
public final class Cylinder extends Revolved implements Shape {
    /** m. */
    private final double radius, halfHeight;

    private Cylinder(double radius, double halfHeight) {
        super(new Discs(-halfHeight, radius, halfHeight, radius, 0));
        this.radius = radius;
        this.halfHeight = halfHeight;
    }

    /**
     * A cylinder with its caps at {@code y = -halfHeight} and {@code y = halfHeight}.
     *
     * @param radius m, in [1e-50, 1e50]
     * @param halfHeight half the distance of the caps, m, in [1e-50, 1e50]
     * @return the shape
     * @throws DegenerateShapeException if a length is NaN, infinite or out of range
     */
    public static Cylinder of(double radius, double halfHeight) {
        Checks.length("Cylinder radius", radius);
        Checks.length("Cylinder halfHeight", halfHeight);
        return new Cylinder(radius, halfHeight);
    }

    /**
     * The radius.
     *
     * @return m
     */
    public double radius() {
        return radius;
    }

    /**
     * Half the distance of the caps.
     *
     * @return m
     */
    public double halfHeight() {
        return halfHeight;
    }

    @Override
    public double volume() {
        return Math.PI * (radius * radius) * (2 * halfHeight);
    }

    @Override
    public MassProperties massProperties(double density) {
        Checks.density(density);
        double mass = density * volume();
        double r2 = radius * radius;
        double across = mass * (r2 / 4 + halfHeight * halfHeight / 3);
        return new MassProperties(mass, 0, 0, 0, across, 0.5 * mass * r2, across, 0, 0, 0);
    }

    @Override
    public double innerRadius() {
        return Math.min(radius, halfHeight);
    }

    @Override
    public double outerRadius() {
        return Math.sqrt(radius * radius + halfHeight * halfHeight);
    }

    @Override
    public Vector3d centreOfMass(Vector3d dest) {
        return dest.zero();
    }

    @Override
    public void bounds(double qx, double qy, double qz, double qw, double[] dest, int offset) {
        Solids.coneBounds(qx, qy, qz, qw, radius, -halfHeight, radius, halfHeight, dest, offset);
    }

    @Override
    public String toString() {
        return "Cylinder[radius=" + radius + ", halfHeight=" + halfHeight + "]";
    }
}
