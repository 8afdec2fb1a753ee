package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.shape.mesh.TriangleSet;

/**
 * Whether a surface lets a normal be at one of its points: m . (w - p) &lt;= 0 for the corners w of
 * each triangle that touches p.
 */
final class NormalCone {
    /** Up to so many triangles near a shape are all looked at; of more, those in a box at p. */
    private static final int FEW = 128;

    /** Sine of what a normal may miss the cone by, for rounding. */
    private static final double ROUNDING = 1e-7;

    private final TriangleSet.Found few = new TriangleSet.Found();
    private final double[] box = new double[6];
    private final double[] corner = new double[9];

    /** A normal of the last triangle that was set. */
    private double nx, ny, nz;

    /**
     * Asks.
     *
     * @param near triangles among which are all that touch p
     * @param px a point of the surface, from the shape's centre, axes of the mesh, m
     * @param mx unit normal, away from the surface
     * @param cx the shape's centre in the mesh's frame, m
     * @param tolerance triangles this near to p touch it, m
     */
    boolean allows(
            TriangleSet set,
            TriangleSet.Found near,
            double px,
            double py,
            double pz,
            double mx,
            double my,
            double mz,
            double cx,
            double cy,
            double cz,
            double tolerance) {
        double x = px + cx;
        double y = py + cy;
        double z = pz + cz;
        TriangleSet.Found all = near;
        if (near.count > FEW) {
            box[0] = x - tolerance;
            box[1] = y - tolerance;
            box[2] = z - tolerance;
            box[3] = x + tolerance;
            box[4] = y + tolerance;
            box[5] = z + tolerance;
            set.find(box, few);
            all = few;
        }
        for (int i = 0; i < all.count; i++) {
            set.corners(all.triangle[i], corner);
            if (!touches(x, y, z, tolerance)) {
                continue;
            }
            for (int c = 0; c < 9; c += 3) {
                double wx = corner[c] - x;
                double wy = corner[c + 1] - y;
                double wz = corner[c + 2] - z;
                double far = Math.sqrt(wx * wx + wy * wy + wz * wz);
                if (far > tolerance
                        && mx * wx + my * wy + mz * wz > ROUNDING * far + tiny(x, y, z)) {
                    return false;
                }
            }
        }
        return true;
    }

    /** What rounding of coordinates may tell a height wrong by. */
    private static double tiny(double x, double y, double z) {
        return 0x1p-48 * (Math.abs(x) + Math.abs(y) + Math.abs(z));
    }

    /** Whether a point is within the tolerance of the plane and of the sides of the triangle. */
    private boolean touches(double x, double y, double z, double tolerance) {
        normal();
        double height = nx * (x - corner[0]) + ny * (y - corner[1]) + nz * (z - corner[2]);
        double square = nx * nx + ny * ny + nz * nz;
        // squares first: most triangles are not near, and need no root
        if (!(height * height <= tolerance * tolerance * square)) {
            return false;
        }
        double length = Math.sqrt(square);
        nx /= length;
        ny /= length;
        nz /= length;
        for (int a = 0; a < 9; a += 3) {
            int b = a == 6 ? 0 : a + 3;
            double ex = corner[b] - corner[a];
            double ey = corner[b + 1] - corner[a + 1];
            double ez = corner[b + 2] - corner[a + 2];
            double sx = ey * nz - ez * ny;
            double sy = ez * nx - ex * nz;
            double sz = ex * ny - ey * nx;
            double over =
                    sx * (x - corner[a]) + sy * (y - corner[a + 1]) + sz * (z - corner[a + 2]);
            if (over > tolerance * Math.sqrt(ex * ex + ey * ey + ez * ez)) {
                return false;
            }
        }
        return true;
    }

    private void normal() {
        double ux = corner[3] - corner[0];
        double uy = corner[4] - corner[1];
        double uz = corner[5] - corner[2];
        double vx = corner[6] - corner[0];
        double vy = corner[7] - corner[1];
        double vz = corner[8] - corner[2];
        nx = uy * vz - uz * vy;
        ny = uz * vx - ux * vz;
        nz = ux * vy - uy * vx;
    }
}
