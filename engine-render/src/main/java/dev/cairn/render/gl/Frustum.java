package dev.cairn.render.gl;

import org.joml.Matrix4d;

/**
 * The six planes around what a matrix maps into the clip cube, to leave out what cannot be seen.
 * Planes from the rows of the matrix: G. Gribb and K. Hartmann, "Fast extraction of viewing frustum
 * planes from the world-view-projection matrix" (2001). One thread; allocates nothing after its
 * making.
 */
final class Frustum {
    /**
     * Vertices are placed in floats, whose error grows with their distance from the anchor; a
     * sphere is grown by so much of its distance and radius before it is left out.
     */
    private static final double FLOAT_SLACK = 1e-5;

    /** Unit normals that point inwards, and offsets: inside where n.x + d >= 0. */
    private final double[] planes = new double[6 * 4];

    /**
     * Takes the planes of a matrix.
     *
     * @param m clip from world
     * @param openNear whether what lies before the near plane counts as inside, because its depth
     *     is clamped
     */
    void set(Matrix4d m, boolean openNear) {
        plane(0, m.m03() + m.m00(), m.m13() + m.m10(), m.m23() + m.m20(), m.m33() + m.m30());
        plane(1, m.m03() - m.m00(), m.m13() - m.m10(), m.m23() - m.m20(), m.m33() - m.m30());
        plane(2, m.m03() + m.m01(), m.m13() + m.m11(), m.m23() + m.m21(), m.m33() + m.m31());
        plane(3, m.m03() - m.m01(), m.m13() - m.m11(), m.m23() - m.m21(), m.m33() - m.m31());
        plane(4, m.m03() - m.m02(), m.m13() - m.m12(), m.m23() - m.m22(), m.m33() - m.m32());
        if (openNear) {
            plane(5, 0, 0, 0, 1);
        } else {
            plane(5, m.m03() + m.m02(), m.m13() + m.m12(), m.m23() + m.m22(), m.m33() + m.m32());
        }
    }

    private void plane(int at, double x, double y, double z, double d) {
        double length = Math.sqrt(x * x + y * y + z * z);
        // A plane at infinity has no direction and leaves nothing out.
        double scale = length > 0 ? 1 / length : 0;
        planes[4 * at] = x * scale;
        planes[4 * at + 1] = y * scale;
        planes[4 * at + 2] = z * scale;
        planes[4 * at + 3] = d * scale;
    }

    /**
     * Whether a sphere may be seen: never false if a point of it is inside, false if it lies wholly
     * outside of one plane.
     *
     * @param x centre, in the matrix's world
     * @param y same
     * @param z same
     * @param radius at least 0
     * @return false if it is surely unseen
     */
    boolean touches(double x, double y, double z, double radius) {
        double reach = radius + FLOAT_SLACK * (radius + Math.abs(x) + Math.abs(y) + Math.abs(z));
        double[] p = planes;
        for (int i = 0; i < 24; i += 4) {
            if (p[i] * x + p[i + 1] * y + p[i + 2] * z + p[i + 3] < -reach) {
                return false;
            }
        }
        return true;
    }
}
