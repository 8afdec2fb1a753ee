package dev.cairn.physics.body;

import dev.cairn.physics.internal.Checks;

/**
 * A degree of freedom that a body can be without, in world axes: {@link
 * dev.cairn.physics.Body#lock}, {@link dev.cairn.physics.BodyRef#setLocks}.
 *
 * <p>Along a locked axis the body does not move, to the bit; about one its angular velocity is 0
 * after a step. Turning: the body's inertia is that of the axes that are left, so contacts and
 * torques answer exactly; with two axes left the gyroscopic torque is left out. Moving: a lock
 * takes its part of the velocity after each pass of the solver, which is exact where contact
 * normals lie along free axes, as in a plane world ({@link #MOVE_Z}, {@link #TURN_X}, {@link
 * #TURN_Y}), and else is approached from sub-step to sub-step.
 */
public enum Lock {
    /** No movement along x. */
    MOVE_X(0),
    /** No movement along y. */
    MOVE_Y(1),
    /** No movement along z. */
    MOVE_Z(2),
    /** No turn about x. */
    TURN_X(3),
    /** No turn about y. */
    TURN_Y(4),
    /** No turn about z. */
    TURN_Z(5);

    private final int bit;

    Lock(int bit) {
        this.bit = bit;
    }

    /**
     * The locks of a set of bits; bits of others do not count.
     *
     * @param bits as {@link #bits} gives them
     * @return a new array, in the order of the constants
     */
    public static Lock[] of(int bits) {
        Lock[] all = values();
        Lock[] found = new Lock[Integer.bitCount(bits & (1 << all.length) - 1)];
        int n = 0;
        for (Lock lock : all) {
            if ((bits >> lock.bit & 1) != 0) {
                found[n++] = lock;
            }
        }
        return found;
    }

    /**
     * Locks as a set of bits.
     *
     * @param locks any of them
     * @return a bit each
     */
    public static int bits(Lock... locks) {
        Checks.notNull("locks", locks);
        int bits = 0;
        for (Lock lock : locks) {
            bits |= 1 << Checks.notNull("lock", lock).bit;
        }
        return bits;
    }
}
