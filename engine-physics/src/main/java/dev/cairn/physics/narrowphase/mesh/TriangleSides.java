package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.shape.mesh.TriangleSet;

/** Arithmetic of single triangles, given as normal and corners or as corners alone. Stateless. */
final class TriangleSides {
    private TriangleSides() {}

    /** 1 if the corners behind a normal go round it counter-clockwise, else -1. */
    static double orientation(double[] n, int at) {
        double ux = n[at + 6] - n[at + 3];
        double uy = n[at + 7] - n[at + 4];
        double uz = n[at + 8] - n[at + 5];
        double vx = n[at + 9] - n[at + 3];
        double vy = n[at + 10] - n[at + 4];
        double vz = n[at + 11] - n[at + 5];
        double dot =
                n[at] * (uy * vz - uz * vy)
                        + n[at + 1] * (uz * vx - ux * vz)
                        + n[at + 2] * (ux * vy - uy * vx);
        return dot < 0 ? -1 : 1;
    }

    /**
     * How far a place is inside the side from a corner to the next one, m: negative beyond it.
     *
     * @param c three corners
     * @param nx unit normal from which the corners go round counter-clockwise
     */
    static double inside(
            double[] c, int side, double nx, double ny, double nz, double x, double y, double z) {
        int a = 3 * side;
        int b = side == 2 ? 0 : a + 3;
        double ex = c[b] - c[a];
        double ey = c[b + 1] - c[a + 1];
        double ez = c[b + 2] - c[a + 2];
        double sx = ny * ez - nz * ey;
        double sy = nz * ex - nx * ez;
        double sz = nx * ey - ny * ex;
        return (sx * (x - c[a]) + sy * (y - c[a + 1]) + sz * (z - c[a + 2]))
                / Math.sqrt(sx * sx + sy * sy + sz * sz);
    }

    /**
     * Whether a place of a triangle is on an edge or at a corner that stands out of the surface.
     *
     * @param c three corners
     * @param flags of the triangle, see {@link TriangleSet}
     * @param isFront whether it is seen from the front
     * @param nx unit normal of the front
     * @param tolerance how far from an edge a place is on it, m
     */
    static boolean standsOut(
            double[] c,
            int flags,
            boolean isFront,
            double nx,
            double ny,
            double nz,
            double x,
            double y,
            double z,
            double tolerance) {
        int edges =
                (flags / (isFront ? TriangleSet.CONVEX : TriangleSet.HOLLOW)
                                | flags / TriangleSet.OPEN)
                        & TriangleSet.ALL;
        int corners =
                flags / (isFront ? TriangleSet.CORNER : TriangleSet.CORNER_BACK) & TriangleSet.ALL;
        int on = 0;
        for (int e = 0; e < 3; e++) {
            on |= inside(c, e, nx, ny, nz, x, y, z) <= tolerance ? 1 << e : 0;
        }
        // corner c is between edge c and the one before
        int at = on & (on << 1 | on >> 2);
        return (on & edges) != 0 || (at & corners) != 0;
    }
}
