package dev.cairn.physics.state;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.Rotation;

import java.util.Arrays;

/**
 * What kinematic bodies do: at the start of a tick a target becomes the velocity that leads there,
 * at its end each body is where its velocity, or its target, has it.
 *
 * <p>A target holds for one tick; without another one the body then stands still. It is reached to
 * the bit, not by adding up. Simulation thread; allocates only when slots are added, and nothing in
 * a world without targets.
 */
public final class KinematicMotion {
    /** Numbers to a target: place of the centre of mass, orientation, way and turn until there. */
    private static final int STRIDE = 13;

    private static final byte NONE = 0;
    private static final byte AIMED = 1;

    /** The velocity of the last tick led to a target. */
    private static final byte ARRIVED = 2;

    private final BodyStore bodies;
    private byte[] state = {};
    private double[] target = {};

    /**
     * Numbers to a body of {@link #past}: mean velocities of the last tick and of the one before,
     * and the velocity at the end of the last tick without that of turning. Not a number where a
     * body is new.
     */
    private static final int PAST = 15;

    /** Where in it the velocity at the end is. */
    private static final int END = 12;

    /** Of what gravity adds in a tick: by so much may a line miss the next mean, to be trusted. */
    private static final double TRUST = 1.0 / 16;

    /** Change of a velocity over what gravity makes of it in a tick that is rounding. */
    private static final double SAME = 1e-10;

    private double[] past = {};

    /** Lengths of the last tick and of the one before, s. */
    private double last, beforeLast;

    /** Length of this tick over that of the last. */
    private double grown;

    /** By slot: whether the body moved in the last tick. */
    private boolean[] moved = {};

    /** Without bodies. */
    public KinematicMotion(BodyStore bodies) {
        this.bodies = bodies;
    }

    /** Grows the columns. */
    public void ensureSlots(int slots) {
        if (state.length < slots) {
            int n = Math.max(slots, bodies.kind.length);
            state = Arrays.copyOf(state, n);
            moved = Arrays.copyOf(moved, n);
            if (past.length > 0) {
                growPast(n);
            }
            if (target.length > 0) {
                target = Arrays.copyOf(target, STRIDE * n);
            }
        }
    }

    /** Targets, and which bodies moved; slots have room already. */
    void state(StateVisitor s, int slots) {
        s.section("kinematic", this);
        boolean aims = s.value("aims", target.length > 0);
        if (aims && target.length == 0) {
            target = new double[STRIDE * state.length];
        }
        state = s.array("state", state, slots);
        moved = s.array("moved", moved, slots);
        last = s.value("last", last);
        beforeLast = s.value("beforeLast", beforeLast);
        boolean knows = s.value("knows", past.length > 0);
        if (knows) {
            ensurePast();
            past = s.array("past", past, PAST * slots);
        } else if (s.isRestoring()) {
            Arrays.fill(past, Double.NaN);
        }
        if (aims) {
            target = s.array("target", target, STRIDE * slots);
        }
    }

    /** A slot has another body, or the body another place or velocity: no target holds. */
    public void forget(int slot) {
        state[slot] = NONE;
    }

    /** The same for a body that is new in its slot. */
    public void born(int slot) {
        state[slot] = NONE;
        moved[slot] = false;
        if (past.length > 0) {
            Arrays.fill(past, PAST * slot, PAST * (slot + 1), Double.NaN);
        }
    }

    /** Room for what was before, from the first kinematic body on. */
    private void ensurePast() {
        if (past.length < PAST * state.length) {
            growPast(state.length);
        }
        if (bodies.ramp.length < BodyStore.RAMP * state.length) {
            bodies.ramp = new double[BodyStore.RAMP * state.length];
            bodies.surges = new boolean[state.length];
        }
    }

    private void growPast(int slots) {
        int old = past.length;
        past = Arrays.copyOf(past, PAST * slots);
        Arrays.fill(past, old, past.length, Double.NaN);
    }

    /**
     * Sets where a body shall be at the end of the next tick.
     *
     * @param slot of a kinematic body
     * @param x centre of mass, world, m
     * @param qx unit quaternion, worldFromBody
     */
    public void aim(
            int slot, double x, double y, double z, double qx, double qy, double qz, double qw) {
        if (target.length == 0) {
            target = new double[STRIDE * state.length];
        }
        BodyStore b = bodies;
        int t = STRIDE * slot;
        target[t] = x;
        target[t + 1] = y;
        target[t + 2] = z;
        target[t + 3] = qx;
        target[t + 4] = qy;
        target[t + 5] = qz;
        target[t + 6] = qw;
        target[t + 7] = x - b.positionX[slot];
        target[t + 8] = y - b.positionY[slot];
        target[t + 9] = z - b.positionZ[slot];
        turn(b, slot, t);
        state[slot] = AIMED;
    }

    /** The rotation vector of {@code q q0^-1}, the shorter way round; set-up, so StrictMath. */
    private void turn(BodyStore b, int slot, int t) {
        double px = -b.orientationX[slot];
        double py = -b.orientationY[slot];
        double pz = -b.orientationZ[slot];
        double pw = b.orientationW[slot];
        double bx = target[t + 3];
        double by = target[t + 4];
        double bz = target[t + 5];
        double bw = target[t + 6];
        double x = bw * px + bx * pw + (by * pz - bz * py);
        double y = bw * py + by * pw + (bz * px - bx * pz);
        double z = bw * pz + bz * pw + (bx * py - by * px);
        double w = bw * pw - (bx * px + by * py + bz * pz);
        double sine = Math.sqrt(x * x + y * y + z * z);
        double angle = 2 * StrictMath.atan2(sine, Math.abs(w));
        double k = sine == 0 ? 0 : (w < 0 ? -angle : angle) / sine;
        target[t + 10] = k * x;
        target[t + 11] = k * y;
        target[t + 12] = k * z;
    }

    /**
     * Start of a tick: velocities of those with a target; counts those that move.
     *
     * @param stepSeconds length of the tick, s
     * @param gravity its magnitude, m/s²
     */
    public void begin(int[] slots, int count, double stepSeconds, double gravity) {
        BodyStore b = bodies;
        b.driven = b.belts;
        b.surging = false;
        if (count > 0) {
            ensurePast();
        }
        for (int k = 0; k < count; k++) {
            int s = slots[k];
            knowPast(s);
            if (state[s] == AIMED) {
                int t = STRIDE * s;
                b.velocityX[s] = target[t + 7] / stepSeconds;
                b.velocityY[s] = target[t + 8] / stepSeconds;
                b.velocityZ[s] = target[t + 9] / stepSeconds;
                b.angularVelocityX[s] = target[t + 10] / stepSeconds;
                b.angularVelocityY[s] = target[t + 11] / stepSeconds;
                b.angularVelocityZ[s] = target[t + 12] / stepSeconds;
            } else if (state[s] == ARRIVED) {
                b.stop(s);
                state[s] = NONE;
            }
            b.driven++; // so that isDriven looks
            if (!b.isDriven(s)) {
                b.driven--;
            }
            ramp(s, stepSeconds, gravity * stepSeconds);
        }
        beforeLast = last;
        last = stepSeconds;
    }

    /** A body that is new has always moved as it does. */
    private void knowPast(int slot) {
        int p = PAST * slot;
        if (!Double.isNaN(past[p])) {
            return;
        }
        BodyStore b = bodies;
        past[p] = b.velocityX[slot];
        past[p + 1] = b.velocityY[slot];
        past[p + 2] = b.velocityZ[slot];
        past[p + 3] = b.angularVelocityX[slot];
        past[p + 4] = b.angularVelocityY[slot];
        past[p + 5] = b.angularVelocityZ[slot];
        System.arraycopy(past, p, past, p + 6, 6);
        System.arraycopy(past, p, past, p + END, 3);
    }

    /**
     * How the velocity changes within the tick. What is known are the mean velocities u of this
     * tick and of those before, and the velocity e at the end of the last. Of a target, where a
     * tick changes the velocity by less than gravity would: if the last tick's line fits the means
     * of the last two, it goes on from e, by 2 (u - e), whatever it did before; a body that stood
     * goes on from there, by 2 u; else the smaller of the slopes u - u' and 2 (u - e). Of a
     * velocity that is told, or that changes by more, a line through the means that does not go
     * beyond any: the smaller of u - u' and u' - u''. None where two differ in sign (minmod; P. Roe
     * 1986). So what speeds up evenly does so within the tick too, and a velocity that jumps,
     * jumps.
     */
    private void ramp(int slot, double stepSeconds, double soft) {
        BodyStore b = bodies;
        int p = PAST * slot;
        int r = BodyStore.RAMP * slot;
        double ofLast = last > 0 ? last : stepSeconds;
        double first = 2 * stepSeconds / (stepSeconds + ofLast);
        double second = beforeLast > 0 ? 2 * stepSeconds / (last + beforeLast) : 0;
        grown = stepSeconds / ofLast;
        boolean stood = past[p] == 0 && past[p + 1] == 0 && past[p + 2] == 0;
        double gentle = state[slot] == AIMED ? soft : 0;
        double x = slope(p, b.velocityX[slot], first, second, stood, gentle);
        double y = slope(p + 1, b.velocityY[slot], first, second, stood, gentle);
        double z = slope(p + 2, b.velocityZ[slot], first, second, stood, gentle);
        boolean surges = surges(p, b.velocityX[slot], b.velocityY[slot], b.velocityZ[slot], soft);
        double u = b.angularVelocityX[slot];
        double v = b.angularVelocityY[slot];
        double w = b.angularVelocityZ[slot];
        // of a turn the change along the axis counts: dw.w/w²
        double along =
                u * slope(p + 3, u, first, second, false, 0)
                        + v * slope(p + 4, v, first, second, false, 0)
                        + w * slope(p + 5, w, first, second, false, 0);
        double square = u * u + v * v + w * w;
        // what stands still in this tick is not moved to and fro
        boolean moves =
                square != 0
                        || b.velocityX[slot] != 0
                        || b.velocityY[slot] != 0
                        || b.velocityZ[slot] != 0;
        b.ramp[r] = moves ? x : 0;
        b.ramp[r + 1] = moves ? y : 0;
        b.ramp[r + 2] = moves ? z : 0;
        b.ramp[r + 3] = square > 0 ? along / square : 0;
        past[p + END] = b.velocityX[slot] + 0.5 * b.ramp[r];
        past[p + END + 1] = b.velocityY[slot] + 0.5 * b.ramp[r + 1];
        past[p + END + 2] = b.velocityZ[slot] + 0.5 * b.ramp[r + 2];
        b.surges[slot] = surges;
        b.surging |= surges;
        for (int c = 0; c < 6; c++) {
            past[p + 6 + c] = past[p + c];
        }
        past[p] = b.velocityX[slot];
        past[p + 1] = b.velocityY[slot];
        past[p + 2] = b.velocityZ[slot];
        past[p + 3] = u;
        past[p + 4] = v;
        past[p + 5] = w;
    }

    /** Whether the velocity of this tick, or that of the last, is another one than before. */
    private boolean surges(int p, double vx, double vy, double vz, double soft) {
        double now =
                Math.max(
                        Math.abs(vx - past[p]),
                        Math.max(Math.abs(vy - past[p + 1]), Math.abs(vz - past[p + 2])));
        double then = 0;
        for (int c = p; c < p + 3; c++) {
            then = Math.max(then, Math.abs(past[c] - past[c + 6]));
        }
        return Math.max(now, then) > SAME * soft;
    }

    /**
     * Whether the line of the last tick fits the means of the last two: then the end of it is where
     * this tick goes on from, also where the slope is another one from now on.
     */
    private boolean fits(int p, double between, double gentle) {
        double line = 2 * (past[p + END] - past[p]) * grown;
        return Math.abs(line - between) <= TRUST * gentle;
    }

    /** Slope by tick of one component. */
    private double slope(
            int p, double now, double first, double second, boolean stood, double gentle) {
        double before = past[p];
        double a = (now - before) * first;
        double c = (before - past[p + 6]) * second;
        if (gentle > 0) {
            // not of a turn, whose end is not known
            if (stood) {
                return 2 * Math.abs(now) <= gentle ? 2 * now : 0;
            }
            double line = 2 * (now - past[p + END]);
            if (Math.abs(line) <= gentle && fits(p, c, gentle)) {
                return line;
            }
            if (Math.abs(a) <= gentle) {
                c = line;
            }
        }
        if (!(a * c > 0)) {
            return 0;
        }
        return Math.abs(a) < Math.abs(c) ? a : c;
    }

    /**
     * Whether a body moved in the last tick and does not in this one, or the reverse: asks once.
     */
    public boolean takeChange(int slot) {
        boolean now = bodies.isDriven(slot);
        boolean was = moved[slot];
        moved[slot] = now;
        return now != was;
    }

    /** End of a tick: all are where they shall be. */
    public void end(int[] slots, int count, double stepSeconds) {
        BodyStore b = bodies;
        for (int k = 0; b.driven > 0 && k < count; k++) {
            int s = slots[k];
            if (!b.isDriven(s)) {
                continue;
            }
            if (state[s] == AIMED) {
                int t = STRIDE * s;
                b.place(s, target[t], target[t + 1], target[t + 2]);
                b.orientationX[s] = target[t + 3];
                b.orientationY[s] = target[t + 4];
                b.orientationZ[s] = target[t + 5];
                b.orientationW[s] = target[t + 6];
            } else {
                b.move(
                        s,
                        stepSeconds * b.velocityX[s],
                        stepSeconds * b.velocityY[s],
                        stepSeconds * b.velocityZ[s]);
                Rotation.turn(
                        b,
                        s,
                        stepSeconds * b.angularVelocityX[s],
                        stepSeconds * b.angularVelocityY[s],
                        stepSeconds * b.angularVelocityZ[s]);
            }
        }
        for (int k = 0; k < count; k++) {
            if (state[slots[k]] == AIMED) {
                state[slots[k]] = ARRIVED;
            }
        }
    }
}
