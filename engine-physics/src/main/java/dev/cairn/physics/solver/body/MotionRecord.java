package dev.cairn.physics.solver.body;

import static dev.cairn.physics.solver.body.SolverBodies.V;

/**
 * How a guided body, whose only contact is with a static body, came through a sub-step: what a
 * correction at its end, when the impulses are known, starts from.
 */
public final class MotionRecord {
    /**
     * Doubles to a body of {@link SolverBodies#motion}, world: velocity at the start; velocity that
     * moved it; angular velocity at the start, then what was added to it before the body turned;
     * angular velocity after the turn; then what a pinned corner needs; then what the energy bound
     * needs; then when a point lands.
     */
    public static final int STRIDE = 31;

    /** Movement, angular velocity and orientation at the start. */
    public static final int START = 12;

    /** The only point that it stands on, -1, or {@link #ROLLS}. */
    public static final int CORNER = 22;

    /** In place of a point: it rolls on its rim. */
    public static final int ROLLS = -2;

    /** 1 if an impact has put the start of its path elsewhere. */
    public static final int STRUCK = 23;

    /**
     * Six numbers, weighted as the state is: velocity of a sub-step without what contacts do in it.
     */
    public static final int FREE = 24;

    /** Share of the sub-step after which the first of its points lands, {@link #NEVER} if none. */
    public static final int LANDS = 30;

    /** In place of a share: no point lands. */
    public static final double NEVER = -1;

    private MotionRecord() {}

    /** Whether a point of a body lands in this sub-step. */
    public static boolean hasLanded(SolverBodies s, int i) {
        return s.motion[STRIDE * i + LANDS] != NEVER;
    }

    /** Start of a sub-step, before impacts of the contact. */
    public static void start(SolverBodies s, int i) {
        System.arraycopy(s.state, SolverBodies.offset(i) + V, s.motion, STRIDE * i + FREE, 6);
    }

    /** The same for a body without a guide, after forces, before the warm start. */
    static void free(SolverBodies s, int i) {
        System.arraycopy(s.state, SolverBodies.offset(i) + V, s.motion, STRIDE * i + FREE, 6);
    }

    /** After forces, before the warm start. */
    static void forced(SolverBodies s, int i) {
        addFree(s, i, 1);
    }

    private static void addFree(SolverBodies s, int i, double sign) {
        int o = SolverBodies.offset(i) + V;
        for (int c = 0; c < 6; c++) {
            s.motion[STRIDE * i + FREE + c] += sign * s.state[o + c];
        }
    }

    /** Before forces, after impacts of the contact. */
    static void begin(SolverBodies s, int i) {
        addFree(s, i, -1);
        int o = SolverBodies.offset(i) + V;
        int g = STRIDE * i;
        for (int axis = 0; axis < 3; axis++) {
            s.motion[g + axis] = s.state[o + axis];
            s.motion[g + 6 + axis] = s.world(i, o + 3, axis);
        }
    }

    /** Before the body turns: the velocity that moves it. */
    static void moves(SolverBodies s, int i, double vx, double vy, double vz) {
        int o = SolverBodies.offset(i) + V + 3;
        int g = STRIDE * i;
        s.motion[g + 3] = vx;
        s.motion[g + 4] = vy;
        s.motion[g + 5] = vz;
        for (int axis = 0; axis < 3; axis++) {
            s.motion[g + 6 + axis] = s.world(i, o, axis) - s.motion[g + 6 + axis];
        }
    }

    /** After the body has turned. */
    static void turned(SolverBodies s, int i) {
        int o = SolverBodies.offset(i) + V + 3;
        for (int axis = 0; axis < 3; axis++) {
            s.motion[STRIDE * i + 9 + axis] = s.world(i, o, axis);
        }
    }
}
