package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;

import java.util.Arrays;

/**
 * What of the motion of bodies that float together is not that of one rigid body.
 *
 * <p>With c the centre of mass, V its velocity, L the angular momentum and I the inertia about it,
 * the rigid motion is {@code u = V + w × (x - c)}, {@code I w = L}. Joints see nothing of it, and
 * whatever is done to the rest alone changes neither momentum nor angular momentum.
 *
 * <p>One to a worker. Does not allocate.
 */
public final class InnerMotion {
    private final double[] centre = new double[3];

    /** Sum of masses times places: arms are from the first body while it is made. */
    private final double[] weighed = new double[3];

    private final double[] speed = new double[3];
    private final double[] spin = new double[3];
    private final double[] angular = new double[3];
    private final double[] arm = new double[3];

    /** Angular momentum before bodies were moved. */
    private final double[] noted = new double[3];

    /** Inertia of all, and L^-1 of a body, row by row. */
    private final double[] inertia = new double[9];

    private final double[] inverse = new double[9];
    private double mass;

    /** Whether all bodies can turn; else only the common velocity is known. */
    private boolean turns;

    /** The bodies, and how many. */
    private int[] body = {};

    private int count;

    /** Takes energy away from the inner motion of an assembly; how much there was to take, J. */
    double cut(SolverContext tick, Assembly s, double excess, double kinetic) {
        return cut(tick, s.body, s.body.length, excess, kinetic, false);
    }

    /**
     * Takes energy away from the inner motion.
     *
     * @param bodies slots, of which the first {@code length} are meant
     * @param excess energy to be taken, J
     * @param kinetic energy of motion of all, J
     * @param spins whether their turning as one pays, too, where the rest is not enough
     * @return how much there was to take, J
     */
    public double cut(
            SolverContext tick,
            int[] bodies,
            int length,
            double excess,
            double kinetic,
            boolean spins) {
        gather(tick, bodies, length);
        double rigid = 0;
        for (int c = 0; c < 3; c++) {
            rigid += 0.5 * (mass * speed[c] * speed[c] + spin[c] * angular[c]);
        }
        double inner = kinetic - rigid;
        if (spins && turns && !(inner > excess)) {
            inner += 0.5 * (spin[0] * angular[0] + spin[1] * angular[1] + spin[2] * angular[2]);
            Arrays.fill(spin, 0.0);
        }
        if (!(inner > 0)) {
            return 0;
        }
        double f = Math.sqrt(Math.max(0, 1 - excess / inner)) - 1;
        double[] v = tick.body.state;
        for (int n = 0; n < count; n++) {
            int i = body[n];
            int o = SolverBodies.offset(i);
            reach(tick, i);
            double[] mark = tick.body.mark;
            int w = (i + 1) * SolverBodies.HALF;
            for (int c = 0; c < 3; c++) {
                double linear = f * (v[o + c] - speed[c] - cross(spin, arm, c));
                v[o + c] += linear;
                mark[w + c] += linear;
            }
            if (turns) {
                invert(tick.body.root, (i + 1) * SolverBodies.ROOT);
            }
            for (int c = 0; c < 3; c++) {
                double turn = f * (v[o + 3 + c] - (turns ? row(inverse, c, spin) : 0));
                v[o + 3 + c] += turn;
                mark[w + 3 + c] += turn;
            }
        }
        return Math.min(excess, inner);
    }

    /** Bodies will be moved without their velocities: keeps the angular momentum of now. */
    void note(SolverContext tick, Assembly s) {
        gather(tick, s.body, s.body.length);
        System.arraycopy(angular, 0, noted, 0, 3);
    }

    /** They were: turns the whole by what has become of its angular momentum. */
    void giveBack(SolverContext tick, Assembly s) {
        gather(tick, s.body, s.body.length);
        for (int c = 0; c < 3; c++) {
            angular[c] = noted[c] - angular[c];
        }
        if (!turns || !solve()) {
            return;
        }
        for (int i : s.body) {
            int o = SolverBodies.offset(i);
            int w = (i + 1) * SolverBodies.HALF;
            reach(tick, i);
            invert(tick.body.root, (i + 1) * SolverBodies.ROOT);
            for (int c = 0; c < 3; c++) {
                double linear = cross(spin, arm, c);
                double turn = row(inverse, c, spin);
                tick.body.state[o + c] += linear;
                tick.body.mark[w + c] += linear;
                tick.body.state[o + 3 + c] += turn;
                tick.body.mark[w + 3 + c] += turn;
            }
        }
    }

    private void gather(SolverContext tick, int[] bodies, int length) {
        body = bodies;
        count = length;
        double[] v = tick.body.state;
        mass = 0;
        turns = true;
        Arrays.fill(centre, 0.0);
        Arrays.fill(weighed, 0.0);
        Arrays.fill(speed, 0.0);
        Arrays.fill(angular, 0.0);
        Arrays.fill(inertia, 0.0);
        for (int n = 0; n < count; n++) {
            int i = body[n];
            int o = SolverBodies.offset(i);
            double m = 1 / v[o + SolverBodies.MASS];
            mass += m;
            turns &=
                    tick.bodies.motionFlags[i] == 0
                            && invert(tick.body.root, (i + 1) * SolverBodies.ROOT);
            reach(tick, i);
            for (int c = 0; c < 3; c++) {
                weighed[c] += m * arm[c];
                speed[c] += m * v[o + c];
            }
        }
        for (int c = 0; c < 3; c++) {
            speed[c] /= mass;
            centre[c] = weighed[c] / mass;
        }
        Arrays.fill(spin, 0.0);
        if (turns) {
            for (int n = 0; n < count; n++) {
                add(tick, body[n]);
            }
            solve();
        }
    }

    /** Place of a body against the centre, m. */
    private void reach(SolverContext tick, int i) {
        BodyStore b = tick.bodies;
        double[] v = tick.body.state;
        int p = SolverBodies.offset(i) + SolverBodies.P;
        int q = SolverBodies.offset(body[0]) + SolverBodies.P;
        arm[0] = b.apartX(body[0], i) + (v[p] - v[q]) - centre[0];
        arm[1] = b.apartY(body[0], i) + (v[p + 1] - v[q + 1]) - centre[1];
        arm[2] = b.apartZ(body[0], i) + (v[p + 2] - v[q + 2]) - centre[2];
    }

    /** Adds angular momentum and inertia of a body: {@code L^-T L^-1 + m (r.r 1 - r r^T)}. */
    private void add(SolverContext tick, int i) {
        double[] v = tick.body.state;
        int o = SolverBodies.offset(i);
        double m = 1 / v[o + SolverBodies.MASS];
        invert(tick.body.root, (i + 1) * SolverBodies.ROOT);
        reach(tick, i);
        double square = arm[0] * arm[0] + arm[1] * arm[1] + arm[2] * arm[2];
        for (int c = 0; c < 3; c++) {
            int d = (c + 1) % 3;
            int e = (c + 2) % 3;
            angular[c] += m * (arm[d] * (v[o + e] - speed[e]) - arm[e] * (v[o + d] - speed[d]));
            for (int k = 0; k < 3; k++) {
                angular[c] += inverse[3 * k + c] * v[o + 3 + k];
                double sum = m * ((c == k ? square : 0) - arm[c] * arm[k]);
                for (int n = 0; n < 3; n++) {
                    sum += inverse[3 * n + c] * inverse[3 * n + k];
                }
                inertia[3 * c + k] += sum;
            }
        }
    }

    /** {@code I w = L} by Cramer's rule; whether that is possible. */
    private boolean solve() {
        if (!invert(inertia, 0)) {
            return false;
        }
        for (int c = 0; c < 3; c++) {
            spin[c] = row(inverse, c, angular);
        }
        return true;
    }

    /** Inverts a matrix of three rows; whether that is possible. */
    private boolean invert(double[] a, int at) {
        for (int r = 0; r < 3; r++) {
            for (int c = 0; c < 3; c++) {
                int i = (c + 1) % 3;
                int j = (c + 2) % 3;
                int k = (r + 1) % 3;
                int l = (r + 2) % 3;
                inverse[3 * r + c] =
                        a[at + 3 * i + k] * a[at + 3 * j + l]
                                - a[at + 3 * i + l] * a[at + 3 * j + k];
            }
        }
        double det = a[at] * inverse[0] + a[at + 1] * inverse[3] + a[at + 2] * inverse[6];
        for (int k = 0; k < 9; k++) {
            inverse[k] /= det;
        }
        return det != 0 && Double.isFinite(inverse[0]);
    }

    private static double row(double[] a, int r, double[] x) {
        return a[3 * r] * x[0] + a[3 * r + 1] * x[1] + a[3 * r + 2] * x[2];
    }

    private static double cross(double[] a, double[] b, int c) {
        int d = (c + 1) % 3;
        int e = (c + 2) % 3;
        return a[d] * b[e] - a[e] * b[d];
    }
}
