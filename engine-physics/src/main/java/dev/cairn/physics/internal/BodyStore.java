package dev.cairn.physics.internal;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;

import java.util.Arrays;

/**
 * All bodies as a structure of arrays; a body is a slot in {@code [0, slotCount)}.
 *
 * <p>Positions are those of the centre of mass, in world axes and metres. Orientations are unit
 * quaternions {@code (x, y, z, w)} that rotate body axes to world axes. Inertia is about the centre
 * of mass. Simulation thread, and blocks of its stages, only; the fields are public because the
 * kernels of the step are loops over them.
 */
public final class BodyStore extends Poses implements Stateful {
    /** Makes an empty store. */
    public BodyStore() {}

    /** Kind of a slot that holds no body. */
    public static final byte FREE = 0;

    /** Kind of a body that never moves: infinite mass. */
    public static final byte STATIC = 1;

    /** Kind of a body that forces and contacts move. */
    public static final byte DYNAMIC = 2;

    /**
     * Kind of a body that forces and contacts would move, but that has come to rest and is left
     * out: velocities are 0 and its rows are not active. Loops that ask for {@link #DYNAMIC} so
     * pass it by.
     */
    public static final byte ASLEEP = 3;

    /**
     * Kind of a body that moves as the user says: infinite mass, and a velocity. Loops that ask for
     * {@link #DYNAMIC} take it for one that does not move.
     */
    public static final byte KINEMATIC = 4;

    /** Numbers to a body of {@link #ramp}. */
    public static final int RAMP = 4;

    /**
     * Of kinematic bodies, how their velocity changes within this tick, world, m/s, three numbers,
     * and the share of their angular velocity that comes to it; others' is not defined. Read of
     * bodies that are driven only.
     */
    public double[] ramp = {};

    /**
     * Of kinematic bodies: whether their velocity is another one than in the tick before, or
     * changes within this one or did within that; others' is not defined.
     */
    public boolean[] surges = {};

    /** Whether any kinematic body does. */
    public boolean surging;

    /** How many kinematic bodies move in this tick. */
    public int driven;

    /** 1 once a surface that moves along has been here, see {@link ColliderStore#belt}. */
    public int belts;

    /** Whether a surface of the body moves along. */
    public boolean[] hasBelt = {};

    /** One past the highest slot in use. */
    public int slotCount;

    /** {@link #FREE}, {@link #STATIC}, {@link #DYNAMIC}, {@link #ASLEEP}, {@link #KINEMATIC}. */
    public byte[] kind = new byte[0];

    /** ECS entity of the body. */
    public long[] entity = new long[0];

    /** The first of the body's colliders, the others follow by {@link ColliderStore#next}. */
    public int[] collider = {};

    /** Whether the body is one ball about its centre of mass. */
    public boolean[] isBall = {};

    /**
     * Outer radii from the origin beyond which the rounding of a position, 2^-53 of it, is more
     * than 2^-41 of the body, and is kept.
     */
    public static final double FAR = 4096;

    /** Velocity of the centre of mass, world, m/s. */
    public double[] velocityX = {}, velocityY = {}, velocityZ = {};

    /** Angular velocity, world, rad/s. */
    public double[] angularVelocityX = {}, angularVelocityY = {}, angularVelocityZ = {};

    /**
     * Force of the user on the centre of mass during this tick, world, N; cleared after the step.
     */
    public double[] forceX = {}, forceY = {}, forceZ = {};

    /** Torque of the user during this tick, world, N m; cleared after the step. */
    public double[] torqueX = {}, torqueY = {}, torqueZ = {};

    /** 1/kg; 0 for static bodies. */
    public double[] inverseMass = {};

    /** Inertia about the centre of mass, body axes, kg m²: the symmetric matrix's six entries. */
    public double[] inertiaXX = {},
            inertiaYY = {},
            inertiaZZ = {},
            inertiaXY = {},
            inertiaXZ = {},
            inertiaYZ = {};

    /** Inverse of that inertia, body axes, 1/(kg m²); all 0 for static bodies. */
    public double[] inverseInertiaXX = {},
            inverseInertiaYY = {},
            inverseInertiaZZ = {},
            inverseInertiaXY = {},
            inverseInertiaXZ = {},
            inverseInertiaYZ = {};

    /** Radii of the balls about the centre of mass that are inside the body, and around it, m. */
    public double[] innerRadius = {}, outerRadius = {};

    /**
     * Factor on mass and inertia in the solver while the body rests under a load, at least 1; 0 for
     * a body that has not been looked at yet.
     */
    public double[] inertiaScale = {};

    /** Ticks that the body has been at rest in a pile; below 0 if it is in none. */
    public int[] restTicks = {};

    /**
     * Whether the closed forms for a body on nothing but one contact are not for it: its core had
     * to be held off the ground. Until it has been without contacts; not by when such bodies were
     * found last, which other islands decide.
     */
    public boolean[] lostGuide = {};

    /** Largest acceleration of late, in g. */
    public double[] unrest = {};

    /** Velocity and angular velocity at the start of the last tick, 6 to a slot. */
    public double[] lastVelocity = {};

    /** Sum of the normal forces on the body at the end of the last tick, N. */
    public double[] pressed = {};

    /** Contacts that pressed on the body at the end of the last tick. */
    public int[] pressing = {};

    /**
     * {@link #DAMPED}, {@link #LIMITED}, and the world axes along which (bits 0 to 2 for x, y, z)
     * and about which (bits 3 to 5) the body may not move; 0 for a body without any of these.
     */
    public byte[] motionFlags = {};

    /** Bit of {@link #motionFlags}: one of the rates of damping is not 0. */
    public static final int DAMPED = 64;

    /** Bit of {@link #motionFlags}: the speed is limited. */
    public static final int LIMITED = -128;

    /** Rates at which velocity and angular velocity decay, 1/s. */
    public double[] linearDamping = {}, angularDamping = {};

    /** The largest speed of the centre of mass, m/s. */
    public double[] speedLimit = {};

    /** Factor on the world's gravity; 1 for most. */
    public double[] gravityScale = {};

    /** Numbers to a collider in {@link #revolution}. */
    public static final int REVOLUTION = 4;

    /** Of each collider what {@link Surface#revolution} tells. */
    public double[] revolution = {};

    /** Whether a collider has had a surface without corners: its points go with an axis. */
    public boolean curved;

    private final Columns.Kept kept = new Columns.Kept();

    /**
     * Grows every column to at least {@code capacity} slots; between phases only.
     *
     * @param capacity slots that must fit
     */
    public void ensureCapacity(int capacity) {
        if (capacity <= kind.length) {
            return;
        }
        int n = Math.max(capacity, Math.max(16, kind.length + (kind.length >> 1)));
        int old = gravityScale.length;
        columns(new Columns.Growth(n));
        Arrays.fill(gravityScale, old, n, 1.0);
    }

    /**
     * Declares the columns.
     *
     * @param c what is done to them
     */
    @Override
    public void columns(Columns c) {
        super.columns(c);
        kind = c.column("kind", kind);
        collider = c.column("collider", collider);
        entity = c.column("entity", entity);
        hasBelt = c.column("hasBelt", hasBelt);
        isBall = c.column("isBall", isBall);
        velocityX = c.column("velocityX", velocityX);
        velocityY = c.column("velocityY", velocityY);
        velocityZ = c.column("velocityZ", velocityZ);
        angularVelocityX = c.column("angularVelocityX", angularVelocityX);
        angularVelocityY = c.column("angularVelocityY", angularVelocityY);
        angularVelocityZ = c.column("angularVelocityZ", angularVelocityZ);
        forceX = c.column("forceX", forceX);
        forceY = c.column("forceY", forceY);
        forceZ = c.column("forceZ", forceZ);
        torqueX = c.column("torqueX", torqueX);
        torqueY = c.column("torqueY", torqueY);
        torqueZ = c.column("torqueZ", torqueZ);
        inverseMass = c.column("inverseMass", inverseMass);
        inertiaXX = c.column("inertiaXX", inertiaXX);
        inertiaYY = c.column("inertiaYY", inertiaYY);
        inertiaZZ = c.column("inertiaZZ", inertiaZZ);
        inertiaXY = c.column("inertiaXY", inertiaXY);
        inertiaXZ = c.column("inertiaXZ", inertiaXZ);
        inertiaYZ = c.column("inertiaYZ", inertiaYZ);
        inverseInertiaXX = c.column("inverseInertiaXX", inverseInertiaXX);
        inverseInertiaYY = c.column("inverseInertiaYY", inverseInertiaYY);
        inverseInertiaZZ = c.column("inverseInertiaZZ", inverseInertiaZZ);
        inverseInertiaXY = c.column("inverseInertiaXY", inverseInertiaXY);
        inverseInertiaXZ = c.column("inverseInertiaXZ", inverseInertiaXZ);
        inverseInertiaYZ = c.column("inverseInertiaYZ", inverseInertiaYZ);
        innerRadius = c.column("innerRadius", innerRadius);
        outerRadius = c.column("outerRadius", outerRadius);
        inertiaScale = c.column("inertiaScale", inertiaScale);
        restTicks = c.column("restTicks", restTicks);
        lostGuide = c.column("lostGuide", lostGuide);
        unrest = c.column("unrest", unrest);
        lastVelocity = c.column("lastVelocity", lastVelocity, 6);
        pressed = c.column("pressed", pressed);
        pressing = c.column("pressing", pressing);
        motionFlags = c.column("motionFlags", motionFlags);
        linearDamping = c.column("linearDamping", linearDamping);
        angularDamping = c.column("angularDamping", angularDamping);
        speedLimit = c.column("speedLimit", speedLimit);
        gravityScale = c.column("gravityScale", gravityScale);
        revolution = c.column("revolution", revolution, REVOLUTION);
    }

    @Override
    public void state(StateVisitor s) {
        s.section("bodies", this);
        slotCount = s.count("slotCount", slotCount);
        driven = s.value("driven", driven);
        belts = s.value("belts", belts);
        isFar = s.value("isFar", isFar);
        curved = s.value("curved", curved);
        ensureCapacity(slotCount);
        columns(kept.of(s, slotCount, kind.length, false));
    }

    /**
     * Empties a slot for another body.
     *
     * @param slot whose
     */
    public void clear(int slot) {
        columns(new Columns.Clear().rows(slot, slot + 1));
    }

    /** Whether two bodies that touch are a pile: each is dynamic, or kinematic. */
    public boolean isPile(int a, int b) {
        return isOfPile(a) && isOfPile(b);
    }

    private boolean isOfPile(int slot) {
        return kind[slot] == DYNAMIC || kind[slot] == KINEMATIC;
    }

    /**
     * Whether a body is kinematic and moves, or its surface does.
     *
     * @param slot whose
     * @return false for all others
     */
    public boolean isDriven(int slot) {
        return driven > 0
                && (isMoved(slot)
                        || (hasBelt[slot] && (kind[slot] == STATIC || kind[slot] == KINEMATIC)));
    }

    /**
     * Whether a body is kinematic and moves.
     *
     * @param slot whose
     * @return false for all others
     */
    public boolean isMoved(int slot) {
        return kind[slot] == KINEMATIC
                && (velocityX[slot] != 0
                        || velocityY[slot] != 0
                        || velocityZ[slot] != 0
                        || angularVelocityX[slot] != 0
                        || angularVelocityY[slot] != 0
                        || angularVelocityZ[slot] != 0);
    }

    /**
     * Puts a body somewhere.
     *
     * @param slot whose
     * @param x centre of mass, world, m
     * @param y centre of mass, world, m
     * @param z centre of mass, world, m
     */
    public void place(int slot, double x, double y, double z) {
        positionX[slot] = x;
        positionY[slot] = y;
        positionZ[slot] = z;
        Arrays.fill(positionLow, 3 * slot, 3 * slot + 3, 0.0);
    }

    /** Takes all velocity from a body. */
    public void stop(int slot) {
        velocityX[slot] = 0;
        velocityY[slot] = 0;
        velocityZ[slot] = 0;
        angularVelocityX[slot] = 0;
        angularVelocityY[slot] = 0;
        angularVelocityZ[slot] = 0;
    }

    /**
     * Moves a body. Far from the origin what rounding takes of the position is kept beside it, so
     * that a stack stands there as it stands at the origin. Any worker, one to a body.
     *
     * @param slot whose
     * @param dx movement, world, m
     * @param dy movement, world, m
     * @param dz movement, world, m
     */
    public void move(int slot, double dx, double dy, double dz) {
        double[] low = positionLow;
        int k = 3 * slot;
        // by where the body is now, never by whether others are far: they are found meanwhile
        boolean far = isFar(slot);
        boolean lacks = isFar && (low[k] != 0 || low[k + 1] != 0 || low[k + 2] != 0);
        if (!far && !lacks) {
            positionX[slot] += dx;
            positionY[slot] += dy;
            positionZ[slot] += dz;
            return;
        }
        double x = positionX[slot];
        double y = positionY[slot];
        double z = positionZ[slot];
        // a low part of 0 must not turn a movement of -0
        double stepX = low[k] == 0 ? dx : dx + low[k];
        double stepY = low[k + 1] == 0 ? dy : dy + low[k + 1];
        double stepZ = low[k + 2] == 0 ? dz : dz + low[k + 2];
        positionX[slot] = x + stepX;
        positionY[slot] = y + stepY;
        positionZ[slot] = z + stepZ;
        lack(slot, far ? lost(x, stepX) : 0, far ? lost(y, stepY) : 0, far ? lost(z, stepZ) : 0);
    }

    /**
     * Sets what a position lacks.
     *
     * @param slot whose
     * @param x world, m
     * @param y world, m
     * @param z world, m
     */
    public void lack(int slot, double x, double y, double z) {
        positionLow[3 * slot] = x;
        positionLow[3 * slot + 1] = y;
        positionLow[3 * slot + 2] = z;
        if (x != 0 || y != 0 || z != 0) {
            isFar = true; // by whoever finds one; only saves looking
        }
    }

    /**
     * Whether a body is so far away that what its position lacks is kept.
     *
     * @param slot whose
     * @return whether a coordinate is beyond {@link #FAR} outer radii
     */
    public boolean isFar(int slot) {
        double limit = FAR * outerRadius[slot];
        return Math.abs(positionX[slot]) > limit
                || Math.abs(positionY[slot]) > limit
                || Math.abs(positionZ[slot]) > limit;
    }

    /** Exact error of {@code a + b} (Knuth's two-sum, The Art of Computer Programming 2, 4.2.2). */
    private static double lost(double a, double b) {
        double sum = a + b;
        double part = sum - a;
        return (a - (sum - part)) + (b - part);
    }

    /**
     * Bound of the speed of any point of a body: |v| + R |w|.
     *
     * @return m/s
     */
    public double surfaceSpeed(int slot) {
        double vx = velocityX[slot];
        double vy = velocityY[slot];
        double vz = velocityZ[slot];
        double wx = angularVelocityX[slot];
        double wy = angularVelocityY[slot];
        double wz = angularVelocityZ[slot];
        return Math.sqrt(vx * vx + vy * vy + vz * vz)
                + outerRadius[slot] * Math.sqrt(wx * wx + wy * wy + wz * wz);
    }

    /**
     * Velocity of a point of a body, {@code v + w x r}, along x.
     *
     * @param y of the point from the centre of mass, world, m
     * @param z see {@code y}
     * @return m/s
     */
    public double pointVelocityX(int slot, double y, double z) {
        return velocityX[slot] + angularVelocityY[slot] * z - angularVelocityZ[slot] * y;
    }

    /** The same along y. */
    public double pointVelocityY(int slot, double x, double z) {
        return velocityY[slot] + angularVelocityZ[slot] * x - angularVelocityX[slot] * z;
    }

    /** The same along z. */
    public double pointVelocityZ(int slot, double x, double y) {
        return velocityZ[slot] + angularVelocityX[slot] * y - angularVelocityY[slot] * x;
    }

    /**
     * The smaller inner radius of two bodies, one of which at least moves; fixed ones have none.
     */
    public double innerRadiusOfMoving(int a, int b) {
        double ofA = kind[a] == DYNAMIC ? innerRadius[a] : Double.MAX_VALUE;
        double ofB = kind[b] == DYNAMIC ? innerRadius[b] : Double.MAX_VALUE;
        return Math.min(ofA, ofB);
    }

    /**
     * Whether two bodies stand still against each other: they are one, or neither is dynamic and
     * they move at one velocity without turning.
     *
     * @param a slot
     * @param b slot
     * @return whether they do
     */
    public boolean movesWith(int a, int b) {
        if (a == b) {
            return true;
        }
        if (kind[a] == DYNAMIC || kind[b] == DYNAMIC) {
            return false;
        }
        boolean turns =
                angularVelocityX[a] != 0
                        || angularVelocityY[a] != 0
                        || angularVelocityZ[a] != 0
                        || angularVelocityX[b] != 0
                        || angularVelocityY[b] != 0
                        || angularVelocityZ[b] != 0;
        return !turns
                && velocityX[a] == velocityX[b]
                && velocityY[a] == velocityY[b]
                && velocityZ[a] == velocityZ[b];
    }
}
