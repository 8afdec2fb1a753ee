package dev.cairn.physics.narrowphase.clip;

import dev.cairn.physics.narrowphase.pair.FeatureIds;

import java.util.Arrays;

/**
 * Chooses four corners of a convex polygon: of all fours that hold a deepest corner, the one that
 * spans most area. The four of the last tick stay while they are still there, hold a corner that is
 * hardly less deep than the deepest, and span nearly as much.
 *
 * <p>The best four with the diagonal from d to k has the corners farthest from that line on either
 * side, and a four that holds d has a diagonal from d. Polygons of more than 16 corners are first
 * thinned to the extremes along 16 directions.
 */
public final class Reduction {
    /** The corners of the last tick stay while their area is at least this part of the best. */
    private static final double NEARLY = 0.97;

    private static final int MANY = 16;

    /** Mean distance of a disc's area from its middle over its radius of gyration. */
    private static final double GYRATION = 2 * Math.sqrt(2) / 3;

    /** Half of the 16 directions in which the corners of a large polygon are sought. */
    private static final double[] COS = new double[MANY / 2], SIN = new double[MANY / 2];

    static {
        for (int i = 0; i < COS.length; i++) {
            COS[i] = StrictMath.cos(2 * StrictMath.PI * i / MANY);
            SIN[i] = StrictMath.sin(2 * StrictMath.PI * i / MANY);
        }
    }

    private int[] index = new int[32];
    private boolean[] chosen = new boolean[32];
    private double[] u = new double[32], v = new double[32];
    private final int[] four = new int[4], old = new int[4];
    private double best;
    private int count;

    /**
     * Leaves at most four corners in the clipper, in their order.
     *
     * @param nx a vector that is not in the plane of the polygon
     * @param tie corners this much above the deepest count as deepest
     * @param hysteresis corners of the last tick may be this much above
     */
    public void reduce(
            Clipper c, double nx, double ny, double nz, double tie, double hysteresis, int last) {
        if (c.count <= 4) {
            return;
        }
        project(c, nx, ny, nz);
        double least = Double.MAX_VALUE;
        for (int i = 0; i < c.count; i++) {
            least = Math.min(least, c.separation[i]);
        }
        thin(c, least + tie, last);
        best = -1;
        for (int i = 0; i < count; i++) {
            if (c.separation[index[i]] <= least + tie) {
                around(i, c, least + tie);
            }
        }
        keep(c, least + hysteresis, last);
        Arrays.fill(chosen, 0, c.count, false);
        for (int i = 0; i < 4; i++) {
            chosen[index[four[i]]] = true;
        }
        compact(c);
    }

    /**
     * Mean distance of the area of a convex polygon from its middle, m: {@code 2 sqrt(2)/3} of the
     * radius of gyration, which is exact for a disc, 0.6 % too much for a square and 2 % too much
     * for an equilateral triangle.
     */
    static double meanDistance(Clipper c) {
        double x0 = c.x[0];
        double y0 = c.y[0];
        double z0 = c.z[0];
        double area = 0;
        double mx = 0;
        double my = 0;
        double mz = 0;
        double square = 0;
        for (int i = 1; i + 1 < c.count; i++) {
            double ax = c.x[i] - x0;
            double ay = c.y[i] - y0;
            double az = c.z[i] - z0;
            double bx = c.x[i + 1] - x0;
            double by = c.y[i + 1] - y0;
            double bz = c.z[i + 1] - z0;
            double nx = ay * bz - az * by;
            double ny = az * bx - ax * bz;
            double nz = ax * by - ay * bx;
            double w = Math.sqrt(nx * nx + ny * ny + nz * nz);
            double aa = ax * ax + ay * ay + az * az;
            double bb = bx * bx + by * by + bz * bz;
            double ab = ax * bx + ay * by + az * bz;
            area += w;
            mx += w * (ax + bx);
            my += w * (ay + by);
            mz += w * (az + bz);
            square += w * (aa + bb + ab);
        }
        if (!(area > 0)) {
            return 0;
        }
        // mean of r² over a triangle (0, a, b) is (a² + b² + a.b)/6, its middle (a + b)/3
        double k = 1 / (3 * area);
        double gyration = square / (6 * area) - k * k * (mx * mx + my * my + mz * mz);
        return GYRATION * Math.sqrt(Math.max(0, gyration));
    }

    /** Mean distance of the corners from their mean, m. */
    static double meanOfCorners(Clipper c) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = 0; i < c.count; i++) {
            x += c.x[i] / c.count;
            y += c.y[i] / c.count;
            z += c.z[i] / c.count;
        }
        double sum = 0;
        for (int i = 0; i < c.count; i++) {
            double dx = c.x[i] - x;
            double dy = c.y[i] - y;
            double dz = c.z[i] - z;
            sum += Math.sqrt(dx * dx + dy * dy + dz * dz);
        }
        return sum / c.count;
    }

    /** Drops the coordinate along which the plane is steepest; ratios of areas stay. */
    private void project(Clipper c, double nx, double ny, double nz) {
        if (c.count > u.length) {
            u = new double[c.x.length];
            v = new double[c.x.length];
            index = new int[c.x.length];
            chosen = new boolean[c.x.length];
        }
        double ax = Math.abs(nx);
        double ay = Math.abs(ny);
        double az = Math.abs(nz);
        boolean dropX = ax >= ay && ax >= az;
        boolean dropZ = !dropX && az > ay;
        for (int i = 0; i < c.count; i++) {
            u[i] = dropX ? c.y[i] : c.x[i];
            v[i] = dropZ ? c.y[i] : c.z[i];
        }
    }

    /** Lists the corners that compete. */
    private void thin(Clipper c, double deep, int last) {
        count = 0;
        if (c.count <= MANY) {
            for (int i = 0; i < c.count; i++) {
                index[count++] = i;
            }
            return;
        }
        int deepest = 0;
        for (int i = 0; i < c.count; i++) {
            chosen[i] = last != 0 && FeatureIds.contains(last, c.feature[i]);
            deepest = c.separation[i] < c.separation[deepest] ? i : deepest;
        }
        chosen[deepest] = true;
        for (int k = 0; k < COS.length; k++) {
            extremes(c, COS[k], SIN[k], Double.MAX_VALUE);
            extremes(c, COS[k], SIN[k], deep);
        }
        for (int i = 0; i < c.count; i++) {
            if (chosen[i]) {
                index[count++] = i;
            }
        }
    }

    private void extremes(Clipper c, double cos, double sin, double deep) {
        int low = -1;
        int high = -1;
        for (int i = 0; i < c.count; i++) {
            if (c.separation[i] > deep) {
                continue;
            }
            double d = cos * u[i] + sin * v[i];
            low = low < 0 || d < cos * u[low] + sin * v[low] ? i : low;
            high = high < 0 || d > cos * u[high] + sin * v[high] ? i : high;
        }
        chosen[low] = true;
        chosen[high] = true;
    }

    /** Tries the fours that have a diagonal from corner d. */
    private void around(int d, Clipper c, double deep) {
        for (int k = 0; k < count; k++) {
            boolean met = k < d && c.separation[index[k]] <= deep;
            if (k == d || next(k) == d || next(d) == k || met) {
                continue;
            }
            int j = farthest(d, k);
            int l = farthest(k, d);
            double area = wide(d, k, j) + wide(d, k, l) + 0x1p-30 * square(d, k);
            if (area > best) {
                best = area;
                four[0] = d;
                four[1] = j;
                four[2] = k;
                four[3] = l;
            }
        }
    }

    /** The corner strictly between two that is farthest from their line. */
    private int farthest(int from, int to) {
        int far = next(from);
        double most = wide(from, to, far);
        for (int i = next(far); i != to; i = next(i)) {
            double w = wide(from, to, i);
            if (w > most) {
                most = w;
                far = i;
            }
        }
        return far;
    }

    private int next(int i) {
        return i + 1 == count ? 0 : i + 1;
    }

    /** Twice the area of a triangle. */
    private double wide(int d, int k, int at) {
        int a = index[d];
        int b = index[k];
        int c = index[at];
        return Math.abs((u[b] - u[a]) * (v[c] - v[a]) - (v[b] - v[a]) * (u[c] - u[a]));
    }

    private double square(int d, int k) {
        double x = u[index[k]] - u[index[d]];
        double y = v[index[k]] - v[index[d]];
        return x * x + y * y;
    }

    /** Chooses the four of the last tick if they will do. */
    private void keep(Clipper c, double deep, int last) {
        int found = 0;
        boolean touches = false;
        for (int i = 0; i < count && found <= 4; i++) {
            if (FeatureIds.contains(last, c.feature[index[i]])) {
                if (found < 4) {
                    old[found] = i;
                }
                found++;
                touches |= c.separation[index[i]] <= deep;
            }
        }
        if (found != 4 || !touches) {
            return;
        }
        double area = wide(old[0], old[2], old[1]) + wide(old[0], old[2], old[3]);
        if (area >= NEARLY * best) {
            System.arraycopy(old, 0, four, 0, 4);
        }
    }

    private void compact(Clipper c) {
        int at = 0;
        for (int i = 0; i < c.count; i++) {
            if (chosen[i]) {
                c.x[at] = c.x[i];
                c.y[at] = c.y[i];
                c.z[at] = c.z[i];
                c.separation[at] = c.separation[i];
                c.feature[at++] = c.feature[i];
            }
        }
        c.count = at;
    }
}
