package dev.cairn.physics.shape.polyhedron;

/** Vertices and planes of a triangle without thickness that goes from place to place. Stateless. */
final class TrianglePlanes {
    private TrianglePlanes() {}

    /**
     * Fills a {@link Polyhedron#triangle} anew.
     *
     * @param p the triangle
     * @param corners three times x, y, z, m; not on one line
     * @param ox the point that the vertices are relative to, m
     */
    static void set(Polyhedron p, double[] corners, double ox, double oy, double oz) {
        double outer = 0;
        for (int v = 0; v < 3; v++) {
            double x = corners[3 * v] - ox;
            double y = corners[3 * v + 1] - oy;
            double z = corners[3 * v + 2] - oz;
            p.vertex[4 * v] = x;
            p.vertex[4 * v + 1] = y;
            p.vertex[4 * v + 2] = z;
            outer = Math.max(outer, x * x + y * y + z * z);
        }
        p.outerRadius = Math.sqrt(outer);
        double nx = crossX(p, 1, 2);
        double ny = crossX(p, 2, 0);
        double nz = crossX(p, 0, 1);
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        nx /= length;
        ny /= length;
        nz /= length;
        double high = -Double.MAX_VALUE;
        double low = Double.MAX_VALUE;
        for (int v = 0; v < 3; v++) {
            double along = p.along(v, nx, ny, nz);
            high = Math.max(high, along);
            low = Math.min(low, along);
        }
        setPlane(p, 0, nx, ny, nz, high);
        setPlane(p, 1, -nx, -ny, -nz, -low);
        for (int slot = 0; slot < 6; slot++) {
            int face = slot < 3 ? 0 : 1;
            int next = slot + 1 == p.faceBegin(face + 1) ? p.faceBegin(face) : slot + 1;
            setSide(
                    p,
                    slot,
                    p.slotVertex(slot),
                    p.slotVertex(next),
                    face == 0 ? 1 : -1,
                    nx,
                    ny,
                    nz);
        }
    }

    /** A component of (v1 - v0) x (v2 - v0), from two coordinates. */
    private static double crossX(Polyhedron p, int y, int z) {
        return (p.vertex[4 + y] - p.vertex[y]) * (p.vertex[8 + z] - p.vertex[z])
                - (p.vertex[4 + z] - p.vertex[z]) * (p.vertex[8 + y] - p.vertex[y]);
    }

    private static void setPlane(
            Polyhedron p, int face, double nx, double ny, double nz, double offset) {
        p.plane[4 * face] = nx;
        p.plane[4 * face + 1] = ny;
        p.plane[4 * face + 2] = nz;
        p.plane[4 * face + 3] = offset;
    }

    /** The plane through a side, at right angles to the triangle. */
    private static void setSide(
            Polyhedron p, int slot, int a, int b, double sign, double nx, double ny, double nz) {
        double ex = sign * (p.vertexX(b) - p.vertexX(a));
        double ey = sign * (p.vertexY(b) - p.vertexY(a));
        double ez = sign * (p.vertexZ(b) - p.vertexZ(a));
        double sx = ey * nz - ez * ny;
        double sy = ez * nx - ex * nz;
        double sz = ex * ny - ey * nx;
        double length = Math.sqrt(sx * sx + sy * sy + sz * sz);
        p.sidePlane[4 * slot] = sx / length;
        p.sidePlane[4 * slot + 1] = sy / length;
        p.sidePlane[4 * slot + 2] = sz / length;
        p.sidePlane[4 * slot + 3] =
                Math.max(
                        p.along(a, sx / length, sy / length, sz / length),
                        p.along(b, sx / length, sy / length, sz / length));
    }

    /** The first of the three corners that is farthest along a direction. */
    static int support(Polyhedron p, double dx, double dy, double dz) {
        double a = p.along(0, dx, dy, dz);
        double b = p.along(1, dx, dy, dz);
        double c = p.along(2, dx, dy, dz);
        return a >= b ? (a >= c ? 0 : 2) : (b >= c ? 1 : 2);
    }
}
