package dev.cairn.physics.solver.joint;

import dev.cairn.physics.solver.joint.net.JointPaths;

import java.util.Arrays;

/**
 * The linear system of an assembly that is too dense for factors, solved by conjugate gradients:
 *
 * <pre>
 * (J J^T + E) l = -b,   du = J^T l
 * </pre>
 *
 * <p>in velocities that are scaled so that the mass matrix is 1. What the joints of each of {@link
 * JointPaths} do to each other is inverted beforehand, block tridiagonal (M. Hestenes, E. Stiefel
 * 1952; P. Concus, G. Golub, G. Meurant 1985): a load goes down a path in one round, where single
 * joints would hand it on by one of them a round. A few rounds leave an error, and that only takes
 * energy away: where b is the speed of the rows, each round goes to the least energy of motion that
 * its directions reach.
 *
 * <p>Sums run in the order of joints, so bits do not depend on which worker solves. A round costs
 * one pass over the rows. Allocates when it is made.
 */
final class ConjugateGradients implements Assembly.Matrix {
    private static final int BODY = BlockFactors.BODY;
    private static final int SIDES = JointMath.JACOBIAN;

    /** Most rounds, and the share of the error at which they end. */
    private static final int ROUNDS = 8;

    private static final double NEAR = 1e-6;

    private final int[] end;
    private final int[] firstRow;

    /** By joint: where the factors of its own block begin; its rows squared each. */
    private final int[] firstBlock;

    private final double[] block;

    /** Unknowns of bodies, then of rows: right-hand side, then the solution. */
    private final double[] x;

    /** By row: what is missing, the same by blocks, where to go, and what that does. */
    private final double[] missing;

    private final double[] near;
    private final double[] way;
    private final double[] effect;

    /** By body: what the way does to velocities. */
    private final double[] moved;

    private final int rows;
    private final int bodies;
    private final JointPaths paths;

    /** By joint: where what its path's joint before it does to it begins, {@code C D^-1}. */
    private final int[] firstLink;

    private final double[] link;

    /** Room for a row of a joint, and for one to each of its rows; how long the longest is. */
    private final double[] row;

    private final double[] other;
    private int most;

    /**
     * Room for an assembly.
     *
     * @param bodies how many
     * @param end bodies of each joint
     * @param firstRow of each joint
     * @param arms by end of a joint: its place in the body's frame, three numbers
     */
    ConjugateGradients(int bodies, int[] end, int[] firstRow, double[] arms) {
        paths = new JointPaths(bodies, end, arms, 1);
        this.bodies = bodies;
        this.end = end;
        this.firstRow = firstRow;
        int joints = firstRow.length - 1;
        rows = firstRow[joints];
        firstBlock = new int[joints + 1];
        for (int k = 0; k < joints; k++) {
            int n = firstRow[k + 1] - firstRow[k];
            firstBlock[k + 1] = firstBlock[k] + n * n;
            most = Math.max(most, n);
        }
        row = new double[most];
        other = new double[most * most];
        block = new double[firstBlock[joints]];
        firstLink = new int[joints];
        int links = 0;
        for (int p = 0; p < joints; p++) {
            int k = paths.joint[p];
            firstLink[k] = links;
            if (paths.prior[p] >= 0) {
                int j = paths.joint[p - 1];
                links += (firstRow[k + 1] - firstRow[k]) * (firstRow[j + 1] - firstRow[j]);
            }
        }
        link = new double[links];
        x = new double[BODY * bodies + rows];
        missing = new double[rows];
        near = new double[rows];
        way = new double[rows];
        effect = new double[rows];
        moved = new double[BODY * bodies];
    }

    /** Of no assembly. */
    static ConjugateGradients none() {
        return new ConjugateGradients(0, new int[0], new int[1], new double[0]);
    }

    @Override
    public int unknown(int node) {
        return node < bodies ? BODY * node : BODY * bodies + firstRow[node - bodies];
    }

    @Override
    public double[] x() {
        return x;
    }

    /**
     * Factors what the rows of each path do to each other, block tridiagonal, {@code L D L^T} with
     * the D in place.
     */
    void factor(Assembly s) {
        for (int p = 0; p < paths.joint.length; p++) {
            int k = paths.joint[p];
            int n = firstRow[k + 1] - firstRow[k];
            int at = firstBlock[k];
            for (int r = 0; r < n; r++) {
                for (int c = 0; c <= r; c++) {
                    block[at + n * r + c] = own(s, firstRow[k] + r, firstRow[k] + c);
                }
            }
            if (paths.prior[p] >= 0) {
                link(s, paths.joint[p - 1], k);
            }
            decompose(at, n);
        }
    }

    /** What the joint before does to one: {@code W = C D^-1, D' -= W C^T}. */
    private void link(Assembly s, int j, int k) {
        int n = firstRow[k + 1] - firstRow[k];
        int m = firstRow[j + 1] - firstRow[j];
        int at = firstLink[k];
        for (int r = 0; r < n; r++) {
            for (int c = 0; c < m; c++) {
                double sum = 0;
                for (int side = 0; side < 4; side++) {
                    int mine = side & 1;
                    int its = side >> 1;
                    if (end[2 * k + mine] >= 0 && end[2 * k + mine] == end[2 * j + its]) {
                        sum += shared(s, firstRow[k] + r, mine, firstRow[j] + c, its);
                    }
                }
                link[at + m * r + c] = sum;
                row[c] = sum;
            }
            solveOwn(firstBlock[j], m, row);
            for (int c = 0; c < m; c++) {
                other[most * r + c] = row[c];
            }
        }
        for (int r = 0; r < n; r++) {
            for (int c = 0; c <= r; c++) {
                double sum = 0;
                for (int q = 0; q < m; q++) {
                    sum += other[most * r + q] * link[at + m * c + q];
                }
                block[firstBlock[k] + n * r + c] -= sum;
            }
        }
        for (int r = 0; r < n; r++) {
            System.arraycopy(other, most * r, link, at + m * r, m);
        }
    }

    /** What two rows do to each other by a body of both. */
    private double shared(Assembly s, int r, int mine, int c, int its) {
        if (!s.isActive[r] || !s.isActive[c]) {
            return 0;
        }
        double sum = 0;
        for (int i = 0; i < BODY; i++) {
            sum += s.scaled[SIDES * r + BODY * mine + i] * s.scaled[SIDES * c + BODY * its + i];
        }
        return mine == its ? sum : -sum;
    }

    /** {@code L D L^T} of a joint's block. */
    private void decompose(int at, int n) {
        for (int c = 0; c < n; c++) {
            double pivot = block[at + n * c + c];
            for (int m = 0; m < c; m++) {
                double f = block[at + n * c + m];
                pivot -= f * f * block[at + n * m + m];
            }
            block[at + n * c + c] = pivot;
            for (int r = c + 1; r < n; r++) {
                double g = block[at + n * r + c];
                for (int m = 0; m < c; m++) {
                    double f = block[at + n * r + m] * block[at + n * c + m];
                    g -= f * block[at + n * m + m];
                }
                block[at + n * r + c] = pivot > 0 ? g / pivot : 0;
            }
        }
    }

    /** Solves with it. */
    private void solveOwn(int at, int n, double[] v) {
        for (int r = 0; r < n; r++) {
            double g = v[r];
            for (int c = 0; c < r; c++) {
                g -= block[at + n * r + c] * v[c];
            }
            v[r] = g;
        }
        for (int r = n - 1; r >= 0; r--) {
            double pivot = block[at + n * r + r];
            double g = pivot > 0 ? v[r] / pivot : 0;
            for (int c = r + 1; c < n; c++) {
                g -= block[at + n * c + r] * v[c];
            }
            v[r] = g;
        }
    }

    /** What two rows of a joint do to each other. */
    private static double own(Assembly s, int r, int c) {
        if (!s.isActive[r] || !s.isActive[c]) {
            return r == c ? 1 : 0;
        }
        double sum = r == c ? -s.pivot[r] : 0;
        for (int i = 0; i < SIDES; i++) {
            sum += s.scaled[SIDES * r + i] * s.scaled[SIDES * c + i];
        }
        return sum;
    }

    /** Solves for {@link #x}. */
    void solve(Assembly s) {
        Arrays.fill(x, 0, BODY * bodies, 0.0);
        for (int r = 0; r < rows; r++) {
            missing[r] = s.isActive[r] ? -x[BODY * bodies + r] : 0;
            x[BODY * bodies + r] = 0;
        }
        double size = approach();
        System.arraycopy(near, 0, way, 0, rows);
        double goal = NEAR * size;
        for (int round = 0; round < ROUNDS && size > goal; round++) {
            double bend = apply(s);
            if (!(bend > 0)) {
                break;
            }
            double step = size / bend;
            for (int i = 0; i < BODY * bodies; i++) {
                x[i] += step * moved[i];
            }
            for (int r = 0; r < rows; r++) {
                x[BODY * bodies + r] += step * way[r];
                missing[r] -= step * effect[r];
            }
            double next = approach();
            double turn = next / size;
            for (int r = 0; r < rows; r++) {
                way[r] = near[r] + turn * way[r];
            }
            size = next;
        }
    }

    /** What each path alone would do about what is missing; its size. */
    private double approach() {
        int last = 0;
        for (int p = 0; p < paths.joint.length; p++) {
            int k = paths.joint[p];
            int n = firstRow[k + 1] - firstRow[k];
            int o = firstRow[k];
            if (paths.prior[p] < 0) {
                System.arraycopy(missing, o, near, o, n);
            } else {
                int m = firstRow[last + 1] - firstRow[last];
                int at = firstLink[k];
                for (int r = 0; r < n; r++) {
                    double g = missing[o + r];
                    for (int c = 0; c < m; c++) {
                        g -= link[at + m * r + c] * near[firstRow[last] + c];
                    }
                    near[o + r] = g;
                }
            }
            last = k;
        }
        double size = 0;
        for (int p = paths.joint.length - 1; p >= 0; p--) {
            int k = paths.joint[p];
            int n = firstRow[k + 1] - firstRow[k];
            int o = firstRow[k];
            System.arraycopy(near, o, row, 0, n);
            solveOwn(firstBlock[k], n, row);
            if (p + 1 < paths.joint.length && paths.prior[p + 1] >= 0) {
                int next = paths.joint[p + 1];
                int m = firstRow[next + 1] - firstRow[next];
                int at = firstLink[next];
                for (int r = 0; r < m; r++) {
                    double g = near[firstRow[next] + r];
                    for (int c = 0; c < n; c++) {
                        row[c] -= link[at + n * r + c] * g;
                    }
                }
            }
            for (int r = 0; r < n; r++) {
                near[o + r] = row[r];
                size += row[r] * missing[o + r];
            }
        }
        return size;
    }

    /** What the way does; its share in the energy. */
    private double apply(Assembly s) {
        double[] j = s.scaled;
        Arrays.fill(moved, 0.0);
        for (int k = 0; k + 1 < firstRow.length; k++) {
            int a = BODY * end[2 * k];
            int b = BODY * end[2 * k + 1];
            for (int r = firstRow[k]; r < firstRow[k + 1]; r++) {
                double l = s.isActive[r] ? way[r] : 0;
                int o = SIDES * r;
                for (int c = 0; c < BODY && a >= 0; c++) {
                    moved[a + c] -= l * j[o + c];
                }
                for (int c = 0; c < BODY && b >= 0; c++) {
                    moved[b + c] += l * j[o + BODY + c];
                }
            }
        }
        double sum = 0;
        for (int k = 0; k + 1 < firstRow.length; k++) {
            int a = BODY * end[2 * k];
            int b = BODY * end[2 * k + 1];
            for (int r = firstRow[k]; r < firstRow[k + 1]; r++) {
                double v = 0;
                int o = SIDES * r;
                for (int c = 0; c < BODY && a >= 0; c++) {
                    v -= moved[a + c] * j[o + c];
                }
                for (int c = 0; c < BODY && b >= 0; c++) {
                    v += moved[b + c] * j[o + BODY + c];
                }
                effect[r] = s.isActive[r] ? v - s.pivot[r] * way[r] : 0;
                sum += effect[r] * way[r];
            }
        }
        return sum;
    }
}
