package dev.cairn.physics.shape;

import org.joml.Vector3d;

/** A ball around the origin of the shape frame. */
public final class Sphere implements Shape {
    /** m. */
    private final double radius;

    private Sphere(double radius) {
        this.radius = radius;
    }

    /**
     * A ball.
     *
     * @param radius m, in [1e-50, 1e50]
     * @return the shape
     * @throws DegenerateShapeException if the radius is NaN, infinite or out of range
     */
    public static Sphere of(double radius) {
        Checks.length("Sphere radius", radius);
        return new Sphere(radius);
    }

    /**
     * The radius.
     *
     * @return m
     */
    public double radius() {
        return radius;
    }

    @Override
    public double volume() {
        return 4.0 / 3.0 * Math.PI * (radius * radius * radius);
    }

    @Override
    public MassProperties massProperties(double density) {
        Checks.density(density);
        double mass = density * volume();
        double inertia = 0.4 * mass * (radius * radius);
        return new MassProperties(mass, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
    }

    @Override
    public double innerRadius() {
        return radius;
    }

    @Override
    public double outerRadius() {
        return radius;
    }

    @Override
    public Vector3d centreOfMass(Vector3d dest) {
        return dest.zero();
    }

    @Override
    public void bounds(double qx, double qy, double qz, double qw, double[] dest, int offset) {
        for (int axis = 0; axis < 3; axis++) {
            dest[offset + axis] = -radius;
            dest[offset + 3 + axis] = radius;
        }
    }

    @Override
    public String toString() {
        return "Sphere[radius=" + radius + "]";
    }
}
