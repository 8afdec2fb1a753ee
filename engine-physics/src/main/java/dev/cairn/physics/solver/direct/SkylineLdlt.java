package dev.cairn.physics.solver.direct;

import java.util.Arrays;

/**
 * A symmetric positive definite matrix of 6 x 6 blocks, a row of blocks to a body, and its factors:
 * {@code A = L D L^T}, L with ones on its diagonal, D diagonal.
 *
 * <p>Only the envelope is stored: of each row, what lies between the first column that is not 0 and
 * the diagonal. L has no entries outside of it. With w columns a row the factors cost {@code n
 * w^2/2} products, and a solution {@code 2 n w}: linear in the length of a column of boxes, whose w
 * is 12. Source: A. Jennings, "A compact storage scheme for the solution of symmetric linear
 * simultaneous equations" (1966).
 *
 * <p>One thread. Allocates only to grow.
 */
public final class SkylineLdlt {
    /** Unknowns to a body. */
    public static final int BLOCK = 6;

    private double[] entry = {};

    /** By row: where column 0 of it would be in {@link #entry}, and its first column. */
    private int[] row = {};

    private int[] first = {};

    /** By row: 1/D. */
    private double[] inverse = {};

    /** Right-hand side, then the solution. */
    public double[] x = {};

    private int size;
    private int entries;

    /**
     * Becomes the unit matrix.
     *
     * @param bodies rows of blocks
     * @param firstBlock by row of blocks, from {@code head} on: the first block that is not 0
     */
    public void begin(int bodies, int[] firstBlock, int head) {
        size = BLOCK * bodies;
        if (row.length < size) {
            row = new int[2 * size];
            first = new int[2 * size];
            inverse = new double[2 * size];
            x = new double[2 * size];
        }
        entries = 0;
        for (int r = 0; r < size; r++) {
            first[r] = BLOCK * firstBlock[head + r / BLOCK];
            row[r] = entries - first[r];
            entries += r + 1 - first[r];
        }
        if (entry.length < entries) {
            entry = new double[entries + entries / 2];
        }
        Arrays.fill(entry, 0, entries, 0.0);
        for (int r = 0; r < size; r++) {
            entry[row[r] + r] = 1;
        }
    }

    /**
     * Adds {@code weight p q^T} to the block of the bodies {@code i} and {@code j}, i not below j.
     */
    public void add(int i, double[] p, int j, double[] q, double weight) {
        for (int k = 0; k < BLOCK; k++) {
            double v = weight * p[k];
            int at = row[BLOCK * i + k] + BLOCK * j;
            int end = i == j ? k + 1 : BLOCK;
            for (int l = 0; l < end; l++) {
                entry[at + l] += v * q[l];
            }
        }
    }

    /** Begins a right-hand side, of zeros. */
    public void clear() {
        Arrays.fill(x, 0, size, 0.0);
    }

    /** Adds {@code weight p} to the right-hand side of a body. */
    public void push(int i, double[] p, double weight) {
        for (int k = 0; k < BLOCK; k++) {
            x[BLOCK * i + k] += weight * p[k];
        }
    }

    /** Product of the solution of a body with {@code p}. */
    double dot(int i, double[] p) {
        double sum = 0;
        for (int k = 0; k < BLOCK; k++) {
            sum += p[k] * x[BLOCK * i + k];
        }
        return sum;
    }

    /**
     * Replaces the matrix by its factors: row by row {@code g_c = a_rc - sum g_k l_ck, l_rc =
     * g_c/d_c, d_r = a_rr - sum g_c l_rc}.
     *
     * @return false if it is not positive definite, or not a number
     */
    public boolean factor() {
        double[] a = entry;
        for (int r = 0; r < size; r++) {
            int own = row[r];
            int start = first[r];
            for (int c = start; c < r; c++) {
                int other = row[c];
                double g = a[own + c];
                for (int k = Math.max(start, first[c]); k < c; k++) {
                    g -= a[own + k] * a[other + k];
                }
                a[own + c] = g;
            }
            double d = a[own + r];
            for (int c = start; c < r; c++) {
                double g = a[own + c];
                double l = g * inverse[c];
                d -= g * l;
                a[own + c] = l;
            }
            if (!(d > 0)) {
                return false;
            }
            inverse[r] = 1 / d;
        }
        return true;
    }

    /** Replaces the right-hand side by the solution. */
    public void solve() {
        double[] a = entry;
        for (int r = 0; r < size; r++) {
            double v = x[r];
            for (int c = first[r]; c < r; c++) {
                v -= a[row[r] + c] * x[c];
            }
            x[r] = v;
        }
        for (int r = size - 1; r >= 0; r--) {
            x[r] *= inverse[r];
        }
        for (int r = size - 1; r >= 0; r--) {
            double v = x[r];
            for (int c = first[r]; c < r; c++) {
                x[c] -= a[row[r] + c] * v;
            }
        }
    }
}
