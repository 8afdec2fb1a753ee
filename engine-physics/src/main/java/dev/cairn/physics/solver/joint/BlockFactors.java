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

    BlockFactors(Elimination order) {
        this.order = order;
        a = new double[order.entries];
        int n = order.unknown[order.nodes];
        pivot = new double[n];
        inverse = new double[n];
        x = new double[n];
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
                for (int k = 0; k < c; k++) {
                    g -= a[d + n * c + k] * a[row + k];
                }
                a[row + c] = g;
            }
        }
    }

    /** {@code C -= W1 D^-1 W2^T}; of a diagonal block the lower triangle. */
    private void subtract(int w1, int m, int w2, int l, int n, int u, int c, boolean isDiagonal) {
        for (int r = 0; r < m; r++) {
            int end = isDiagonal ? r + 1 : l;
            for (int s = 0; s < end; s++) {
                double sum = 0;
                for (int k = 0; k < n; k++) {
                    sum += a[w1 + n * r + k] * inverse[u + k] * a[w2 + n * s + k];
                }
                a[c + l * r + s] -= sum;
            }
        }
    }

    /** Solves for {@link #x}. */
    void solve() {
        Elimination o = order;
        for (int p = 0; p < o.nodes; p++) {
            int n = o.size[o.node[p]];
            int d = o.diagonal[p];
            int u = o.unknown[p];
            for (int r = 1; r < n; r++) {
                double g = x[u + r];
                for (int k = 0; k < r; k++) {
                    g -= a[d + n * r + k] * x[u + k];
                }
                x[u + r] = g;
            }
            for (int e = o.first[p]; e < o.first[p + 1]; e++) {
                int v = o.unknown[o.later[e]];
                int m = o.size[o.node[o.later[e]]];
                for (int r = 0; r < m; r++) {
                    double sum = 0;
                    for (int k = 0; k < n; k++) {
                        sum += a[o.block[e] + n * r + k] * inverse[u + k] * x[u + k];
                    }
                    x[v + r] -= sum;
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
                double w = x[v + r];
                for (int k = 0; k < n; k++) {
                    x[u + k] -= a[o.block[e] + n * r + k] * w;
                }
            }
        }
        for (int r = 0; r < n; r++) {
            x[u + r] *= inverse[u + r];
        }
        for (int r = n - 1; r >= 0; r--) {
            double g = x[u + r];
            for (int k = r + 1; k < n; k++) {
                g -= a[d + n * k + r] * x[u + k];
            }
            x[u + r] = g;
        }
    }
}
