package dev.cairn.physics.solver.single;

import static dev.cairn.physics.solver.body.SolverBodies.GRAVITY;
import static dev.cairn.physics.solver.body.SolverBodies.LOADED;
import static dev.cairn.physics.solver.body.SolverBodies.MASS;
import static dev.cairn.physics.solver.body.SolverBodies.P;
import static dev.cairn.physics.solver.body.SolverBodies.V;
import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.MotionRecord;
import dev.cairn.physics.solver.body.Rotation;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.refresh.JacobianRefresh;
import dev.cairn.physics.solver.refresh.Rim;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * A body that rolls on its rim without slip, as a coin does: for the sub-step it is what it is, a
 * rigid body whose point of contact has no velocity and travels round the rim.
 *
 * <p>Problem: the deepest point of a flat disc travels hundreds of radians in a second. Sweeps hold
 * a point of the start of the sub-step, while the disc sinks beside it, and push it out again; the
 * points of the rim ahead seem to strike. That took the energy of Euler's disc within two turns.
 *
 * <p>With u the normal of the plane, a the axis, o the middle of the rim and R its radius, c = u.a,
 * s = sqrt(1 - c²), all in the body, the contact is at
 *
 * <pre>
 * r = o - R (u - c a)/s,      v = r x w
 * (I + m (r² - r r^T)) w' = t - w x I w - r x f + m r x (r' x w)
 * </pre>
 *
 * <p>with f the weight and forces, t the user's torque and r' the velocity of the place, seen from
 * the world: the law of momentum about the centre of mass, with the contact's force m v' - f. It is
 * solved by the classical method of Runge and Kutta (1901), in so many parts that neither the body
 * nor the place on its rim turns by more than {@link #PART}. The plane holds the place: height
 * follows from the pose. If the impulse that this needs pulls, or is more than friction holds, or
 * if the place goes round too fast, all is left as the sweeps have it. So it is where the tilt
 * changes far faster than the place goes round: that body tips over its rim, does not roll on it,
 * and will slip or land, which is for the sweeps.
 *
 * <p>One body at a time, any worker. Does not allocate. Source: own study; the equations are those
 * of E. J. Routh, Advanced Rigid Dynamics (1905), of a disc on a plane.
 */
final class RollingRim {
    /** Largest turn of a part of the sub-step, rad, and most parts. */
    private static final double PART = 0.02;

    private static final int PARTS = 64;

    /** Cosine of the largest way of the contact round the rim in a part. */
    private static final double NEAR = 0.995;

    /** Largest rate of the tilt over that of the place round the rim; beyond, the body tips. */
    private static final double TIPS = 2;

    /** Height of a rim across its solid, over the body's inner radius, up to which it lies flat. */
    private static final double FLAT = 1e-3;

    /** Gap over the radius of the rim that is rounding, and no gap. */
    private static final double CLOSED = 1e-9;

    /** Numbers of a state: orientation, angular velocity in the body, movement. */
    private static final int NUMBERS = 10;

    private static final int W = 4;
    private static final int X = 7;

    private final HeldPoint held = new HeldPoint();
    private final Rim rim = new Rim();
    private final double[] state = new double[NUMBERS], stage = new double[NUMBERS];
    private final double[] slope = new double[NUMBERS], sum = new double[NUMBERS];

    /** In the body, unit: from the middle of the rim to the contact; where that was a part ago. */
    private final double[] low = new double[3], before = new double[3];

    /** In the body: the normal, the contact, its velocity as seen from the world, w. */
    private final double[] u = new double[3], r = new double[3], to = new double[3];

    /** World: weight and forces, the user's torque. */
    private final double[] force = new double[3], torque = new double[3];

    /** Vectors in the body. */
    private final double[] f = new double[3], t = new double[3], v = new double[3];

    private final double[] spin = new double[3], momentum = new double[3];

    /**
     * Moments of inertia about the contact, row by row above the diagonal: xx, xy, xz, yy, yz, zz.
     */
    private final double[] about = new double[6];

    private double mass;

    /** Sine of the tilt at a stage; how fast the place goes round and the tilt changes, rad/s. */
    private double tilt, round, tips;

    /**
     * Start of a sub-step, before its kick and before impacts of the contact.
     *
     * @param rows with the body's only row at {@code place}
     * @param levers know the rim, and the contact at the tick's start
     * @return whether the body rolls in the sub-step, if the sweeps do not find it elsewhere
     */
    boolean begin(
            SolverContext tick,
            ConstraintRows rows,
            int place,
            int i,
            SubStep sub,
            JacobianRefresh levers) {
        SolverBodies s = tick.body;
        int o = SolverBodies.offset(i);
        int g = MotionRecord.STRIDE * i;
        int side = rows.link[place * LINK] == o ? -1 : 1;
        int source = rows.link[place * LINK + ConstraintRows.SOURCE];
        if (s.state[o + GRAVITY] != 1
                || rows.rolling.has(place)
                || !levers.rim(tick.bodies, tick.contacts, source, place, i, side, rim)) {
            return false;
        }
        HeldPoint.remember(tick.bodies, s, i);
        double friction = rows.get(rows.base(place) + FRICTION * rows.lanes);
        if (!step(tick, i, sub, s.state, o + V) || !held.isHeld(rim.up, 0, 1, 1, friction)) {
            return false;
        }
        s.motion[g + MotionRecord.CORNER] = MotionRecord.ROLLS;
        return true;
    }

    /**
     * End of a sub-step: puts a body that rolls where it goes.
     *
     * @param rows of doubles, with the body's only row at {@code place}
     * @param kept place of that row's first levers in {@code levers}
     * @return whether it was held; if not, nothing has changed
     */
    boolean run(
            SolverContext tick,
            ConstraintRows rows,
            int place,
            int i,
            SubStep sub,
            JacobianRefresh levers,
            int kept) {
        SolverBodies s = tick.body;
        BodyStore b = tick.bodies;
        int g = MotionRecord.STRIDE * i;
        int o = SolverBodies.offset(i);
        int side = rows.link[place * LINK] == o ? -1 : 1;
        int source = rows.link[place * LINK + ConstraintRows.SOURCE];
        if (s.motion[g + MotionRecord.CORNER] != MotionRecord.ROLLS
                || !levers.rim(b, tick.contacts, source, kept, i, side, rim)) {
            return false;
        }
        if (!step(tick, i, sub, s.motion, g)) {
            return false;
        }
        held.begin(b, i, state, 0);
        if (!held.isNear(b, i)) {
            held.restore(b, i);
            return false;
        }
        for (int k = 0; k < 3; k++) {
            s.state[o + P + k] = state[X + k];
            s.state[o + V + k] = world(k, v, 0);
            spin[k] = world(k, state, W);
        }
        s.weigh(i, spin[0], spin[1], spin[2]);
        s.state[o + LOADED] = 1;
        held.tell(s, b, i, rows, place, rim.point, side);
        return true;
    }

    /**
     * From the start of the sub-step; whether the body stays on the rim.
     *
     * @param velocity of the start, world, from {@code at} on
     */
    private boolean step(SolverContext tick, int i, SubStep sub, double[] velocity, int at) {
        BodyStore b = tick.bodies;
        double[] d = tick.body.motion;
        int g = MotionRecord.STRIDE * i;
        mass = 1 / tick.body.state[SolverBodies.offset(i) + MASS];
        double scale = mass * b.gravityScale[i];
        force[0] = scale * tick.gravity[0] + b.forceX[i];
        force[1] = scale * tick.gravity[1] + b.forceY[i];
        force[2] = scale * tick.gravity[2] + b.forceZ[i];
        torque[0] = b.torqueX[i];
        torque[1] = b.torqueY[i];
        torque[2] = b.torqueZ[i];
        System.arraycopy(d, g + MotionRecord.START + 6, state, 0, 4);
        System.arraycopy(d, g + MotionRecord.START, state, X, 3);
        double h = sub.seconds;
        if (!stop(b, i, d, g + MotionRecord.START + 3, velocity, at) || !(TIPS * round > tips)) {
            return false;
        }
        double gap = open();
        double parts = Math.ceil(h * (round + length(state, W)) / PART);
        if (gap > CLOSED * rim.radius + sub.touch || !(parts <= PARTS)) {
            return false;
        }
        int n = Math.max(1, (int) parts);
        for (int k = 0; k < n; k++) {
            System.arraycopy(low, 0, before, 0, 3);
            if (!part(b, i, h / n) || !place(state) || !isAhead()) {
                return false;
            }
        }
        // what overlaps is pushed out, what is open closes
        double speed = Math.min(-sub.fixedRate * gap, sub.pushSpeed);
        double lift = (gap > 0 ? 0 : gap + speed * h) - open();
        cross(r, state, W, v);
        for (int k = 0; k < 3; k++) {
            state[X + k] += lift * rim.up[k];
            held.impulse[k] = mass * (world(k, v, 0) - velocity[at + k]) - h * force[k];
        }
        return true;
    }

    /** Whether the place has gone round as far as a part may, and not to the other side. */
    private boolean isAhead() {
        return low[0] * before[0] + low[1] * before[1] + low[2] * before[2] > NEAR;
    }

    /** Momentum about the contact stays in what stops there: L = I w + (-r) x m v. */
    private boolean stop(BodyStore b, int i, double[] w, int k0, double[] velocity, int at) {
        turnIn(w, k0, state, W);
        if (!place(state) || !(rim.radius * tilt > FLAT * b.innerRadius[i])) {
            return false;
        }
        turnIn(velocity, at, v, 0);
        inertia(b, i, state, W, momentum);
        cross(v, r, 0, t);
        for (int k = 0; k < 3; k++) {
            momentum[k] += mass * t[k];
        }
        moments(b, i);
        solve(momentum, state, W);
        return place(state);
    }

    /** Turns a vector of the world into the body at {@code state}. */
    private void turnIn(double[] a, int at, double[] out, int o) {
        for (int k = 0; k < 3; k++) {
            out[o + k] =
                    axis(state, k, 0) * a[at]
                            + axis(state, k, 1) * a[at + 1]
                            + axis(state, k, 2) * a[at + 2];
        }
    }

    /** One step of the method of Runge and Kutta. */
    private boolean part(BodyStore b, int i, double h) {
        System.arraycopy(state, 0, stage, 0, NUMBERS);
        System.arraycopy(state, 0, sum, 0, NUMBERS);
        for (int n = 0; n < 4; n++) {
            if (!slope(b, i)) {
                return false;
            }
            double weight = n == 0 || n == 3 ? h / 6 : h / 3;
            double ahead = n < 2 ? 0.5 * h : h;
            for (int k = 0; k < NUMBERS; k++) {
                sum[k] += weight * slope[k];
                stage[k] = state[k] + ahead * slope[k];
            }
        }
        double norm = 0;
        for (int k = 0; k < 4; k++) {
            norm += sum[k] * sum[k];
        }
        norm = 1 / Math.sqrt(norm);
        for (int k = 0; k < NUMBERS; k++) {
            state[k] = k < 4 ? norm * sum[k] : sum[k];
        }
        return true;
    }

    /** How fast {@code stage} changes; false where the rim lies flat. */
    private boolean slope(BodyStore b, int i) {
        if (!place(stage)) {
            return false;
        }
        double x = stage[W];
        double y = stage[W + 1];
        double z = stage[W + 2];
        // q' = q w / 2
        slope[0] = 0.5 * (stage[3] * x + stage[1] * z - stage[2] * y);
        slope[1] = 0.5 * (stage[3] * y + stage[2] * x - stage[0] * z);
        slope[2] = 0.5 * (stage[3] * z + stage[0] * y - stage[1] * x);
        slope[3] = -0.5 * (stage[0] * x + stage[1] * y + stage[2] * z);
        for (int k = 0; k < 3; k++) {
            f[k] = 0;
            momentum[k] = 0;
            for (int c = 0; c < 3; c++) {
                double e = axis(stage, k, c);
                f[k] += e * force[c];
                momentum[k] += e * torque[c];
            }
        }
        // t - w x I w - r x f + m r x (r' x w)
        inertia(b, i, stage, W, t);
        cross(t, stage, W, v);
        add(momentum, v, 1);
        cross(f, r, 0, v);
        add(momentum, v, 1);
        cross(to, stage, W, t);
        cross(r, t, 0, v);
        add(momentum, v, mass);
        moments(b, i);
        solve(momentum, slope, W);
        cross(r, stage, W, v);
        for (int k = 0; k < 3; k++) {
            slope[X + k] =
                    axis(stage, 0, k) * v[0] + axis(stage, 1, k) * v[1] + axis(stage, 2, k) * v[2];
        }
        return true;
    }

    /** Finds the contact and its velocity; false where the rim lies flat. */
    private boolean place(double[] y) {
        double c = 0;
        for (int k = 0; k < 3; k++) {
            u[k] =
                    axis(y, k, 0) * rim.up[0]
                            + axis(y, k, 1) * rim.up[1]
                            + axis(y, k, 2) * rim.up[2];
            c += u[k] * rim.axis[k];
        }
        tilt = Math.sqrt(Math.max(0, 1 - c * c));
        if (!(tilt > 0)) {
            return false;
        }
        // u' = u x w, c' = u'.a
        cross(u, y, W, v);
        double turn = v[0] * rim.axis[0] + v[1] * rim.axis[1] + v[2] * rim.axis[2];
        tips = Math.abs(turn) / tilt;
        double bend = -c * turn / tilt;
        double square = 0;
        for (int k = 0; k < 3; k++) {
            low[k] = -(u[k] - c * rim.axis[k]) / tilt;
            double moves = -(v[k] - turn * rim.axis[k]) / tilt - low[k] * bend / tilt;
            square += moves * moves;
            r[k] = rim.middle[k] + rim.radius * low[k];
            to[k] = rim.radius * moves;
        }
        round = Math.sqrt(square);
        // as seen from the world: + w x r
        cross(r, y, W, v);
        add(to, v, -1);
        return true;
    }

    /** Gap of the deepest point of {@code state}, m; after {@link #place}. */
    private double open() {
        double height = -rim.level;
        for (int k = 0; k < 3; k++) {
            height += u[k] * r[k] + rim.up[k] * state[X + k];
        }
        return height;
    }

    /** {@code I + m (r² - r r^T)}. */
    private void moments(BodyStore b, int i) {
        double x = r[0];
        double y = r[1];
        double z = r[2];
        about[0] = b.inertiaXX[i] + mass * (y * y + z * z);
        about[1] = b.inertiaXY[i] - mass * (x * y);
        about[2] = b.inertiaXZ[i] - mass * (x * z);
        about[3] = b.inertiaYY[i] + mass * (x * x + z * z);
        about[4] = b.inertiaYZ[i] - mass * (y * z);
        about[5] = b.inertiaZZ[i] + mass * (x * x + y * y);
    }

    /** Solves for the moments about the contact, by cofactors. */
    private void solve(double[] right, double[] out, int o) {
        double[] a = about;
        double xx = a[3] * a[5] - a[4] * a[4];
        double xy = a[2] * a[4] - a[1] * a[5];
        double xz = a[1] * a[4] - a[2] * a[3];
        double k = 1 / (a[0] * xx + a[1] * xy + a[2] * xz);
        double yz = a[1] * a[2] - a[0] * a[4];
        double p = right[0];
        double q = right[1];
        double s = right[2];
        out[o] = k * (xx * p + xy * q + xz * s);
        out[o + 1] = k * (xy * p + (a[0] * a[5] - a[2] * a[2]) * q + yz * s);
        out[o + 2] = k * (xz * p + yz * q + (a[0] * a[3] - a[1] * a[1]) * s);
    }

    /** Momentum about the centre of mass, in the body. */
    private static void inertia(BodyStore b, int i, double[] w, int o, double[] out) {
        double x = w[o];
        double y = w[o + 1];
        double z = w[o + 2];
        out[0] = b.inertiaXX[i] * x + b.inertiaXY[i] * y + b.inertiaXZ[i] * z;
        out[1] = b.inertiaXY[i] * x + b.inertiaYY[i] * y + b.inertiaYZ[i] * z;
        out[2] = b.inertiaXZ[i] * x + b.inertiaYZ[i] * y + b.inertiaZZ[i] * z;
    }

    private static void cross(double[] a, double[] b, int o, double[] out) {
        double x = a[1] * b[o + 2] - a[2] * b[o + 1];
        double y = a[2] * b[o] - a[0] * b[o + 2];
        out[2] = a[0] * b[o + 1] - a[1] * b[o];
        out[0] = x;
        out[1] = y;
    }

    private static void add(double[] sum, double[] a, double scale) {
        for (int k = 0; k < 3; k++) {
            sum[k] += scale * a[k];
        }
    }

    private static double length(double[] a, int o) {
        return Math.sqrt(a[o] * a[o] + a[o + 1] * a[o + 1] + a[o + 2] * a[o + 2]);
    }

    /** Component k, world, of an axis of the body. */
    private static double axis(double[] q, int axis, int k) {
        return Rotation.axis(q[0], q[1], q[2], q[3], axis, k);
    }

    /** Component k, world, of a vector in the body at {@code state}. */
    private double world(int k, double[] a, int o) {
        return axis(state, 0, k) * a[o]
                + axis(state, 1, k) * a[o + 1]
                + axis(state, 2, k) * a[o + 2];
    }
}
