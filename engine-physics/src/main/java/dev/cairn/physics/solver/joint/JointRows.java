package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.row.KindRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

import java.util.Arrays;

/**
 * Joints that are swept, as contacts are: those of nets so dense that factors would not pay. A
 * joint's rows are solved one after the other, a few times; the bias pass closes a share of each
 * gap, the relax pass takes back the speed of that.
 *
 * <p>Joints of assemblies that are solved directly have places here, too, and are passed by.
 */
public final class JointRows implements KindRows {
    private static final int LINK = 3;

    /** Sweeps over the rows of one joint. */
    private static final int INNER = 3;

    /** Share of a gap that a sub-step closes. */
    private static final double CLOSES = 0.3;

    private final JointStore store;
    private final boolean isSingle;
    private int[] link = {};
    private JointMath[] math = {};

    /** By row of the store: derivatives, what it measures, and its inverse mass. */
    private double[] derivative = {};

    private double[] value = {};
    private double[] compliance = {};

    /** Rows of one precision. */
    public JointRows(JointStore store, boolean isSingle) {
        this.store = store;
        this.isSingle = isSingle;
    }

    @Override
    public int group() {
        return 1;
    }

    @Override
    public void ensurePlaces(int places) {
        if (LINK * places > link.length) {
            int n = places + places / 2;
            link = new int[LINK * n];
            math = Arrays.copyOf(math, n);
        }
        if (places > 0 && store.rowCount > value.length) {
            int n = store.law.length;
            value = new double[n];
            compliance = new double[n];
            derivative = new double[JointMath.JACOBIAN * n];
        }
    }

    @Override
    public void bind(int place, int source, int offsetA, int offsetB, int variant) {
        link[LINK * place] = offsetA;
        link[LINK * place + 1] = offsetB;
        link[LINK * place + 2] = store.isDirect[source] ? -1 : source;
        if (!store.isDirect[source] && math[place] == null) {
            math[place] = new JointMath();
        }
    }

    @Override
    public void pad(int place) {
        link[LINK * place + 2] = -1;
    }

    @Override
    public void prepare(SolverContext tick, SubStep sub, int from, int to) {
        for (int p = from; p < to; p++) {
            int j = link[LINK * p + 2];
            if (j < 0) {
                continue;
            }
            look(tick, p, j);
            for (int r = store.firstRow[j]; r < store.firstRow[j] + store.rows[j]; r++) {
                double last = (store.before[r] + store.after[r]) * sub.fillScale;
                store.after[r] = 0;
                store.before[r] = last;
                push(tick.body, p, r, last, true);
            }
        }
    }

    private void look(SolverContext tick, int p, int j) {
        int a = link[LINK * p];
        int b = link[LINK * p + 1];
        math[p].look(tick.bodies, tick.body.state, store, j, a, b);
        math[p].advance(store, j);
        for (int r = store.firstRow[j]; r < store.firstRow[j] + store.rows[j]; r++) {
            value[r] = math[p].measure(store, j, store.law[r]);
            math[p].derive(store, j, store.law[r], derivative, JointMath.JACOBIAN * r);
            compliance[r] = weigh(tick.body, r, 0, a) + weigh(tick.body, r, 6, b);
        }
    }

    /** Replaces a torque by its scaled one; the inverse mass of the row at one body. */
    private double weigh(SolverBodies body, int r, int side, int o) {
        int at = JointMath.JACOBIAN * r + side;
        double[] d = derivative;
        if (o == 0) {
            Arrays.fill(d, at, at + 6, 0.0);
            return 0;
        }
        double[] l = body.root;
        int q = o / SolverBodies.STRIDE * SolverBodies.ROOT;
        double x = d[at + 3];
        double y = d[at + 4];
        double z = d[at + 5];
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            d[at + 3 + c] = l[q + c] * x + l[q + 3 + c] * y + l[q + 6 + c] * z;
            sum += d[at + 3 + c] * d[at + 3 + c];
            sum += body.state[o + SolverBodies.MASS] * d[at + c] * d[at + c];
        }
        return sum;
    }

    @Override
    public void bias(SolverContext tick, SubStep sub, int from, int to, Scratch scratch) {
        sweep(tick, sub, from, to, true);
    }

    @Override
    public void relax(SolverContext tick, SubStep sub, int from, int to, Scratch scratch) {
        sweep(tick, sub, from, to, false);
    }

    private void sweep(SolverContext tick, SubStep sub, int from, int to, boolean moves) {
        for (int p = from; p < to; p++) {
            int j = link[LINK * p + 2];
            if (j < 0) {
                continue;
            }
            look(tick, p, j);
            for (int sweep = 0; sweep < INNER; sweep++) {
                for (int r = store.firstRow[j]; r < store.firstRow[j] + store.rows[j]; r++) {
                    if (compliance[r] > 0) {
                        row(tick, sub, p, r, moves);
                    }
                }
            }
        }
    }

    private void row(SolverContext tick, SubStep sub, int p, int r, boolean moves) {
        double h = sub.seconds;
        double old = store.before[r];
        double v = speed(tick.body, p, r);
        double most = h * store.most[r];
        double l =
                switch (store.role[r]) {
                    case JointStore.MOTOR ->
                            within(old - (v - store.target[r]) / compliance[r], most);
                    case JointStore.SPRING -> {
                        double k = h * AssemblyEquations.stiffness(store, r, compliance[r]);
                        double d = AssemblyEquations.damping(store, r, compliance[r]) + h * k;
                        double way = value[r] - store.target[r];
                        way = JointMath.isAngle(store.law[r]) ? Angles.wrap(way) : way;
                        // l = -k way - d v, v after the impulse
                        double after = old + (-k * way - d * v - old) / (1 + d * compliance[r]);
                        yield moves ? within(after, left(link[LINK * p + 2], r, most)) : old;
                    }
                    case JointStore.LIMIT -> limit(sub, r, v, old, moves);
                    default ->
                            old
                                    - (v + bias(sub, value[r] - store.target[r], moves))
                                            / compliance[r];
                };
        store.before[r] = l;
        push(tick.body, p, r, l - old, false);
    }

    private static double within(double x, double most) {
        return Math.max(-most, Math.min(most, x));
    }

    /** What the other springs along x, y and z leave of a force that they have together. */
    private double left(int j, int r, double most) {
        if (!store.isRound[j] || store.law[r] >= JointStore.TURN) {
            return most;
        }
        double square = most * most;
        for (int i = store.firstRow[j]; i < store.firstRow[j] + store.rows[j]; i++) {
            boolean isOther = i != r && store.role[i] == JointStore.SPRING;
            if (isOther && store.law[i] < JointStore.TURN) {
                square -= store.before[i] * store.before[i];
            }
        }
        return Math.sqrt(Math.max(0, square));
    }

    private double limit(SubStep sub, int r, double v, double old, boolean moves) {
        double low = value[r] - store.lower[r];
        double high = value[r] - store.upper[r];
        boolean isLow = low <= -high;
        double past = isLow ? low : high;
        boolean isOpen = isLow ? past > 0 : past < 0;
        double rate = isOpen ? past * sub.inverse : bias(sub, past, moves);
        double l = old - (v + rate) / compliance[r];
        return isLow ? Math.max(0, l) : Math.min(0, l);
    }

    private static double bias(SubStep sub, double gap, boolean moves) {
        double rate = CLOSES * gap * sub.inverse;
        return moves ? Math.max(-sub.pushSpeed, Math.min(sub.pushSpeed, rate)) : 0;
    }

    private double speed(SolverBodies body, int p, int r) {
        double sum = 0;
        for (int side = 0; side < 2; side++) {
            int o = link[LINK * p + side];
            int at = JointMath.JACOBIAN * r + 6 * side;
            double part = 0;
            for (int c = 0; c < 6; c++) {
                part += derivative[at + c] * (isSingle ? body.floats[o + c] : body.state[o + c]);
            }
            sum += side == 0 ? -part : part;
        }
        return sum;
    }

    /** Adds an impulse to velocities, or to the warm start. */
    private void push(SolverBodies body, int p, int r, double impulse, boolean warm) {
        for (int side = 0; side < 2; side++) {
            int o = link[LINK * p + side];
            if (o == 0) {
                continue;
            }
            double l = side == 0 ? -impulse : impulse;
            int at = JointMath.JACOBIAN * r + 6 * side;
            for (int c = 0; c < 6; c++) {
                double v = l * derivative[at + c];
                v *= c < 3 ? body.state[o + SolverBodies.MASS] : 1;
                if (warm) {
                    body.warm[o / SolverBodies.STRIDE * SolverBodies.HALF + c] += v;
                } else if (isSingle) {
                    body.floats[o + c] += (float) v;
                } else {
                    body.state[o + c] += v;
                }
            }
        }
    }

    @Override
    public void store(SolverContext tick, SubStep sub, int from, int to) {
        for (int p = from; p < to; p++) {
            int j = link[LINK * p + 2];
            if (j < 0) {
                continue;
            }
            look(tick, p, j);
            Arrays.fill(store.reaction, 6 * j, 6 * j + 6, 0.0);
            for (int r = store.firstRow[j]; r < store.firstRow[j] + store.rows[j]; r++) {
                math[p].derive(store, j, store.law[r], derivative, JointMath.JACOBIAN * r);
                double force = store.before[r] * sub.inverse;
                math[p].react(derivative, JointMath.JACOBIAN * r, force, store.reaction, 6 * j);
            }
        }
    }
}
