package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.Rotation;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.joint.net.NetBodies;
import dev.cairn.physics.solver.joint.net.PointNet;

import java.util.Arrays;

/**
 * The halves of a sub-step of a {@link PointNet}, by the same steps as {@link JointSolve} does them
 * for rows of any kind: one round of Newton's method before the bodies move, what is open closed
 * aside, and what joints do not allow taken from the velocities.
 *
 * <p>One to a worker. Does not allocate.
 */
final class NetSolve {
    /** What is missing by less than this share of a body's size is no matter. */
    private static final double CLOSED = 1e-13;

    /** The same of gaps that are closed aside, in nets that have factors to compare with. */
    private static final double NEARLY = 1e-9;

    /** The same in nets that have none: a thousandth of what anybody sees. */
    private static final double LOOSELY = 1e-6;

    /**
     * Share of its own inverse mass by which a row yields. What Newton's method lacks in directions
     * that hardly move any body asks for impulses that a few rounds do not find, and warm starts
     * heap up what they do find: with 1e-10 a net of unlike balls came apart.
     */
    private static final double SLACK = 1e-3;

    /** A few rounds do not find how bodies share a load whose masses differ by more. */
    private static final double ALIKE = 2;

    /**
     * Of its smallest body: a net with wider gaps is given to factors, if there are any; if not, it
     * gets both halves of each step.
     */
    private static final double OPEN = 1e-5;

    private final InnerMotion inner = new InnerMotion();
    private final JointMath math = new JointMath();
    private SolverContext tick;
    private JointStore store;
    private Assembly s;
    private PointNet net;

    /** Speed at which gaps are closed, m/s. */
    private double push;

    /** Energy of motion that a half has begun with, J. */
    private double motion;

    /** Halves of a step that the impulses in work are those of. */
    private double halves = 1;

    /**
     * Whether a tick of what touches nothing is under way: impulses that are kept are in the axes
     * of the world, and arms and gaps go with the bodies.
     */
    private boolean flies;

    /** Whether the last step was left without its velocity half. */
    private boolean flows;

    NetSolve(SolverContext tick, JointStore store, Assembly none) {
        this.tick = tick;
        this.store = store;
        s = none;
        net = none.net;
    }

    void open(SolverContext context, JointStore joints, Assembly assembly, double pushSpeed) {
        tick = context;
        store = joints;
        s = assembly;
        net = assembly.net;
        push = pushSpeed;
        halves = 1;
        flies = false;
        flows = false;
    }

    /** Begin of a tick: whether the assembly is a net of balls now, and if so, its numbers. */
    boolean begin() {
        double size = Double.POSITIVE_INFINITY;
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        for (int i : s.body) {
            if (!tick.body.axes.isIsotropic(i) || tick.bodies.motionFlags[i] != 0) {
                return false;
            }
            size = Math.min(size, tick.bodies.outerRadius[i]);
            double inverse = tick.body.state[SolverBodies.offset(i) + SolverBodies.MASS];
            least = Math.min(least, inverse);
            most = Math.max(most, inverse);
        }
        if (s.hasFactors && most > ALIKE * least) {
            return false;
        }
        s.size = size;
        net.bodies.begin(tick);
        for (int p = 0; p < net.joint.length; p++) {
            look(p);
        }
        return true;
    }

    /** Begin of a tick: distance, static bodies, and last impulses of a joint. */
    private void look(int p) {
        int k = net.joint[p];
        int j = s.joint[k];
        int a = store.bodyA[j];
        int b = store.bodyB[j];
        net.apart[3 * p] = tick.bodies.apartX(a, b);
        net.apart[3 * p + 1] = tick.bodies.apartY(a, b);
        net.apart[3 * p + 2] = tick.bodies.apartZ(a, b);
        boolean isA = s.end[2 * k] < 0;
        if (isA || s.end[2 * k + 1] < 0) {
            int o = isA ? 0 : SolverBodies.offset(s.body[s.end[2 * k]]);
            int q = isA ? SolverBodies.offset(s.body[s.end[2 * k + 1]]) : 0;
            math.look(tick.bodies, tick.body.state, store, j, o, q);
            System.arraycopy(isA ? math.armA : math.armB, 0, net.local, 6 * p + (isA ? 0 : 3), 3);
        }
        int row = store.firstRow[j];
        for (int r = 0; r < 3 && isA; r++) {
            int e = 3 * (store.law[row + r] - JointStore.SLIDE);
            System.arraycopy(math.axesA, e, net.axes, 9 * p + 3 * r, 3);
        }
        net.fill(store.before, row, net.before, p);
        net.fill(store.after, row, net.after, p);
    }

    /** Whether the last sub-step has left a joint farther open than factors would. */
    boolean isOpen() {
        double worst = 0;
        for (double gap : net.gap) {
            worst = Math.max(worst, Math.abs(gap));
        }
        return !(worst <= OPEN * s.size);
    }

    /** Gives the impulses back to the rows. */
    void end() {
        s.judge(isOpen());
        if (flies) {
            net.bodies.look(tick);
            net.inward(net.before, net.before);
            net.inward(net.after, net.after);
            flies = false;
        }
        for (int p = 0; p < net.joint.length; p++) {
            int row = store.firstRow[s.joint[net.joint[p]]];
            net.give(net.before, p, store.before, row);
            net.give(net.after, p, store.after, row);
        }
    }

    // What touches nothing
    // -------------------------------------------------------------------------

    /**
     * A step of what touches nothing.
     *
     * <p>What its velocity half would take from the velocities the position half of the next step
     * takes, too, as both push along {@code J(x')^T}: all positions are the same without it
     * (RATTLE's are SHAKE's). So it is left out where velocities are not seen, but in nets that
     * whip, which two halves keep closer together, and in those that are compared with factors.
     */
    void step(double h, boolean isLast) {
        NetBodies bodies = net.bodies;
        takeOff();
        if (!flows) {
            bodies.take(tick);
            multiply(net.before, 1, net.impulse);
            net.apply(net.impulse);
        }
        halves = flows ? 2 : 1;
        bodies.kick(h);
        start(JointWork.GAIN);
        solvePosition(h, JointWork.GAIN);
        if (isLast) {
            react(1 / (halves * h), false);
        }
        bodies.move(tick);
        double worst = net.follow(2 / halves);
        s.isFactored = false;
        flows = !isLast && !s.hasFactors && worst <= OPEN * s.size;
        if (flows) {
            return;
        }
        multiply(net.impulse, 0.5, net.before);
        if (halves == 1) {
            net.follow(net.after);
        }
        multiply(halves > 1 ? net.before : net.after, 1, net.impulse);
        net.apply(net.impulse);
        start(s.keeps ? JointWork.GAIN : Double.POSITIVE_INFINITY);
        solveVelocity(h);
        multiply(net.impulse, 1, net.after);
        if (isLast) {
            react(1 / h, true);
        }
        bodies.give(tick);
    }

    /** Whether the last step was left without its velocity half. */
    boolean flows() {
        return flows;
    }

    private void takeOff() {
        if (flies) {
            return;
        }
        flies = true;
        derive();
        net.outward(net.before, net.before, 1);
        net.outward(net.after, net.after, 1);
        for (int i : s.body) {
            tick.body.state[SolverBodies.offset(i) + SolverBodies.LOADED] = 0;
        }
    }

    private static void multiply(double[] from, double factor, double[] into) {
        for (int r = 0; r < into.length; r++) {
            into[r] = factor * from[r];
        }
    }

    // With contacts
    // --------------------------------------------------------------------------------

    /** The impulses of the last sub-step, unless they add too much energy. */
    void warm(double scale, double gain) {
        derive();
        net.bodies.take(tick);
        net.outward(net.before, net.impulse, scale);
        net.apply(net.impulse);
        start(gain);
        net.bodies.give(tick);
    }

    /** The position half; others move the bodies. */
    void position(double h, double gain) {
        derive();
        net.bodies.take(tick);
        motion = net.bodies.kinetic();
        solvePosition(h, gain);
        net.bodies.give(tick);
        net.inward(net.impulse, net.before);
        react(1 / h, false);
    }

    /**
     * After the bodies have moved.
     *
     * @param isWarm whether to begin with the impulses of the last sub-step
     */
    void beginVelocity(boolean isWarm, double gain) {
        s.isFresh = false;
        derive();
        if (isWarm) {
            net.bodies.take(tick);
            net.outward(net.after, net.impulse, 1);
            net.apply(net.impulse);
            start(gain);
            net.bodies.give(tick);
        } else {
            Arrays.fill(net.impulse, 0.0);
        }
    }

    /** The velocity half. */
    void velocity(double h, boolean counts) {
        net.bodies.take(tick);
        solveVelocity(h);
        net.bodies.give(tick);
        if (counts) {
            net.inward(net.impulse, net.after);
            react(1 / h, true);
        }
    }

    // Both
    // -----------------------------------------------------------------------------------------

    /** Begins with the impulses in work, which have been applied, unless they add energy. */
    private void start(double gain) {
        double most = gain * net.bodies.kinetic();
        net.bodies.add(1);
        motion = net.bodies.kinetic();
        if (!(motion <= most)) {
            release();
            motion = net.bodies.kinetic();
        }
    }

    private void release() {
        net.apply(net.impulse);
        net.bodies.add(-1);
        Arrays.fill(net.impulse, 0.0);
    }

    /** Arms and gaps in the poses of now. */
    private void derive() {
        if (!s.isFresh) {
            net.derive(tick);
            s.isFresh = true;
            s.isFactored = false;
        }
    }

    private void correct() {
        net.solve(SLACK, s.isFactored, true);
        s.isFactored = true;
    }

    /** One round of Newton's method; how bodies will move then is foreseen. */
    private void solvePosition(double h, double gain) {
        net.bodies.foresee(tick, h);
        double worst = net.foresee(h, HoldingRows.tiny(false));
        if (!(worst <= CLOSED * s.size)) {
            correct();
            if (!(net.bodies.kinetic() <= gain * motion)) {
                release();
            }
            net.bodies.foresee(tick, h);
        }
    }

    /** Takes from the velocities what the joints do not allow. */
    private void solveVelocity(double h) {
        close(h);
        if (!(net.speeds() * Math.abs(h) <= CLOSED * s.size)) {
            correct();
        }
    }

    /** Forces that joints were seen to bear. */
    private void react(double scale, boolean adds) {
        for (int p = 0; p < net.joint.length; p++) {
            int at = 6 * s.joint[net.joint[p]];
            for (int c = 0; c < 3; c++) {
                double first = adds ? store.reaction[at + c] : 0;
                store.reaction[at + c] = first + scale * net.impulse[3 * p + c];
                store.reaction[at + 3 + c] = 0;
            }
        }
    }

    /** Closes what is open by moving bodies, without any speed; see {@link PositionCorrection}. */
    private void close(double h) {
        double reach = push * Math.abs(h);
        double worst = 0;
        for (int r = 0; r < net.missing.length; r++) {
            double gap = HoldingRows.within(net.gap[r], reach);
            worst = Math.max(worst, Math.abs(gap));
            net.missing[r] = -gap;
        }
        if (!(worst > (s.hasFactors ? NEARLY : LOOSELY) * s.size)) {
            return;
        }
        if (!s.isGrounded) {
            net.bodies.give(tick);
            inner.note(tick, s);
        }
        net.solve(AssemblyEquations.SOFT, s.isFactored, false);
        shift(reach);
        s.isFresh = false;
        derive();
        s.isFactored = worst <= OPEN * s.size; // they have hardly moved
        if (!s.isGrounded) {
            inner.giveBack(tick, s);
            net.bodies.take(tick);
        }
    }

    private void shift(double reach) {
        double part = 1;
        double[] x = net.bodies.sum;
        double turn = JointSolve.TURN_BACK / push * reach;
        for (int n = 0; n < s.body.length; n++) {
            int at = NetBodies.STRIDE * n;
            double way = SolverBodies.norm(x[at], x[at + 1], x[at + 2]);
            double angle = SolverBodies.norm(x[at + 3], x[at + 4], x[at + 5]);
            part = PositionCorrection.cut(part, way, reach);
            part = PositionCorrection.cut(part, angle, turn);
        }
        double[] v = tick.body.state;
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int at = NetBodies.STRIDE * n;
            int p = SolverBodies.offset(i) + SolverBodies.P;
            double root = tick.body.root[(i + 1) * SolverBodies.ROOT];
            for (int c = 0; c < 3; c++) {
                v[p + c] += part * x[at + c];
                v[p + 3 + c] += root > 0 ? part * x[at + 3 + c] / root : 0;
            }
            Rotation.turn(tick.bodies, i, part * x[at + 3], part * x[at + 4], part * x[at + 5]);
        }
    }
}
