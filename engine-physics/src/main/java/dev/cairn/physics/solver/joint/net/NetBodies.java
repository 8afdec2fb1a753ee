package dev.cairn.physics.solver.joint.net;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.Rotation;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;

import java.util.Arrays;

/**
 * The bodies of a {@link PointNet}, which turn about any axis alike: velocities, and what is done
 * to them, {@link #STRIDE} numbers to a body, linear and angular, in the axes of the world. One
 * more body stands for all that do not move.
 *
 * <p>Poses stay where all bodies have them. Does not allocate but when it is made.
 */
public final class NetBodies {
    /** Numbers to a body; six are used, of {@link #step} seven. */
    public static final int STRIDE = 8;

    static final int WEIGHTS = 2;

    /** How many move. */
    public final int count;

    /** Velocity, m/s and rad/s; and what it was when it was taken over. */
    final double[] velocity;

    private final double[] taken;

    /** What impulses do: first their sums, then changes of velocity. */
    final double[] change;

    /** How a solution moves bodies aside. */
    public final double[] sum;

    /** Movement of a step, m, and the quaternion of its turn. */
    final double[] step;

    /** Rotation matrices, row by row. */
    final double[] turn;

    /** Inverse mass and inertia, {@link #WEIGHTS} to a body. */
    final double[] inverse;

    /** Mass and inertia, 0 if infinite. */
    private final double[] weight;

    /** What gravity, forces and torques add to velocities in a second. */
    private final double[] push;

    private final int[] slot;

    NetBodies(int[] slots) {
        slot = slots;
        count = slots.length;
        int n = STRIDE * (count + 1);
        velocity = new double[n];
        taken = new double[n];
        change = new double[n];
        sum = new double[n];
        step = new double[n];
        step[n - STRIDE + 6] = 1;
        turn = new double[9 * (count + 1)];
        for (int c = 0; c < 3; c++) {
            turn[9 * count + 4 * c] = 1;
        }
        inverse = new double[WEIGHTS * (count + 1)];
        weight = new double[WEIGHTS * (count + 1)];
        push = new double[n];
    }

    /** Begin of a tick: masses and forces. */
    public void begin(SolverContext tick) {
        BodyStore b = tick.bodies;
        double[] v = tick.body.state;
        double[] g = tick.gravity;
        for (int n = 0; n < count; n++) {
            int i = slot[n];
            int o = SolverBodies.offset(i);
            int at = STRIDE * n;
            double root = root(tick, i);
            double m = v[o + SolverBodies.MASS];
            double k = v[o + SolverBodies.GRAVITY] * b.gravityScale[i];
            double spin = root * root;
            push[at] = k * g[0] + m * b.forceX[i];
            push[at + 1] = k * g[1] + m * b.forceY[i];
            push[at + 2] = k * g[2] + m * b.forceZ[i];
            push[at + 3] = spin * b.torqueX[i];
            push[at + 4] = spin * b.torqueY[i];
            push[at + 5] = spin * b.torqueZ[i];
            inverse[WEIGHTS * n] = m;
            inverse[WEIGHTS * n + 1] = spin;
            weight[WEIGHTS * n] = m > 0 ? 1 / m : 0;
            weight[WEIGHTS * n + 1] = spin > 0 ? 1 / spin : 0;
        }
    }

    private static double root(SolverContext tick, int i) {
        return tick.body.root[(i + 1) * SolverBodies.ROOT];
    }

    /** Takes over the velocities of now. */
    public void take(SolverContext tick) {
        double[] v = tick.body.state;
        for (int n = 0; n < count; n++) {
            int o = SolverBodies.offset(slot[n]);
            double root = root(tick, slot[n]);
            for (int c = 0; c < 3; c++) {
                velocity[STRIDE * n + c] = v[o + c];
                velocity[STRIDE * n + 3 + c] = root * v[o + 3 + c];
            }
        }
        System.arraycopy(velocity, 0, taken, 0, velocity.length);
    }

    /** Gives them back with what was done since; it is no part of a warm start. */
    public void give(SolverContext tick) {
        double[] v = tick.body.state;
        double[] mark = tick.body.mark;
        for (int n = 0; n < count; n++) {
            int o = SolverBodies.offset(slot[n]);
            int w = (slot[n] + 1) * SolverBodies.HALF;
            double root = root(tick, slot[n]);
            double scale = root > 0 ? 1 / root : 0;
            for (int c = 0; c < 6; c++) {
                int at = STRIDE * n + c;
                double d = (c < 3 ? 1 : scale) * (velocity[at] - taken[at]);
                v[o + c] += d;
                mark[w + c] += d;
                taken[at] = velocity[at];
            }
        }
    }

    /** Weight and forces of a step of what touches nothing. */
    public void kick(double h) {
        for (int r = 0; r < velocity.length; r++) {
            velocity[r] += h * push[r];
        }
    }

    /** Makes changes of velocity of the impulses in {@link #change}. */
    void weigh() {
        for (int n = 0; n <= count; n++) {
            int at = STRIDE * n;
            double m = inverse[WEIGHTS * n];
            double spin = inverse[WEIGHTS * n + 1];
            change[at] *= m;
            change[at + 1] *= m;
            change[at + 2] *= m;
            change[at + 3] *= spin;
            change[at + 4] *= spin;
            change[at + 5] *= spin;
        }
    }

    /** Adds a share of the changes to the velocities, or to the sum. */
    void add(double share, double[] into) {
        for (int r = 0; r < change.length; r++) {
            into[r] += share * change[r];
        }
    }

    /** The same of all. */
    public void add(double share) {
        add(share, velocity);
    }

    /** Energy of motion, J. */
    public double kinetic() {
        double[] v = velocity;
        double linear = 0;
        double angular = 0;
        for (int n = 0; n < count; n++) {
            int at = STRIDE * n;
            double x = v[at] * v[at] + v[at + 1] * v[at + 1] + v[at + 2] * v[at + 2];
            double y = v[at + 3] * v[at + 3] + v[at + 4] * v[at + 4] + v[at + 5] * v[at + 5];
            linear += weight[WEIGHTS * n] * x;
            angular += weight[WEIGHTS * n + 1] * y;
        }
        return 0.5 * (linear + angular);
    }

    /** Finds how a step of such a length will move the bodies. */
    public void foresee(SolverContext tick, double h) {
        double[] v = tick.body.state;
        for (int n = 0; n < count; n++) {
            int at = STRIDE * n;
            boolean isLoaded = v[SolverBodies.offset(slot[n]) + SolverBodies.LOADED] != 0;
            double fall = isLoaded ? 0 : 0.5 * h;
            step[at] = h * (velocity[at] - fall * push[at]);
            step[at + 1] = h * (velocity[at + 1] - fall * push[at + 1]);
            step[at + 2] = h * (velocity[at + 2] - fall * push[at + 2]);
            turn(at, h * velocity[at + 3], h * velocity[at + 4], h * velocity[at + 5]);
        }
    }

    private void turn(int at, double x, double y, double z) {
        double square = 0.25 * (x * x + y * y + z * z);
        double k = Rotation.halfSine(square);
        step[at + 3] = k * x;
        step[at + 4] = k * y;
        step[at + 5] = k * z;
        step[at + 6] = Rotation.halfCosine(square);
    }

    /** Moves the bodies as is foreseen. */
    public void move(SolverContext tick) {
        double[] v = tick.body.state;
        for (int n = 0; n < count; n++) {
            int at = STRIDE * n;
            int p = SolverBodies.offset(slot[n]) + SolverBodies.P;
            v[p] += step[at];
            v[p + 1] += step[at + 1];
            v[p + 2] += step[at + 2];
            Rotation.turn(
                    tick.bodies, slot[n], step[at + 3], step[at + 4], step[at + 5], step[at + 6]);
        }
    }

    /** Rotation matrices of now, and into {@link #change} where the bodies are. */
    public void look(SolverContext tick) {
        BodyStore b = tick.bodies;
        for (int n = 0; n < count; n++) {
            int i = slot[n];
            System.arraycopy(
                    tick.body.state,
                    SolverBodies.offset(i) + SolverBodies.P,
                    change,
                    STRIDE * n,
                    3);
            double x = b.orientationX[i];
            double y = b.orientationY[i];
            double z = b.orientationZ[i];
            double w = b.orientationW[i];
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
        Arrays.fill(change, STRIDE * count, change.length, 0.0);
    }
}
