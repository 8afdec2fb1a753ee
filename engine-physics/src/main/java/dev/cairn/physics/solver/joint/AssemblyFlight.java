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
 * sub-step of a few bodies is made of five steps of {@link JointSolve} of lengths {@code g h, g h,
 * (1 - 4 g) h, g h, g h}, {@code g = 1/(4 - 4^(1/3))}, the middle one back in time: together they
 * are of fourth order and symplectic (M. Suzuki 1990). A pendulum at 45 degrees gains 1e-10 of its
 * time, where single steps gain 1.3e-5. Limits, motors, springs and damping know a direction of
 * time: with them it is single steps, and so it is with many bodies.
 *
 * <p>A light link under tension is a string that swings the faster the more it bears. Where that is
 * fast against the step, see {@link Tension}, each sub-step is cut into more.
 *
 * <p>One to a worker. Does not allocate.
 */
public final class AssemblyFlight {
    private static final double OUTER = 0.4144907717943757;

    /**
     * Bodies up to which steps are of fourth order. The motion of more is chaotic: no digit that
     * they would save is left after a second, and a chain would cost four times as much.
     */
    private static final int FEW = 4;

    private final JointEnergy energy = new JointEnergy();
    private final Tension tension = new Tension();
    private final JointSolve solve = new JointSolve();

    /** Length of the tick's step before, s, or 0. */
    private double last;

    /** Runs a tick. */
    public void run(SolverContext tick, SubStep sub, JointStore store, Assembly s) {
        s.keeps = JointEnergy.keeps(tick, store, s);
        // how it is solved decides how fine its steps are
        solve.open(tick, sub, store, s);
        solve.choose();
        boolean isSmooth = s.isDirect && !s.keepsFailing();
        double quick = s.isDirect ? sub.seconds * tension.quickest(tick, store, s) : 0;
        int parts = isSmooth ? Tension.partsAlone(quick) : 1;
        boolean isFine = isSmooth && parts == 1 && s.body.length <= FEW && isReversible(tick, s);
        solve.open(tick, sub, store, s, isFine ? 8 * OUTER - 1 : 1);
        solve.findDrives();
        solve.findCarriers();
        last = 0;
        double h = sub.seconds / parts;
        for (int k = 0; k < sub.count * parts; k++) {
            if (!solve.flows()) {
                s.energy = JointEnergy.kinetic(tick, s) + JointEnergy.potential(tick, s);
            }
            if (isFine) {
                step(tick, s, OUTER * h, false);
                step(tick, s, OUTER * h, false);
                step(tick, s, (1 - 4 * OUTER) * h, false);
                step(tick, s, OUTER * h, false);
                step(tick, s, OUTER * h, false);
            } else if (s.isNet) {
                solve.step(h, k == sub.count * parts - 1);
            } else {
                step(tick, s, h, false);
            }
            if (s.keeps && !solve.flows()) {
                energy.settle(tick, s, false);
            }
            solve.reconsider();
        }
        solve.finish();
    }

    private static boolean isReversible(SolverContext tick, Assembly s) {
        if (!s.isRigid) {
            return false;
        }
        for (int i : s.body) {
            if (tick.bodies.motionFlags[i] != 0) {
                return false;
            }
        }
        return true;
    }

    /**
     * A sub-step of a taut assembly that touches something, in smaller steps: contacts push at its
     * begin, weight and joints act on the way. Where it leads is kept until {@link #place}.
     */
    public void cross(SolverContext tick, SubStep sub, JointStore store, Assembly s) {
        solve.open(tick, sub, store, s);
        solve.release();
        last = 0;
        double begun = s.time;
        SolverBodies body = tick.body;
        double h = sub.seconds;
        double[] g = tick.gravity;
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int o = SolverBodies.offset(i);
            int at = Assembly.CARRIED * n;
            System.arraycopy(body.state, o, s.carried, at, SolverBodies.STRIDE);
            System.arraycopy(body.mark, (i + 1) * SolverBodies.HALF, s.carried, at + 16, 6);
            System.arraycopy(body.warm, (i + 1) * SolverBodies.HALF, s.carried, at + 22, 6);
            System.arraycopy(
                    body.root, (i + 1) * SolverBodies.ROOT, s.carried, at + 28, SolverBodies.ROOT);
            turn(tick.bodies, i, s.carried, at + 40);
            Arrays.fill(
                    body.warm, (i + 1) * SolverBodies.HALF, (i + 1) * SolverBodies.HALF + 6, 0.0);
            Motion.kick(tick.bodies, body, i, g[0], g[1], g[2], -h);
        }
        for (int n = 0; n < s.parts; n++) {
            step(tick, s, h / s.parts, true);
        }
        for (int n = 0; n < s.body.length; n++) {
            leave(tick, s, n);
        }
        s.time = begun;
        s.isFresh = false;
    }

    private static void turn(BodyStore b, int i, double[] into, int at) {
        into[at] = b.orientationX[i];
        into[at + 1] = b.orientationY[i];
        into[at + 2] = b.orientationZ[i];
        into[at + 3] = b.orientationW[i];
    }

    /** Puts a body back to the sub-step's begin, and keeps where it came to. */
    private static void leave(SolverContext tick, Assembly s, int n) {
        SolverBodies body = tick.body;
        BodyStore b = tick.bodies;
        int i = s.body[n];
        int o = SolverBodies.offset(i);
        int at = Assembly.CARRIED * n;
        double x = body.world(i, o + 3, 0);
        double y = body.world(i, o + 3, 1);
        double z = body.world(i, o + 3, 2);
        System.arraycopy(
                s.carried, at + 28, body.root, (i + 1) * SolverBodies.ROOT, SolverBodies.ROOT);
        body.weigh(i, x, y, z);
        // what contacts will have done is still the velocity less the mark
        for (int c = 0; c < 6; c++) {
            s.carried[at + 16 + c] += body.state[o + c] - s.carried[at + c];
        }
        for (int c = 0; c < SolverBodies.STRIDE; c++) {
            double start = s.carried[at + c];
            s.carried[at + c] = body.state[o + c];
            body.state[o + c] = start;
        }
        s.carried[at + SolverBodies.LOADED] = body.state[o + SolverBodies.LOADED];
        System.arraycopy(s.carried, at + 22, body.warm, (i + 1) * SolverBodies.HALF, 6);
        double qx = s.carried[at + 40];
        double qy = s.carried[at + 41];
        double qz = s.carried[at + 42];
        double qw = s.carried[at + 43];
        turn(b, i, s.carried, at + 40);
        b.orientationX[i] = qx;
        b.orientationY[i] = qy;
        b.orientationZ[i] = qz;
        b.orientationW[i] = qw;
    }

    /** After the bodies were moved: those of a taut assembly come to where {@link #cross} led. */
    public static void place(SolverContext tick, Assembly s) {
        for (int n = 0; n < s.body.length && s.parts > 1; n++) {
            int i = s.body[n];
            int at = Assembly.CARRIED * n;
            System.arraycopy(
                    s.carried, at, tick.body.state, SolverBodies.offset(i), SolverBodies.STRIDE);
            System.arraycopy(s.carried, at + 16, tick.body.mark, (i + 1) * SolverBodies.HALF, 6);
            tick.bodies.orientationX[i] = s.carried[at + 40];
            tick.bodies.orientationY[i] = s.carried[at + 41];
            tick.bodies.orientationZ[i] = s.carried[at + 42];
            tick.bodies.orientationW[i] = s.carried[at + 43];
        }
    }

    private void step(SolverContext tick, Assembly s, double h, boolean isStruck) {
        double[] g = tick.gravity;
        for (int i : s.body) {
            Motion.kick(tick.bodies, tick.body, i, g[0], g[1], g[2], h);
        }
        solve.start(!s.isDirect ? 1 : s.isRigid && last != 0 ? h / last : 0);
        last = h;
        solve.position(h, true);
        for (int i : s.body) {
            JointSolve.renew(tick, i);
        }
        solve.beginVelocity(true);
        solve.velocity(h, true, isStruck);
    }
}
