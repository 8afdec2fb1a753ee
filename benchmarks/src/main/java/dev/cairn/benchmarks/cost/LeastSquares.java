package dev.cairn.benchmarks.cost;

/**
 * Weighted linear regression by the normal equations, solved by Cholesky's factors (Golub and Van
 * Loan, Matrix Computations, 4.2 and 5.3). Columns are scaled to unit length before, so that counts
 * of a few and of thousands do not spoil each other.
 *
 * @param coefficients one per column, in the unit of y over that of the column
 * @param errors standard error of each
 * @param rSquared share of the weighted variance that is explained
 */
@SuppressWarnings("ArrayRecordComponent") // read, never compared
record LeastSquares(double[] coefficients, double[] errors, double rSquared) {
    /**
     * Fits y = sum of coefficient x column.
     *
     * @param x rows of columns; more rows than columns
     * @param y one per row
     * @param weights one per row, at least 0: the inverse of a row's variance
     * @return the fit
     * @throws IllegalArgumentException if the columns depend on each other
     */
    static LeastSquares fit(double[][] x, double[] y, double[] weights) {
        int rows = y.length;
        int n = x[0].length;
        double[] scale = new double[n];
        for (int k = 0; k < n; k++) {
            for (int r = 0; r < rows; r++) {
                scale[k] += weights[r] * x[r][k] * x[r][k];
            }
            scale[k] = Math.sqrt(scale[k]);
            if (scale[k] == 0) {
                throw new IllegalArgumentException("column " + k + " is zero in every row");
            }
        }
        double[][] a = new double[n][n];
        double[] b = new double[n];
        for (int r = 0; r < rows; r++) {
            for (int i = 0; i < n; i++) {
                b[i] += weights[r] * y[r] * x[r][i] / scale[i];
                for (int k = 0; k < n; k++) {
                    a[i][k] += weights[r] * x[r][i] * x[r][k] / scale[i] / scale[k];
                }
            }
        }
        double[][] inverse = inverse(a);
        double[] coefficients = new double[n];
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < n; k++) {
                coefficients[i] += inverse[i][k] * b[k];
            }
            coefficients[i] /= scale[i];
        }
        return withErrors(x, y, weights, coefficients, inverse, scale);
    }

    private static LeastSquares withErrors(
            double[][] x,
            double[] y,
            double[] weights,
            double[] coefficients,
            double[][] inverse,
            double[] scale) {
        double sum = 0;
        double weight = 0;
        for (int r = 0; r < y.length; r++) {
            sum += weights[r] * y[r];
            weight += weights[r];
        }
        double residual = 0;
        double total = 0;
        for (int r = 0; r < y.length; r++) {
            double fitted = 0;
            for (int k = 0; k < coefficients.length; k++) {
                fitted += coefficients[k] * x[r][k];
            }
            residual += weights[r] * (y[r] - fitted) * (y[r] - fitted);
            total += weights[r] * (y[r] - sum / weight) * (y[r] - sum / weight);
        }
        double variance = residual / (y.length - coefficients.length);
        double[] errors = new double[coefficients.length];
        for (int k = 0; k < errors.length; k++) {
            errors[k] = Math.sqrt(variance * inverse[k][k]) / scale[k];
        }
        return new LeastSquares(coefficients, errors, 1 - residual / total);
    }

    /** Inverse of a symmetric positive matrix: A = L Lᵀ, then one column after the other. */
    private static double[][] inverse(double[][] a) {
        int n = a.length;
        double[][] l = new double[n][n];
        for (int i = 0; i < n; i++) {
            for (int k = 0; k <= i; k++) {
                double sum = a[i][k];
                for (int m = 0; m < k; m++) {
                    sum -= l[i][m] * l[k][m];
                }
                if (i == k) {
                    if (sum <= 1e-12 * a[i][i]) {
                        throw new IllegalArgumentException(
                                "column " + i + " depends on those before it");
                    }
                    l[i][i] = Math.sqrt(sum);
                } else {
                    l[i][k] = sum / l[k][k];
                }
            }
        }
        double[][] inverse = new double[n][n];
        for (int column = 0; column < n; column++) {
            double[] z = new double[n];
            for (int i = 0; i < n; i++) {
                double sum = i == column ? 1 : 0;
                for (int m = 0; m < i; m++) {
                    sum -= l[i][m] * z[m];
                }
                z[i] = sum / l[i][i];
            }
            for (int i = n - 1; i >= 0; i--) {
                double sum = z[i];
                for (int m = i + 1; m < n; m++) {
                    sum -= l[m][i] * inverse[m][column];
                }
                inverse[i][column] = sum / l[i][i];
            }
        }
        return inverse;
    }
}
