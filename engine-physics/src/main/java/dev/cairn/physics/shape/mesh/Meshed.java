package dev.cairn.physics.shape.mesh;

import org.joml.Vector3d;

/**
 * A shape that is a surface of triangles. The narrow phase reads them with {@link TriangleSet#of};
 * they are no part of what a user of the shape sees.
 */
public abstract class Meshed {
    /** In the shape's frame, whose origin is what bodies are placed by. */
    final TriangleSet triangles;

    /** Of these triangles. */
    protected Meshed(TriangleSet triangles) {
        this.triangles = triangles;
    }

    /**
     * The number of a triangle's material, see {@code Collider.materials}.
     *
     * @param triangle as {@code Hit.triangle} and {@code Contacts.triangle} tell it
     * @return 0..254
     * @throws IndexOutOfBoundsException if there is no such triangle
     */
    public abstract int material(int triangle);

    /**
     * The volume.
     *
     * @return infinite: only what does not move by itself is ground
     */
    public final double volume() {
        return Double.POSITIVE_INFINITY;
    }

    /**
     * Of the shapes that touch the ground the other one is always the smaller.
     *
     * @return infinite
     */
    public final double innerRadius() {
        return Double.POSITIVE_INFINITY;
    }

    /**
     * Bodies are placed by the origin of the frame.
     *
     * @param dest receives 0, 0, 0
     * @return dest
     */
    public final Vector3d centreOfMass(Vector3d dest) {
        return dest.zero();
    }

    /**
     * The box around the turned box of all triangles, relative to the frame's origin: tight while
     * the shape is not turned.
     *
     * @param qx unit quaternion, worldFromShape; likewise qy, qz, qw
     * @param dest receives minX, minY, minZ, maxX, maxY, maxZ
     * @param offset where in dest
     */
    public final void bounds(
            double qx, double qy, double qz, double qw, double[] dest, int offset) {
        row(
                dest,
                offset,
                1 - 2 * (qy * qy + qz * qz),
                2 * (qx * qy - qz * qw),
                2 * (qx * qz + qy * qw));
        row(
                dest,
                offset + 1,
                2 * (qx * qy + qz * qw),
                1 - 2 * (qx * qx + qz * qz),
                2 * (qy * qz - qx * qw));
        row(
                dest,
                offset + 2,
                2 * (qx * qz - qy * qw),
                2 * (qy * qz + qx * qw),
                1 - 2 * (qx * qx + qy * qy));
    }

    private void row(double[] dest, int at, double dx, double dy, double dz) {
        double low = 0;
        double high = 0;
        for (int axis = 0; axis < 3; axis++) {
            double d = axis == 0 ? dx : axis == 1 ? dy : dz;
            low += d * triangles.end(axis, d < 0);
            high += d * triangles.end(axis, d >= 0);
        }
        dest[at] = low;
        dest[at + 3] = high;
    }
}
