package dev.cairn.physics;

/**
 * A degree of freedom that a body can be without, in world axes: {@link Body#lock}, {@link
 * BodyRef#setLocks}.
 *
 * <p>Along and about a locked axis nothing moves the body, to the bit. Turning: the body's inertia
 * is that of the axes that are left, so contacts and torques answer exactly; with two axes left the
 * gyroscopic torque is left out. Moving: a lock takes its part of the velocity after each pass of
 * the solver, which is exact where contact normals lie along free axes, as in a plane world ({@link
 * #MOVE_Z}, {@link #TURN_X}, {@link #TURN_Y}), and else is approached from sub-step to sub-step.
 */
public enum Lock {
    /** No movement along x. */
    MOVE_X,
    /** No movement along y. */
    MOVE_Y,
    /** No movement along z. */
    MOVE_Z,
    /** No turn about x. */
    TURN_X,
    /** No turn about y. */
    TURN_Y,
    /** No turn about z. */
    TURN_Z;

    static int bits(Lock... locks) {
        Checks.notNull("locks", locks);
        int bits = 0;
        for (Lock lock : locks) {
            bits |= 1 << Checks.notNull("lock", lock).ordinal();
        }
        return bits;
    }
}
