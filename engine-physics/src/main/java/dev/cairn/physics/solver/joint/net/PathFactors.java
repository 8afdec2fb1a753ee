package dev.cairn.physics.solver.joint.net;

/**
 * What the joints of each path of a {@link PointNet} do to each other, inverted: block tridiagonal,
 * so that a solution is a sweep to and fro. With A a joint's own block, and C what the one before
 * does to it,
 *
 * <pre>
 * W = C D^-1,  D' = A - W C^T
 * </pre>
 *
 * <p>Does not allocate but when it is made.
 */
final class PathFactors {
    /** By place: whether a path begins. */
    private final boolean[] begins;

    /** By place: W, row by row, and the inverse of D: xx, yy, zz, xy, xz, yz. */
    private final double[] link;

    private final double[] inverse;

    PathFactors(boolean[] begins) {
        this.begins = begins;
        link = new double[9 * begins.length];
        inverse = new double[6 * begins.length];
    }

    /**
     * Inverts what the joints of each path do to each other, and sweeps what is missing forth.
     */
    void factor(PointNet net, double slack) {
        int[] a = net.a;
        int[] b = net.b;
        double[] inverseMass = net.bodies.inverse;
        double[] arm = net.arm;
        double[] own = net.own;
        double[] near = net.near;
        double[] missing = net.missing;
        for (int p = 0; p < begins.length; p++) {
            int i = a[p];
            int k = b[p];
            int o = 6 * p;
            int q = 3 * p;
            double gx = missing[q];
            double gy = missing[q + 1];
            double gz = missing[q + 2];
            double m = inverseMass[i] + inverseMass[k];
            double u = inverseMass[i + 3];
            double v = inverseMass[k + 3];
            double ax = arm[o];
            double ay = arm[o + 1];
            double az = arm[o + 2];
            double bx = arm[o + 3];
            double by = arm[o + 4];
            double bz = arm[o + 5];
            double xx = m + u * (ay * ay + az * az) + v * (by * by + bz * bz);
            double yy = m + u * (ax * ax + az * az) + v * (bx * bx + bz * bz);
            double zz = m + u * (ax * ax + ay * ay) + v * (bx * bx + by * by);
            double xy = -u * ax * ay - v * bx * by;
            double xz = -u * ax * az - v * bx * bz;
            double yz = -u * ay * az - v * by * bz;
            own[p] = (xx + yy + zz) / 3;
            double e = slack * own[p];
            xx += e;
            yy += e;
            zz += e;
            if (!begins[p]) {
                int at = 9 * p;
                couple(net, p, at);
                // W = C D^-1, and D' = A - W C^T
                int d = 6 * (p - 1);
                for (int r = 0; r < 3; r++) {
                    double x = link[at + 3 * r];
                    double y = link[at + 3 * r + 1];
                    double z = link[at + 3 * r + 2];
                    double wx = x * inverse[d] + y * inverse[d + 3] + z * inverse[d + 4];
                    double wy = x * inverse[d + 3] + y * inverse[d + 1] + z * inverse[d + 5];
                    double wz = x * inverse[d + 4] + y * inverse[d + 5] + z * inverse[d + 2];
                    if (r == 0) {
                        xx -= wx * x + wy * y + wz * z;
                        xy -= wx * link[at + 3] + wy * link[at + 4] + wz * link[at + 5];
                        xz -= wx * link[at + 6] + wy * link[at + 7] + wz * link[at + 8];
                    } else if (r == 1) {
                        yy -= wx * x + wy * y + wz * z;
                        yz -= wx * link[at + 6] + wy * link[at + 7] + wz * link[at + 8];
                    } else {
                        zz -= wx * x + wy * y + wz * z;
                    }
                    link[at + 3 * r] = wx;
                    link[at + 3 * r + 1] = wy;
                    link[at + 3 * r + 2] = wz;
                }
                double fx = near[q - 3];
                double fy = near[q - 2];
                double fz = near[q - 1];
                gx -= link[at] * fx + link[at + 1] * fy + link[at + 2] * fz;
                gy -= link[at + 3] * fx + link[at + 4] * fy + link[at + 5] * fz;
                gz -= link[at + 6] * fx + link[at + 7] * fy + link[at + 8] * fz;
            }
            near[q] = gx;
            near[q + 1] = gy;
            near[q + 2] = gz;
            double cx = yy * zz - yz * yz;
            double cy = xz * yz - xy * zz;
            double cz = xy * yz - xz * yy;
            double f = 1 / (xx * cx + xy * cy + xz * cz);
            inverse[o] = f * cx;
            inverse[o + 1] = f * (xx * zz - xz * xz);
            inverse[o + 2] = f * (xx * yy - xy * xy);
            inverse[o + 3] = f * cy;
            inverse[o + 4] = f * cz;
            inverse[o + 5] = f * (xy * xz - xx * yz);
        }
    }

    /** What the joint before does to one, by the body of both. */
    private void couple(PointNet net, int p, int at) {
        int[] a = net.a;
        int[] b = net.b;
        double[] arm = net.arm;
        boolean mine = a[p] == a[p - 1] || a[p] == b[p - 1];
        int body = mine ? a[p] : b[p];
        boolean its = a[p - 1] == body;
        int k = 6 * p + (mine ? 0 : 3);
        int j = 6 * (p - 1) + (its ? 0 : 3);
        double sign = mine == its ? 1 : -1;
        double i = sign * net.bodies.inverse[body + 3];
        double m =
                sign * net.bodies.inverse[body]
                        + i * (arm[k] * arm[j] + arm[k + 1] * arm[j + 1] + arm[k + 2] * arm[j + 2]);
        for (int r = 0; r < 3; r++) {
            for (int c = 0; c < 3; c++) {
                link[at + 3 * r + c] = (r == c ? m : 0) - i * arm[j + r] * arm[k + c];
            }
        }
    }

    /** Sweeps what is missing forth. */
    void sweep(PointNet net) {
        double[] near = net.near;
        double[] missing = net.missing;
        double x = 0;
        double y = 0;
        double z = 0;
        for (int p = 0; p < begins.length; p++) {
            int o = 3 * p;
            double gx = missing[o];
            double gy = missing[o + 1];
            double gz = missing[o + 2];
            if (!begins[p]) {
                int w = 9 * p;
                gx -= link[w] * x + link[w + 1] * y + link[w + 2] * z;
                gy -= link[w + 3] * x + link[w + 4] * y + link[w + 5] * z;
                gz -= link[w + 6] * x + link[w + 7] * y + link[w + 8] * z;
            }
            x = gx;
            y = gy;
            z = gz;
            near[o] = x;
            near[o + 1] = y;
            near[o + 2] = z;
        }
    }

    /** And back: what each path alone would do about what is missing; its size. */
    double back(PointNet net) {
        double[] near = net.near;
        double[] missing = net.missing;
        double x = 0;
        double y = 0;
        double z = 0;
        double size = 0;
        boolean isEnd = true;
        for (int p = begins.length - 1; p >= 0; p--) {
            int o = 3 * p;
            int d = 6 * p;
            double fx = near[o];
            double fy = near[o + 1];
            double fz = near[o + 2];
            double gx = inverse[d] * fx + inverse[d + 3] * fy + inverse[d + 4] * fz;
            double gy = inverse[d + 3] * fx + inverse[d + 1] * fy + inverse[d + 5] * fz;
            double gz = inverse[d + 4] * fx + inverse[d + 5] * fy + inverse[d + 2] * fz;
            if (!isEnd) {
                int w = 9 * p + 9;
                gx -= link[w] * x + link[w + 3] * y + link[w + 6] * z;
                gy -= link[w + 1] * x + link[w + 4] * y + link[w + 7] * z;
                gz -= link[w + 2] * x + link[w + 5] * y + link[w + 8] * z;
            }
            isEnd = begins[p];
            x = gx;
            y = gy;
            z = gz;
            near[o] = x;
            near[o + 1] = y;
            near[o + 2] = z;
            size += x * missing[o] + y * missing[o + 1] + z * missing[o + 2];
        }
        return size;
    }
}
