package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;

/**
 * Locks and limits do no work: an assembly never has more energy than was put into it.
 *
 * <p>With K the energy of motion, U that of place in gravity and constant forces, and W the work of
 * contacts, each sub-step enters
 *
 * <pre>
 * a' = max(a + (K' + U') - (K + U) - max(0, W), -CREDIT k)
 * </pre>
 *
 * <p>into the assembly's account, where k is the largest K of the last seconds. A symplectic step
 * swings about its value: up to {@code ALLOWED k} is left alone, and of what was lost by that much
 * it may come back. What is beyond is taken from the velocities at once,
 *
 * <pre>
 * v' = u + f (v - u),  f² = 1 - (a' - ALLOWED k) / K(v - u)
 * </pre>
 *
 * <p>with u the motion as one rigid body of what touches nothing that does not move, and 0
 * otherwise. Rows see nothing of u, and of the rest they see the same as before, 0; momentum and
 * angular momentum stay.
 *
 * <p>A sub-step goes from v to v' before bodies are moved by {@code h v'}, and to v" after. An
 * impulse p of a contact has done {@code W = p.v'} of work if it came before the movement, whatever
 * it did to K, and what it adds to K if it came after: an overlap that is pushed out without speed
 * lifts what lies there by W, and joints have no part in it.
 *
 * <p>Assemblies with motors, springs, torques or a kinematic partner are given energy and have no
 * account. One worker at a time. Does not allocate. Source: own study.
 */
final class JointEnergy {
    /** Of k: what an account may hold, and what it may owe. */
    private static final double ALLOWED = 1e-4;

    private static final double CREDIT = 1e-3;

    /** What is left of k after a sub-step without motion. */
    private static final double FADES = 0.999;

    private final InnerMotion inner = new InnerMotion();

    /** Whether an assembly has an account in this tick. */
    static boolean keeps(SolverContext tick, JointStore store, Assembly s) {
        BodyStore b = tick.bodies;
        for (int i : s.body) {
            if (b.torqueX[i] != 0 || b.torqueY[i] != 0 || b.torqueZ[i] != 0) {
                return false;
            }
        }
        for (int k = 0; k < s.joint.length; k++) {
            int j = s.joint[k];
            if (b.kind[store.bodyA[j]] == BodyStore.KINEMATIC
                    || b.kind[store.bodyB[j]] == BodyStore.KINEMATIC) {
                return false;
            }
            for (int r = store.firstRow[j]; r < store.firstRow[j] + store.rows[j]; r++) {
                if (store.role[r] >= JointStore.MOTOR) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Energy of motion, J. */
    static double kinetic(SolverContext tick, Assembly s) {
        double sum = 0;
        for (int i : s.body) {
            sum += kinetic(tick, i);
        }
        return sum;
    }

    /** Energy of motion of a body, J. */
    static double kinetic(SolverContext tick, int i) {
        double[] v = tick.body.state;
        int o = SolverBodies.offset(i);
        double linear = v[o] * v[o] + v[o + 1] * v[o + 1] + v[o + 2] * v[o + 2];
        double turn = v[o + 3] * v[o + 3] + v[o + 4] * v[o + 4] + v[o + 5] * v[o + 5];
        double mass = v[o + SolverBodies.MASS];
        return 0.5 * (mass > 0 ? linear / mass + turn : turn);
    }

    /** Energy of place since the tick's begin, J. */
    static double potential(SolverContext tick, Assembly s) {
        BodyStore b = tick.bodies;
        double[] v = tick.body.state;
        double[] g = tick.gravity;
        double sum = 0;
        for (int i : s.body) {
            int o = SolverBodies.offset(i);
            int p = o + SolverBodies.P;
            double m = v[o + SolverBodies.MASS];
            double k = m > 0 ? v[o + SolverBodies.GRAVITY] * b.gravityScale[i] / m : 0;
            sum -= (k * g[0] + b.forceX[i]) * v[p];
            sum -= (k * g[1] + b.forceY[i]) * v[p + 1];
            sum -= (k * g[2] + b.forceZ[i]) * v[p + 2];
        }
        return sum;
    }

    /**
     * A sub-step begins: bodies have got weight, forces and the warm start of their contacts.
     *
     * @param h length of the sub-step
     */
    static void begin(SolverContext tick, Assembly s, double h) {
        BodyStore b = tick.bodies;
        double[] v = tick.body.state;
        double[] g = tick.gravity;
        double before = 0;
        double kicked = 0;
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int o = SolverBodies.offset(i);
            int w = (i + 1) * SolverBodies.HALF;
            double m = v[o + SolverBodies.MASS];
            double k = v[o + SolverBodies.GRAVITY] * b.gravityScale[i];
            for (int c = 0; c < 6; c++) {
                double f = c == 0 ? b.forceX[i] : c == 1 ? b.forceY[i] : b.forceZ[i];
                double a = c < 3 ? h * (k * g[c] + m * f) : 0;
                double free = v[o + c] - tick.body.warm[w + c];
                double weight = c > 2 ? 1 : m > 0 ? 1 / m : 0;
                kicked += weight * free * free;
                before += weight * (free - a) * (free - a);
                s.press[SolverBodies.HALF * n + c] = tick.body.warm[w + c];
            }
        }
        s.energy = 0.5 * before + potential(tick, s);
        s.pushed = kinetic(tick, s) - 0.5 * kicked;
    }

    /** Sweeps of contacts before bodies are moved begin, or end. */
    static void presses(SolverContext tick, Assembly s, boolean end) {
        sweeps(tick, s, end);
        double[] v = tick.body.state;
        for (int n = 0; n < s.body.length; n++) {
            int o = SolverBodies.offset(s.body[n]);
            for (int c = 0; c < 6; c++) {
                s.press[SolverBodies.HALF * n + c] += end ? v[o + c] : -v[o + c];
            }
        }
    }

    /**
     * Bodies will be moved with the velocities of now: what contacts have done to them so far.
     *
     * @param back share of what they gave that was not there yet while bodies moved
     */
    static void moves(SolverContext tick, Assembly s, double back) {
        double[] v = tick.body.state;
        double work = 0;
        for (int n = 0; n < s.body.length; n++) {
            int o = SolverBodies.offset(s.body[n]);
            double m = v[o + SolverBodies.MASS];
            for (int c = 0; c < 6; c++) {
                double p = s.press[SolverBodies.HALF * n + c];
                double weight = c > 2 ? 1 : m > 0 ? 1 / m : 0;
                work += weight * p * (v[o + c] - back * p);
            }
        }
        s.pushed = Math.max(s.pushed, work);
    }

    /** Sweeps of contacts after that begin, or end. */
    static void sweeps(SolverContext tick, Assembly s, boolean end) {
        double k = kinetic(tick, s);
        s.pushed += end ? k : -k;
    }

    /**
     * A sub-step ends: what is too much is taken away.
     *
     * @param touches whether anything but joints acts on the assembly
     */
    void settle(SolverContext tick, Assembly s, boolean touches) {
        double k = kinetic(tick, s);
        s.level = Math.max(FADES * s.level, k);
        double gain = k + potential(tick, s) - s.energy - (touches ? Math.max(0, s.pushed) : 0);
        s.account = Math.max(s.account + gain, -CREDIT * s.level);
        double excess = s.account - ALLOWED * s.level;
        if (excess > 0 && k > 0) {
            boolean floats = !s.isGrounded && !(touches && s.touchesFixed);
            s.account -= floats ? inner.cut(tick, s, excess, k) : cut(tick, s, excess, k);
            // what has come to a stand on something owes nothing: it could never move again
            s.account = touches && excess > k ? ALLOWED * s.level : s.account;
        }
    }

    private static double cut(SolverContext tick, Assembly s, double excess, double k) {
        double f = Math.sqrt(Math.max(0, 1 - excess / k)) - 1;
        double[] v = tick.body.state;
        for (int i : s.body) {
            int o = SolverBodies.offset(i);
            int w = (i + 1) * SolverBodies.HALF;
            for (int c = 0; c < 6; c++) {
                double d = f * v[o + c];
                v[o + c] += d;
                tick.body.mark[w + c] += d;
            }
        }
        return Math.min(excess, k);
    }
}
