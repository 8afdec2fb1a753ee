package dev.cairn.physics.solver.joint;

import java.util.Arrays;

/**
 * The matrix of an assembly and its factors, {@code A = L D L^T} in blocks:
 *
 * <pre>
 * [  1   -J^T ] [ du ]   [ 0 ]
 * [ -J   -E   ] [ l  ] = [ b ]
 * </pre>
 *
 * <p>in velocities that are scaled so that the mass matrix is 1. With E above 0 it is
 * quasi-definite: the factors exist in any order (R. Vanderbei, 1995). Only blocks that {@link
 * Elimination} names are stored, so a tree costs a fixed amount to a body. One worker at a time.
 * Allocates when it is made.
 */
final class BlockFactors implements Assembly.Matrix {
    /** Unknowns to a body. */
    static final int BODY = 6;

    final Elimination order;
    private final double[] a;

    /** By unknown: D and 1/D. */
    private final double[] pivot;

    private final double[] inverse;

    /** Right-hand side, then the solution. */
    private final double[] x;

    /** A row, times 1/D. */
    private final double[] scaled;

    BlockFactors(Elimination order) {
        this.order = order;
        a = new double[order.entries];
        int n = order.unknown[order.nodes];
        pivot = new double[n];
        inverse = new double[n];
        x = new double[n];
        scaled = new double[Math.max(BODY, order.largest())];
    }

    @Override
    public double[] x() {
        return x;
    }

    /** Becomes the matrix without joints' entries: 1 for bodies, 0 for joints. */
    void begin(int bodies) {
        Arrays.fill(a, 0.0);
        for (int i = 0; i < bodies; i++) {
            int at = order.diagonal[order.place[i]];
            for (int k = 0; k < BODY; k++) {
                a[at + (BODY + 1) * k] = 1;
            }
        }
    }

    @Override
    public int unknown(int node) {
        return order.unknown[order.place[node]];
    }

    /** Sets the diagonal entry of a joint's row. */
    void pivot(int joint, int row, double value) {
        a[order.diagonal[order.place[joint]] + (order.size[joint] + 1) * row] = value;
    }

    /** Sets what a joint's row and a body share, {@link #BODY} numbers, times {@code sign}. */
    void couple(int joint, int row, int body, double[] j, int at, double sign) {
        int p = order.place[joint];
        int k = order.place[body];
        int rows = order.size[joint];
        if (p > k) {
            int to = order.at(p, k) + BODY * row;
            for (int c = 0; c < BODY; c++) {
                a[to + c] += sign * j[at + c];
            }
        } else {
            int to = order.at(k, p) + row;
            for (int c = 0; c < BODY; c++) {
                a[to + rows * c] += sign * j[at + c];
            }
        }
    }

    /** Replaces the matrix by its factors. */
    void factor() {
        Elimination o = order;
        for (int p = 0; p < o.nodes; p++) {
            int n = o.size[o.node[p]];
            int d = o.diagonal[p];
            int u = o.unknown[p];
            diagonal(d, n, u);
            int update = o.firstUpdate[p];
            for (int e = o.first[p]; e < o.first[p + 1]; e++) {
                int m = o.size[o.node[o.later[e]]];
                divide(o.block[e], m, d, n);
                for (int f = o.first[p]; f <= e; f++) {
                    int l = o.size[o.node[o.later[f]]];
                    subtract(o.block[e], m, o.block[f], l, n, u, o.update[update++], e == f);
                }
            }
        }
    }

    /** Unit lower factor in the strict lower triangle, 1/D aside. */
    private void diagonal(int d, int n, int u) {
        for (int c = 0; c < n; c++) {
            double own = a[d + (n + 1) * c];
            for (int k = 0; k < c; k++) {
                own -= a[d + n * c + k] * a[d + n * c + k] * pivot[u + k];
            }
            pivot[u + c] = own;
            // a row without any mass behind it: nothing can be done
            inverse[u + c] = own == 0 ? 0 : 1 / own;
            for (int r = c + 1; r < n; r++) {
                double g = a[d + n * r + c];
                for (int k = 0; k < c; k++) {
                    g -= a[d + n * r + k] * a[d + n * c + k] * pivot[u + k];
                }
                a[d + n * r + c] = g * inverse[u + c];
            }
        }
    }

    /** {@code W = B L^-T}, row by row. */
    private void divide(int b, int m, int d, int n) {
        for (int r = 0; r < m; r++) {
            int row = b + n * r;
            for (int c = 1; c < n; c++) {
                double g = a[row + c];
                a[row + c] = g - dot(a, d + n * c, a, row, c);
            }
        }
    }

    /** {@code C -= W1 D^-1 W2^T}; of a diagonal block the lower triangle. */
    private void subtract(int w1, int m, int w2, int l, int n, int u, int c, boolean isDiagonal) {
        for (int r = 0; r < m; r++) {
            int end = isDiagonal ? r + 1 : l;
            for (int k = 0; k < n; k++) {
                scaled[k] = a[w1 + n * r + k] * inverse[u + k];
            }
            for (int s = 0; s < end; s++) {
                a[c + l * r + s] -= dot(a, w2 + n * s, scaled, 0, n);
            }
        }
    }

    /** Solves for {@link #x}: {@code L y = b}, then {@code D L^T x = y}. */
    void solve() {
        Elimination o = order;
        for (int p = 0; p < o.nodes; p++) {
            int n = o.size[o.node[p]];
            int d = o.diagonal[p];
            int u = o.unknown[p];
            for (int r = 1; r < n; r++) {
                x[u + r] -= dot(a, d + n * r, x, u, r);
            }
            for (int k = 0; k < n; k++) {
                scaled[k] = inverse[u + k] * x[u + k];
            }
            for (int e = o.first[p]; e < o.first[p + 1]; e++) {
                int v = o.unknown[o.later[e]];
                int m = o.size[o.node[o.later[e]]];
                for (int r = 0; r < m; r++) {
                    x[v + r] -= dot(a, o.block[e] + n * r, scaled, 0, n);
                }
            }
        }
        for (int p = o.nodes - 1; p >= 0; p--) {
            back(p);
        }
    }

    private void back(int p) {
        Elimination o = order;
        int n = o.size[o.node[p]];
        int d = o.diagonal[p];
        int u = o.unknown[p];
        for (int e = o.first[p]; e < o.first[p + 1]; e++) {
            int v = o.unknown[o.later[e]];
            int m = o.size[o.node[o.later[e]]];
            for (int r = 0; r < m; r++) {
                subtract(a, o.block[e] + n * r, x[v + r], x, u, n);
            }
        }
        for (int k = 0; k < n; k++) {
            x[u + k] *= inverse[u + k];
        }
        for (int r = n - 1; r > 0; r--) {
            subtract(a, d + n * r, x[u + r], x, u, r);
        }
    }

    /** {@code a.b}: a body's six and a point's three numbers without a loop, which costs more. */
    private static double dot(double[] a, int i, double[] b, int j, int n) {
        if (n == BODY) {
            return a[i] * b[j]
                    + a[i + 1] * b[j + 1]
                    + a[i + 2] * b[j + 2]
                    + a[i + 3] * b[j + 3]
                    + a[i + 4] * b[j + 4]
                    + a[i + 5] * b[j + 5];
        }
        if (n == 3) {
            return a[i] * b[j] + a[i + 1] * b[j + 1] + a[i + 2] * b[j + 2];
        }
        double sum = 0;
        for (int k = 0; k < n; k++) {
            sum += a[i + k] * b[j + k];
        }
        return sum;
    }

    /** {@code x -= w a}. */
    private static void subtract(double[] a, int i, double w, double[] x, int j, int n) {
        if (n == BODY) {
            x[j] -= w * a[i];
            x[j + 1] -= w * a[i + 1];
            x[j + 2] -= w * a[i + 2];
            x[j + 3] -= w * a[i + 3];
            x[j + 4] -= w * a[i + 4];
            x[j + 5] -= w * a[i + 5];
            return;
        }
        for (int k = 0; k < n; k++) {
            x[j + k] -= w * a[i + k];
        }
    }
}
