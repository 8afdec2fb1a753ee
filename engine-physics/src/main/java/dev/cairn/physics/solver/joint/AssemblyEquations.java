package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.tuning.Tuning;

import java.util.Arrays;

/**
 * The equations of an assembly: its rows in the present poses, and the linear system that says with
 * which impulses they hold, {@code (J M^-1 J^T + E) l = r}. Each row yields by {@code E}, {@link
 * #SLACK} of its own inverse mass, so that rows that depend on each other share a load.
 */
abstract class AssemblyEquations {
    private static final double SLACK = 1e-10;

    /** The same where Newton's method fails, and where gaps are closed aside. */
    static final double SOFT = 2e-6;

    static final SolverContext NONE = new SolverContext(Tuning.DEFAULT);
    static final Assembly EMPTY =
            new Assembly(
                    new int[0],
                    new int[0],
                    new int[0],
                    new int[0],
                    false,
                    new double[0],
                    new double[0]);

    final JointMath math = new JointMath();
    private final MovingPartner partner = new MovingPartner();
    SolverContext tick = NONE;
    Assembly s = EMPTY;
    JointStore store = new JointStore();

    /** Length of the half's sub-step, s. */
    double h;

    /** Whether what is solved for is a way that bodies are moved, and no impulse. */
    boolean isClosing;

    int offset(int joint, int side) {
        int i = s.end[2 * joint + side];
        return i < 0 ? 0 : SolverBodies.offset(s.body[i]);
    }

    /** Rows of the present poses. */
    void derive() {
        if (s.isFresh) {
            return;
        }
        math.at(s.carriedRoot > 0 ? s.time : 0, tick.step);
        for (int k = 0; k < s.joint.length; k++) {
            int j = s.joint[k];
            math.look(tick.bodies, tick.body.state, store, j, offset(k, 0), offset(k, 1));
            math.advance(store, j);
            System.arraycopy(math.armB, 0, s.arm, 3 * k, 3);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = store.firstRow[j] + r - s.firstRow[k];
                s.start[r] = math.measure(store, j, store.law[row]);
                math.derive(store, j, store.law[row], s.derivative, JointMath.JACOBIAN * r);
                s.compliance[r] = scale(r, 0, offset(k, 0)) + scale(r, 6, offset(k, 1));
            }
        }
        s.isFresh = true;
        s.isFactored = false;
    }

    /**
     * Scales the derivatives of a row for one body; its share in the row's inverse mass. An axis
     * along which the body may not move has none.
     */
    double scale(int r, int side, int o) {
        int at = JointMath.JACOBIAN * r + side;
        if (o == 0) {
            Arrays.fill(s.scaled, at, at + 6, 0.0);
            return 0;
        }
        double[] d = s.derivative;
        double root = Math.sqrt(tick.body.state[o + SolverBodies.MASS]);
        double[] l = tick.body.root;
        int q = o / SolverBodies.STRIDE * SolverBodies.ROOT;
        int locks = tick.bodies.motionFlags[SolverBodies.slot(o)];
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            s.scaled[at + c] = (locks >> c & 1) != 0 ? 0 : root * d[at + c];
            s.scaled[at + 3 + c] =
                    l[q + c] * d[at + 3] + l[q + 3 + c] * d[at + 4] + l[q + 6 + c] * d[at + 5];
            sum += s.scaled[at + c] * s.scaled[at + c];
            sum += s.scaled[at + 3 + c] * s.scaled[at + 3 + c];
        }
        return sum;
    }

    /** Adds an impulse of a row to the velocities. It is no part of the warm start. */
    void push(int k, int r, double impulse) {
        if (impulse == 0) {
            return;
        }
        for (int side = 0; side < 2; side++) {
            int o = offset(k, side);
            if (o > 0) {
                double l = side == 0 ? -impulse : impulse;
                int at = JointMath.JACOBIAN * r + 6 * side;
                double root = l * Math.sqrt(tick.body.state[o + SolverBodies.MASS]);
                for (int c = 0; c < 3; c++) {
                    change(o, c, root * s.scaled[at + c]);
                    change(o, 3 + c, l * s.scaled[at + 3 + c]);
                }
            }
        }
    }

    void change(int o, int c, double value) {
        tick.body.state[o + c] += value;
        tick.body.mark[o / SolverBodies.STRIDE * SolverBodies.HALF + c] += value;
    }

    /** {@code J v}, that of kinematic partners included. */
    double speed(int k, int r) {
        double[] v = tick.body.state;
        double sum = 0;
        for (int side = 0; side < 2; side++) {
            int o = offset(k, side);
            int at = JointMath.JACOBIAN * r + 6 * side;
            double part = o == 0 ? partnerSpeed(k, side, at) : 0;
            for (int c = 0; c < 3; c++) {
                part += s.derivative[at + c] * v[o + c] + s.scaled[at + 3 + c] * v[o + 3 + c];
            }
            sum += side == 0 ? -part : part;
        }
        return sum;
    }

    /** What a kinematic partner adds to the speed of a row, at its derivatives. */
    private double partnerSpeed(int k, int side, int at) {
        int i = side == 0 ? store.bodyA[s.joint[k]] : store.bodyB[s.joint[k]];
        if (s.carriedRoot == 0 || !tick.bodies.isMoved(i)) {
            return 0;
        }
        partner.speed(tick.bodies, i, s.time, tick.step);
        double sum = 0;
        for (int c = 0; c < 6; c++) {
            sum += s.derivative[at + c] * partner.velocity[c];
        }
        return sum;
    }

    /** Makes the factors, if rows, or which of them hold, have changed. */
    void factor(boolean moves) {
        boolean same = s.isFactored;
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                double p = s.isActive[r] ? -give(k, r, moves) - slack(k, r) * s.compliance[r] : -1;
                same &= s.pivot[r] == p;
                s.pivot[r] = p;
            }
        }
        if (same) {
            return;
        }
        s.isFactored = true;
        if (!s.isDirect) {
            s.gradients.factor(s);
            return;
        }
        BlockFactors f = s.factors;
        f.begin(s.body.length);
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int node = s.body.length + k;
                int row = r - s.firstRow[k];
                f.pivot(node, row, s.pivot[r]);
                for (int side = 0; side < 2 && s.isActive[r]; side++) {
                    if (s.end[2 * k + side] >= 0) {
                        int at = JointMath.JACOBIAN * r + 6 * side;
                        f.couple(node, row, s.end[2 * k + side], s.scaled, at, side == 0 ? 1 : -1);
                    }
                }
            }
        }
        f.factor();
    }

    /** A motor that is not at its most keeps its speed. */
    double slack(int k, int r) {
        boolean isHard = s.approximateSteps == 0 && !isClosing;
        return isHard || store.role[row(k, r)] >= JointStore.MOTOR ? SLACK : SOFT;
    }

    /** {@code 1/(h (h k/4 + d/2))} of a spring. */
    double give(int k, int r, boolean moves) {
        int row = row(k, r);
        return moves && store.role[row] == JointStore.SPRING
                ? 1 / (h * (0.25 * h * stiffness(r, row) + 0.5 * damping(r, row)))
                : 0;
    }

    int row(int k, int r) {
        return store.firstRow[s.joint[k]] + r - s.firstRow[k];
    }

    double stiffness(int r, int row) {
        return stiffness(store, row, s.compliance[r]);
    }

    double damping(int r, int row) {
        return damping(store, row, s.compliance[r]);
    }

    /** {@code k = m w²}, N/m or N m/rad. */
    static double stiffness(JointStore store, int row, double compliance) {
        double f = 2 * Math.PI * store.stiffness[row];
        return store.isAbsolute[row] ? store.stiffness[row] : f * f / compliance;
    }

    /** {@code d = 2 z m w}, N s/m or N m s/rad. */
    static double damping(JointStore store, int row, double compliance) {
        double f = 2 * Math.PI * store.stiffness[row];
        return store.isAbsolute[row] ? store.damping[row] : 2 * store.damping[row] * f / compliance;
    }

    /** Solves for right-hand sides that are in {@link Assembly#now}. */
    void solve() {
        Assembly.Matrix f = s.system;
        double[] x = f.x();
        for (int i = 0; i < s.body.length; i++) {
            int u = f.unknown(i);
            Arrays.fill(x, u, u + BlockFactors.BODY, 0.0);
        }
        for (int k = 0; k < s.joint.length; k++) {
            int u = f.unknown(s.body.length + k);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                x[u + r - s.firstRow[k]] = s.isActive[r] ? s.now[r] : 0;
            }
        }
        if (s.isDirect) {
            s.factors.solve();
        } else {
            s.gradients.solve(s);
        }
    }

    /** The same, and adds the impulses. */
    void correct() {
        solve();
        addImpulses();
    }

    /** Adds the impulses of the solution. */
    void addImpulses() {
        Assembly.Matrix f = s.system;
        for (int k = 0; k < s.joint.length; k++) {
            int u = f.unknown(s.body.length + k);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                if (s.isActive[r]) {
                    double l = f.x()[u + r - s.firstRow[k]];
                    s.impulse[r] += l;
                    push(k, r, l);
                }
            }
        }
    }

    /**
     * Takes from the impulses of loops what cancels out. Where rows depend on each other Newton's
     * rounds leave impulses {@code n} with {@code J^T n = 0}, of any size: what the trial movement
     * missed in such a direction, over the slack. They do nothing, but tell of a tension that is
     * not there. With {@code A = J M^-1 J^T}
     *
     * <pre>
     * l' = (A + E)^-1 A l = l - (A + E)^-1 E l
     * </pre>
     *
     * <p>is the smallest impulse that does the same; twice, as the system is solved to 1e-6 only.
     */
    void relieve(boolean moves) {
        for (int round = 0; round < 2 && s.isLooped && s.isDirect; round++) {
            factor(moves);
            for (int k = 0; k < s.joint.length; k++) {
                for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                    s.now[r] = slack(k, r) * s.compliance[r] * s.impulse[r];
                }
            }
            solve();
            for (int k = 0; k < s.joint.length; k++) {
                int u = s.system.unknown(s.body.length + k);
                for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                    s.impulse[r] += s.isActive[r] ? s.system.x()[u + r - s.firstRow[k]] : 0;
                }
            }
        }
    }

    /** Takes the impulses back. */
    void release() {
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                set(k, r, 0);
            }
        }
    }

    /**
     * Adds the forces that the impulses of a half stand for to those of its joints, in the poses in
     * which its rows were derived: those of the halves lie about the middle of the sub-step.
     */
    void react() {
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = JointMath.JACOBIAN * r;
                double force = s.impulse[r] / h;
                int at = 6 * s.joint[k];
                JointMath.react(s.derivative, row, force, s.arm, 3 * k, store.reaction, at);
            }
        }
    }

    double kinetic() {
        return JointEnergy.kinetic(tick, s);
    }

    void set(int k, int r, double impulse) {
        push(k, r, impulse - s.impulse[r]);
        s.impulse[r] = impulse;
    }
}
