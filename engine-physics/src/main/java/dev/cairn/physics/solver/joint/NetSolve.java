package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.Motion;
import dev.cairn.physics.solver.body.Rotation;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
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

    /** Halves of a step that the impulses in work are those of. */
    private double halves = 1;

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
        for (int n = 0; n < s.body.length; n++) {
            double root = tick.body.root[(s.body[n] + 1) * SolverBodies.ROOT];
            net.mass[n] = tick.body.state[SolverBodies.offset(s.body[n]) + SolverBodies.MASS];
            net.spin[n] = root * root;
        }
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
        return !(widest() <= OPEN * s.size);
    }

    private double widest() {
        double worst = 0;
        for (double gap : net.gap) {
            worst = Math.max(worst, Math.abs(gap));
        }
        return worst;
    }

    /** Gives the impulses back to the rows. */
    void end() {
        s.judge(isOpen());
        for (int p = 0; p < net.joint.length; p++) {
            int row = store.firstRow[s.joint[net.joint[p]]];
            net.give(net.before, p, store.before, row);
            net.give(net.after, p, store.after, row);
        }
    }

    /** The impulses of the last sub-step, unless they add too much energy. */
    void warm(double scale, double gain) {
        derive();
        halves = flows ? 2 : 1;
        start(net.before, halves * scale, gain);
    }

    /**
     * The position half of a step of what touches nothing ends. What its velocity half would take
     * from the velocities the position half of the next step takes, too, as both push along {@code
     * J(x')^T}: all positions are the same without it (RATTLE's are SHAKE's). So it is left out
     * where velocities are not seen, but in nets that whip, which two halves keep closer together,
     * and in those that are compared with factors.
     */
    void flow(boolean isLast) {
        flows = false;
        if (!isLast && !s.hasFactors) {
            s.isFresh = false;
            derive();
            flows = widest() <= OPEN * s.size;
        }
    }

    boolean flows() {
        return flows;
    }

    private void start(double[] first, double scale, double gain) {
        double most = gain * kinetic();
        net.warmStart(first, scale);
        net.apply(net.impulse);
        add(net.linear, net.angular, 1);
        if (!(kinetic() <= most)) {
            release();
        }
    }

    private void release() {
        net.apply(net.impulse);
        add(net.linear, net.angular, -1);
        Arrays.fill(net.impulse, 0.0);
    }

    private double kinetic() {
        return JointEnergy.kinetic(tick, s);
    }

    /** Adds changes of velocity. It is no part of the warm start. */
    private void add(double[] linear, double[] angular, double sign) {
        double[] v = tick.body.state;
        double[] mark = tick.body.mark;
        for (int n = 0; n < s.body.length; n++) {
            int o = SolverBodies.offset(s.body[n]);
            int w = (s.body[n] + 1) * SolverBodies.HALF;
            double root = tick.body.root[(s.body[n] + 1) * SolverBodies.ROOT];
            double inverse = root > 0 ? sign / root : 0;
            for (int c = 0; c < 3; c++) {
                double x = sign * linear[3 * n + c];
                double t = inverse * angular[3 * n + c];
                v[o + c] += x;
                mark[w + c] += x;
                v[o + 3 + c] += t;
                mark[w + 3 + c] += t;
            }
        }
    }

    /** Arms and gaps in the poses of now. */
    private void derive() {
        if (s.isFresh) {
            return;
        }
        where();
        net.derive(tick.bodies, s.body);
        s.isFresh = true;
        s.isFactored = false;
    }

    /** Where the bodies are now. */
    private void where() {
        for (int n = 0; n < s.body.length; n++) {
            int p = SolverBodies.offset(s.body[n]) + SolverBodies.P;
            System.arraycopy(tick.body.state, p, net.linear, 3 * n, 3);
        }
        Arrays.fill(net.linear, 3 * net.bodies, 3 * net.bodies + 3, 0.0);
    }

    private void factor(double slack) {
        net.factor(slack, s.isFactored);
        s.isFactored = true;
    }

    /** One round of Newton's method; moves the bodies if they are to stay. */
    void position(double h, boolean stay, double gain) {
        derive();
        double most = gain * kinetic();
        keep();
        move(h);
        where();
        net.look(tick.bodies, s.body);
        restore();
        double worst = 0;
        double tiny = HoldingRows.tiny(false);
        for (int r = 0; r < net.missing.length; r++) {
            double gap = net.gap[r];
            double miss = net.missing[r] - (Math.abs(gap) > tiny ? gap : 0);
            worst = Math.max(worst, Math.abs(miss));
            net.missing[r] = -miss / h;
        }
        if (!(worst <= CLOSED * s.size)) {
            correct();
            if (!(kinetic() <= most)) {
                release();
            }
        }
        if (stay) {
            move(h);
        }
        net.keep(net.before, 1 / halves);
        for (int p = 0; p < net.joint.length; p++) {
            int at = 6 * s.joint[net.joint[p]];
            for (int c = 0; c < 3; c++) {
                store.reaction[at + c] = net.impulse[3 * p + c] / (halves * h);
                store.reaction[at + 3 + c] = 0;
            }
        }
    }

    private void correct() {
        factor(SLACK);
        net.solve();
        for (int r = 0; r < net.impulse.length; r++) {
            net.impulse[r] += net.solution[r];
        }
        add(net.linearSum, net.angularSum, 1);
    }

    private void move(double h) {
        double[] g = tick.gravity;
        for (int i : s.body) {
            Motion.drift(tick.bodies, tick.body, i, g[0], g[1], g[2], h);
        }
    }

    private void keep() {
        BodyStore b = tick.bodies;
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int at = 10 * n;
            System.arraycopy(
                    tick.body.state, SolverBodies.offset(i) + SolverBodies.P, net.kept, at, 6);
            net.kept[at + 6] = b.orientationX[i];
            net.kept[at + 7] = b.orientationY[i];
            net.kept[at + 8] = b.orientationZ[i];
            net.kept[at + 9] = b.orientationW[i];
        }
    }

    private void restore() {
        BodyStore b = tick.bodies;
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int at = 10 * n;
            System.arraycopy(
                    net.kept, at, tick.body.state, SolverBodies.offset(i) + SolverBodies.P, 6);
            b.orientationX[i] = net.kept[at + 6];
            b.orientationY[i] = net.kept[at + 7];
            b.orientationZ[i] = net.kept[at + 8];
            b.orientationW[i] = net.kept[at + 9];
        }
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
            start(halves > 1 ? net.before : net.after, 1, gain);
        } else {
            Arrays.fill(net.impulse, 0.0);
        }
    }

    /** Takes from the velocities what the joints do not allow. */
    void velocity(double h, boolean counts) {
        close(h);
        double[] v = tick.body.state;
        for (int n = 0; n < s.body.length; n++) {
            int o = SolverBodies.offset(s.body[n]);
            double root = tick.body.root[(s.body[n] + 1) * SolverBodies.ROOT];
            for (int c = 0; c < 3; c++) {
                net.linear[3 * n + c] = v[o + c];
                net.angular[3 * n + c] = root * v[o + 3 + c];
            }
        }
        Arrays.fill(net.linear, 3 * net.bodies, 3 * net.bodies + 3, 0.0);
        Arrays.fill(net.angular, 3 * net.bodies, 3 * net.bodies + 3, 0.0);
        net.speeds(net.missing);
        double worst = 0;
        for (int r = 0; r < net.missing.length; r++) {
            worst = Math.max(worst, Math.abs(net.missing[r]));
            net.missing[r] = -net.missing[r];
        }
        if (!(worst * Math.abs(h) <= CLOSED * s.size)) {
            correct();
        }
        if (!counts) {
            return;
        }
        net.keep(net.after, 1);
        for (int p = 0; p < net.joint.length; p++) {
            int at = 6 * s.joint[net.joint[p]];
            for (int c = 0; c < 3; c++) {
                store.reaction[at + c] += net.impulse[3 * p + c] / h;
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
            inner.note(tick, s);
        }
        factor(AssemblyEquations.SOFT);
        net.solve();
        shift(reach);
        s.isFresh = false;
        derive();
        if (!s.isGrounded) {
            inner.giveBack(tick, s);
        }
    }

    private void shift(double reach) {
        double part = 1;
        double[] x = net.linearSum;
        double[] t = net.angularSum;
        double turn = JointSolve.TURN_BACK / push * reach;
        for (int n = 0; n < s.body.length; n++) {
            double way = SolverBodies.norm(x[3 * n], x[3 * n + 1], x[3 * n + 2]);
            double angle = SolverBodies.norm(t[3 * n], t[3 * n + 1], t[3 * n + 2]);
            part = PositionCorrection.cut(part, way, reach);
            part = PositionCorrection.cut(part, angle, turn);
        }
        double[] v = tick.body.state;
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int p = SolverBodies.offset(i) + SolverBodies.P;
            double root = tick.body.root[(i + 1) * SolverBodies.ROOT];
            for (int c = 0; c < 3; c++) {
                v[p + c] += part * x[3 * n + c];
                v[p + 3 + c] += root > 0 ? part * t[3 * n + c] / root : 0;
            }
            Rotation.turn(
                    tick.bodies, i, part * t[3 * n], part * t[3 * n + 1], part * t[3 * n + 2]);
        }
    }
}
