package dev.cairn.physics.shape;

/** The planes of a {@link Polyhedron}'s faces and of their sides. Set-up only. */
final class FacePlanes {
    final double[] normalX, normalY, normalZ, offset;
    final double[] sideX, sideY, sideZ, sideOffset;

    /** The corners of a face are not in one plane up to rounding; and whether any face is so. */
    final boolean[] rough;

    boolean anyRough;

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
        rough = new boolean[faces];
        planes(x, y, z, topology);
    }

    /**
     * Planes by Newell's sums, which are exact for blocks; offsets touch the outermost corner of
     * the face.
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
            for (int s = begin + 1; s + 1 < end; s++) {
                int a = slotVertex[s];
                int b = slotVertex[s + 1];
                double ax = x[a] - x[origin];
                double ay = y[a] - y[origin];
                double az = z[a] - z[origin];
                double bx = x[b] - x[origin];
                double by = y[b] - y[origin];
                double bz = z[b] - z[origin];
                nx += ay * bz - az * by;
                ny += az * bx - ax * bz;
                nz += ax * by - ay * bx;
            }
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
            rough[f] = end - begin > 3 && d - low > 0x1p-46 * extent;
            anyRough |= rough[f];
            for (int s = begin; s < end; s++) {
                int a = slotVertex[s];
                int b = slotVertex[s + 1 == end ? begin : s + 1];
                side(s, x[a], y[a], z[a], x[b] - x[a], y[b] - y[a], z[b] - z[a], nx, ny, nz);
            }
        }
    }

    private void side(
            int slot,
            double ax,
            double ay,
            double az,
            double ex,
            double ey,
            double ez,
            double nx,
            double ny,
            double nz) {
        double sx = ey * nz - ez * ny;
        double sy = ez * nx - ex * nz;
        double sz = ex * ny - ey * nx;
        double length = Math.sqrt(sx * sx + sy * sy + sz * sz);
        sideX[slot] = sx / length;
        sideY[slot] = sy / length;
        sideZ[slot] = sz / length;
        sideOffset[slot] = sideX[slot] * ax + sideY[slot] * ay + sideZ[slot] * az;
    }
}
