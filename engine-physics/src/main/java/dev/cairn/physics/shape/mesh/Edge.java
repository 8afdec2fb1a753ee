package dev.cairn.physics.shape.mesh;

/** How two triangles meet at an edge. Stateless. */
final class Edge {
    /** Sine of the angle between faces that count as one plane. */
    private static final double FLAT = 1e-6;

    private Edge() {}

    /**
     * What the edge from a to b of a triangle (a, b, c) is, whose neighbour is (b, a, d). With n
     * and m, twice their areas along their normals, d is |m| / |b - a| away from the edge and n .
     * (d - a) / |n| above the first plane, so
     *
     * <pre>
     *   sin = n . (d - a) |b - a| / (|n| |m|)
     * </pre>
     *
     * <p>which is compared with the bound by squares.
     *
     * @return {@link TriangleSet#CONVEX}, {@link TriangleSet#HOLLOW} or, where the two lie on each
     *     other, {@link TriangleSet#OPEN}: that of edge 0; 0 for a flat edge
     */
    static int kind(
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            double cx,
            double cy,
            double cz,
            double dx,
            double dy,
            double dz) {
        double ex = bx - ax;
        double ey = by - ay;
        double ez = bz - az;
        double ux = cx - ax;
        double uy = cy - ay;
        double uz = cz - az;
        double vx = dx - ax;
        double vy = dy - ay;
        double vz = dz - az;
        double nx = ey * uz - ez * uy;
        double ny = ez * ux - ex * uz;
        double nz = ex * uy - ey * ux;
        double mx = vy * ez - vz * ey;
        double my = vz * ex - vx * ez;
        double mz = vx * ey - vy * ex;
        double height = nx * vx + ny * vy + nz * vz;
        boolean folded = nx * mx + ny * my + nz * mz < 0;
        double edge = ex * ex + ey * ey + ez * ez;
        double areas = (nx * nx + ny * ny + nz * nz) * (mx * mx + my * my + mz * mz);
        if (!folded && height * height * edge <= FLAT * FLAT * areas) {
            return 0;
        }
        return height < 0 ? TriangleSet.CONVEX : height > 0 ? TriangleSet.HOLLOW : TriangleSet.OPEN;
    }
}
