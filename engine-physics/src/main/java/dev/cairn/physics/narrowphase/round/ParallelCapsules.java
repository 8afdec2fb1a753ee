package dev.cairn.physics.narrowphase.round;

import dev.cairn.physics.narrowphase.clip.Patch;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;

/**
 * Two capsules side by side: both ends of the part that their lines share, by the rules of {@link
 * CurvedContact}, in world axes.
 */
final class ParallelCapsules {
    /** Of a line: what two of them must share. */
    private static final double SHARED = 0x1p-10;

    /** The least separation of the points of the last pair. */
    double deepest;

    /**
     * Writes up to two points; none when the lines, which are level, do not share anything, or
     * cross so far that round sides would lose more than is calm.
     */
    void run(
            RoundContacts r,
            double radiusA,
            double halfA,
            double radiusB,
            double halfB,
            double dx,
            double dy,
            double dz,
            double length,
            double margin,
            double hysteresis,
            Manifold out) {
        out.pointCount = 0;
        deepest = Double.MAX_VALUE;
        double nx = r.x / length;
        double ny = r.y / length;
        double nz = r.z / length;
        // A's line is a + s u, B's is b + t v, s and t from 0 to 1, each on its surface.
        double h = 2 * halfA;
        double k = 2 * halfB;
        double ux = h * r.axisX;
        double uy = h * r.axisY;
        double uz = h * r.axisZ;
        double vx = k * r.otherX;
        double vy = k * r.otherY;
        double vz = k * r.otherZ;
        double ax = radiusA * nx - 0.5 * ux;
        double ay = radiusA * ny - 0.5 * uy;
        double az = radiusA * nz - 0.5 * uz;
        double bx = dx - radiusB * nx - 0.5 * vx;
        double by = dy - radiusB * ny - 0.5 * vy;
        double bz = dz - radiusB * nz - 0.5 * vz;
        double square = h * h;
        double begin = ((bx - ax) * ux + (by - ay) * uy + (bz - az) * uz) / square;
        double slope = (vx * ux + vy * uy + vz * uz) / square;
        double from = Math.max(0, Math.min(begin, begin + slope));
        double to = Math.min(1, Math.max(begin, begin + slope));
        if (!(to - from > SHARED)) {
            return;
        }
        out.normalX = nx;
        out.normalY = ny;
        out.normalZ = nz;
        for (int end = 0; end < 2; end++) {
            double s = end == 0 ? from : to;
            double t = (s - begin) / slope;
            double px = ax + s * ux;
            double py = ay + s * uy;
            double pz = az + s * uz;
            double gx = bx + t * vx - px;
            double gy = by + t * vy - py;
            double gz = bz + t * vz - pz;
            double gap = gx * nx + gy * ny + gz * nz;
            double side = Math.max(0, gx * gx + gy * gy + gz * gz - gap * gap);
            // What round sides lose where they pass each other: side^2 / (2 (R + r)).
            if (side > 2 * hysteresis * (radiusA + radiusB)) {
                out.pointCount = 0;
                return;
            }
            if (gap <= margin) {
                put(px + gx / 2, py + gy / 2, pz + gz / 2, gap, name(s, t), out);
            }
        }
    }

    /** The end of A, or of B, that a point is at. */
    private static int name(double s, double t) {
        if (s == 0 || s == 1) {
            return FeatureIds.VERTEX_A | (s == 0 ? Patch.END : Patch.END + 1);
        }
        return FeatureIds.VERTEX_B | (t <= 0.5 ? Patch.END : Patch.END + 1);
    }

    /** Inserts a point in order of its name. */
    private void put(double x, double y, double z, double gap, int name, Manifold out) {
        deepest = Math.min(deepest, gap);
        int at = out.pointCount++;
        if (at > 0 && Integer.compareUnsigned(out.feature[0], name) > 0) {
            out.pointX[1] = out.pointX[0];
            out.pointY[1] = out.pointY[0];
            out.pointZ[1] = out.pointZ[0];
            out.separation[1] = out.separation[0];
            out.feature[1] = out.feature[0];
            at = 0;
        }
        out.pointX[at] = x;
        out.pointY[at] = y;
        out.pointZ[at] = z;
        out.separation[at] = gap;
        out.feature[at] = name;
    }
}
