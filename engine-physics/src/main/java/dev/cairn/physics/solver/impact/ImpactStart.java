package dev.cairn.physics.solver.impact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.MotionRecord;
import dev.cairn.physics.solver.body.Rotation;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;

/**
 * Moves the start of a body's path after an impact within a sub-step.
 *
 * <p>A change {@code dv} of velocity at time t is the same path as the change now, from a start
 * that is moved by {@code -t dv}; so it is with a turn. But a body whose moments differ has another
 * momentum and another energy with the same angular velocity once it is turned. So it gets the
 * velocity that fits those of before: without that a plate of 0.6 m that bounced on its rim gained
 * 1e-3 of its energy.
 *
 * <p>One thread. Does not allocate.
 */
public final class ImpactStart {
    /** So much may momentum and energy miss each other, as a share; needles miss by factors. */
    private static final double MISS = 0.3;

    /** Turns until both fit; the longest of each, rad; what of the energy is rounding. */
    private static final int STEPS = 4;

    private static final double FAR = 0.2;
    private static final double ROUNDING = 1e-15;

    /** Change of the energy with a turn, over twice the energy, below which rounding would turn. */
    private static final double EVEN = 1e-4;

    private final double[] momentum = new double[3], spin = new double[3];

    /** Spin after a turn, rad/s. */
    private final double[] turned = new double[3];

    /**
     * Start of a sub-step, before its impacts; bodies of a batch in {@link SolverContext#order}.
     */
    public static void forget(SolverContext tick, int head, int tail) {
        for (int k = head; k < tail; k++) {
            tick.body.impactTime[tick.order[k]] = 0;
            tick.body.shifted[tick.order[k]] = false;
            tick.body.collided[tick.order[k]] = false;
        }
    }

    /** Fits those whose start was moved, after the impacts. */
    public void fit(SolverContext tick, int head, int tail) {
        for (int k = head; k < tail; k++) {
            int slot = tick.order[k];
            if (tick.body.shifted[slot]) {
                fit(tick.bodies, tick.body, slot, tick.body.collided[slot]);
            }
        }
    }

    /**
     * Moves the start of the path of a moving body.
     *
     * @param at its place in {@link SolverBodies#state}
     * @param old holds the velocities before the impact, at {@code q}
     * @param time of the impact, from the start of the sub-step, s
     */
    public static void shift(
            BodyStore store, SolverBodies bodies, int at, double[] old, int q, double time) {
        if (!(time > 0) || !bodies.isMoved(at)) {
            return;
        }
        double[] body = bodies.state;
        int slot = SolverBodies.slot(at);
        bodies.motion[MotionRecord.STRIDE * slot + MotionRecord.STRUCK] = 1;
        bodies.shifted[slot] = true;
        int p = at + SolverBodies.P;
        double tu = -time * (body[at + 3] - old[q + 3]);
        double tv = -time * (body[at + 4] - old[q + 4]);
        double tw = -time * (body[at + 5] - old[q + 5]);
        body[p] -= time * (body[at] - old[q]);
        body[p + 1] -= time * (body[at + 1] - old[q + 1]);
        body[p + 2] -= time * (body[at + 2] - old[q + 2]);
        body[p + 3] += tu;
        body[p + 4] += tv;
        body[p + 5] += tw;
        int k = (at >> 4) * SolverBodies.ROOT;
        double[] r = bodies.root;
        Rotation.turn(
                store,
                slot,
                r[k] * tu + r[k + 1] * tv + r[k + 2] * tw,
                r[k + 3] * tu + r[k + 4] * tv + r[k + 5] * tw,
                r[k + 6] * tu + r[k + 7] * tv + r[k + 8] * tw);
    }

    /**
     * Gives a body the root of the inertia that it has as its start is turned now, and the angular
     * velocity that fits it. After all impacts of a sub-step, which take the inertia to be that of
     * the start.
     *
     * @param slot of a body whose start was moved
     * @param keepsMomentum whether its angular momentum is to fit as well as its energy: that of an
     *     impact of two bodies that move
     */
    public void fit(BodyStore store, SolverBodies bodies, int slot, boolean keepsMomentum) {
        if (bodies.axes.isIsotropic(slot)) {
            return;
        }
        double[] v = bodies.state;
        int w = SolverBodies.offset(slot) + SolverBodies.V + 3;
        double twice = square(v, w);
        if (!(twice < Double.POSITIVE_INFINITY)) {
            // such a body is stopped when the step ends
            return;
        }
        bodies.momentum(slot, momentum);
        for (int c = 0; c < 3; c++) {
            spin[c] = bodies.world(slot, w, c);
        }
        keepMomentum(store, bodies, slot);
        for (int step = 0; step < STEPS && keepsMomentum; step++) {
            if (!turnTowards(store, bodies, slot, twice)) {
                break;
            }
            keepMomentum(store, bodies, slot);
        }
        double scale = Math.sqrt(twice / square(v, w));
        if (keepsMomentum && scale > 1) {
            return; // what is lost of the energy is lost, but nothing is made
        }
        if (!(Math.abs(scale - 1) <= MISS)) {
            bodies.weigh(slot, spin[0], spin[1], spin[2]);
            scale = Math.sqrt(twice / square(v, w));
        }
        for (int c = 0; c < 3 && scale > 0; c++) {
            v[w + c] *= scale;
        }
    }

    /** The inertia that the body has as it is turned now, and the spin of its momentum with it. */
    private void keepMomentum(BodyStore store, SolverBodies bodies, int slot) {
        double[] v = bodies.state;
        double[] r = bodies.root;
        int o = SolverBodies.offset(slot);
        int w = o + SolverBodies.V + 3;
        int k = (slot + 1) * SolverBodies.ROOT;
        bodies.rootOfInertia(store, slot, v[o + SolverBodies.GRAVITY]);
        for (int c = 0; c < 3; c++) {
            // L^T (angular momentum)
            v[w + c] =
                    r[k + c] * momentum[0]
                            + r[k + 3 + c] * momentum[1]
                            + r[k + 6 + c] * momentum[2];
        }
    }

    /**
     * Turns a body to where it has an energy with its angular momentum M. Both are kept on its free
     * path, so where they do not fit its start is beside the path on which the impact was. With a
     * turn {@code q} the energy changes by {@code q.(w x M)}; the shortest one is along that.
     *
     * @param twice the energy
     * @return whether it was turned
     */
    private boolean turnTowards(BodyStore store, SolverBodies bodies, int slot, double twice) {
        double[] v = bodies.state;
        int w = SolverBodies.offset(slot) + SolverBodies.V + 3;
        double miss = 0.5 * (twice - square(v, w));
        for (int c = 0; c < 3; c++) {
            turned[c] = bodies.world(slot, w, c);
        }
        double x = turned[1] * momentum[2] - turned[2] * momentum[1];
        double y = turned[2] * momentum[0] - turned[0] * momentum[2];
        double z = turned[0] * momentum[1] - turned[1] * momentum[0];
        double square = x * x + y * y + z * z;
        boolean leads = square > EVEN * EVEN * (twice * twice) && miss * miss < FAR * FAR * square;
        if (!leads || !(Math.abs(miss) > ROUNDING * twice)) {
            return false;
        }
        double k = miss / square;
        Rotation.turn(store, slot, k * x, k * y, k * z);
        return true;
    }

    private static double square(double[] v, int w) {
        return v[w] * v[w] + v[w + 1] * v[w + 1] + v[w + 2] * v[w + 2];
    }
}
