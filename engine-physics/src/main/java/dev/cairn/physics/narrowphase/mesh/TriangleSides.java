package dev.cairn.physics.narrowphase.mesh;

/** Arithmetic of single triangles, given as normal and corners or as corners alone. Stateless. */
final class TriangleSides {
    private TriangleSides() {}

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
     * On which edges of a triangle a place of it is.
     *
     * @param c three corners
     * @param nx unit normal from which the corners go round counter-clockwise
     * @param tolerance how far from an edge a place is on it, m
     * @return bit e for the edge from corner e to the next
     */
    static int on(
            double[] c,
            double nx,
            double ny,
            double nz,
            double x,
            double y,
            double z,
            double tolerance) {
        int on = 0;
        for (int e = 0; e < 3; e++) {
            on |= inside(c, e, nx, ny, nz, x, y, z) <= tolerance ? 1 << e : 0;
        }
        return on;
    }
}
