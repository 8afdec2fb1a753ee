package dev.cairn.physics.narrowphase.box;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

import dev.cairn.physics.narrowphase.pair.BoxTopology;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;

/**
 * Two edges of a pair in a batch that cross: the axis from the columns of the fifteen axes, and the
 * point midway between the edges, with the operations of {@code Axes} and {@code ContactPoints},
 * hence their bits.
 */
final class BoxEdgeContact {
    /** Columns of the batch. */
    private final double[] t;

    /** The unit axis from A to B, in A's frame, of the pair at hand. */
    private double axisX, axisY, axisZ;

    BoxEdgeContact(double[] columns) {
        t = columns;
    }

    /** Finds the axis of the two edges that separate best; false when all are parallel. */
    boolean place(int i) {
        int pair = (int) t[EDGE + i];
        if (pair < 0) {
            return false;
        }
        int at = RELATIVE + pair % 3 * CAPACITY + i;
        double x = t[at];
        double y = t[at + 3 * CAPACITY];
        double z = t[at + 6 * CAPACITY];
        // The cross product of A's axis and B's.
        if (pair < 3) {
            double length = Math.sqrt(y * y + z * z);
            axisX = 0;
            axisY = -z / length;
            axisZ = y / length;
        } else if (pair < 6) {
            double length = Math.sqrt(x * x + z * z);
            axisX = z / length;
            axisY = 0;
            axisZ = -x / length;
        } else {
            double length = Math.sqrt(x * x + y * y);
            axisX = -y / length;
            axisY = x / length;
            axisZ = 0;
        }
        double along =
                axisX * t[CENTRE + i]
                        + axisY * t[CENTRE + CAPACITY + i]
                        + axisZ * t[CENTRE + 2 * CAPACITY + i];
        if (along < 0) {
            axisX = -axisX;
            axisY = -axisY;
            axisZ = -axisZ;
        }
        return true;
    }

    /**
     * The cosine of the axis and the normal of a face of A, or of B reversed; after {@link #place}.
     */
    double cosine(int i, boolean flip, int face) {
        int k = face >> 1;
        double sign = (face & 1) != 0 == flip ? -1 : 1;
        if (flip) {
            int at = RELATIVE + k * CAPACITY + i;
            return sign * t[at] * axisX
                    + sign * t[at + 3 * CAPACITY] * axisY
                    + sign * t[at + 6 * CAPACITY] * axisZ;
        }
        return sign * (k == 0 ? axisX : k == 1 ? axisY : axisZ);
    }

    /**
     * Writes the point midway between the two edges and the normal; after {@link #place}. Returns
     * false when their lines pass beyond an end, or are farther apart than the margin.
     */
    boolean point(int i, Manifold out) {
        double[] t = this.t;
        double r00 = t[RELATIVE + i];
        double r01 = t[RELATIVE + CAPACITY + i];
        double r02 = t[RELATIVE + 2 * CAPACITY + i];
        double r10 = t[RELATIVE + 3 * CAPACITY + i];
        double r11 = t[RELATIVE + 4 * CAPACITY + i];
        double r12 = t[RELATIVE + 5 * CAPACITY + i];
        double r20 = t[RELATIVE + 6 * CAPACITY + i];
        double r21 = t[RELATIVE + 7 * CAPACITY + i];
        double r22 = t[RELATIVE + 8 * CAPACITY + i];
        double nx = axisX;
        double ny = axisY;
        double nz = axisZ;
        int pair = (int) t[EDGE + i];
        int va = (nx >= 0 ? 1 : 0) | (ny >= 0 ? 2 : 0) | (nz >= 0 ? 4 : 0);
        double mx = r00 * nx + r10 * ny + r20 * nz;
        double my = r01 * nx + r11 * ny + r21 * nz;
        double mz = r02 * nx + r12 * ny + r22 * nz;
        int vb = (mx <= 0 ? 1 : 0) | (my <= 0 ? 2 : 0) | (mz <= 0 ? 4 : 0);
        int k = pair / 3;
        int l = pair % 3;
        double hx = t[HALF_A + i];
        double hy = t[HALF_A + CAPACITY + i];
        double hz = t[HALF_A + 2 * CAPACITY + i];
        double ax = k == 0 ? 0 : nx >= 0 ? hx : -hx;
        double ay = k == 1 ? 0 : ny >= 0 ? hy : -hy;
        double az = k == 2 ? 0 : nz >= 0 ? hz : -hz;
        double u = k == 0 ? hx : k == 1 ? hy : hz;
        hx = t[HALF_B + i];
        hy = t[HALF_B + CAPACITY + i];
        hz = t[HALF_B + 2 * CAPACITY + i];
        double bx = l == 0 ? 0 : mx <= 0 ? hx : -hx;
        double by = l == 1 ? 0 : my <= 0 ? hy : -hy;
        double bz = l == 2 ? 0 : mz <= 0 ? hz : -hz;
        double h = l == 0 ? hx : l == 1 ? hy : hz;
        double px = r00 * bx + r01 * by + r02 * bz + t[CENTRE + i];
        double py = r10 * bx + r11 * by + r12 * bz + t[CENTRE + CAPACITY + i];
        double pz = r20 * bx + r21 * by + r22 * bz + t[CENTRE + 2 * CAPACITY + i];
        double vx = (l == 0 ? r00 : l == 1 ? r01 : r02) * h;
        double vy = (l == 0 ? r10 : l == 1 ? r11 : r12) * h;
        double vz = (l == 0 ? r20 : l == 1 ? r21 : r22) * h;
        double rx = px - ax;
        double ry = py - ay;
        double rz = pz - az;
        double uu = u * u;
        double vv = vx * vx + vy * vy + vz * vz;
        double uv = u * (k == 0 ? vx : k == 1 ? vy : vz);
        double ur = u * (k == 0 ? rx : k == 1 ? ry : rz);
        double vr = vx * rx + vy * ry + vz * rz;
        double det = uu * vv - uv * uv;
        double f = (ur * vv - vr * uv) / det;
        double g = (ur * uv - vr * uu) / det;
        double end = ContactTolerances.CROSSING_END;
        boolean beside = !(Math.abs(f) <= end && Math.abs(g) <= end);
        double separation = t[SEPARATION_EDGE + i];
        if (beside || separation > t[MARGIN + i]) {
            return false;
        }
        out.pointCount = 1;
        out.feature[0] = name(va, vb, k, l);
        out.separation[0] = separation;
        double x = (ax + (k == 0 ? f * u : 0) + (px + g * vx)) / 2;
        double y = (ay + (k == 1 ? f * u : 0) + (py + g * vy)) / 2;
        double z = (az + (k == 2 ? f * u : 0) + (pz + g * vz)) / 2;
        double[] w = t;
        double w00 = w[WORLD + i];
        double w01 = w[WORLD + CAPACITY + i];
        double w02 = w[WORLD + 2 * CAPACITY + i];
        double w10 = w[WORLD + 3 * CAPACITY + i];
        double w11 = w[WORLD + 4 * CAPACITY + i];
        double w12 = w[WORLD + 5 * CAPACITY + i];
        double w20 = w[WORLD + 6 * CAPACITY + i];
        double w21 = w[WORLD + 7 * CAPACITY + i];
        double w22 = w[WORLD + 8 * CAPACITY + i];
        out.pointX[0] = w00 * x + w01 * y + w02 * z;
        out.pointY[0] = w10 * x + w11 * y + w12 * z;
        out.pointZ[0] = w20 * x + w21 * y + w22 * z;
        out.normalX = w00 * nx + w01 * ny + w02 * nz;
        out.normalY = w10 * nx + w11 * ny + w12 * nz;
        out.normalZ = w20 * nx + w21 * ny + w22 * nz;
        return true;
    }

    /** Writes the point that lanes found; false when they found none. */
    boolean copy(int i, Manifold out) {
        int ends = (int) t[CROSSING_ENDS + i];
        if (ends < 0) {
            return false;
        }
        int pair = (int) t[EDGE + i];
        out.pointCount = 1;
        out.feature[0] = name(ends >> 3, ends & 7, pair / 3, pair % 3);
        out.separation[0] = t[SEPARATION_EDGE + i];
        out.pointX[0] = t[CROSSING_POINT + i];
        out.pointY[0] = t[CROSSING_POINT + CAPACITY + i];
        out.pointZ[0] = t[CROSSING_POINT + 2 * CAPACITY + i];
        out.normalX = t[CROSSING_NORMAL + i];
        out.normalY = t[CROSSING_NORMAL + CAPACITY + i];
        out.normalZ = t[CROSSING_NORMAL + 2 * CAPACITY + i];
        return true;
    }

    private static int name(int va, int vb, int k, int l) {
        return FeatureIds.CROSSING
                | BoxTopology.edge(3 * va + k) << 15
                | BoxTopology.edge(3 * vb + l);
    }
}
