package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.DrivenSides;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * What motors and springs may give, and the way back: velocities and impulses of before a half of
 * the sub-step, to which it returns if more energy has come than that.
 */
abstract class JointWork extends ContactCoupling {
    /**
     * Energy that impulses may add beside contacts. Those of a turning link turn with it and add
     * {@code (w h)²/4}; more than this is no turn, but sweeps and joints that pull against each
     * other.
     */
    static final double GAIN = 1.05;

    /** How much faster than a driven body levers may make others. */
    private static final double LEVERAGE = 4;

    /** By what a first guess may exceed the energy that there may be. */
    static final double GUESS = 2;

    /** Of {@link BodyStore#motionFlags}: axes along and about which a body may not move. */
    private static final int LOCKS = 63;

    /** Begin of a tick: whether a motor or a spring acts. */
    void findDrives() {
        s.isDriven = false;
        for (int j : s.joint) {
            for (int r = store.firstRow[j]; r < store.firstRow[j] + store.rows[j]; r++) {
                s.isDriven |= store.role[r] >= JointStore.MOTOR;
            }
        }
    }

    /** Whether a joint ties it to a kinematic body that moves. */
    boolean isCarried() {
        boolean moves = false;
        for (int j : s.joint) {
            moves |= tick.bodies.isMoved(store.bodyA[j]);
            moves |= tick.bodies.isMoved(store.bodyB[j]);
        }
        return moves;
    }

    /** Whether an axis of a body is locked. */
    boolean isLocked() {
        boolean locked = false;
        for (int i : s.body) {
            locked |= (tick.bodies.motionFlags[i] & LOCKS) != 0;
        }
        return locked;
    }

    /**
     * Begin of a tick: what kinematic partners that move may give, see {@link #most}. With locked
     * axes they are taken to stand where the tick begins: they may ask for what locks forbid, and
     * what is not reached is closed aside, without a speed.
     */
    void findCarriers() {
        s.time = 0;
        s.carriedRoot = 0;
        if (isLocked()) {
            return;
        }
        BodyStore b = tick.bodies;
        for (int k = 0; k < s.joint.length; k++) {
            for (int side = 0; side < 2; side++) {
                int i = side == 0 ? store.bodyA[s.joint[k]] : store.bodyB[s.joint[k]];
                if (s.end[2 * k + side] < 0 && b.isMoved(i)) {
                    s.carriedRoot += Math.sqrt(carried(b, i));
                }
            }
        }
    }

    /** At least the energy of motion of all bodies if they moved as one with body i, J. */
    private double carried(BodyStore b, int i) {
        double speed = SolverBodies.norm(b.velocityX[i], b.velocityY[i], b.velocityZ[i]);
        double x = b.angularVelocityX[i];
        double y = b.angularVelocityY[i];
        double z = b.angularVelocityZ[i];
        double spin = SolverBodies.norm(x, y, z);
        double sum = 0;
        for (int n : s.body) {
            double inverse = tick.body.state[SolverBodies.offset(n) + SolverBodies.MASS];
            double far = SolverBodies.norm(b.apartX(i, n), b.apartY(i, n), b.apartZ(i, n));
            double size = spin * b.outerRadius[n];
            double most = speed + spin * far;
            sum += inverse > 0 ? (most * most + size * size) / inverse : 0;
        }
        return 0.5 * sum;
    }

    /**
     * Energy of motion that impulses of joints may leave, J. The velocities that joints allow lie
     * in a plane, and they take the nearest of it; one with a kinematic partner, with energy V, is
     * in it. So {@code sqrt(K') <= sqrt(K) + 2 sqrt(V)}.
     */
    double most() {
        double k = GAIN * kinetic();
        if (s.carriedRoot == 0) {
            return k;
        }
        double root = Math.sqrt(k) + 2 * s.carriedRoot;
        return root * root;
    }

    /**
     * Whether the impulses of the last half, given anew, are a guess at those of this one. Those of
     * joints that contradict each other, or a contact, are large and cancel, but not in the poses
     * of now: such ones made 1e24 J of 3e4. Where nothing but joints acts, no gain is a guess;
     * elsewhere a blow changes them much, and they are still better than none.
     *
     * @param most energy of motion that joints may leave, see {@link #most}, J
     */
    boolean isGuess(double most) {
        return kinetic() <= (s.keeps ? most : GUESS * (most + work()));
    }

    /** Energy of all springs, J: {@code k x²/2} up to where their force ends, then straight on. */
    private double stored() {
        derive();
        double sum = 0;
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                if (store.role[row] == JointStore.SPRING && s.compliance[r] > 0) {
                    double x = s.start[r] - store.target[row];
                    x = Math.abs(JointMath.isAngle(store.law[row]) ? Angles.wrap(x) : x);
                    double stiff = stiffness(r, row);
                    double end = Math.min(x, store.most[row] / stiff);
                    sum += stiff > 0 ? stiff * end * (x - 0.5 * end) : 0;
                }
            }
        }
        return sum;
    }

    /** Keeps velocities and impulses of before a half. */
    void note() {
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int w = (i + 1) * SolverBodies.HALF;
            System.arraycopy(
                    tick.body.state, SolverBodies.offset(i), s.first, Assembly.FIRST * n, 6);
            System.arraycopy(tick.body.mark, w, s.first, Assembly.FIRST * n + 6, 6);
        }
        System.arraycopy(s.impulse, 0, s.firstImpulse, 0, s.impulse.length);
    }

    void comeBack() {
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int w = (i + 1) * SolverBodies.HALF;
            System.arraycopy(
                    s.first, Assembly.FIRST * n, tick.body.state, SolverBodies.offset(i), 6);
            System.arraycopy(s.first, Assembly.FIRST * n + 6, tick.body.mark, w, 6);
        }
        System.arraycopy(s.firstImpulse, 0, s.impulse, 0, s.impulse.length);
    }

    /**
     * Makes them those of now. Impulses that grew large leave rounding where they are taken off.
     */
    void takeBack() {
        comeBack();
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                // what was found of motors on the way is as wrong as the impulses
                if (store.role[row(k, r)] == JointStore.MOTOR) {
                    store.held[row(k, r)] = 0;
                }
            }
        }
    }

    /**
     * Energy that motors and springs may give in a half, J: impulse times the speed that is wanted,
     * as a motor brakes beyond that, and what is stored.
     */
    double work() {
        double sum = 0;
        for (int k = 0; k < s.joint.length && s.isDriven; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                if (store.role[row] == JointStore.MOTOR) {
                    sum +=
                            Math.min(Math.abs(s.impulse[r]), bound(row))
                                    * Math.abs(store.target[row]);
                }
            }
        }
        return s.isDriven ? 2 * (sum + stored()) : 0;
    }

    /**
     * Notes what may be given in the sub-step: in two halves, and what springs hold at its begin.
     *
     * @param isBegin or else its end, when motors' impulses are known
     */
    public void give(SubStep sub, boolean isBegin) {
        h = sub.seconds;
        double work = s.isNet ? 0 : 2 * work();
        s.given = isBegin ? work : Math.max(s.given, work);
    }

    /** Energy of motion of the assembly and of what it is solved with, J. */
    double motion(ConstraintRows rows) {
        double sum = kinetic();
        for (int e = s.standCount; e < s.touchCount; e++) {
            int slot = freeSlot(rows, s.stand[e]);
            sum += isFirst(rows, e, slot) ? JointEnergy.kinetic(tick, slot) : 0;
        }
        return sum;
    }

    /**
     * Energy that contacts may leave beside what there is, J: of all moving at the speed with which
     * overlaps are pushed out, or some times as fast as what is driven.
     */
    double pushed(ConstraintRows rows, SubStep sub) {
        double fastest = sub.pushSpeed;
        for (int e = 0; e < s.standCount; e++) {
            int j = rows.list.place[s.stand[e]] * ConstraintRows.LINK;
            for (int side = 0; side < 2; side++) {
                int o = rows.link[j + side];
                boolean isDriven = o >= tick.body.drivenFrom;
                double twice = isDriven ? DrivenSides.fastest(tick.body, o) : 0;
                fastest = Math.max(fastest, 0.5 * LEVERAGE * twice);
            }
        }
        return 0.5 * mass(rows) * fastest * fastest;
    }
}
