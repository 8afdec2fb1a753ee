package dev.cairn.physics.solver.joint.net;

import dev.cairn.physics.internal.BodyStore;

import java.util.Arrays;

/**
 * A net of balls: all joints hold points together, and all bodies turn about any axis alike. What
 * {@link ConjugateGradients} does for rows of any kind takes a tenth of the numbers here: with r
 * the arms, rows in the axes of the world are
 *
 * <pre>
 * c = (x_B + r_B) - (x_A + r_A),   c' = (v_B + w_B × r_B) - (v_A + w_A × r_A)
 * </pre>
 *
 * <p>and with m and i the inverse mass and inertia of a body, {@code [r]} the matrix of {@code r
 * ×}, two of its joints j and k do to each other, but for a sign, {@code m 1 + i [k][j]^T = (m + i
 * k.j) 1 - i j k^T}.
 *
 * <p>Joints lie in the order of their {@link JointPaths}. Allocates when it is made.
 */
public final class PointNet {
    /** Most rounds, and the share of the error at which they end. */
    private static final int ROUNDS = 8;

    private static final double NEAR = 1e-6;

    /** Whether all joints hold points. */
    public final boolean isPoints;

    /** By place: the joint among those of the assembly. */
    public final int[] joint;

    private final PathFactors paths;

    /** By place: three numbers of body A, then of B; one more body for all that do not move. */
    public final int[] a;

    public final int[] b;

    /** By place: arms in the bodies' axes, or the world's of static bodies; of A, of B. */
    public final double[] local;

    /** The same in the world, in the poses of {@link #derive}, m. */
    final double[] arm;

    /** The same of a movement that is taken back. */
    private final double[] trial;

    /** By place: axes of its rows in A, row by row; those of static bodies in the world. */
    public final double[] axes;

    /** By place: distance of the centres at the tick's begin; c in the poses of derive, m. */
    public final double[] apart;

    public final double[] gap;

    /** By place: impulse in work, N s; those of the last sub-step's halves in the axes of A. */
    public final double[] impulse;

    public final double[] before;
    public final double[] after;

    /** By place: what is missing; the solution; room for the directions of the rounds. */
    public final double[] missing;

    public final double[] solution;
    final double[] near;
    final double[] way;
    final double[] effect;

    /** By body: rotation, inverse mass and inertia; what a way does to linear and angular speed. */
    private final double[] turn;

    private final double[] trialTurn;
    public final double[] mass;
    public final double[] spin;
    public final double[] linear;
    public final double[] angular;

    /** By body: what the solution does. */
    public final double[] linearSum;

    public final double[] angularSum;

    /** By body: movement and orientation, to take a movement back. */
    public final double[] kept;

    /** Share of a row's own inverse mass by which it yields. */
    private double slack;

    /** By place: inverse mass of a row, a mean of the three. */
    final double[] own;

    public final int bodies;

    /**
     * Room for an assembly, if it is one.
     *
     * @param end bodies of each joint, -1 for one that does not move
     * @param arms by end of a joint: its place in the body's frame, three numbers
     * @param rowAxes by joint: the axes of its rows in A's frame, row by row
     */
    public PointNet(boolean isPoints, int bodyCount, int[] end, double[] arms, double[] rowAxes) {
        this.isPoints = isPoints;
        bodies = isPoints ? bodyCount : 0;
        int n = isPoints ? end.length / 2 : 0;
        JointPaths order =
                isPoints
                        ? new JointPaths(bodyCount, end, arms)
                        : new JointPaths(0, new int[0], arms);
        joint = order.joint;
        paths = new PathFactors(order.begins);
        a = new int[n];
        b = new int[n];
        local = new double[6 * n];
        axes = new double[9 * n];
        for (int p = 0; p < n; p++) {
            int k = joint[p];
            a[p] = 3 * (end[2 * k] < 0 ? bodies : end[2 * k]);
            b[p] = 3 * (end[2 * k + 1] < 0 ? bodies : end[2 * k + 1]);
            System.arraycopy(arms, 6 * k, local, 6 * p, 6);
            System.arraycopy(rowAxes, 9 * k, axes, 9 * p, 9);
        }
        arm = new double[6 * n];
        trial = new double[6 * n];
        apart = new double[3 * n];
        gap = new double[3 * n];
        impulse = new double[3 * n];
        before = new double[3 * n];
        after = new double[3 * n];
        missing = new double[3 * n];
        solution = new double[3 * n];
        near = new double[3 * n];
        way = new double[3 * n];
        effect = new double[3 * n];
        own = new double[n];
        turn = new double[9 * (bodies + 1)];
        trialTurn = new double[9 * (bodies + 1)];
        mass = new double[bodies + 1];
        spin = new double[bodies + 1];
        linear = new double[3 * (bodies + 1)];
        angular = new double[3 * (bodies + 1)];
        linearSum = new double[3 * (bodies + 1)];
        angularSum = new double[3 * (bodies + 1)];
        kept = new double[10 * bodies];
        for (int c = 0; c < 3; c++) {
            turn[9 * bodies + 4 * c] = 1;
            trialTurn[9 * bodies + 4 * c] = 1;
        }
    }

    /** Impulses of rows in the axes of A. */
    public void fill(double[] from, int row, double[] into, int p) {
        for (int c = 0; c < 3; c++) {
            int e = 9 * p + c;
            into[3 * p + c] =
                    axes[e] * from[row] + axes[e + 3] * from[row + 1] + axes[e + 6] * from[row + 2];
        }
    }

    /** Gives them back to the rows. */
    public void give(double[] from, int p, double[] into, int row) {
        for (int r = 0; r < 3; r++) {
            int e = 9 * p + 3 * r;
            into[row + r] =
                    axes[e] * from[3 * p]
                            + axes[e + 1] * from[3 * p + 1]
                            + axes[e + 2] * from[3 * p + 2];
        }
    }

    /** Begins with impulses of the last sub-step, which go along with A. */
    public void warmStart(double[] last, double scale) {
        for (int p = 0; p < joint.length; p++) {
            int o = 3 * a[p];
            int q = 3 * p;
            double x = scale * last[q];
            double y = scale * last[q + 1];
            double z = scale * last[q + 2];
            impulse[q] = turn[o] * x + turn[o + 1] * y + turn[o + 2] * z;
            impulse[q + 1] = turn[o + 3] * x + turn[o + 4] * y + turn[o + 5] * z;
            impulse[q + 2] = turn[o + 6] * x + turn[o + 7] * y + turn[o + 8] * z;
        }
    }

    /** Keeps the impulses for the next one. */
    public void keep(double[] last, double scale) {
        for (int p = 0; p < joint.length; p++) {
            int o = 3 * a[p];
            int q = 3 * p;
            double x = scale * impulse[q];
            double y = scale * impulse[q + 1];
            double z = scale * impulse[q + 2];
            last[q] = turn[o] * x + turn[o + 3] * y + turn[o + 6] * z;
            last[q + 1] = turn[o + 1] * x + turn[o + 4] * y + turn[o + 7] * z;
            last[q + 2] = turn[o + 2] * x + turn[o + 5] * y + turn[o + 8] * z;
        }
    }

    /** Rotations of the bodies. */
    private void rotate(BodyStore all, int[] slot, double[] turn) {
        for (int n = 0; n < bodies; n++) {
            int i = slot[n];
            double x = all.orientationX[i];
            double y = all.orientationY[i];
            double z = all.orientationZ[i];
            double w = all.orientationW[i];
            int o = 9 * n;
            turn[o] = 1 - 2 * (y * y + z * z);
            turn[o + 1] = 2 * (x * y - w * z);
            turn[o + 2] = 2 * (x * z + w * y);
            turn[o + 3] = 2 * (x * y + w * z);
            turn[o + 4] = 1 - 2 * (x * x + z * z);
            turn[o + 5] = 2 * (y * z - w * x);
            turn[o + 6] = 2 * (x * z - w * y);
            turn[o + 7] = 2 * (y * z + w * x);
            turn[o + 8] = 1 - 2 * (x * x + y * y);
        }
    }

    /**
     * Arms and gaps.
     *
     * @param turn by body: its rotation
     * @param moved by body: movement since the tick's begin, as in {@link #kept}
     * @param arms receives the arms of the point where both are held, B's, six to a joint
     * @param gaps receives the gaps
     */
    private void measure(double[] turn, double[] moved, double[] arms, double[] gaps) {
        for (int p = 0; p < joint.length; p++) {
            int o = 6 * p;
            int i = 3 * a[p];
            int k = 3 * b[p];
            for (int c = 0; c < 3; c++) {
                double ra =
                        turn[i + 3 * c] * local[o]
                                + turn[i + 3 * c + 1] * local[o + 1]
                                + turn[i + 3 * c + 2] * local[o + 2];
                double rb =
                        turn[k + 3 * c] * local[o + 3]
                                + turn[k + 3 * c + 1] * local[o + 4]
                                + turn[k + 3 * c + 2] * local[o + 5];
                double way = apart[3 * p + c] + (moved[b[p] + c] - moved[a[p] + c]) + rb;
                arms[o + c] = way;
                arms[o + 3 + c] = rb;
                gaps[3 * p + c] = way - ra;
            }
        }
    }

    /** Arms and gaps in the poses of now; {@link #linear} is where bodies have moved to. */
    public void derive(BodyStore all, int[] slot) {
        rotate(all, slot, turn);
        measure(turn, linear, arm, gap);
    }

    /** The gaps alone, into {@link #missing}. */
    public void look(BodyStore all, int[] slot) {
        rotate(all, slot, trialTurn);
        measure(trialTurn, linear, trial, missing);
    }

    /**
     * Inverts what the joints of each path do to each other.
     *
     * @param isSame whether the poses are those of the last time
     */
    public void factor(double slack, boolean isSame) {
        if (!isSame) {
            paths.factor(this, slack);
        }
        this.slack = slack;
    }

    /** Solves {@code (J M^-1 J^T + E) l = missing}; what l does is in the sums. */
    public void solve() {
        Arrays.fill(solution, 0.0);
        Arrays.fill(way, 0.0);
        Arrays.fill(linearSum, 0.0);
        Arrays.fill(angularSum, 0.0);
        double left = 0;
        for (double m : missing) {
            left += m * m;
        }
        double goal = NEAR * left;
        double size = 1;
        for (int round = 0; round < ROUNDS && left > goal; round++) {
            double next = paths.approach(this);
            double turned = round == 0 ? 0 : next / size;
            size = next;
            for (int r = 0; r < way.length; r++) {
                way[r] = near[r] + turned * way[r];
            }
            apply(way);
            double bend = effect();
            if (!(bend > 0)) {
                return;
            }
            double step = size / bend;
            for (int r = 0; r < linear.length; r++) {
                linearSum[r] += step * linear[r];
                angularSum[r] += step * angular[r];
            }
            left = 0;
            for (int r = 0; r < way.length; r++) {
                solution[r] += step * way[r];
                double m = missing[r] - step * effect[r];
                missing[r] = m;
                left += m * m;
            }
        }
    }

    /** What impulses do to the bodies' velocities. */
    public void apply(double[] l) {
        Arrays.fill(linear, 0.0);
        Arrays.fill(angular, 0.0);
        for (int p = 0; p < joint.length; p++) {
            int i = a[p];
            int k = b[p];
            int o = 6 * p;
            double x = l[3 * p];
            double y = l[3 * p + 1];
            double z = l[3 * p + 2];
            linear[i] -= x;
            linear[i + 1] -= y;
            linear[i + 2] -= z;
            angular[i] -= arm[o + 1] * z - arm[o + 2] * y;
            angular[i + 1] -= arm[o + 2] * x - arm[o] * z;
            angular[i + 2] -= arm[o] * y - arm[o + 1] * x;
            linear[k] += x;
            linear[k + 1] += y;
            linear[k + 2] += z;
            angular[k] += arm[o + 4] * z - arm[o + 5] * y;
            angular[k + 1] += arm[o + 5] * x - arm[o + 3] * z;
            angular[k + 2] += arm[o + 3] * y - arm[o + 4] * x;
        }
        for (int n = 0; n <= bodies; n++) {
            for (int c = 3 * n; c < 3 * n + 3; c++) {
                linear[c] *= mass[n];
                angular[c] *= spin[n];
            }
        }
    }

    /** Speeds of the rows by {@link #linear} and {@link #angular}, into an array. */
    public void speeds(double[] into) {
        for (int p = 0; p < joint.length; p++) {
            int i = a[p];
            int k = b[p];
            int o = 6 * p;
            into[3 * p] =
                    linear[k]
                            - linear[i]
                            + (angular[k + 1] * arm[o + 5] - angular[k + 2] * arm[o + 4])
                            - (angular[i + 1] * arm[o + 2] - angular[i + 2] * arm[o + 1]);
            into[3 * p + 1] =
                    linear[k + 1]
                            - linear[i + 1]
                            + (angular[k + 2] * arm[o + 3] - angular[k] * arm[o + 5])
                            - (angular[i + 2] * arm[o] - angular[i] * arm[o + 2]);
            into[3 * p + 2] =
                    linear[k + 2]
                            - linear[i + 2]
                            + (angular[k] * arm[o + 4] - angular[k + 1] * arm[o + 3])
                            - (angular[i] * arm[o + 1] - angular[i + 1] * arm[o]);
        }
    }

    /** What the way does to the rows; its share in the energy. */
    private double effect() {
        speeds(effect);
        double sum = 0;
        for (int p = 0; p < joint.length; p++) {
            double e = slack * own[p];
            for (int r = 3 * p; r < 3 * p + 3; r++) {
                effect[r] += e * way[r];
                sum += effect[r] * way[r];
            }
        }
        return sum;
    }
}
