package dev.cairn.physics.solver.joint.net;

/**
 * What the joints of each path of a {@link PointNet} do to each other, inverted: block tridiagonal,
 * so that a solution is a sweep to and fro. With A a joint's own block, and {@code C = c 1 - i j
 * k^T} what the one before, of the arm j, does to it, of the arm k,
 *
 * <pre>
 * W = C D^-1 = c D^-1 - i j u^T,  u = D^-1 k
 * D' = A - W C^T = A - c W + i W k j^T
 * </pre>
 *
 * <p>Does not allocate but when it is made.
 */
final class PathFactors {
    /** By place: the one before on its path, or -1; and the one after. */
    private final int[] prior;

    private final int[] next;

    /** By place: weights of the body that it shares with the one before; its arm, and that's. */
    private final int[] shared;

    private final int[] mine;
    private final int[] its;

    /** By place: W, row by row, and the inverse of D: xx, yy, zz, xy, xz, yz. */
    private final double[] link;

    private final double[] inverse;

    /**
     * Room for them.
     *
     * @param prior by place: the one before on its path, or -1
     * @param a by place: body A
     * @param b by place: body B
     */
    PathFactors(int[] prior, int[] a, int[] b) {
        this.prior = prior;
        int n = prior.length;
        next = new int[n];
        shared = new int[n];
        mine = new int[n];
        its = new int[n];
        for (int p = 0; p < n; p++) {
            next[p] = -1;
            int o = prior[p];
            if (o >= 0) {
                next[o] = p;
                boolean isA = a[p] == a[o] || a[p] == b[o];
                int body = isA ? a[p] : b[p];
                shared[p] = NetBodies.WEIGHTS * (body / NetBodies.STRIDE);
                mine[p] = 6 * p + (isA ? 0 : 3);
                its[p] = 6 * o + (a[o] == body ? 0 : 3);
            }
        }
        link = new double[9 * n];
        inverse = new double[6 * n];
    }

    /**
     * Inverts what the joints of each path do to each other, and sweeps what is missing forth.
     *
     * @param from place where a group of paths begins
     * @return the square of what is missing
     */
    double factor(PointNet net, double slack, int from, int to) {
        int[] a = net.a;
        int[] b = net.b;
        double[] weights = net.bodies.inverse;
        double[] arm = net.arm;
        double[] own = net.own;
        double[] near = net.near;
        double[] missing = net.missing;
        double left = 0;
        for (int p = from; p < to; p++) {
            int o = 6 * p;
            int q = 3 * p;
            double gx = missing[q];
            double gy = missing[q + 1];
            double gz = missing[q + 2];
            left += gx * gx + gy * gy + gz * gz;
            int wa = NetBodies.WEIGHTS * (a[p] / NetBodies.STRIDE);
            int wb = NetBodies.WEIGHTS * (b[p] / NetBodies.STRIDE);
            double m = weights[wa] + weights[wb];
            double u = weights[wa + 1];
            double v = weights[wb + 1];
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
            own[p] = (xx + yy + zz) * (1 / 3.0);
            double e = slack * own[p];
            xx += e;
            yy += e;
            zz += e;
            int before = prior[p];
            if (before >= 0) {
                int k = mine[p];
                int j = its[p];
                double sign = (k - o == 0) == (j - 6 * before == 0) ? 1 : -1;
                double i = sign * weights[shared[p] + 1];
                double kx = arm[k];
                double ky = arm[k + 1];
                double kz = arm[k + 2];
                double jx = arm[j];
                double jy = arm[j + 1];
                double jz = arm[j + 2];
                double c = sign * weights[shared[p]] + i * (kx * jx + ky * jy + kz * jz);
                int d = 6 * before;
                double dxx = inverse[d];
                double dyy = inverse[d + 1];
                double dzz = inverse[d + 2];
                double dxy = inverse[d + 3];
                double dxz = inverse[d + 4];
                double dyz = inverse[d + 5];
                double ux = dxx * kx + dxy * ky + dxz * kz;
                double uy = dxy * kx + dyy * ky + dyz * kz;
                double uz = dxz * kx + dyz * ky + dzz * kz;
                jx *= i;
                jy *= i;
                jz *= i;
                double wxx = c * dxx - jx * ux;
                double wxy = c * dxy - jx * uy;
                double wxz = c * dxz - jx * uz;
                double wyx = c * dxy - jy * ux;
                double wyy = c * dyy - jy * uy;
                double wyz = c * dyz - jy * uz;
                double wzx = c * dxz - jz * ux;
                double wzy = c * dyz - jz * uy;
                double wzz = c * dzz - jz * uz;
                // W k
                double square = kx * ux + ky * uy + kz * uz;
                double rx = c * ux - jx * square;
                double ry = c * uy - jy * square;
                double rz = c * uz - jz * square;
                xx -= c * wxx - rx * jx;
                yy -= c * wyy - ry * jy;
                zz -= c * wzz - rz * jz;
                xy -= c * wxy - rx * jy;
                xz -= c * wxz - rx * jz;
                yz -= c * wyz - ry * jz;
                int w = 9 * p;
                link[w] = wxx;
                link[w + 1] = wxy;
                link[w + 2] = wxz;
                link[w + 3] = wyx;
                link[w + 4] = wyy;
                link[w + 5] = wyz;
                link[w + 6] = wzx;
                link[w + 7] = wzy;
                link[w + 8] = wzz;
                double fx = near[3 * before];
                double fy = near[3 * before + 1];
                double fz = near[3 * before + 2];
                gx -= wxx * fx + wxy * fy + wxz * fz;
                gy -= wyx * fx + wyy * fy + wyz * fz;
                gz -= wzx * fx + wzy * fy + wzz * fz;
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
        return left;
    }

    /** Sweeps what is missing forth; its square. */
    double sweep(PointNet net, int from, int to) {
        double[] near = net.near;
        double[] missing = net.missing;
        double left = 0;
        for (int p = from; p < to; p++) {
            int o = 3 * p;
            double gx = missing[o];
            double gy = missing[o + 1];
            double gz = missing[o + 2];
            left += gx * gx + gy * gy + gz * gz;
            if (prior[p] >= 0) {
                int w = 9 * p;
                double x = near[3 * prior[p]];
                double y = near[3 * prior[p] + 1];
                double z = near[3 * prior[p] + 2];
                gx -= link[w] * x + link[w + 1] * y + link[w + 2] * z;
                gy -= link[w + 3] * x + link[w + 4] * y + link[w + 5] * z;
                gz -= link[w + 6] * x + link[w + 7] * y + link[w + 8] * z;
            }
            near[o] = gx;
            near[o + 1] = gy;
            near[o + 2] = gz;
        }
        return left;
    }

    /** And back: what each path alone would do about what is missing; its size. */
    double back(PointNet net, int from, int to) {
        double[] near = net.near;
        double[] missing = net.missing;
        double size = 0;
        for (int p = to - 1; p >= from; p--) {
            int o = 3 * p;
            int d = 6 * p;
            double fx = near[o];
            double fy = near[o + 1];
            double fz = near[o + 2];
            double gx = inverse[d] * fx + inverse[d + 3] * fy + inverse[d + 4] * fz;
            double gy = inverse[d + 3] * fx + inverse[d + 1] * fy + inverse[d + 5] * fz;
            double gz = inverse[d + 4] * fx + inverse[d + 5] * fy + inverse[d + 2] * fz;
            if (next[p] >= 0) {
                int w = 9 * next[p];
                double x = near[3 * next[p]];
                double y = near[3 * next[p] + 1];
                double z = near[3 * next[p] + 2];
                gx -= link[w] * x + link[w + 3] * y + link[w + 6] * z;
                gy -= link[w + 1] * x + link[w + 4] * y + link[w + 7] * z;
                gz -= link[w + 2] * x + link[w + 5] * y + link[w + 8] * z;
            }
            near[o] = gx;
            near[o + 1] = gy;
            near[o + 2] = gz;
            size += gx * missing[o] + gy * missing[o + 1] + gz * missing[o + 2];
        }
        return size;
    }
}
