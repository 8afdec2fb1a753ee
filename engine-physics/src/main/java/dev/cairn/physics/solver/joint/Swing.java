package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.Motion;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.row.SubStep;

import java.util.Arrays;

/**
 * The whole tick of an assembly that touches nothing, as flight is that of a single body.
 *
 * <p>Where nothing but rigid rows and gravity act the motion can be run backwards, and each
 * sub-step is made of three steps of {@link JointSolve} of lengths {@code g h, (1 - 2 g) h, g h}, {@code
 * g = 1/(2 - 2^(1/3))}, the middle one back in time: together they are of fourth order and
 * symplectic (E. Forest, R. Ruth 1990; H. Yoshida 1990). A pendulum at 45 degrees gains 5e-9 of its
 * time, where single steps gain 1.3e-5. Limits, motors, springs and damping know a direction of
 * time: with them it is single steps.
 *
 * <p>A light link under tension is a string that swings the faster the more it bears. Where that is
 * fast against the step, see {@link Tension}, each sub-step is cut into more.
 *
 * <p>One to a worker. Does not allocate.
 */
public final class Swing {
    private static final double OUTER = 1.3512071919596578;

    /** Frequency times step up to which a step is accurate; beyond 2 it would be unstable. */
    private static final double SLOW = 0.4;

    private static final int MOST = 27;

    private final Tension tension = new Tension();
    private final JointSolve solve = new JointSolve();

    /** Runs a tick. */
    public void run(SolverContext tick, SubStep sub, JointStore store, Assembly s) {
        solve.open(tick, sub, store, s);
        s.isFresh = false;
        Arrays.fill(s.slow, 1.0);
        boolean isReversible = isReversible(tick.bodies, store, s);
        double quick = sub.seconds * tension.quickest(tick, store, s);
        int parts = parts(quick);
        for (int k = 0; k < sub.count; k++) {
            if (parts > 1) {
                for (int n = 0; n < parts; n++) {
                    step(tick, s, sub.seconds / parts);
                }
            } else if (isReversible) {
                step(tick, s, OUTER * sub.seconds);
                step(tick, s, (1 - 2 * OUTER) * sub.seconds);
                step(tick, s, OUTER * sub.seconds);
            } else {
                step(tick, s, sub.seconds);
            }
        }
    }

    /** Steps to a sub-step; more than one only where a taut link swings so fast that it must be. */
    private static int parts(double quick) {
        if (quick <= SLOW) {
            return 1;
        }
        // few numbers, so that a tension that changes a little does not change the steps
        int parts = 3;
        while (parts < MOST && quick > SLOW * parts) {
            parts += parts / 2 + parts % 2;
        }
        return parts;
    }

    private static boolean isReversible(BodyStore b, JointStore store, Assembly s) {
        for (int j : s.joint) {
            for (int r = store.firstRow[j]; r < store.firstRow[j] + store.rows[j]; r++) {
                if (store.role[r] != JointStore.LOCK) {
                    return false;
                }
            }
        }
        for (int i : s.body) {
            if (b.restraint[i] != 0) {
                return false;
            }
        }
        return true;
    }

    private void step(SolverContext tick, Assembly s, double h) {
        double[] g = tick.gravity;
        for (int i : s.body) {
            Motion.kick(tick.bodies, tick.body, i, g[0], g[1], g[2], h);
        }
        solve.cold();
        solve.position(h, true);
        for (int i : s.body) {
            renew(tick, i);
        }
        solve.beginVelocity(false);
        solve.velocity(h);
    }

    /** Gives a body the root of its present inertia; no contact knows the old one. */
    static void renew(SolverContext tick, int i) {
        SolverBodies body = tick.body;
        if (body.axes.isIsotropic(i)) {
            return;
        }
        int o = SolverBodies.offset(i);
        double x = body.world(i, o + 3, 0);
        double y = body.world(i, o + 3, 1);
        double z = body.world(i, o + 3, 2);
        body.rootOfInertia(tick.bodies, i, body.state[o + SolverBodies.GRAVITY]);
        body.weigh(i, x, y, z);
        System.arraycopy(body.state, o, body.mark, (i + 1) * SolverBodies.HALF, 6);
    }
}
