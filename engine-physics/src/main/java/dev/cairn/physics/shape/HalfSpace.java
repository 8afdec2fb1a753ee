package dev.cairn.physics.shape;

import org.joml.Vector3d;

/**
 * Everything below a plane, without end: {@code y <= 0} in the shape frame. For fixed bodies only;
 * {@code Body.rotation} tilts it. Its mass is infinite, which no moving body can have.
 */
public final class HalfSpace implements Shape {
    private static final HalfSpace ONE = new HalfSpace();

    private HalfSpace() {}

    /**
     * The half-space below the plane {@code y = 0} of the shape frame.
     *
     * @return the shape, the same object each time
     */
    public static HalfSpace of() {
        return ONE;
    }

    /**
     * The volume.
     *
     * @return infinite
     */
    @Override
    public double volume() {
        return Double.POSITIVE_INFINITY;
    }

    /**
     * Infinite mass and inertia, its centre at the origin of the shape frame by definition.
     *
     * @param density kg/m³, positive and finite
     */
    @Override
    public MassProperties massProperties(double density) {
        Checks.density(density);
        double much = Double.POSITIVE_INFINITY;
        return new MassProperties(much, 0, 0, 0, much, much, much, 0, 0, 0);
    }

    /**
     * Of the shapes that touch a half-space the other one is always the smaller.
     *
     * @return infinite
     */
    @Override
    public double innerRadius() {
        return Double.POSITIVE_INFINITY;
    }

    /**
     * No ball contains it.
     *
     * @return infinite
     */
    @Override
    public double outerRadius() {
        return Double.POSITIVE_INFINITY;
    }

    @Override
    public Vector3d centreOfMass(Vector3d dest) {
        return dest.zero();
    }

    /**
     * Infinite on all sides, but for a plane that is exactly at right angles to a world axis: then
     * it ends there.
     */
    @Override
    public void bounds(double qx, double qy, double qz, double qw, double[] dest, int offset) {
        double nx = 2 * (qx * qy - qz * qw);
        double ny = 1 - 2 * (qx * qx + qz * qz);
        double nz = 2 * (qy * qz + qx * qw);
        for (int axis = 0; axis < 3; axis++) {
            dest[offset + axis] = Double.NEGATIVE_INFINITY;
            dest[offset + 3 + axis] = Double.POSITIVE_INFINITY;
        }
        end(dest, offset, nx, ny == 0 && nz == 0);
        end(dest, offset + 1, ny, nx == 0 && nz == 0);
        end(dest, offset + 2, nz, nx == 0 && ny == 0);
    }

    private static void end(double[] dest, int at, double normal, boolean alone) {
        if (alone) {
            dest[normal > 0 ? at + 3 : at] = 0;
        }
    }

    @Override
    public String toString() {
        return "HalfSpace[]";
    }
}
