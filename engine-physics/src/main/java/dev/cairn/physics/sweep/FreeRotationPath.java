package dev.cairn.physics.sweep;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.solver.body.FreeRotation;
import dev.cairn.physics.solver.body.PrincipalAxes;

/**
 * How a body that nothing turns lies at any time of a tick: by {@link FreeRotation}, so that its
 * angular momentum and its energy are at each time what they were, to rounding.
 *
 * <p>With two equal moments in closed form. With three by steps of a fixed length s from the start,
 * and one of the rest: the n-th step's end is kept, and a look at the time t costs one step. Back
 * from the time t = n s + r the same steps are taken in the other order, first -r, then n times -s,
 * so that forwards from there it comes to where it was. Of a body that turns by more than 128 rad
 * in a tick only the mean motion is known.
 *
 * <p>One thread. Allocates when it is made.
 */
public final class FreeRotationPath {
    /** The turn of a step, rad, and how many steps a tick has at most. */
    private static final double TURN = 0.25;

    private static final int STEPS = 128;

    /** The turn of a tick, rad, from which on only the mean is known. */
    private static final double WHIRL = 128;

    /** Numbers to a state: orientation and angular velocity. */
    private static final int STATE = 7;

    /** Square of the sine between w and I w that is rounding. */
    private static final double STEADY = 0x1p-80;

    /** Bodies whose principal axes are kept: one of each slot modulo this power of two. */
    private static final int KEPT = 512;

    /** The body that turns, alone. */
    private final BodyStore one = new BodyStore();

    private final PrincipalAxes axes = new PrincipalAxes();
    private final double[] kept = new double[KEPT * PrincipalAxes.STRIDE];

    /** Ends of steps. */
    private final double[] ends = new double[STATE * (STEPS + 1)];

    /** How many of them are known, the start among them. */
    private int known;

    private double span;
    private boolean isSymmetric, whirls;
    private double most;

    /** At a time: angular velocity, rad/s, world. */
    private final double[] w = new double[3];

    private final double[] v = new double[3], turn = new double[4], tensor = new double[9];

    /** Any body, until one is chosen. */
    public FreeRotationPath() {
        one.ensureCapacity(1);
        axes.ensureCapacity(1);
    }

    /**
     * Chooses a body as it is in a store: orientation and angular velocity are those of the start.
     *
     * @param s bodies
     * @param body slot
     * @param tick how far it is looked at, s
     * @return whether it tumbles; otherwise it keeps its angular velocity, and is not looked at
     *     here
     */
    public boolean begin(BodyStore s, int body, double tick) {
        double[] e = ends;
        e[0] = s.orientationX[body];
        e[1] = s.orientationY[body];
        e[2] = s.orientationZ[body];
        e[3] = s.orientationW[body];
        e[4] = s.angularVelocityX[body];
        e[5] = s.angularVelocityY[body];
        e[6] = s.angularVelocityZ[body];
        if (isSteady(s, body, e)) {
            return false;
        }
        inertia(s, body);
        known = 1;
        load(0);
        pace(tick);
        return true;
    }

    private void inertia(BodyStore s, int body) {
        one.inertiaXX[0] = s.inertiaXX[body];
        one.inertiaYY[0] = s.inertiaYY[body];
        one.inertiaZZ[0] = s.inertiaZZ[body];
        one.inertiaXY[0] = s.inertiaXY[body];
        one.inertiaXZ[0] = s.inertiaXZ[body];
        one.inertiaYZ[0] = s.inertiaYZ[body];
        // they cost more than all else here, and are looked for again in the next search
        int at = (body & KEPT - 1) * PrincipalAxes.STRIDE;
        System.arraycopy(kept, at, axes.data, 0, PrincipalAxes.STRIDE);
        if (!axes.isCurrent(one, 0)) {
            axes.find(one, 0, tensor, turn);
        }
        System.arraycopy(axes.data, 0, kept, at, PrincipalAxes.STRIDE);
        isSymmetric = FreeRotation.symmetry(axes.data, 0) >= 0;
    }

    /** Chooses the steps, which go by what does not change as the body turns. */
    private void pace(double tick) {
        most = Math.sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        if (isSymmetric) {
            return;
        }
        most = Math.max(most, FreeRotation.fastest(one, 0, axes.data, w));
        whirls = !(tick * most <= WHIRL);
        span = tick / Math.max(1, Math.min(Math.ceil(tick * most / TURN), STEPS));
    }

    /** How fast the body turns at most, at any time, rad/s. */
    public double most() {
        return most;
    }

    /**
     * Turns the body from its start.
     *
     * @param t s, from 0 to the length of the tick
     */
    public void move(double t) {
        if (isSymmetric || whirls) {
            load(0);
            turn(t);
            return;
        }
        int n = steps(t);
        while (known <= n) {
            load(known - 1);
            turn(span);
            save(known++);
        }
        load(n);
        turn(t - n * span);
    }

    private int steps(double t) {
        return Math.max(0, Math.min(STEPS, (int) (t / span)));
    }

    /**
     * Finds where a body was at the start, and how it turned then, if it is so at a time.
     *
     * @param s bodies; of this one the inertia is read
     * @param body slot
     * @param tick see {@link #begin}
     * @param t that time, s
     * @param state orientation and angular velocity, at the time; receives those of the start
     */
    public void back(BodyStore s, int body, double tick, double t, double[] state) {
        unit(state, 0);
        if (isSteady(s, body, state)) {
            turnBack(state, t);
            return;
        }
        inertia(s, body);
        System.arraycopy(state, 0, ends, 0, STATE);
        load(0);
        pace(tick);
        if (isSymmetric || whirls) {
            turn(-t);
        } else {
            int n = steps(t);
            turn(n * span - t);
            for (int i = 0; i < n; i++) {
                turn(-span);
            }
        }
        save(0);
        System.arraycopy(ends, 0, state, 0, STATE);
    }

    /**
     * Makes an orientation a unit one that was found by a {@link Flight}, which turns the
     * orientation of the start: the error of a body that is struck again and again would double
     * each time.
     */
    public static void unit(double[] q, int at) {
        double square =
                q[at] * q[at]
                        + q[at + 1] * q[at + 1]
                        + q[at + 2] * q[at + 2]
                        + q[at + 3] * q[at + 3];
        double unit = 1 / Math.sqrt(square);
        for (int c = at; c < at + 4; c++) {
            q[c] *= unit;
        }
    }

    private void turn(double t) {
        if (t == 0) {
            return;
        }
        if (whirls && !isSymmetric) {
            FreeRotation.turnInTheMean(one, 0, axes.data, w, t);
        } else {
            FreeRotation.turn(one, 0, axes.data, w, 0, t, 1);
        }
    }

    private void load(int at) {
        int k = STATE * at;
        one.orientationX[0] = ends[k];
        one.orientationY[0] = ends[k + 1];
        one.orientationZ[0] = ends[k + 2];
        one.orientationW[0] = ends[k + 3];
        System.arraycopy(ends, k + 4, w, 0, 3);
    }

    private void save(int at) {
        int k = STATE * at;
        ends[k] = one.orientationX[0];
        ends[k + 1] = one.orientationY[0];
        ends[k + 2] = one.orientationZ[0];
        ends[k + 3] = one.orientationW[0];
        System.arraycopy(w, 0, ends, k + 4, 3);
    }

    /**
     * The turn from the start to where the body is.
     *
     * @param out receives the unit quaternion, and the angular velocity there
     */
    public void turned(double[] out) {
        double x = one.orientationX[0];
        double y = one.orientationY[0];
        double z = one.orientationZ[0];
        double a = one.orientationW[0];
        double px = -ends[0];
        double py = -ends[1];
        double pz = -ends[2];
        double pw = ends[3];
        out[0] = a * px + x * pw + (y * pz - z * py);
        out[1] = a * py + y * pw + (z * px - x * pz);
        out[2] = a * pz + z * pw + (x * py - y * px);
        out[3] = a * pw - (x * px + y * py + z * pz);
        System.arraycopy(w, 0, out, 4, 3);
    }

    /** {@link #back} of a body that keeps its angular velocity. */
    private void turnBack(double[] q, double t) {
        double rate = Math.sqrt(q[4] * q[4] + q[5] * q[5] + q[6] * q[6]);
        if (rate == 0) {
            return;
        }
        Rotations.turn(-q[4], -q[5], -q[6], rate, t, turn);
        double x = turn[3] * q[0] + turn[0] * q[3] + turn[1] * q[2] - turn[2] * q[1];
        double y = turn[3] * q[1] - turn[0] * q[2] + turn[1] * q[3] + turn[2] * q[0];
        double z = turn[3] * q[2] + turn[0] * q[1] - turn[1] * q[0] + turn[2] * q[3];
        double w = turn[3] * q[3] - turn[0] * q[0] - turn[1] * q[1] - turn[2] * q[2];
        double unit = 1 / Math.sqrt(x * x + y * y + z * z + w * w);
        q[0] = x * unit;
        q[1] = y * unit;
        q[2] = z * unit;
        q[3] = w * unit;
    }

    /**
     * Whether a body turns about a principal axis, so that its angular velocity stays: w x I w = 0.
     */
    private boolean isSteady(BodyStore s, int body, double[] state) {
        // in body axes
        Rotations.rotate(
                -state[0], -state[1], -state[2], state[3], state[4], state[5], state[6], v);
        double x = v[0];
        double y = v[1];
        double z = v[2];
        double lx = s.inertiaXX[body] * x + s.inertiaXY[body] * y + s.inertiaXZ[body] * z;
        double ly = s.inertiaXY[body] * x + s.inertiaYY[body] * y + s.inertiaYZ[body] * z;
        double lz = s.inertiaXZ[body] * x + s.inertiaYZ[body] * y + s.inertiaZZ[body] * z;
        double cx = y * lz - z * ly;
        double cy = z * lx - x * lz;
        double cz = x * ly - y * lx;
        double most = STEADY * (x * x + y * y + z * z) * (lx * lx + ly * ly + lz * lz);
        return cx * cx + cy * cy + cz * cz <= most;
    }

    /**
     * How far a torque may take a point of a body off its way within a tick, t²/2 J torque, at
     * most.
     *
     * @param step length of the tick, s
     * @param radius how far the point is from the centre of mass at most, m
     * @return m; 0 without a torque
     */
    public static double doubt(BodyStore s, int body, double step, double radius) {
        double x = s.torqueX[body];
        double y = s.torqueY[body];
        double z = s.torqueZ[body];
        if (x == 0 && y == 0 && z == 0) {
            return 0;
        }
        double least =
                s.inverseInertiaXX[body] + s.inverseInertiaYY[body] + s.inverseInertiaZZ[body];
        return 0.5 * step * step * least * Math.sqrt(x * x + y * y + z * z) * radius;
    }
}
