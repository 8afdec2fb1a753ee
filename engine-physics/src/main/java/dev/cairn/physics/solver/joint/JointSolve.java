package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.Motion;
import dev.cairn.physics.solver.body.Rotation;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.refresh.JacobianRefresh;
import dev.cairn.physics.solver.row.SubStep;
import dev.cairn.physics.tuning.Tuning;

import java.util.Arrays;

/**
 * A sub-step of an assembly, solved as a whole, by the scheme RATTLE.
 *
 * <p>With J the derivatives of what the rows measure, c,
 *
 * <pre>
 * position half:  v' = v + h a + M^-1 J(x)^T l,  x' = x + h (v' - h a/2),  c(x') = 0
 * velocity half:  v" = v' + M^-1 J(x')^T l',                              J(x') v" = 0
 * </pre>
 *
 * <p>where a is what gravity and forces do, and the turn of a body is its free rotation. The
 * impulses of the first half follow by Newton's method with the matrix of its start: each round
 * moves the bodies, measures, takes the movement back and solves for what is missing. It is
 * symplectic, of second order, keeps momentum, and closes joints to the last digits.
 *
 * <p>Limits and motors are equations as long as their impulse is one that they may have; which of
 * them hold is found by trial (active set). A spring is {@code l = -h/4 k (c + c') - d/2 (c' - c)},
 * half of the implicit midpoint rule, in each half.
 *
 * <p>Where loops close twice, rows depend on each other. Each row therefore yields by {@link
 * #SLACK} of its own inverse mass; Newton's rounds take out what that leaves, so it only decides
 * how dependent rows share a load.
 *
 * <p>Source: H. C. Andersen, "Rattle: a velocity version of the Shake algorithm" (1983). One to a
 * worker. Does not allocate.
 */
public final class JointSolve {
    /** Numbers to a body of {@link Assembly#kept}. */
    static final int KEPT = 22;

    private static final double SLACK = 1e-10;

    /** The same where Newton's method fails, see {@link #project}. */
    private static final double SOFT = 2e-6;

    /** Most sub-steps until Newton's method is tried again where it has failed. */
    static final int ROUGH = 128;

    /** Rounds in which gaps are closed aside, and down to which share of a body's size. */
    private static final int CLOSINGS = 4;

    private static final double CLOSELY = 1e-4;
    private static final int ROUNDS = 12;

    /** Changes of who holds in one half. */
    private static final int CHANGES = 8;

    /** A joint is closed to this share of its bodies' size, or rad. */
    private static final double CLOSED = 1e-13;

    /** Up to this the search may end with a round that gains little, or with the last one. */
    private static final double NEARLY = 1e-9;

    /**
     * Energy that impulses may add beside contacts. Those of a turning link turn with it and add
     * {@code (w h)²/4}; more than this is no turn, but sweeps and joints that pull against each
     * other.
     */
    private static final double GAIN = 1.05;

    /** Gap, m or rad, that is closed by the movement itself; larger ones are closed aside. */
    private static final double TINY = 1e-7;

    /** Turning speed at which a joint that is out of place is turned back, rad/s. */
    private static final double TURN_BACK = 10;

    private final JointEnergy energy = new JointEnergy();
    private final Tension tension = new Tension();
    private final JointMath math = new JointMath();
    private SolverContext tick = NONE;
    private Assembly s = EMPTY;
    private JointStore store = new JointStore();
    private double h;
    private final double[] turn = new double[3];
    private double push;
    private double turnBack;
    private int changes;
    private boolean isClosing;

    private static final SolverContext NONE = new SolverContext(Tuning.DEFAULT);
    private static final Assembly EMPTY =
            new Assembly(new int[0], new int[0], new int[0], new int[0]);

    /** Takes an assembly to work. */
    public void open(SolverContext context, SubStep sub, JointStore joints, Assembly assembly) {
        open(context, sub, joints, assembly, 1);
    }

    /**
     * The same for sub-steps that are made of steps to and fro.
     *
     * @param way sum of the steps' lengths, of a sub-step
     */
    void open(
            SolverContext context, SubStep sub, JointStore joints, Assembly assembly, double way) {
        tick = context;
        s = assembly;
        store = joints;
        push = sub.pushSpeed / way;
        turnBack = TURN_BACK / way;
    }

    // Rows ----------------------------------------------------------------------------------------

    private int offset(int joint, int side) {
        int i = s.end[2 * joint + side];
        return i < 0 ? 0 : SolverBodies.offset(s.body[i]);
    }

    /** Rows of the present poses. */
    private void derive() {
        if (s.isFresh) {
            return;
        }
        for (int k = 0; k < s.joint.length; k++) {
            int j = s.joint[k];
            math.look(tick.bodies, tick.body.state, store, j, offset(k, 0), offset(k, 1));
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

    /** Scales the derivatives of a row for one body; its share in the row's inverse mass. */
    private double scale(int r, int side, int o) {
        int at = JointMath.JACOBIAN * r + side;
        if (o == 0) {
            Arrays.fill(s.scaled, at, at + 6, 0.0);
            return 0;
        }
        double[] d = s.derivative;
        double root = Math.sqrt(tick.body.state[o + SolverBodies.MASS]);
        double[] l = tick.body.root;
        int q = o / SolverBodies.STRIDE * SolverBodies.ROOT;
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            s.scaled[at + c] = root * d[at + c];
            s.scaled[at + 3 + c] =
                    l[q + c] * d[at + 3] + l[q + 3 + c] * d[at + 4] + l[q + 6 + c] * d[at + 5];
            sum += s.scaled[at + c] * s.scaled[at + c];
            sum += s.scaled[at + 3 + c] * s.scaled[at + 3 + c];
        }
        return sum;
    }

    /** Adds an impulse of a row to the velocities. It is no part of the warm start. */
    private void push(int k, int r, double impulse) {
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

    private void change(int o, int c, double value) {
        tick.body.state[o + c] += value;
        tick.body.mark[o / SolverBodies.STRIDE * SolverBodies.HALF + c] += value;
    }

    /** {@code J v}. */
    private double speed(int k, int r) {
        double[] v = tick.body.state;
        double sum = 0;
        for (int side = 0; side < 2; side++) {
            int o = offset(k, side);
            int at = JointMath.JACOBIAN * r + 6 * side;
            double part = 0;
            for (int c = 0; c < 3; c++) {
                part += s.derivative[at + c] * v[o + c] + s.scaled[at + 3 + c] * v[o + 3 + c];
            }
            sum += side == 0 ? -part : part;
        }
        return sum;
    }

    // The linear system ---------------------------------------------------------------------------

    /** Makes the factors, if rows or who holds have changed. */
    private void factor(boolean moves) {
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
        s.isFactored = true;
    }

    /** A motor that is not at its most keeps its speed. */
    private double slack(int k, int r) {
        boolean isHard = s.rough == 0 && !isClosing;
        return isHard || store.role[row(k, r)] >= JointStore.MOTOR ? SLACK : SOFT;
    }

    /** {@code 1/(h (h k/4 + d/2))} of a spring. */
    private double give(int k, int r, boolean moves) {
        int row = row(k, r);
        return moves && store.role[row] == JointStore.SPRING
                ? 1 / (h * (0.25 * h * stiffness(r, row) + 0.5 * damping(r, row)))
                : 0;
    }

    private int row(int k, int r) {
        return store.firstRow[s.joint[k]] + r - s.firstRow[k];
    }

    private double stiffness(int r, int row) {
        return stiffness(store, row, s.compliance[r]);
    }

    private double damping(int r, int row) {
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
    private void solve() {
        BlockFactors f = s.factors;
        for (int i = 0; i < s.body.length; i++) {
            int u = f.unknown(i);
            Arrays.fill(f.x, u, u + BlockFactors.BODY, 0.0);
        }
        for (int k = 0; k < s.joint.length; k++) {
            int u = f.unknown(s.body.length + k);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                f.x[u + r - s.firstRow[k]] = s.isActive[r] ? s.now[r] : 0;
            }
        }
        f.solve();
    }

    /** The same, and adds the impulses. */
    private void correct() {
        solve();
        BlockFactors f = s.factors;
        for (int k = 0; k < s.joint.length; k++) {
            int u = f.unknown(s.body.length + k);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                if (s.isActive[r]) {
                    double l = f.x[u + r - s.firstRow[k]];
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
    private void relieve(boolean moves) {
        for (int round = 0; round < 2 && s.isLooped; round++) {
            factor(moves);
            for (int k = 0; k < s.joint.length; k++) {
                for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                    s.now[r] = slack(k, r) * s.compliance[r] * s.impulse[r];
                }
            }
            solve();
            for (int k = 0; k < s.joint.length; k++) {
                int u = s.factors.unknown(s.body.length + k);
                for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                    s.impulse[r] += s.isActive[r] ? s.factors.x[u + r - s.firstRow[k]] : 0;
                }
            }
        }
    }

    // Position half -------------------------------------------------------------------------------

    /**
     * Before the contacts are swept: the impulses of the last sub-step, as a first guess.
     *
     * @param scale of the impulses that were kept
     */
    public void warm(double scale) {
        s.calm();
        derive();
        double most = GAIN * kinetic();
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                double whole = s.parts * (store.before[row] + store.after[row]);
                s.impulse[r] = scale * (s.parts > 1 ? whole : store.before[row]);
                push(k, r, s.impulse[r]);
            }
        }
        if (s.keeps && !(kinetic() <= most)) {
            release();
        }
    }

    /** A sub-step with contacts begins: bodies have got their weight. */
    public void account(SubStep sub) {
        if (s.keeps) {
            JointEnergy.begin(tick, s, sub.seconds);
        }
    }

    /** Sweeps of contacts begin, or end. */
    public void sweeps(boolean end) {
        if (s.keeps) {
            JointEnergy.sweeps(tick, s, end);
        }
    }

    /** A sub-step with contacts ends. */
    public void settle() {
        if (s.keeps) {
            energy.settle(tick, s, true);
        }
    }

    /** Begin of a tick: bodies may be elsewhere, and weigh otherwise. */
    public void begin(SubStep sub) {
        s.isFresh = false;
        s.keeps = JointEnergy.keeps(tick, store, s);
        double quick = sub.seconds * tension.quickest(tick, store, s);
        s.parts = s.isRough() ? 1 : Swing.parts(quick);
    }

    /**
     * Bodies that have turned get the root of their present inertia, unless that was done.
     *
     * @param renewal has done it for those that have contacts
     */
    public void turn(JacobianRefresh renewal) {
        for (int i : s.body) {
            if (!renewal.stirs(i)) {
                Swing.renew(tick, i);
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

    /** Without a first guess. */
    void cold() {
        s.calm();
        derive();
        Arrays.fill(s.impulse, 0.0);
    }

    /**
     * Finds the impulses with which the bodies' movement closes the joints.
     *
     * @param seconds length of the sub-step
     * @param stay whether the bodies are moved then
     */
    public void position(double seconds, boolean stay) {
        h = seconds;
        changes = 0;
        activate(true);
        double most = GAIN * kinetic();
        note();
        double last = Double.POSITIVE_INFINITY;
        for (int round = 0; round < ROUNDS; round++) {
            if (s.rough > 0) {
                project(most);
                break;
            }
            keep();
            move();
            measure();
            if (!s.isRigid) {
                restore();
            }
            boolean changed = !s.isRigid && hold(round);
            double worst = residuals();
            boolean gains = worst <= 0.3 * last && round < ROUNDS - 1;
            boolean ends = !changed && worst <= (gains ? CLOSED : NEARLY);
            if (s.isRigid && !(ends && stay)) {
                restore();
            }
            if (ends && kinetic() <= most + work()) {
                end(stay && !s.isRigid);
                return;
            }
            boolean fails = round > 1 && !changed && !(worst <= 4 * Math.max(last, NEARLY));
            if (ends || fails || round == ROUNDS - 1) {
                if (ends && s.isRigid && stay) {
                    restore();
                }
                s.rough = s.patience;
                s.patience = Math.min(4 * s.patience, ROUGH);
                project(most);
                break;
            }
            last = changed ? Double.POSITIVE_INFINITY : worst;
            factor(true);
            correct();
        }
        end(stay);
    }

    /** Notes speeds and impulses of motors and springs, for {@link #work}. */
    private void note() {
        for (int k = 0; k < s.joint.length && !s.isRigid; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                if (store.role[row(k, r)] >= JointStore.MOTOR) {
                    s.speed[r] = speed(k, r);
                    s.noted[r] = s.impulse[r];
                }
            }
        }
    }

    /** Energy that motors and springs may have given since: impulse times mean speed, J. */
    private double work() {
        double sum = 0;
        for (int k = 0; k < s.joint.length && !s.isRigid; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                if (store.role[row(k, r)] >= JointStore.MOTOR) {
                    double mean = 0.5 * (s.speed[r] + speed(k, r));
                    sum += (s.impulse[r] - s.noted[r]) * mean;
                }
            }
        }
        return GAIN * Math.max(0, sum);
    }

    private double kinetic() {
        return JointEnergy.kinetic(tick, s);
    }

    /** Keeps the impulses; moves the bodies if that is still to be done. */
    private void end(boolean moves) {
        if (moves) {
            move();
        }
        relieve(true);
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                store.before[row] = s.impulse[r];
                if (store.role[row] == JointStore.SPRING) {
                    store.after[row] = springAfter(r, row);
                }
            }
        }
    }

    /** Half of the spring again; of a damper that would turn the motion round, less. */
    private double springAfter(int r, int row) {
        if (store.held[row] != 0) {
            return s.impulse[r];
        }
        double d = 0.5 * damping(r, row);
        double x = 2 * h * d * s.compliance[r];
        if (!(x > 1)) {
            return s.impulse[r];
        }
        double k = 0.25 * h * stiffness(r, row);
        double way = s.start[r] - store.target[row];
        way = JointMath.isAngle(store.law[row]) ? Angles.wrap(way) : way;
        double step = -(s.impulse[r] + 2 * k * way) / (k + d);
        return s.impulse[r] + (1 - 1 / x) * d * step;
    }

    /**
     * Who holds at first: limits as they were, motors and springs unless they were at their most.
     */
    private void activate(boolean moves) {
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                boolean bound = store.held[row] != 0;
                s.isActive[r] =
                        switch (store.role[row]) {
                                    case JointStore.LIMIT -> bound;
                                    case JointStore.MOTOR -> !bound;
                                    case JointStore.SPRING -> moves && !bound && isSprung(r, row);
                                    default -> true;
                                }
                                && s.compliance[r] > 0;
                if (bound && store.role[row] >= JointStore.MOTOR && moves) {
                    set(k, r, isRound(k, row) ? held(k, row) : store.held[row] * bound(row));
                }
            }
        }
    }

    private boolean isSprung(int r, int row) {
        return stiffness(r, row) > 0 || damping(r, row) > 0;
    }

    /** Largest impulse of a half. */
    private double bound(int row) {
        return 0.5 * Math.abs(h) * store.most[row];
    }

    private void set(int k, int r, double impulse) {
        push(k, r, impulse - s.impulse[r]);
        s.impulse[r] = impulse;
    }

    /** Moves the bodies as the sub-step will. */
    private void move() {
        double[] g = tick.gravity;
        for (int i : s.body) {
            Motion.drift(tick.bodies, tick.body, i, g[0], g[1], g[2], h);
        }
    }

    private void keep() {
        BodyStore b = tick.bodies;
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int o = SolverBodies.offset(i);
            int at = KEPT * n;
            System.arraycopy(tick.body.state, o, s.kept, at, 6);
            System.arraycopy(tick.body.state, o + SolverBodies.P, s.kept, at + 6, 6);
            int w = (i + 1) * SolverBodies.HALF;
            System.arraycopy(tick.body.mark, w, s.kept, at + 12, 6);
            s.kept[at + 18] = b.orientationX[i];
            s.kept[at + 19] = b.orientationY[i];
            s.kept[at + 20] = b.orientationZ[i];
            s.kept[at + 21] = b.orientationW[i];
        }
    }

    private void restore() {
        BodyStore b = tick.bodies;
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int o = SolverBodies.offset(i);
            int at = KEPT * n;
            System.arraycopy(s.kept, at, tick.body.state, o, 6);
            System.arraycopy(s.kept, at + 6, tick.body.state, o + SolverBodies.P, 6);
            int w = (i + 1) * SolverBodies.HALF;
            System.arraycopy(s.kept, at + 12, tick.body.mark, w, 6);
            b.orientationX[i] = s.kept[at + 18];
            b.orientationY[i] = s.kept[at + 19];
            b.orientationZ[i] = s.kept[at + 20];
            b.orientationW[i] = s.kept[at + 21];
        }
    }

    /** What the rows measure in the poses of now. */
    private void measure() {
        for (int k = 0; k < s.joint.length; k++) {
            int j = s.joint[k];
            math.look(tick.bodies, tick.body.state, store, j, offset(k, 0), offset(k, 1));
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                s.now[r] = math.measure(store, j, store.law[row(k, r)]);
            }
        }
    }

    /** Lets rows hold, or lets them go; whether any has changed. */
    private boolean hold(int round) {
        if (changes >= CHANGES) {
            return false;
        }
        boolean changed = false;
        for (int k = 0; k < s.joint.length; k++) {
            changed |= store.isRound[s.joint[k]] && clampLength(k);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                byte role = store.role[row];
                if (role == JointStore.LIMIT) {
                    changed |= limit(k, r, row, round);
                } else if (role != JointStore.LOCK && !isRound(k, row) && s.compliance[r] > 0) {
                    changed |= clamp(k, r, row);
                }
            }
        }
        changes += changed ? 1 : 0;
        return changed;
    }

    /** Whether a limit begins to hold, or lets go as it would pull. */
    private boolean limit(int k, int r, int row, int round) {
        if (s.compliance[r] == 0) {
            return false;
        }
        double tiny = tiny(JointMath.isAngle(store.law[row]));
        double start = s.start[r];
        double low = store.lower[row] - start > tiny ? start : store.lower[row];
        double high = start - store.upper[row] > tiny ? start : store.upper[row];
        int side = s.now[r] < low ? -1 : s.now[r] > high ? 1 : 0;
        if (!s.isActive[r]) {
            if (side == 0) {
                return false;
            }
            store.held[row] = (byte) side;
            s.isActive[r] = true;
            return true;
        }
        if (round == 0 || s.impulse[r] * store.held[row] <= 0) {
            return false;
        }
        return release(k, r, row);
    }

    private boolean release(int k, int r, int row) {
        set(k, r, 0);
        store.held[row] = 0;
        s.isActive[r] = false;
        return true;
    }

    /** Whether a motor or spring comes to the most that it can do, or back from it. */
    private boolean clamp(int k, int r, int row) {
        double most = bound(row);
        if (s.isActive[r]) {
            if (Math.abs(s.impulse[r]) <= most) {
                return false;
            }
            store.held[row] = (byte) (s.impulse[r] > 0 ? 1 : -1);
            s.isActive[r] = false;
            set(k, r, store.held[row] * most);
            return true;
        }
        // it pushes with all it has: if the row has gone too far, less would do
        if (store.held[row] != 0 && miss(r, row) * store.held[row] > 0) {
            store.held[row] = 0;
            s.isActive[r] = true;
            return true;
        }
        return false;
    }

    /** Whether a row is one of the springs whose forces together have a largest length. */
    private boolean isRound(int k, int row) {
        return store.isRound[s.joint[k]]
                && store.role[row] == JointStore.SPRING
                && store.law[row] < JointStore.TURN;
    }

    /** The last impulse of such a row, if they were at their most. */
    private double held(int k, int row) {
        double square = 0;
        for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
            double l = isRound(k, row(k, r)) ? store.before[row(k, r)] : 0;
            square += l * l;
        }
        return square > 0 ? store.before[row] * bound(row) / Math.sqrt(square) : 0;
    }

    /**
     * The same as {@link #clamp} for springs whose forces together have a largest length. At their
     * most they push as {@code -h/2 k x - d/2 step} points, which is sought by iteration.
     */
    private boolean clampLength(int k) {
        double square = 0;
        double most = Double.POSITIVE_INFINITY;
        boolean isFree = false;
        for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
            int row = row(k, r);
            if (isRound(k, row)) {
                double l = wanted(r, row);
                square += l * l;
                most = bound(row);
                isFree |= s.isActive[r];
            }
        }
        double length = Math.sqrt(square);
        if (isFree && length <= most) {
            return false;
        }
        boolean changed = isFree || length <= most;
        for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
            int row = row(k, r);
            if (isRound(k, row) && s.compliance[r] > 0) {
                s.isActive[r] = length <= most;
                store.held[row] = (byte) (length <= most ? 0 : 1);
                double l = wanted(r, row) * Math.min(1, most / length);
                changed |= Math.abs(l - s.impulse[r]) > NEARLY * most;
                set(k, r, l);
            }
        }
        return changed;
    }

    /** Impulse that a spring wants. */
    private double wanted(int r, int row) {
        double give = 0.25 * h * stiffness(r, row) + 0.5 * damping(r, row);
        return s.isActive[r] ? s.impulse[r] : s.impulse[r] - give * miss(r, row);
    }

    /** What an equation lacks; in metres or rad. */
    private double miss(int r, int row) {
        boolean isAngle = JointMath.isAngle(store.law[row]);
        double c0 = s.start[r];
        double c1 = s.now[r];
        double most = tiny(isAngle);
        return switch (store.role[row]) {
            case JointStore.LIMIT -> {
                double edge = store.held[row] < 0 ? store.lower[row] : store.upper[row];
                double past = c0 - edge;
                boolean isPast = past * store.held[row] > 0;
                yield c1 - edge - (isPast && Math.abs(past) > most ? past : 0);
            }
            case JointStore.MOTOR ->
                    (isAngle ? Angles.wrap(c1 - c0) : c1 - c0) - store.target[row] * h;
            case JointStore.SPRING -> {
                double x = c0 - store.target[row];
                x = isAngle ? Angles.wrap(x) : x;
                double step = isAngle ? Angles.wrap(c1 - c0) : c1 - c0;
                double k2 = 0.5 * h * stiffness(r, row);
                yield step + (k2 * x + s.impulse[r]) / (0.5 * k2 + 0.5 * damping(r, row));
            }
            default -> {
                double gap = c0 - store.target[row];
                yield c1 - store.target[row] - (Math.abs(gap) > most ? gap : 0);
            }
        };
    }

    /** How much of a gap the movement itself closes, m or rad. */
    private static double tiny(boolean isAngle) {
        return isAngle ? TINY : 0.1 * TINY;
    }

    /** How much of a gap a step closes, m or rad. */
    private double reach(boolean isAngle) {
        return (isAngle ? turnBack : push) * Math.abs(h);
    }

    private static double within(double x, double most) {
        return Math.max(-most, Math.min(most, x));
    }

    /** Writes what is missing over h to {@link Assembly#now}; the worst, over its size. */
    private double residuals() {
        double worst = 0;
        for (int k = 0; k < s.joint.length; k++) {
            double size = size(k);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                if (!s.isActive[r]) {
                    s.now[r] = 0;
                    continue;
                }
                double m = miss(r, row);
                boolean isAngle = JointMath.isAngle(store.law[row]);
                worst = Math.max(worst, Math.abs(isAngle ? m : m / size));
                if (Double.isNaN(m)) {
                    worst = Double.POSITIVE_INFINITY;
                }
                s.now[r] = m / h;
            }
        }
        return worst;
    }

    /** Size that the gaps of a joint are measured by, m: its smaller body that moves, and arms. */
    private double size(int k) {
        BodyStore b = tick.bodies;
        double size = 0;
        for (int side = 0; side < 2; side++) {
            if (s.end[2 * k + side] >= 0) {
                size = Math.max(size, b.outerRadius[s.body[s.end[2 * k + side]]]);
            }
        }
        return size;
    }

    /**
     * Where Newton's method fails: its first round alone, and if that adds too much energy, no
     * impulse at all.
     */
    private void project(double most) {
        single();
        if (!(kinetic() <= most + work())) {
            release();
        }
    }

    private void single() {
        release();
        activate(true);
        keep();
        move();
        measure();
        restore();
        for (int k = 0; k < s.joint.length && !s.isRigid; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                if (store.role[row(k, r)] == JointStore.LIMIT) {
                    limit(k, r, row(k, r), 0);
                }
            }
        }
        residuals();
        factor(true);
        correct();
    }

    // Velocity half -------------------------------------------------------------------------------

    /**
     * After the bodies have moved, and their roots are those of their present orientation.
     *
     * @param warm whether to begin with the impulses of the last sub-step
     * @param counts whether what is found are the impulses of the sub-step
     */
    public void beginVelocity(boolean warm, boolean counts) {
        s.isFresh = false;
        derive();
        activate(false);
        double most = GAIN * kinetic();
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                byte role = store.role[row];
                double first = warm && s.isActive[r] ? store.after[row] : 0;
                first = role == JointStore.SPRING ? store.after[row] : first;
                first = role == JointStore.MOTOR && !s.isActive[r] ? store.before[row] : first;
                s.impulse[r] = 0;
                set(k, r, counts ? first : 0);
            }
        }
        if (s.keeps && counts && !(kinetic() <= most)) {
            release();
        }
    }

    /**
     * Takes from the velocities what the joints do not allow.
     *
     * @param counts whether its impulses are those of the sub-step
     */
    public void velocity(double seconds, boolean counts) {
        h = seconds;
        changes = 0;
        double first = 0;
        close();
        for (int round = 0; round < ROUNDS; round++) {
            boolean changed = round > 0 && letGo();
            double worst = 0;
            for (int k = 0; k < s.joint.length; k++) {
                for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                    int row = row(k, r);
                    boolean isDriven = store.role[row] == JointStore.MOTOR;
                    double miss = speed(k, r) - (isDriven ? store.target[row] : 0);
                    s.now[r] = s.isActive[r] ? miss : 0;
                    worst = Math.max(worst, Math.abs(s.now[r]));
                }
            }
            first = Math.max(first, worst);
            if (!changed && (worst <= 1e-14 * first || round > 2)) {
                break;
            }
            factor(false);
            correct();
        }
        if (counts) {
            relieve(false);
            end();
        }
    }

    /**
     * Closes what is open by moving bodies, without any speed: {@code x' = x - M^-1 J^T (A + E)^-1
     * c}.
     */
    private void close() {
        for (int round = 0; round < CLOSINGS; round++) {
            double worst = gaps(round == 0);
            if (!(worst > (round == 0 ? NEARLY : CLOSELY))) {
                return;
            }
            isClosing = true;
            factor(false);
            solve();
            isClosing = false;
            shift();
            s.isFresh = false;
            derive();
        }
    }

    /** Writes what is open to {@link Assembly#now}; the worst, over its size. */
    private double gaps(boolean begins) {
        double worst = 0;
        for (int k = 0; k < s.joint.length; k++) {
            double size = size(k);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                boolean isAngle = JointMath.isAngle(store.law[row]);
                double gap = 0;
                if (s.isActive[r] && store.role[row] == JointStore.LOCK) {
                    gap = s.start[r] - store.target[row];
                } else if (s.isActive[r] && store.role[row] == JointStore.LIMIT) {
                    double edge = store.held[row] < 0 ? store.lower[row] : store.upper[row];
                    double past = s.start[r] - edge;
                    gap = past * store.held[row] > 0 ? past : 0;
                }
                // what is far apart is drawn nearer only once
                double most = reach(isAngle);
                gap = begins || Math.abs(gap) < most ? within(gap, most) : 0;
                worst = Math.max(worst, Math.abs(isAngle ? gap : gap / size));
                s.now[r] = gap;
            }
        }
        return worst;
    }

    /**
     * Moves bodies by the solution. Where a loop is almost straight that would lead far beyond: it
     * is cut to twice the way that a gap is closed by.
     */
    private void shift() {
        BlockFactors f = s.factors;
        SolverBodies body = tick.body;
        double part = 1;
        for (int n = 0; n < s.body.length; n++) {
            int o = SolverBodies.offset(s.body[n]);
            int u = f.unknown(n);
            double root = Math.sqrt(body.state[o + SolverBodies.MASS]);
            double way = root * SolverBodies.norm(f.x[u], f.x[u + 1], f.x[u + 2]);
            turn(s.body[n], u + 3);
            double angle = SolverBodies.norm(turn[0], turn[1], turn[2]);
            part = way * part > 2 * reach(false) ? 2 * reach(false) / way : part;
            part = angle * part > 2 * reach(true) ? 2 * reach(true) / angle : part;
        }
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int o = SolverBodies.offset(i);
            int p = o + SolverBodies.P;
            int u = f.unknown(n);
            double root = part * Math.sqrt(body.state[o + SolverBodies.MASS]);
            for (int c = 0; c < 3; c++) {
                body.state[p + c] += root * f.x[u + c];
                body.state[p + 3 + c] += part * f.x[u + 3 + c];
            }
            turn(i, u + 3);
            Rotation.turn(tick.bodies, i, part * turn[0], part * turn[1], part * turn[2]);
        }
    }

    /** {@code L u} of three unknowns. */
    private void turn(int i, int u) {
        double[] l = tick.body.root;
        int q = (i + 1) * SolverBodies.ROOT;
        double[] x = s.factors.x;
        for (int c = 0; c < 3; c++) {
            turn[c] =
                    l[q + 3 * c] * x[u] + l[q + 3 * c + 1] * x[u + 1] + l[q + 3 * c + 2] * x[u + 2];
        }
    }

    /** Lets limits go that would pull, and holds motors to their most. */
    private boolean letGo() {
        boolean changed = false;
        for (int k = 0; k < s.joint.length && changes < CHANGES; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                if (!s.isActive[r]) {
                    continue;
                }
                if (store.role[row] == JointStore.LIMIT) {
                    changed |= s.impulse[r] * store.held[row] > 0 && release(k, r, row);
                } else if (store.role[row] == JointStore.MOTOR
                        && Math.abs(s.impulse[r]) > bound(row)) {
                    s.isActive[r] = false;
                    set(k, r, s.impulse[r] > 0 ? bound(row) : -bound(row));
                    changed = true;
                }
            }
        }
        changes += changed ? 1 : 0;
        return changed;
    }

    /** Keeps impulses, and the forces that they stand for. */
    private void end() {
        for (int k = 0; k < s.joint.length; k++) {
            int j = s.joint[k];
            math.look(tick.bodies, tick.body.state, store, j, offset(k, 0), offset(k, 1));
            Arrays.fill(store.reaction, 6 * j, 6 * j + 6, 0.0);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                store.after[row] = s.impulse[r];
                double force = (store.before[row] + store.after[row]) / h;
                math.react(s.derivative, JointMath.JACOBIAN * r, force, store.reaction, 6 * j);
            }
        }
    }
}
