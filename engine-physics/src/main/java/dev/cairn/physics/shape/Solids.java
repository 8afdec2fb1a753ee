package dev.cairn.physics.shape;

/**
 * Volume, centre of mass and inertia of a closed polyhedron: the sum of the integrals over the
 * signed tetrahedra from one point to the triangles of the faces (divergence theorem). Exact for
 * polynomials up to the second degree, so only rounding remains. Two passes: the second takes the
 * centre of mass as the point, so that a far-away origin costs no digits.
 *
 * <p>Sources: B. Mirtich, JGT 1 (1996); D. Eberly, "Polyhedral mass properties (revisited)" (2002).
 */
final class Solids {
    private Solids() {}

    /**
     * The box of two discs at right angles to the y axis and all between them: a cylinder, or with
     * an upper radius of 0 a cone. Along world axis i, with a = R y: a disc reaches a_i height +
     * radius sqrt(1 - a_i²).
     */
    static void coneBounds(
            double qx,
            double qy,
            double qz,
            double qw,
            double lowRadius,
            double low,
            double highRadius,
            double high,
            double[] dest,
            int offset) {
        for (int i = 0; i < 3; i++) {
            double a =
                    i == 0
                            ? 2 * (qx * qy - qz * qw)
                            : i == 1 ? 1 - 2 * (qx * qx + qz * qz) : 2 * (qy * qz + qx * qw);
            double u =
                    i == 0
                            ? 1 - 2 * (qy * qy + qz * qz)
                            : i == 1 ? 2 * (qx * qy + qz * qw) : 2 * (qx * qz - qy * qw);
            double v =
                    i == 0
                            ? 2 * (qx * qz + qy * qw)
                            : i == 1 ? 2 * (qy * qz - qx * qw) : 1 - 2 * (qx * qx + qy * qy);
            double across = Math.sqrt(u * u + v * v);
            dest[offset + i] =
                    Math.min(a * low - lowRadius * across, a * high - highRadius * across);
            dest[offset + 3 + i] =
                    Math.max(a * low + lowRadius * across, a * high + highRadius * across);
        }
    }

    /** At density 1. */
    static MassProperties integrate(double[] p, int[][] loops) {
        int origin = 3 * loops[0][0];
        double[] sum = sums(p, loops, p[origin], p[origin + 1], p[origin + 2]);
        double cx = p[origin] + sum[1] / (4 * sum[0]);
        double cy = p[origin + 1] + sum[2] / (4 * sum[0]);
        double cz = p[origin + 2] + sum[3] / (4 * sum[0]);
        sum = sums(p, loops, cx, cy, cz);
        double mass = sum[0] / 6;
        double rx = sum[1] / (4 * sum[0]);
        double ry = sum[2] / (4 * sum[0]);
        double rz = sum[3] / (4 * sum[0]);
        double xx = sum[4] / 60 - mass * (rx * rx);
        double yy = sum[5] / 60 - mass * (ry * ry);
        double zz = sum[6] / 60 - mass * (rz * rz);
        double xy = sum[7] / 120 - mass * (rx * ry);
        double xz = sum[8] / 120 - mass * (rx * rz);
        double yz = sum[9] / 120 - mass * (ry * rz);
        return new MassProperties(
                mass, cx + rx, cy + ry, cz + rz, yy + zz, xx + zz, xx + yy, -xy, -xz, -yz);
    }

    /**
     * Six times the volume, 24 times the first moments, 60 and 120 times the second moments about a
     * point. Each face is added up in both directions, so that a mirror image has the same bits.
     */
    private static double[] sums(double[] p, int[][] loops, double ox, double oy, double oz) {
        double[] sum = new double[10];
        for (int[] loop : loops) {
            double[] there = new double[10];
            double[] back = new double[10];
            for (int i = 1; i + 1 < loop.length; i++) {
                int j = loop.length - 1 - i;
                add(there, p, 3 * loop[0], 3 * loop[i], 3 * loop[i + 1], ox, oy, oz);
                add(back, p, 3 * loop[0], 3 * loop[j], 3 * loop[j + 1], ox, oy, oz);
            }
            for (int k = 0; k < sum.length; k++) {
                sum[k] += 0.5 * (there[k] + back[k]);
            }
        }
        return sum;
    }

    private static void add(
            double[] sum, double[] p, int a, int b, int c, double ox, double oy, double oz) {
        double ax = p[a] - ox;
        double ay = p[a + 1] - oy;
        double az = p[a + 2] - oz;
        double bx = p[b] - ox;
        double by = p[b + 1] - oy;
        double bz = p[b + 2] - oz;
        double cx = p[c] - ox;
        double cy = p[c + 1] - oy;
        double cz = p[c + 2] - oz;
        double det = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
        double sx = ax + (bx + cx);
        double sy = ay + (by + cy);
        double sz = az + (bz + cz);
        sum[0] += det;
        sum[1] += det * sx;
        sum[2] += det * sy;
        sum[3] += det * sz;
        sum[4] += det * (ax * ax + (bx * bx + cx * cx) + sx * sx) / 2;
        sum[5] += det * (ay * ay + (by * by + cy * cy) + sy * sy) / 2;
        sum[6] += det * (az * az + (bz * bz + cz * cz) + sz * sz) / 2;
        sum[7] += det * (ax * ay + (bx * by + cx * cy) + sx * sy);
        sum[8] += det * (ax * az + (bx * bz + cx * cz) + sx * sz);
        sum[9] += det * (ay * az + (by * bz + cy * cz) + sy * sz);
    }
}
