package dev.cairn.physics.solver;

import java.util.Arrays;

/**
 * The contacts of a tick as constraint rows, flat: {@link #ROW} doubles per contact and {@link
 * #POINT} doubles per point, four points to a contact. Kernels loop over rows; what a row holds is
 * all that a sweep needs besides the two bodies.
 */
final class ConstraintRows {
    /** Doubles to a contact. */
    static final int ROW = 58;

    static final int NORMAL = 0;
    static final int TANGENT1 = 3;
    static final int TANGENT2 = 6;
    static final int FRICTION = 9;

    /** Soft step: bias rate, mass scale, impulse scale. */
    static final int BIAS_RATE = 10;

    static final int MASS_SCALE = 11;
    static final int IMPULSE_SCALE = 12;

    /** Inverse of the 2 x 2 tangent block: 11, 12, 22. */
    static final int BLOCK = 13;

    /** Friction impulses of the sub-step along the tangents, then the twist impulse. */
    static final int LAMBDA = 16;

    /** Inverse of the twist's inverse inertia. */
    static final int TWIST_MASS = 19;

    /** {@code rA x t1, rA x t2, rB x t1, rB x t2} at the patch's centre. */
    static final int LEVER = 20;

    /** The same four times the body's inverse inertia, then {@code IA^-1 n} and {@code IB^-1 n}. */
    static final int TURN = 32;

    /** Totals of the tick: friction along the tangents, twist. */
    static final int TOTAL = 50;

    static final int MASS_A = 53;
    static final int MASS_B = 54;
    static final int RESTITUTION = 55;

    /** Largest distance of a point from the patch's centre, m. */
    static final int RADIUS = 56;

    /** Doubles to a point. */
    static final int POINT = 19;

    /** {@code rA x n, rB x n}. */
    static final int ARM = 0;

    /** {@code IA^-1 (rA x n), IB^-1 (rB x n)}. */
    static final int SPIN = 6;

    /** Effective mass along the normal. */
    static final int MASS = 12;

    /** Separation at the start of the tick plus offset, m. */
    static final int GAP = 13;

    /** Normal impulse of the sub-step, N s. */
    static final int IMPULSE = 14;

    /** Distance from the patch's centre, m. */
    static final int REACH = 15;

    /** Normal impulse of the tick, N s. */
    static final int SUM = 16;

    /** Impulse within one impact, N s. */
    static final int STRIKE = 17;

    /** Impulse of a sub-step that a metre of overlap holds at rest, N s/m. */
    static final int STIFFNESS = 18;

    /** Ints to a contact. */
    static final int LINK = 6;

    /** Offsets of the bodies in {@link SolverBodies#state}. */
    static final int BODY_A = 0;

    static final int BODY_B = 1;
    static final int COUNT = 2;

    /** Row in the contact store. */
    static final int SOURCE = 3;

    /** 1 while the contact had no impulse to start the sub-step with. */
    static final int COLD = 4;

    /** 1 in the tick in which a load that the contact's island carried has gone. */
    static final int UNLOADED = 5;

    int count;
    double[] row = {};
    double[] point = {};
    int[] link = {};

    /** Rows whose restitution is above zero. */
    int bouncing;

    int[] bouncer = {};

    void ensureCapacity(int rows) {
        if (rows > bouncer.length) {
            int n = Math.max(rows, Math.max(64, bouncer.length + (bouncer.length >> 1)));
            row = Arrays.copyOf(row, n * ROW);
            point = Arrays.copyOf(point, n * 4 * POINT);
            link = Arrays.copyOf(link, n * LINK);
            bouncer = Arrays.copyOf(bouncer, n);
        }
    }
}
