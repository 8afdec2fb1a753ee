package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.narrowphase.pair.Pair;

/**
 * Whether a convex shape is plainly apart from a triangle: a few supports in place of a whole
 * narrow phase, for the triangles whose boxes meet the shape's box and that are still out of its
 * reach.
 *
 * <p>Tried are the directions in the triangle's plane away from its edges, and the one from the
 * shape's centre to the nearest point of the triangle; its normal has been tried before. An axis
 * {@code u} along which the shape ends before the triangle begins is a proof:
 *
 * <pre>
 * min over the triangle of u.x - max over the shape of u.x &gt; margin  =&gt;  distance &gt; margin
 * </pre>
 *
 * <p>Source: the separating-axis theorem (C. Ericson, "Real-Time Collision Detection", 2005,
 * section 5.2.1). Stateless but for scratch; one worker.
 */
final class TriangleGap {
    private double qx, qy, qz;

    /**
     * Whether one of these axes parts them by more than the margin.
     *
     * @param corner of the triangle, from the shape's centre, mesh axes, m
     * @param nx unit normal of the triangle, on whichever side
     * @param pair whose A is the shape, with its orientation in the mesh's axes
     * @return false says nothing
     */
    boolean isApart(double[] corner, double nx, double ny, double nz, Pair pair, Margin margin) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 9; i += 3) {
            int j = i == 6 ? 0 : i + 3;
            int k = 6 - i - j + 3;
            double ex = corner[j] - corner[i];
            double ey = corner[j + 1] - corner[i + 1];
            double ez = corner[j + 2] - corner[i + 2];
            double ox = ey * nz - ez * ny;
            double oy = ez * nx - ex * nz;
            double oz = ex * ny - ey * nx;
            // the third corner is on the inner side
            double side =
                    ox * (corner[k] - corner[i])
                            + oy * (corner[k + 1] - corner[i + 1])
                            + oz * (corner[k + 2] - corner[i + 2]);
            double s = side > 0 ? 1 : -1;
            double out = s * (ox * corner[i] + oy * corner[i + 1] + oz * corner[i + 2]);
            if (!(out > 0)) {
                continue; // the centre is on the inner side
            }
            double length = Math.sqrt(ox * ox + oy * oy + oz * oz);
            s /= length;
            out /= length;
            double most = margin.along(-s * ox, -s * oy, -s * oz);
            if (out > most && out - reach(pair, s * ox, s * oy, s * oz) > most) {
                return true;
            }
            nearest = Math.min(nearest, toEdge(corner, i, ex, ey, ez, nearest));
        }
        if (nearest == Double.POSITIVE_INFINITY) {
            return false; // the centre is over the triangle: its normal is the axis
        }
        double distance = Math.sqrt(nearest);
        double u = 1 / distance;
        double most = margin.along(-u * qx, -u * qy, -u * qz);
        return distance > most && distance - reach(pair, u * qx, u * qy, u * qz) > most;
    }

    /** Square of the distance to an edge; keeps its nearest point if that is nearer. */
    private double toEdge(double[] c, int i, double ex, double ey, double ez, double nearest) {
        double way = -(c[i] * ex + c[i + 1] * ey + c[i + 2] * ez);
        double t = Math.max(0, Math.min(1, way / (ex * ex + ey * ey + ez * ez)));
        double x = c[i] + t * ex;
        double y = c[i + 1] + t * ey;
        double z = c[i + 2] + t * ez;
        double square = x * x + y * y + z * z;
        if (square < nearest) {
            qx = x;
            qy = y;
            qz = z;
        }
        return square;
    }

    /** How far the shape goes from its centre along a direction of the mesh's axes. */
    private static double reach(Pair p, double x, double y, double z) {
        double tx = p.w00 * x + p.w10 * y + p.w20 * z;
        double ty = p.w01 * x + p.w11 * y + p.w21 * z;
        double tz = p.w02 * x + p.w12 * y + p.w22 * z;
        return p.reachA(tx, ty, tz) + p.radiusA;
    }
}
