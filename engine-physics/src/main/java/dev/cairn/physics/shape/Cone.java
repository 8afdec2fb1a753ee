package dev.cairn.physics.shape;

import dev.cairn.physics.shape.revolution.Discs;
import dev.cairn.physics.shape.revolution.Revolved;

import org.joml.Vector3d;

/**
 * A round cone along the y axis of the shape frame, its apex up. The origin is midway between apex
 * and base; the centre of mass lies a quarter of the height above the base.
 */
public final class Cone extends Revolved implements Shape {
    /** m. */
    private final double radius, halfHeight;

    private Cone(double radius, double halfHeight) {
        super(new Discs(-(0.5 * halfHeight), radius, 1.5 * halfHeight, 0, 0));
        this.radius = radius;
        this.halfHeight = halfHeight;
    }

    /**
     * A cone with its base at {@code y = -halfHeight} and its apex at {@code y = halfHeight}.
     *
     * @param radius of the base, m, in [1e-50, 1e50]
     * @param halfHeight half the distance of apex and base, m, in [1e-50, 1e50]
     * @return the shape
     * @throws DegenerateShapeException if a length is NaN, infinite or out of range
     */
    public static Cone of(double radius, double halfHeight) {
        Checks.length("Cone radius", radius);
        Checks.length("Cone halfHeight", halfHeight);
        return new Cone(radius, halfHeight);
    }

    /**
     * The radius of the base.
     *
     * @return m
     */
    public double radius() {
        return radius;
    }

    /**
     * Half the distance of apex and base.
     *
     * @return m
     */
    public double halfHeight() {
        return halfHeight;
    }

    /**
     * The apex above the centre of mass.
     *
     * @return three quarters of the height, m
     */
    public double apexAbove() {
        return 1.5 * halfHeight;
    }

    /**
     * The base below the centre of mass.
     *
     * @return a quarter of the height, m
     */
    public double baseBelow() {
        return 0.5 * halfHeight;
    }

    @Override
    public double volume() {
        return Math.PI / 3 * (radius * radius) * (2 * halfHeight);
    }

    @Override
    public MassProperties massProperties(double density) {
        Checks.density(density);
        double mass = density * volume();
        double r2 = radius * radius;
        // 3/20 r² + 3/80 height², height = 2 halfHeight.
        double across = mass * (0.15 * (r2 + halfHeight * halfHeight));
        return new MassProperties(
                mass, 0, -0.5 * halfHeight, 0, across, 0.3 * mass * r2, across, 0, 0, 0);
    }

    @Override
    public double innerRadius() {
        double height = 2 * halfHeight;
        double side = apexAbove() * (radius / Math.sqrt(radius * radius + height * height));
        return Math.min(baseBelow(), side);
    }

    @Override
    public double outerRadius() {
        return Math.max(apexAbove(), Math.sqrt(radius * radius + baseBelow() * baseBelow()));
    }

    @Override
    public Vector3d centreOfMass(Vector3d dest) {
        return dest.set(0, -0.5 * halfHeight, 0);
    }

    @Override
    public void bounds(double qx, double qy, double qz, double qw, double[] dest, int offset) {
        Solids.coneBounds(qx, qy, qz, qw, radius, -baseBelow(), 0, apexAbove(), dest, offset);
    }

    @Override
    public String toString() {
        return "Cone[radius=" + radius + ", halfHeight=" + halfHeight + "]";
    }
}
