package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.refresh.JacobianRefresh;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

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
 * <p>The chapters that it is built on, each knowing the one before:
 *
 * <pre>
 *   AssemblyEquations   rows in the present poses, and the linear system
 *   HoldingRows         which limits, motors and springs are equations, by trial
 *   PositionCorrection  what is open already is closed aside
 *   ContactCoupling     what it stands on is solved with it
 *   JointWork           what motors and springs may give, and the way back
 *   VelocityHalf        what joints do not allow is taken from the velocities
 *   PositionTrial       where trials of the position half lead, and what if nowhere
 *   JointSolve          the position half, and what a sub-step is made of
 * </pre>
 *
 * <p>A spring is {@code l = -h/4 k (c + c') - d/2 (c' - c)}, half of the implicit midpoint rule, in
 * each half. Where loops close twice, rows depend on each other; Newton's rounds take out what
 * their slack leaves, so it only decides how dependent rows share a load.
 *
 * <p>Source: H. C. Andersen, "Rattle: a velocity version of the Shake algorithm" (1983). One to a
 * worker. Does not allocate.
 */
public final class JointSolve extends PositionTrial {
    /** Most sub-steps until Newton's method is tried again where it has failed. */
    static final int LONGEST_BACK_OFF = 128;

    /** Rounds of Newton's method for what stands on something: light wheels turn far. */
    private static final int STANDING = 24;

    /**
     * What may be left after the last of them, to be closed aside: far less than a failure leaves.
     */
    private static final double ALMOST = 1e-7;

    /** A joint is closed to this share of its bodies' size, or rad. */
    private static final double CLOSED = 1e-12;

    /** Turning speed at which a joint that is out of place is turned back, rad/s. */
    static final double TURN_BACK = 10;

    private final JointEnergy energy = new JointEnergy();
    private final Tension tension = new Tension();
    private final NetSolve nets = new NetSolve(NONE, store, EMPTY);

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
        nets.open(context, joints, assembly, push);
    }

    // Position half -------------------------------------------------------------------------------

    /**
     * Before the contacts are swept: the impulses of the last sub-step, as a first guess.
     *
     * @param scale of the impulses that were kept
     */
    public void warm(double scale) {
        if (s.isNet) {
            nets.warm(scale, s.keeps ? GAIN : Double.POSITIVE_INFINITY);
            return;
        }
        s.calm();
        Arrays.fill(s.impactImpulses, 0, Assembly.POINTS * s.touchCount, 0.0);
        derive();
        double most = most();
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                s.load[2 * r] = scale * store.before[row];
                s.load[2 * r + 1] = scale * store.after[row];
                double whole = s.parts * (store.before[row] + store.after[row]);
                s.impulse[r] = scale * (s.parts > 1 ? whole : store.before[row]);
                push(k, r, s.impulse[r]);
            }
        }
        if (!isGuess(most)) {
            release();
        }
    }

    /** A sub-step with contacts begins: bodies have got their weight. */
    public void account(SubStep sub) {
        if (s.keeps) {
            JointEnergy.begin(tick, s, sub.seconds);
        }
    }

    /** A sub-step with contacts ends. */
    public void settle() {
        if (s.keeps) {
            energy.settle(tick, s, true);
        }
        finish();
    }

    /** Impulses that are kept elsewhere in a tick are given back to the rows. */
    void finish() {
        if (s.isNet) {
            nets.end();
        }
    }

    /** Begin of a tick: whether the assembly is solved as a {@link PointNet}. */
    void choose() {
        s.isNet = s.mayBeNet() && !isCarried() && !isLocked() && nets.begin();
        s.isDirect = s.hasFactors && !s.isNet;
        s.standCount = s.isNet ? 0 : s.standCount;
        s.touchCount = s.isNet ? 0 : s.touchCount;
        s.isFresh = false;
    }

    /** A whole step of a net that touches nothing. */
    void step(double seconds, boolean isLast) {
        nets.step(seconds, isLast);
    }

    /** Whether the step before this one was left without its velocity half. */
    boolean flows() {
        return nets.flows();
    }

    /** A step of what touches nothing ends: a net that is left open goes on with factors. */
    void reconsider() {
        if (s.isNet && s.hasFactors && nets.isOpen()) {
            nets.end();
            s.isNet = false;
            s.isDirect = true;
            s.isFresh = false;
        }
    }

    /**
     * Begin of a tick: bodies may be elsewhere, and weigh otherwise. Before impacts, which shift
     * struck bodies by the way that they would have gone until then: that is no gap.
     */
    public void begin(SubStep sub) {
        choose();
        findCarriers();
        if (!s.isNet) {
            derive();
        }
        s.keeps = JointEnergy.keeps(tick, store, s);
        findDrives();
        s.parts = s.isDirect ? Tension.parts(s, sub.seconds * tension.quickest(tick, store, s)) : 1;
    }

    /**
     * Bodies that have turned get the root of their present inertia, unless that was done.
     *
     * @param refresh has done it for those that have contacts
     * @param seconds for which they have moved
     */
    public void turn(JacobianRefresh refresh, double seconds) {
        s.time += seconds;
        for (int i : s.body) {
            if (!refresh.hasRenewedRow(i)) {
                renew(tick, i);
            }
        }
    }

    /**
     * A step that contacts have no part in begins: the impulses of the last one are a first guess,
     * if they do not add energy.
     *
     * @param scale of the impulses that were kept; 0 for none
     */
    void start(double scale) {
        s.calm();
        derive();
        double most = GAIN * kinetic();
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                s.impulse[r] = 0;
                set(k, r, scale * store.before[row(k, r)]);
            }
        }
        if (!(kinetic() <= most)) {
            release();
        }
    }

    @Override
    public void beginVelocity(boolean counts) {
        if (s.isNet) {
            boolean isBound = s.keeps && counts;
            nets.beginVelocity(counts, isBound ? GAIN : Double.POSITIVE_INFINITY);
        } else {
            super.beginVelocity(counts);
        }
    }

    @Override
    public void velocity(SubStep sub, boolean counts, ConstraintRows rows) {
        if (s.isNet) {
            nets.velocity(sub.seconds, counts);
        } else {
            super.velocity(sub, counts, rows);
        }
    }

    /**
     * Finds the impulses with which the bodies' movement closes the joints.
     *
     * @param seconds length of the sub-step
     * @param stay whether the bodies are moved then
     */
    public void position(double seconds, boolean stay) {
        h = seconds;
        if (s.isNet) {
            nets.position(seconds, GAIN);
            return;
        }
        changes = 0;
        activate(true);
        double most = most();
        note();
        if (!s.isDirect) {
            approach(most);
            end(stay);
            return;
        }
        double last = Double.POSITIVE_INFINITY;
        int flying = s.isRigid ? ROUNDS : 2 * ROUNDS;
        int each = s.touchCount > 0 ? STANDING : flying;
        int rounds = each;
        double almost = s.touchCount > 0 ? ALMOST : NEARLY;
        boolean asks = true;
        for (int round = 0; round < rounds; round++) {
            if (s.approximateSteps > 0) {
                project(most);
                break;
            }
            keep();
            move();
            measure();
            if (!s.isRigid) {
                restore();
            }
            boolean changed = !s.isRigid && asks && hold(round, last);
            asks = s.isRigid || !changed || !isFirm();
            if (!asks) {
                // the rows that are tried next have as many rounds as the first
                again();
                rounds = round + 1 + each;
                last = Double.POSITIVE_INFINITY;
                continue;
            }
            double worst = residuals();
            boolean gains = worst <= 0.3 * last && round < rounds - 1;
            boolean ends =
                    !changed && worst <= (gains ? CLOSED : round < rounds - 1 ? NEARLY : almost);
            if (s.isRigid && !(ends && stay)) {
                restore();
            }
            if (ends && kinetic() <= most + work()) {
                end(stay && !s.isRigid);
                return;
            }
            boolean fails = round > 1 && !changed && !(worst <= 4 * Math.max(last, NEARLY));
            if (ends || fails || round == rounds - 1) {
                if (ends && s.isRigid && stay) {
                    restore();
                }
                if (!isHeld) {
                    s.approximateSteps = s.backOff;
                    s.backOff = Math.min(4 * s.backOff, LONGEST_BACK_OFF);
                }
                project(most);
                break;
            }
            last = changed ? Double.POSITIVE_INFINITY : worst;
            factor(true);
            correct();
        }
        end(stay);
    }

    /**
     * The position half of an assembly that touches something: after the joints, what it stands on,
     * and the joints again.
     *
     * @param rows of the contacts
     */
    public void position(SubStep sub, ConstraintRows rows) {
        share(tick.weight() * sub.seconds);
        position(sub.seconds, false);
        if (misses(rows, sub, true)) {
            presses(false);
            land(rows, sub);
            isHeld = true;
            position(sub.seconds, false);
            isHeld = false;
            presses(true);
        }
        moves(0);
    }

    /**
     * Contacts of a taut assembly, before it is moved in smaller steps: joints act on the way, but
     * what it stands on stops all of it at once. Only where joints have limits, which limbs are
     * pressed past otherwise: a chain of locks alone that lands was torn by it now and then (a
     * world in 800), which was not traced.
     *
     * @param rows of the contacts
     */
    public void bear(SubStep sub, ConstraintRows rows) {
        h = sub.seconds;
        if (!s.isRigid) {
            release();
        }
        if (s.touchCount > 0 && !s.isRigid) {
            presses(false);
            activate(true);
            note();
            double most = GUESS * (motion(rows) + pushed(rows, sub) + work());
            rest();
            if (!(motion(rows) <= most)) {
                takeBack();
            } else if (misses(rows, sub, true)) {
                land(rows, sub);
                // a blow that was handed on is done, and no load of the steps
                Arrays.fill(s.impulse, 0.0);
            }
            release();
            presses(true);
        }
        moves(0.5);
    }

    /**
     * Where contacts bear a load, and none of them an impact, all bodies move as those that are
     * loaded: {@code x' = x + h v'}, with the velocity that holds at the sub-step's end, not along
     * the parabola. What hangs on the others would else fall by {@code g h/2} in the first half and
     * be caught in the second, and contacts be asked for two loads in turn, of which they begin
     * with the wrong one each time.
     */
    private void share(double weight) {
        double[] v = tick.body.state;
        double[] warm = tick.body.warm;
        double[] mark = tick.body.mark;
        boolean isLoaded = false;
        for (int i : s.body) {
            int o = SolverBodies.offset(i);
            int w = (i + 1) * SolverBodies.HALF;
            double x = v[o] - mark[w];
            double y = v[o + 1] - mark[w + 1];
            double z = v[o + 2] - mark[w + 2];
            if (!(SolverBodies.norm(x, y, z) <= weight)) {
                return; // the sweeps have changed more than a load would in a sub-step
            }
            boolean bears = warm[w] != 0 || warm[w + 1] != 0 || warm[w + 2] != 0;
            isLoaded |= bears && v[o + SolverBodies.LOADED] != 0;
        }
        for (int i : s.body) {
            int o = SolverBodies.offset(i);
            v[o + SolverBodies.LOADED] = isLoaded ? 1 : v[o + SolverBodies.LOADED];
        }
    }

    /** Keeps the impulses; moves the bodies if that is still to be done. */
    private void end(boolean moves) {
        if (moves) {
            move();
        }
        relieve(true);
        for (int k = 0; k < s.joint.length; k++) {
            Arrays.fill(store.reaction, 6 * s.joint[k], 6 * s.joint[k] + 6, 0.0);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                store.before[row] = s.impulse[r];
                if (store.role[row] == JointStore.SPRING) {
                    store.after[row] = springAfter(r, row);
                }
            }
        }
        react();
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
}
