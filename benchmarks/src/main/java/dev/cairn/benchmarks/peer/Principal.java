package dev.cairn.benchmarks.peer;

import org.joml.Matrix3d;
import org.joml.Quaterniond;

/**
 * Principal axes of an inertia tensor, by Jacobi's rotations (Golub and Van Loan, Matrix
 * Computations, 8.5): each makes one off-diagonal element zero; a handful of sweeps are enough.
 */
final class Principal {
    private static final int SWEEPS = 30;

    private Principal() {}

    /** Returns the rotation whose columns are the principal axes: diagonal = Rᵀ I R. */
    static Quaterniond axes(Matrix3d inertia) {
        double[][] a = new double[3][3];
        double[][] v = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                a[row][column] = inertia.get(column, row);
            }
        }
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            rotate(a, v, 0, 1);
            rotate(a, v, 0, 2);
            rotate(a, v, 1, 2);
        }
        Matrix3d r =
                new Matrix3d(
                        v[0][0], v[1][0], v[2][0], v[0][1], v[1][1], v[2][1], v[0][2], v[1][2],
                        v[2][2]);
        return new Quaterniond().setFromNormalized(r).normalize();
    }

    /** Makes a[p][q] zero. */
    private static void rotate(double[][] a, double[][] v, int p, int q) {
        if (a[p][q] == 0) {
            return;
        }
        double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        double t = Math.copySign(1, theta) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
        double c = 1 / Math.sqrt(t * t + 1);
        double s = t * c;
        for (int k = 0; k < 3; k++) {
            double akp = a[k][p];
            a[k][p] = c * akp - s * a[k][q];
            a[k][q] = s * akp + c * a[k][q];
        }
        for (int k = 0; k < 3; k++) {
            double apk = a[p][k];
            a[p][k] = c * apk - s * a[q][k];
            a[q][k] = s * apk + c * a[q][k];
            double vkp = v[k][p];
            v[k][p] = c * vkp - s * v[k][q];
            v[k][q] = s * vkp + c * v[k][q];
        }
    }
}
