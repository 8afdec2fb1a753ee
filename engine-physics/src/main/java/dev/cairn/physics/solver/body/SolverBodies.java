package dev.cairn.physics.solver.body;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.BodyStore;

import java.util.Arrays;

/**
 * What the solver holds of each body: 16 doubles in a row, so that a contact gathers a body from
 * two cache lines. The body of slot i is at {@code offset(i)}; at offset 0 lies a body that does
 * not move, which stands for all of those.
 */
public final class SolverBodies {
    /** Doubles to a body of {@link #state}. */
    public static final int STRIDE = 16;

    /**
     * Velocity of the centre of mass, world, m/s; at {@code V + 3} the weighted angular velocity
     * {@code L^-1 w}, where {@code L L^T} is the world inverse inertia of the tick's start.
     */
    public static final int V = 0;

    /** 1 if a contact pressed on the body in this sub-step, else 0. */
    public static final int LOADED = 6;

    /** Inverse mass in the solver, 1/kg. */
    public static final int MASS = 7;

    /**
     * Movement since the start of the tick, world, m; weighted turn since then at {@code P + 3}.
     */
    public static final int P = 8;

    /** Factor on gravity in the solver. */
    public static final int GRAVITY = 14;

    /** Value of {@link #guide}: no contact has points, the body flies the whole tick in one go. */
    public static final int FREE = -2;

    /** Value of {@link #guide}: the body has contacts and takes sub-steps. */
    public static final int BOUND = -1;

    /** {@link #guide} of a body on one contact with a static body whose closed forms are off. */
    public static final int LOST = -3;

    /** Turn in a sub-step, rad, after which no root of before it tells the energy. */
    public static final double FAR_TURN = 0.3;

    /** How many times its mass another body has that may squeeze a light one. */
    private static final double HEAVY = 4;

    /** Doubles to a body of {@link #root}. */
    public static final int ROOT = 12;

    /** Doubles to a body of {@link #warm} and {@link #mark}. */
    public static final int HALF = 8;

    public double[] state = {};

    /**
     * What sweeps in single precision see of the state, at the same places: rounded by {@link
     * #round} before them; what they have changed is added to the state by {@link #add}. Current
     * only for bodies whose rows are floats.
     */
    public float[] floats = {};

    /** {@link #root} and {@link #warm} for code that fills rows of floats. */
    public float[] rootFloats = {};

    public float[] warmFloats = {};

    /**
     * {@code L}, row by row, then the three inverses of the squares of its columns: {@code L^-1} is
     * these times {@code L^T}, since the columns are orthogonal.
     */
    public double[] root = {};

    /**
     * Change of the velocities by the impulses of the last sub-step: the warm start of all contacts
     * of a body at once.
     */
    public double[] warm = {};

    /** Velocities after the warm start. */
    public double[] mark = {};

    /** For guided bodies, {@link MotionRecord#STRIDE} to a slot. */
    public double[] motion = {};

    /**
     * {@link #FREE}, {@link #BOUND}, {@link #LOST}, or the only row of the body where its partner
     * is static: the body is guided.
     */
    public int[] guide = {};

    /**
     * Flight: what the last additions to position and velocity lost to rounding, then position and
     * velocity as they were left; 12 to a slot. A body that something else has moved starts anew.
     */
    double[] carry = {};

    /** Room for {@link #state(StateVisitor, int)}. */
    private boolean[] loaded = {};

    /** By slot: no point of the body is faster until the next sub-step, m/s; see {@link #limit}. */
    public double[] fastest = {};

    /** By slot: time of the last impact in this sub-step, s; whether one has moved the start. */
    public double[] impactTime = {};

    public boolean[] shifted = {};

    /** Whether in this sub-step the body and another one that moves have bounced. */
    public boolean[] collided = {};

    /** By slot: the share of a sub-step by which a body moves, 0 to 1. */
    public double[] pace = {};

    /** Whether a body with contacts turns in this tick, so that energy is bounded by island. */
    public boolean boundsEnergy;

    /** Offsets from here on are those of {@link DrivenSides}. */
    public int drivenFrom = Integer.MAX_VALUE;

    public final PrincipalAxes axes = new PrincipalAxes();

    /**
     * What a body's flight has lost to rounding, and whether a contact pressed on it; all else is
     * loaded in each tick.
     *
     * @param slots in use
     */
    public void state(StateVisitor s, int slots) {
        s.section("flight", this);
        int count = s.count("count", Math.min(slots, guide.length));
        ensureCapacity(count);
        carry = s.array("carry", carry, 0, 12 * count, carry.length, true);
        for (int i = 0; i < count && !s.isRestoring(); i++) {
            loaded[i] = state[offset(i) + LOADED] != 0;
        }
        loaded = s.array("loaded", loaded, count);
        for (int i = 0; i < guide.length && s.isRestoring(); i++) {
            state[offset(i) + LOADED] = loaded[i] ? 1 : 0;
        }
    }

    public static int offset(int slot) {
        return (slot + 1) * STRIDE;
    }

    /** Whether a body is so light beside another that what squeezes it may throw it. */
    public static boolean isLight(BodyStore b, int slot, int beside) {
        return b.inverseMass[slot] > HEAVY * b.inverseMass[beside];
    }

    /** Whether the one contact of a dynamic body is with a static one. */
    public boolean isAlone(int slot) {
        return guide[slot] >= 0 || guide[slot] == LOST;
    }

    /** Whether a body, by its offset, is guided, see {@link #guide}. */
    public boolean isGuided(int offset) {
        return offset != 0 && guide[slot(offset)] >= 0;
    }

    public static int slot(int offset) {
        return offset / STRIDE - 1;
    }

    public void ensureCapacity(int slots) {
        if (slots > guide.length) {
            int n = Math.max(slots, guide.length + (guide.length >> 1));
            state = Arrays.copyOf(state, (n + 1) * STRIDE);
            floats = new float[(n + 1) * STRIDE];
            rootFloats = new float[(n + 1) * ROOT];
            warmFloats = new float[(n + 1) * HALF];
            root = Arrays.copyOf(root, (n + 1) * ROOT);
            warm = Arrays.copyOf(warm, (n + 1) * HALF);
            mark = Arrays.copyOf(mark, (n + 1) * HALF);
            motion = Arrays.copyOf(motion, n * MotionRecord.STRIDE);
            carry = Arrays.copyOf(carry, n * 12);
            guide = Arrays.copyOf(guide, n);
            loaded = new boolean[n];
            fastest = new double[n];
            impactTime = new double[n];
            shifted = new boolean[n];
            collided = new boolean[n];
            pace = new double[n];
        }
        axes.ensureCapacity(slots);
    }

    /** Shows the sweeps the state of a body, where they are in single precision. */
    public void round(int i) {
        int o = offset(i);
        for (int k = o; k < o + STRIDE; k++) {
            floats[k] = (float) state[k];
        }
    }

    /** The same where only velocities have changed since then. */
    public void roundVelocity(int i) {
        int o = offset(i);
        for (int k = o; k <= o + LOADED; k++) {
            floats[k] = (float) state[k];
        }
    }

    /** Adds what sweeps in single precision have changed since {@link #round} to the state. */
    public void add(int i) {
        int o = offset(i);
        for (int k = o; k <= o + LOADED; k++) {
            state[k] += floats[k] - (float) state[k];
        }
    }

    /** The root of a body for code that fills rows of floats; they have no warm start yet. */
    public void roundRoot(int i) {
        int r = (i + 1) * ROOT;
        for (int k = r; k < r + 9; k++) {
            rootFloats[k] = (float) root[k];
        }
        int w = (i + 1) * HALF;
        for (int k = w; k < w + 6; k++) {
            warmFloats[k] = 0;
        }
    }

    /** Adds the warm start that rows of floats were filled with. */
    public void addWarm(int i) {
        int w = (i + 1) * HALF;
        for (int k = w; k < w + 6; k++) {
            warm[k] += warmFloats[k];
            warmFloats[k] = 0;
        }
    }

    /** A component of the warm start, also before that of rows of floats is added. */
    public double warm(int at) {
        return warm[at] + warmFloats[at];
    }

    /** Loads a body that has contacts; keeps {@link #LOADED} of the last sub-step. */
    public void loadBound(BodyStore b, int i, double massScale) {
        double[] s = state;
        int o = offset(i);
        double inverse = 1 / massScale;
        rootOfInertia(b, i, inverse);
        s[o + V] = b.velocityX[i];
        s[o + V + 1] = b.velocityY[i];
        s[o + V + 2] = b.velocityZ[i];
        weigh(i, b.angularVelocityX[i], b.angularVelocityY[i], b.angularVelocityZ[i]);
        for (int k = P; k < P + 6; k++) {
            s[o + k] = 0;
        }
        int w = o / STRIDE * HALF;
        for (int k = w; k < w + 6; k++) {
            warm[k] = 0;
        }
        s[o + MASS] = b.inverseMass[i] * inverse;
        s[o + GRAVITY] = inverse;
    }

    /** Sets the weighted angular velocity, {@code L^-1 w}. */
    public void weigh(int i, double x, double y, double z) {
        double[] r = root;
        int k = (i + 1) * ROOT;
        int o = offset(i) + V + 3;
        state[o] = r[k + 9] * (r[k] * x + r[k + 3] * y + r[k + 6] * z) + 0.0;
        state[o + 1] = r[k + 10] * (r[k + 1] * x + r[k + 4] * y + r[k + 7] * z) + 0.0;
        state[o + 2] = r[k + 11] * (r[k + 2] * x + r[k + 5] * y + r[k + 8] * z) + 0.0;
    }

    /**
     * Writes the angular momentum about the centre of mass, {@code L^-T} of the weighted velocity.
     */
    public void momentum(int i, double[] destination) {
        double[] r = root;
        int k = (i + 1) * ROOT;
        int o = offset(i) + V + 3;
        for (int c = 0; c < 3; c++) {
            destination[c] =
                    r[k + 3 * c] * (r[k + 9] * state[o])
                            + r[k + 3 * c + 1] * (r[k + 10] * state[o + 1])
                            + r[k + 3 * c + 2] * (r[k + 11] * state[o + 2]);
        }
    }

    /**
     * Whether a body turns by more than {@link #FAR_TURN} in a time. Most are told by {@code |w|²
     * <= |u|² max s²}, s being the lengths of the root's columns.
     *
     * @param seconds s
     */
    public boolean turnsFar(int i, double seconds) {
        int o = offset(i) + V + 3;
        int k = (i + 1) * ROOT;
        double rate = FAR_TURN / seconds;
        double square = rate * rate;
        double u = state[o] * state[o] + state[o + 1] * state[o + 1] + state[o + 2] * state[o + 2];
        if (u <= square * Math.min(Math.min(root[k + 9], root[k + 10]), root[k + 11])) {
            return false;
        }
        double x = world(i, o, 0);
        double y = world(i, o, 1);
        double z = world(i, o, 2);
        return x * x + y * y + z * z > square;
    }

    /** Component {@code axis} of {@code L u}, u the weighted vector at {@code state[o]}. */
    public double world(int i, int o, int axis) {
        int k = (i + 1) * ROOT + 3 * axis;
        return root[k] * state[o] + root[k + 1] * state[o + 1] + root[k + 2] * state[o + 2];
    }

    /**
     * Notes how fast a body can be when it meets something in the next sub-step: twice as fast as
     * now, since what is still to be solved of this one takes speed away rather than adding it, and
     * what gravity and forces add, unless contacts carry the body.
     *
     * @param gravity its size, m/s²
     */
    public void limit(BodyStore b, int i, double gravity, double seconds) {
        int o = offset(i);
        double turn = norm(world(i, o + 3, 0), world(i, o + 3, 1), world(i, o + 3, 2));
        double speed = norm(state[o], state[o + 1], state[o + 2]) + turn * b.outerRadius[i];
        double gain = 0;
        if (state[o + LOADED] == 0) {
            double push = norm(b.forceX[i], b.forceY[i], b.forceZ[i]) * b.inverseMass[i];
            gain = seconds * (gravity * Math.abs(b.gravityScale[i]) + push);
        }
        fastest[i] = 2 * speed + gain;
    }

    /** Whether impulses move what lies at an offset of the state. */
    public boolean isMoved(int offset) {
        return offset != 0 && offset < drivenFrom;
    }

    /** Whether an impact of this sub-step has shifted the body at an offset of the state. */
    public boolean isShifted(int offset) {
        return offset != 0 && shifted[slot(offset)];
    }

    /** Length of a vector. */
    public static double norm(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** {@code L} with {@code L L^T = scale I^-1}: the principal axes, each times a square root. */
    public void rootOfInertia(BodyStore b, int i, double scale) {
        double[] r = root;
        int k = (i + 1) * ROOT;
        if ((b.motionFlags[i] & AxisLocks.TURNS) != 0) {
            AxisLocks.rootOfInertia(b, i, scale, r, k);
            return;
        }
        if (axes.isotropic[i]) {
            double square = b.inverseInertiaXX[i] * scale;
            double x = Math.sqrt(square);
            Arrays.fill(r, k, k + 9, 0.0);
            r[k] = x;
            r[k + 4] = x;
            r[k + 8] = x;
            Arrays.fill(r, k + 9, k + 12, square > 0 ? 1 / square : 0);
            return;
        }
        double[] d = axes.data;
        int p = i * PrincipalAxes.STRIDE;
        double px = d[p + PrincipalAxes.QX];
        double py = d[p + PrincipalAxes.QX + 1];
        double pz = d[p + PrincipalAxes.QX + 2];
        double pw = d[p + PrincipalAxes.QX + 3];
        double bx = b.orientationX[i];
        double by = b.orientationY[i];
        double bz = b.orientationZ[i];
        double bw = b.orientationW[i];
        // q = worldFromPrincipal = worldFromBody bodyFromPrincipal
        double x = bw * px + bx * pw + (by * pz - bz * py);
        double y = bw * py + by * pw + (bz * px - bx * pz);
        double z = bw * pz + bz * pw + (bx * py - by * px);
        double w = bw * pw - (bx * px + by * py + bz * pz);
        double square1 = scale / d[p + PrincipalAxes.MOMENT];
        double square2 = scale / d[p + PrincipalAxes.MOMENT + 1];
        double square3 = scale / d[p + PrincipalAxes.MOMENT + 2];
        double s1 = Math.sqrt(square1);
        double s2 = Math.sqrt(square2);
        double s3 = Math.sqrt(square3);
        r[k] = s1 * (1 - 2 * (y * y + z * z));
        r[k + 1] = s2 * (2 * (x * y - w * z));
        r[k + 2] = s3 * (2 * (x * z + w * y));
        r[k + 3] = s1 * (2 * (x * y + w * z));
        r[k + 4] = s2 * (1 - 2 * (x * x + z * z));
        r[k + 5] = s3 * (2 * (y * z - w * x));
        r[k + 6] = s1 * (2 * (x * z - w * y));
        r[k + 7] = s2 * (2 * (y * z + w * x));
        r[k + 8] = s3 * (1 - 2 * (x * x + y * y));
        r[k + 9] = 1 / square1;
        r[k + 10] = 1 / square2;
        r[k + 11] = 1 / square3;
    }

    /** Writes velocities and the movement of the tick back; the orientation was kept up to date. */
    public void store(BodyStore b, int i) {
        double[] s = state;
        int o = offset(i);
        b.velocityX[i] = s[o + V];
        b.velocityY[i] = s[o + V + 1];
        b.velocityZ[i] = s[o + V + 2];
        b.angularVelocityX[i] = world(i, o + V + 3, 0);
        b.angularVelocityY[i] = world(i, o + V + 3, 1);
        b.angularVelocityZ[i] = world(i, o + V + 3, 2);
        b.move(i, s[o + P], s[o + P + 1], s[o + P + 2]);
        if ((b.motionFlags[i] & BodyStore.LIMITED) != 0) {
            AxisLocks.limit(b, i);
        }
    }
}
