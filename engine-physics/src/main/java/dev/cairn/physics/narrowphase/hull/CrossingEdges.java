package dev.cairn.physics.narrowphase.hull;

import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.Containment;
import dev.cairn.physics.narrowphase.pair.Pair;

/**
 * Two edges of a pair that may cross: their axis, the separation along it, and the bounds of the
 * signed distance that {@link WarmContact} explains.
 */
final class CrossingEdges {
    /** The unit axis from A to B in A's frame, and the separation of the edges along it, m. */
    double axisX, axisY, axisZ, along;

    private final Pair pair;
    private final Axes axes;
    private final Containment inside;
    private int edgeA, edgeB;

    /** In A's frame: where they begin, and where they lead. */
    private double ax, ay, az, bx, by, bz, ux, uy, uz, vx, vy, vz;

    CrossingEdges(Pair pair, Axes axes, Containment inside) {
        this.pair = pair;
        this.axes = axes;
        this.inside = inside;
    }

    /** Finds two edges, and their axis and separation; false when they are parallel. */
    boolean place(int ea, int eb) {
        Pair p = pair;
        edgeA = ea;
        edgeB = eb;
        axes.rawX = p.dx;
        axes.rawY = p.dy;
        axes.rawZ = p.dz;
        if (axes.cross(p, ea, eb) == 0) {
            return false;
        }
        axisX = axes.cx;
        axisY = axes.cy;
        axisZ = axes.cz;
        int from = p.a.edgeFrom(ea);
        int to = p.a.edgeTo(ea);
        ax = p.a.vertexX(from);
        ay = p.a.vertexY(from);
        az = p.a.vertexZ(from);
        ux = p.a.vertexX(to) - ax;
        uy = p.a.vertexY(to) - ay;
        uz = p.a.vertexZ(to) - az;
        p.vertexB(p.b.edgeTo(eb));
        vx = p.px;
        vy = p.py;
        vz = p.pz;
        p.vertexB(p.b.edgeFrom(eb));
        bx = p.px;
        by = p.py;
        bz = p.pz;
        vx -= bx;
        vy -= by;
        vz -= bz;
        along = (bx - ax) * axisX + (by - ay) * axisY + (bz - az) * axisZ;
        return true;
    }

    /**
     * An upper bound of the signed distance, from edges u from a and v from b; tries until it is
     * near enough to the separation.
     */
    double upper(double enough) {
        Pair p = pair;
        double s = along;
        double rx = bx - ax;
        double ry = by - ay;
        double rz = bz - az;
        double uu = ux * ux + uy * uy + uz * uz;
        double vv = vx * vx + vy * vy + vz * vz;
        double uv = ux * vx + uy * vy + uz * vz;
        double ur = ux * rx + uy * ry + uz * rz;
        double vr = vx * rx + vy * ry + vz * rz;
        double det = uu * vv - uv * uv;
        double f = (ur * vv - vr * uv) / det;
        double g = (ur * uv - vr * uu) / det;
        double alongU = Math.min(f, 1 - f);
        double alongV = Math.min(g, 1 - g);
        if (!(alongU >= 0 && alongV >= 0)) {
            return Double.POSITIVE_INFINITY;
        }
        if (s >= 0) {
            return s;
        }
        double high = axisX * p.dx + axisY * p.dy + axisZ * p.dz;
        double square = p.dx * p.dx + p.dy * p.dy + p.dz * p.dz;
        double beside = Math.sqrt(Math.max(0, square - high * high));
        // Distances from the sides of the parallelogram: |u x v| / |v| and / |u|.
        double r = Math.sqrt(det) * Math.min(alongU / Math.sqrt(vv), alongV / Math.sqrt(uu));
        double upper = -Math.max(0, Containment.depth(p, -s, r, high, beside));
        if (upper - s > enough) {
            double inA = inside.within(p.a, bx + g * vx, by + g * vy, bz + g * vz);
            upper = Math.min(upper, -inA);
        }
        if (upper - s > enough) {
            // The point of A, in B's frame.
            double x = ax + f * ux - p.dx;
            double y = ay + f * uy - p.dy;
            double z = az + f * uz - p.dz;
            double inB =
                    inside.within(
                            p.b,
                            p.r00 * x + p.r10 * y + p.r20 * z,
                            p.r01 * x + p.r11 * y + p.r21 * z,
                            p.r02 * x + p.r12 * y + p.r22 * z);
            upper = Math.min(upper, -inB);
        }
        return upper;
    }

    /** Whether no vertex reaches farther along the axis than the edges do. */
    boolean support() {
        Pair p = pair;
        double nx = axisX;
        double ny = axisY;
        double nz = axisZ;
        int a = p.a.climb(nx, ny, nz, p.a.edgeFrom(edgeA));
        int b =
                p.b.climb(
                        -(p.r00 * nx + p.r10 * ny + p.r20 * nz),
                        -(p.r01 * nx + p.r11 * ny + p.r21 * nz),
                        -(p.r02 * nx + p.r12 * ny + p.r22 * nz),
                        p.b.edgeFrom(edgeB));
        p.vertexB(b);
        double t =
                (p.px - p.a.vertexX(a)) * nx
                        + (p.py - p.a.vertexY(a)) * ny
                        + (p.pz - p.a.vertexZ(a)) * nz;
        return t >= along - 0x1p-46 * p.scale;
    }
}
