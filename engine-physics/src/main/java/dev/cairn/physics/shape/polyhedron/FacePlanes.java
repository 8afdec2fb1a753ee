package dev.cairn.physics.shape.polyhedron;

/** The planes of a {@link Polyhedron}'s faces and of their sides. Set-up only. */
final class FacePlanes {
    final double[] normalX, normalY, normalZ, offset;
    final double[] sideX, sideY, sideZ, sideOffset;

    /** The corners of a face are not in one plane up to rounding; and whether any face is so. */
    final boolean[] uneven;

    boolean anyUneven;

    FacePlanes(double[] x, double[] y, double[] z, Topology topology) {
        int faces = topology.faceBegin.length - 1;
        int slots = topology.slotVertex.length;
        normalX = new double[faces];
        normalY = new double[faces];
        normalZ = new double[faces];
        offset = new double[faces];
        sideX = new double[slots];
        sideY = new double[slots];
        sideZ = new double[slots];
        sideOffset = new double[slots];
        uneven = new boolean[faces];
        planes(x, y, z, topology);
    }

    /**
     * Planes by Newell's sums, which are exact for blocks, added up in both directions round the
     * face, so that a mirror image has the mirrored bits; offsets touch the outermost corner.
     */
    private void planes(double[] x, double[] y, double[] z, Topology t) {
        int[] faceBegin = t.faceBegin;
        int[] slotVertex = t.slotVertex;
        for (int f = 0; f + 1 < faceBegin.length; f++) {
            int begin = faceBegin[f];
            int end = faceBegin[f + 1];
            int origin = slotVertex[begin];
            double nx = 0;
            double ny = 0;
            double nz = 0;
            double mx = 0;
            double my = 0;
            double mz = 0;
            for (int s = begin + 1; s + 1 < end; s++) {
                nx += crossX(y, z, origin, slotVertex[s], slotVertex[s + 1]);
                ny += crossX(z, x, origin, slotVertex[s], slotVertex[s + 1]);
                nz += crossX(x, y, origin, slotVertex[s], slotVertex[s + 1]);
                int back = begin + end - s - 1;
                mx += crossX(y, z, origin, slotVertex[back], slotVertex[back + 1]);
                my += crossX(z, x, origin, slotVertex[back], slotVertex[back + 1]);
                mz += crossX(x, y, origin, slotVertex[back], slotVertex[back + 1]);
            }
            nx += mx;
            ny += my;
            nz += mz;
            double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
            nx /= length;
            ny /= length;
            nz /= length;
            normalX[f] = nx;
            normalY[f] = ny;
            normalZ[f] = nz;
            double d = -Double.MAX_VALUE;
            double low = Double.MAX_VALUE;
            double extent = 0;
            for (int s = begin; s < end; s++) {
                int v = slotVertex[s];
                double height = nx * x[v] + ny * y[v] + nz * z[v];
                d = Math.max(d, height);
                low = Math.min(low, height);
                extent = Math.max(extent, Math.max(Math.abs(x[v]), Math.abs(y[v])));
                extent = Math.max(extent, Math.abs(z[v]));
            }
            offset[f] = d;
            uneven[f] = end - begin > 3 && d - low > 0x1p-46 * extent;
            anyUneven |= uneven[f];
            for (int s = begin; s < end; s++) {
                int a = slotVertex[s];
                int b = slotVertex[s + 1 == end ? begin : s + 1];
                side(s, x[a], y[a], z[a], x[b], y[b], z[b], nx, ny, nz);
            }
        }
    }

    /** A component of (a - o) x (b - o), from the two coordinates after it. */
    private static double crossX(double[] y, double[] z, int o, int a, int b) {
        return (y[a] - y[o]) * (z[b] - z[o]) - (z[a] - z[o]) * (y[b] - y[o]);
    }

    private void side(
            int slot,
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            double nx,
            double ny,
            double nz) {
        double ex = bx - ax;
        double ey = by - ay;
        double ez = bz - az;
        double sx = ey * nz - ez * ny;
        double sy = ez * nx - ex * nz;
        double sz = ex * ny - ey * nx;
        double length = Math.sqrt(sx * sx + sy * sy + sz * sz);
        sideX[slot] = sx / length;
        sideY[slot] = sy / length;
        sideZ[slot] = sz / length;
        double begin = sideX[slot] * ax + sideY[slot] * ay + sideZ[slot] * az;
        double end = sideX[slot] * bx + sideY[slot] * by + sideZ[slot] * bz;
        sideOffset[slot] = Math.max(begin, end);
    }
}
