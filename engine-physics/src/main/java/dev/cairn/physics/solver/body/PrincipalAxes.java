package dev.cairn.physics.solver.body;

import dev.cairn.physics.internal.BodyStore;

import java.util.Arrays;

/**
 * Principal moments and axes of each body's inertia, kept from tick to tick and made anew when the
 * inertia of a slot changes.
 *
 * <p>Method: cyclic Jacobi rotations of the symmetric 3 x 3 matrix (Golub and Van Loan, section
 * 8.5); arithmetic and square roots only. A box is already diagonal and keeps its own axes to the
 * bit.
 */
public final class PrincipalAxes {
    /** Doubles to a slot. */
    public static final int STRIDE = 13;

    /** Three moments, kg m². */
    public static final int MOMENT = 0;

    /** Quaternion bodyFromPrincipal, x y z w. */
    public static final int QX = 3;

    private static final int KEY = 7;
    private static final double SAME = 1e-9;

    public double[] data = {};
    boolean[] isotropic = {};

    /** Whether the moments of a body are equal. */
    public boolean isIsotropic(int i) {
        return isotropic[i];
    }

    public void ensureCapacity(int slots) {
        if (slots > isotropic.length) {
            int n = Math.max(slots, isotropic.length + (isotropic.length >> 1));
            data = Arrays.copyOf(data, n * STRIDE);
            isotropic = Arrays.copyOf(isotropic, n);
        }
    }

    /** Makes the axes of slot {@code i} agree with its inertia; allocates if it has changed. */
    public void update(BodyStore b, int i) {
        if (!isCurrent(b, i)) {
            find(b, i, new double[9], new double[4]);
        }
    }

    /** Whether the axes of slot {@code i} are those of its inertia. */
    public boolean isCurrent(BodyStore b, int i) {
        double[] d = data;
        int k = i * STRIDE + KEY;
        return d[k] == b.inertiaXX[i]
                && d[k + 1] == b.inertiaYY[i]
                && d[k + 2] == b.inertiaZZ[i]
                && d[k + 3] == b.inertiaXY[i]
                && d[k + 4] == b.inertiaXZ[i]
                && d[k + 5] == b.inertiaYZ[i];
    }

    /**
     * Finds the axes of slot {@code i}.
     *
     * @param a scratch, nine numbers
     * @param q scratch, four
     */
    public void find(BodyStore b, int i, double[] a, double[] q) {
        double[] d = data;
        int k = i * STRIDE + KEY;
        double xx = b.inertiaXX[i];
        double yy = b.inertiaYY[i];
        double zz = b.inertiaZZ[i];
        double xy = b.inertiaXY[i];
        double xz = b.inertiaXZ[i];
        double yz = b.inertiaYZ[i];
        d[k] = xx;
        d[k + 1] = yy;
        d[k + 2] = zz;
        d[k + 3] = xy;
        d[k + 4] = xz;
        d[k + 5] = yz;
        double size = Math.max(xx, Math.max(yy, zz));
        double spread = size - Math.min(xx, Math.min(yy, zz));
        double off = Math.max(Math.abs(xy), Math.max(Math.abs(xz), Math.abs(yz)));
        isotropic[i] = Math.max(spread, off) <= SAME * size;
        a[0] = xx;
        a[4] = yy;
        a[8] = zz;
        a[1] = a[3] = xy;
        a[2] = a[6] = xz;
        a[5] = a[7] = yz;
        q[0] = q[1] = q[2] = 0;
        q[3] = 1;
        if (off > 1e-14 * size) {
            for (int sweep = 0; sweep < 12; sweep++) {
                sweep(a, q);
            }
        }
        int o = i * STRIDE;
        d[o + MOMENT] = a[0];
        d[o + MOMENT + 1] = a[4];
        d[o + MOMENT + 2] = a[8];
        System.arraycopy(q, 0, d, o + QX, 4);
    }

    /** One sweep over the symmetric matrix {@code a}; {@code q} collects the turns. */
    public static void sweep(double[] a, double[] q) {
        rotate(a, q, 0, 1);
        rotate(a, q, 1, 2);
        rotate(a, q, 0, 2);
    }

    /** Component {@code k}, in the body, of the principal axis {@code axis} of the first slot. */
    public static double column(double[] d, int axis, int k) {
        double x = d[QX];
        double y = d[QX + 1];
        double z = d[QX + 2];
        double w = d[QX + 3];
        return Rotation.axis(x, y, z, w, axis, k);
    }

    /** One Jacobi rotation that clears {@code a[r][c]}; {@code q} collects the turns. */
    private static void rotate(double[] a, double[] q, int r, int c) {
        double arc = a[3 * r + c];
        if (arc == 0) {
            return;
        }
        double theta = (a[4 * c] - a[4 * r]) / (2 * arc);
        double t = (theta >= 0 ? 1 : -1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
        double cos = 1 / Math.sqrt(t * t + 1);
        double sin = t * cos;
        // a = J^T a J with J = [[cos, sin], [-sin, cos]] in the plane (r, c)
        for (int k = 0; k < 3; k++) {
            double kr = a[3 * k + r];
            double kc = a[3 * k + c];
            a[3 * k + r] = cos * kr - sin * kc;
            a[3 * k + c] = sin * kr + cos * kc;
        }
        for (int k = 0; k < 3; k++) {
            double rk = a[3 * r + k];
            double ck = a[3 * c + k];
            a[3 * r + k] = cos * rk - sin * ck;
            a[3 * c + k] = sin * rk + cos * ck;
        }
        // J is a turn by phi, cos(phi) = cos, about the third axis; its sign from the handedness of
        // (r, c)
        int axis = 3 - r - c;
        double sign = axis == 1 ? 1 : -1;
        double half = Math.sqrt(0.5 * (1 + cos));
        double sinHalf = sign * sin / (2 * half);
        double x = axis == 0 ? sinHalf : 0;
        double y = axis == 1 ? sinHalf : 0;
        double z = axis == 2 ? sinHalf : 0;
        double qx = q[0];
        double qy = q[1];
        double qz = q[2];
        double qw = q[3];
        q[0] = qw * x + qx * half + (qy * z - qz * y);
        q[1] = qw * y + qy * half + (qz * x - qx * z);
        q[2] = qw * z + qz * half + (qx * y - qy * x);
        q[3] = qw * half - (qx * x + qy * y + qz * z);
    }
}
