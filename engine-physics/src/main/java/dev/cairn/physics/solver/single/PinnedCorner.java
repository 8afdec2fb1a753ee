package dev.cairn.physics.solver.single;

import static dev.cairn.physics.solver.body.SolverBodies.GRAVITY;
import static dev.cairn.physics.solver.body.SolverBodies.LOADED;
import static dev.cairn.physics.solver.body.SolverBodies.MASS;
import static dev.cairn.physics.solver.body.SolverBodies.P;
import static dev.cairn.physics.solver.body.SolverBodies.V;
import static dev.cairn.physics.solver.row.ConstraintRows.*;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.AxisLocks;
import dev.cairn.physics.solver.body.FreeRotation;
import dev.cairn.physics.solver.body.MotionRecord;
import dev.cairn.physics.solver.body.PrincipalAxes;
import dev.cairn.physics.solver.body.Rotation;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.refresh.JacobianRefresh;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.RollingRows;
import dev.cairn.physics.solver.row.SubStep;

import java.util.Arrays;

/**
 * A body that stands and turns on one corner, held there by friction: for the sub-step it is what
 * it is, a rigid body pinned at that point.
 *
 * <p>Problem: sweeps stop the corner at one end of the sub-step. That drives the nutation of a top,
 * whose period they hardly resolve: at 32 sub-steps it grew by a tenth a tick, at any number until
 * the corner slipped, so that the tilt of a steady top did not converge.
 *
 * <p>About a fixed point the body turns freely but for its weight, and so: half a kick of the
 * moment of weight and forces about the point; free rotation with the inertia about the point,
 * exact or nearly ({@link FreeRotation}); half a kick at the new pose. Symmetric and of the second
 * order; without weight it is the free motion itself, at any speed. The corner stays where it is,
 * but for what it is pushed out of an overlap. The contact's impulse is what the body's momentum
 * lacks then. If that pulls, or is more than friction holds, the body slips or lifts: then all is
 * left as the sweeps have it.
 *
 * <p>Only corners of polyhedra and tips of cones, which stay the same point of the body, on what is
 * flat or edged and does not move. One body at a time, any worker. Does not allocate. Source: own
 * study; for the splitting see {@link Rotation}.
 */
final class PinnedCorner {
    private static final int SWEEPS = 12;

    /** Products of inertia over the moments that are none. */
    private static final double DIAGONAL = 1e-15;

    /** Principal axes about the corner, as {@link PrincipalAxes} has them, and what they are of. */
    private final double[] axes = new double[PrincipalAxes.STRIDE];

    private final double[] matrix = new double[9];
    private final double[] turn = new double[4];

    /** From the centre of mass to the corner at the tick's start, in the world and in the body. */
    private final double[] arm = new double[6];

    /** From the corner to the centre of mass, at the start and the end. */
    private final double[] from = new double[3];

    private final double[] to = new double[3];

    /** About the corner. */
    private final double[] momentum = new double[3];

    private final double[] spin = new double[3];
    private final double[] force = new double[3];
    private final HeldPoint held = new HeldPoint();
    private final double[] impulse = held.impulse;

    /** The user's and that of rolling friction; of that the impulse. */
    private final double[] torque = new double[3];

    private final double[] roll = new double[3];

    /** Start of a sub-step, before its kick: remembers where a body is that stands on a point. */
    static void begin(
            BodyStore b, SolverBodies s, int i, ConstraintRows rows, int place, double touch) {
        double[] d = s.motion;
        int g = MotionRecord.STRIDE * i;
        int corner = d[g + MotionRecord.STRUCK] != 0 ? -1 : only(rows, place, touch);
        d[g + MotionRecord.STRUCK] = 0;
        d[g + MotionRecord.CORNER] = corner;
        if (corner >= 0) {
            HeldPoint.remember(b, s, i);
        }
    }

    /** The only point of a row that presses or touches, or -1. */
    private static int only(ConstraintRows rows, int place, double touch) {
        int o = rows.base(place);
        int found = -1;
        for (int p = 0; p < rows.points(place); p++) {
            int q = o + (POINT + p * POINT_FIELDS) * rows.lanes;
            if (rows.get(q + IMPULSE * rows.lanes) > 0
                    || rows.get(q + SEPARATION * rows.lanes) <= touch) {
                if (found >= 0) {
                    return -1;
                }
                found = p;
            }
        }
        return found;
    }

    /**
     * End of a sub-step: puts a body that stood on one point where it goes if that is held.
     *
     * @param rows of doubles, with the body's only row at {@code place}
     * @param kept place of that row's first levers in {@code levers}, and in {@code rolling}
     * @return whether it was held; if not, nothing has changed
     */
    boolean run(
            SolverContext tick,
            ConstraintRows rows,
            RollingRows rolling,
            int place,
            int i,
            SubStep sub,
            JacobianRefresh levers,
            int kept) {
        SolverBodies s = tick.body;
        BodyStore b = tick.bodies;
        int g = MotionRecord.STRIDE * i;
        int corner = (int) s.motion[g + MotionRecord.CORNER];
        int o = SolverBodies.offset(i);
        if (corner < 0 || s.state[o + GRAVITY] != 1 || pressesElsewhere(rows, place, corner)) {
            return false;
        }
        double side = rows.link[place * LINK] == o ? -1 : 1;
        int source = rows.link[place * LINK + ConstraintRows.SOURCE];
        double gap = levers.corner(b, tick.contacts, source, kept, corner, i, side, arm);
        if (Double.isNaN(gap) || !rolling.slips(rows, place, kept, side, roll)) {
            return false;
        }
        held.begin(b, i, s.motion, g + MotionRecord.START + 6);
        step(tick, i, sub.seconds, rolling.has(kept));
        int r = rows.base(place);
        double friction = rows.doubles[r + FRICTION * rows.lanes];
        if (!held.isNear(b, i) || !held.isHeld(rows.doubles, r, rows.lanes, side, friction)) {
            held.restore(b, i);
            return false;
        }
        put(s, rows, r, i, side, gap, sub);
        s.weigh(i, spin[0], spin[1], spin[2]);
        s.state[o + LOADED] = 1;
        held.tell(s, b, i, rows, place, corner, side);
        if (rolling.has(kept)) {
            rolling.addWarm(rows, s.warm, place, kept, 1);
        }
        return true;
    }

    /**
     * Moves the body; a corner that overlaps is pushed out, and one that is open closes.
     *
     * @param gap at the start of the tick
     */
    private void put(
            SolverBodies s,
            ConstraintRows rows,
            int r,
            int i,
            double side,
            double gap,
            SubStep sub) {
        // how far the corner has moved since the tick's start
        double[] d = s.motion;
        int g = MotionRecord.STRIDE * i;
        int o = SolverBodies.offset(i);
        double open = gap;
        for (int k = 0; k < 3; k++) {
            double moved = d[g + MotionRecord.START + k] - from[k] - arm[k];
            open += side * rows.doubles[r + k * rows.lanes] * moved;
        }
        double speed = Math.min(-sub.fixedRate * open, sub.pushSpeed);
        double rise = open > 0 ? -open : speed * sub.seconds;
        for (int k = 0; k < 3; k++) {
            double up = side * rows.doubles[r + k * rows.lanes];
            s.state[o + P + k] = d[g + MotionRecord.START + k] + (to[k] - from[k]) + rise * up;
        }
        s.state[o + V] = spin[1] * to[2] - spin[2] * to[1];
        s.state[o + V + 1] = spin[2] * to[0] - spin[0] * to[2];
        s.state[o + V + 2] = spin[0] * to[1] - spin[1] * to[0];
    }

    private static boolean pressesElsewhere(ConstraintRows rows, int place, int corner) {
        int o = rows.base(place);
        for (int p = 0; p < rows.points(place); p++) {
            int q = o + (POINT + p * POINT_FIELDS) * rows.lanes;
            if (p != corner && rows.doubles[q + IMPULSE * rows.lanes] > 0) {
                return true;
            }
        }
        return false;
    }

    /** From the start of the sub-step: half a kick, free rotation, half a kick. */
    private void step(SolverContext tick, int i, double h, boolean rolls) {
        SolverBodies s = tick.body;
        BodyStore b = tick.bodies;
        int g = MotionRecord.STRIDE * i;
        double[] d = s.motion;
        double mass = 1 / s.state[SolverBodies.offset(i) + MASS];
        double scale = mass * b.gravityScale[i];
        force[0] = scale * tick.gravity[0] + b.forceX[i];
        force[1] = scale * tick.gravity[1] + b.forceY[i];
        force[2] = scale * tick.gravity[2] + b.forceZ[i];
        double linear = 1;
        double angular = 1;
        if (b.motionFlags[i] != 0) {
            linear = AxisLocks.decay(b.linearDamping[i] * h);
            angular = AxisLocks.decay(b.angularDamping[i] * h);
        }
        moments(b, i, mass);
        lever(b, i, from);
        // L = I w + r x m v
        double x = mass * linear * d[g];
        double y = mass * linear * d[g + 1];
        double z = mass * linear * d[g + 2];
        impulse[0] = -x - h * force[0];
        impulse[1] = -y - h * force[1];
        impulse[2] = -z - h * force[2];
        for (int k = 0; k < 3; k++) {
            spin[k] = angular * d[g + MotionRecord.START + 3 + k];
        }
        torque[0] = b.torqueX[i];
        torque[1] = b.torqueY[i];
        torque[2] = b.torqueZ[i];
        for (int k = 0; k < 3 && rolls; k++) {
            torque[k] += roll[k] / h;
        }
        own(b, i);
        momentum[0] += from[1] * z - from[2] * y;
        momentum[1] += from[2] * x - from[0] * z;
        momentum[2] += from[0] * y - from[1] * x;
        kick(from, 0.5 * h);
        spin(b, i);
        FreeRotation.turn(b, i, axes, 0, spin, 0, h, 1);
        lever(b, i, to);
        kick(to, 0.5 * h);
        spin(b, i);
        impulse[0] += mass * (spin[1] * to[2] - spin[2] * to[1]);
        impulse[1] += mass * (spin[2] * to[0] - spin[0] * to[2]);
        impulse[2] += mass * (spin[0] * to[1] - spin[1] * to[0]);
    }

    /** Moments and principal axes about the corner: {@code I + m (r² - r r^T)}. */
    private void moments(BodyStore b, int i, double mass) {
        double x = arm[3];
        double y = arm[4];
        double z = arm[5];
        double[] a = matrix;
        a[0] = b.inertiaXX[i] + mass * (y * y + z * z);
        a[4] = b.inertiaYY[i] + mass * (x * x + z * z);
        a[8] = b.inertiaZZ[i] + mass * (x * x + y * y);
        a[1] = b.inertiaXY[i] - mass * (x * y);
        a[2] = b.inertiaXZ[i] - mass * (x * z);
        a[5] = b.inertiaYZ[i] - mass * (y * z);
        a[3] = a[1];
        a[6] = a[2];
        a[7] = a[5];
        Arrays.fill(turn, 0, 3, 0.0);
        turn[3] = 1;
        double size = Math.max(a[0], Math.max(a[4], a[8]));
        for (int n = 0; n < SWEEPS; n++) {
            double off = Math.max(Math.abs(a[1]), Math.max(Math.abs(a[2]), Math.abs(a[5])));
            if (!(off > DIAGONAL * size)) {
                break;
            }
            PrincipalAxes.sweep(a, turn);
        }
        axes[PrincipalAxes.MOMENT] = a[0];
        axes[PrincipalAxes.MOMENT + 1] = a[4];
        axes[PrincipalAxes.MOMENT + 2] = a[8];
        System.arraycopy(turn, 0, axes, PrincipalAxes.QX, 4);
    }

    /** From the corner to the centre of mass. */
    private void lever(BodyStore b, int i, double[] out) {
        for (int k = 0; k < 3; k++) {
            out[k] =
                    -(Rotation.axis(b, i, 0, k) * arm[3]
                            + Rotation.axis(b, i, 1, k) * arm[4]
                            + Rotation.axis(b, i, 2, k) * arm[5]);
        }
    }

    /** Momentum about the centre of mass. */
    private void own(BodyStore b, int i) {
        double x = along(b, i, 0, spin);
        double y = along(b, i, 1, spin);
        double z = along(b, i, 2, spin);
        double u = b.inertiaXX[i] * x + b.inertiaXY[i] * y + b.inertiaXZ[i] * z;
        double v = b.inertiaXY[i] * x + b.inertiaYY[i] * y + b.inertiaYZ[i] * z;
        double w = b.inertiaXZ[i] * x + b.inertiaYZ[i] * y + b.inertiaZZ[i] * z;
        for (int k = 0; k < 3; k++) {
            momentum[k] =
                    Rotation.axis(b, i, 0, k) * u
                            + Rotation.axis(b, i, 1, k) * v
                            + Rotation.axis(b, i, 2, k) * w;
        }
    }

    /** Component of a world vector along an axis of the body. */
    private static double along(BodyStore b, int i, int axis, double[] v) {
        return Rotation.axis(b, i, axis, 0) * v[0]
                + Rotation.axis(b, i, axis, 1) * v[1]
                + Rotation.axis(b, i, axis, 2) * v[2];
    }

    /** {@code L += t (r x f + torque)}. */
    private void kick(double[] r, double t) {
        momentum[0] += t * (r[1] * force[2] - r[2] * force[1] + torque[0]);
        momentum[1] += t * (r[2] * force[0] - r[0] * force[2] + torque[1]);
        momentum[2] += t * (r[0] * force[1] - r[1] * force[0] + torque[2]);
    }

    /** {@code w = I^-1 L} about the corner. */
    private void spin(BodyStore b, int i) {
        Arrays.fill(spin, 0.0);
        for (int axis = 0; axis < 3; axis++) {
            double x = PrincipalAxes.column(axes, axis, 0);
            double y = PrincipalAxes.column(axes, axis, 1);
            double z = PrincipalAxes.column(axes, axis, 2);
            double part =
                    (x * along(b, i, 0, momentum)
                                    + y * along(b, i, 1, momentum)
                                    + z * along(b, i, 2, momentum))
                            / axes[PrincipalAxes.MOMENT + axis];
            for (int k = 0; k < 3; k++) {
                spin[k] +=
                        part
                                * (x * Rotation.axis(b, i, 0, k)
                                        + y * Rotation.axis(b, i, 1, k)
                                        + z * Rotation.axis(b, i, 2, k));
            }
        }
    }
}
