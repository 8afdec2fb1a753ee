package dev.cairn.physics.contact.impact;

import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.sweep.Flight;

/** Two colliders along the motion of a tick: when they meet, and how. */
public interface MovingPair {
    /**
     * Chooses the bodies' freedom of this tick.
     *
     * @param free by body, 0 where nothing but gravity and the user's forces accelerates it
     */
    void use(byte[] free);

    /**
     * Whether two colliders meet.
     *
     * @param first a collider
     * @param second another one
     * @param from since when they are looked at, s after the start of the tick
     * @param stepSeconds length of the tick, s
     * @return whether they do; {@link #time} tells when
     */
    boolean meet(int first, int second, double from, double stepSeconds);

    /**
     * Whether two colliders that have just met, and were given other velocities there, meet again
     * after they have parted.
     *
     * @param first a collider
     * @param second another one
     * @param from when they met, s after the start of the tick
     * @param stepSeconds length of the tick, s
     * @return whether they do
     */
    boolean meetAgain(int first, int second, double from, double stepSeconds);

    /** When they met, s after the start of the tick. */
    double time();

    /** Whether the two of the last {@link #meetAgain} stay in touch until the tick ends. */
    boolean stays();

    /**
     * Whether the two of the last search, which have not met, turn too often to be followed farther
     * than {@link #time}.
     */
    boolean isUndecided();

    /**
     * Puts two colliders where they are at a time.
     *
     * @param first a collider
     * @param second another one
     * @param seconds since the start of the tick
     * @param stepSeconds length of the tick, s
     */
    void place(int first, int second, double seconds, double stepSeconds);

    /**
     * By how much a body's acceleration may take it off a straight line, over the square of a time.
     *
     * @param body slot
     * @return m/s²
     */
    double bend(int body);

    /**
     * The contact of the meeting, of bodies where they are then.
     *
     * @return with its points from the first collider's centre
     */
    Manifold there();

    /** As {@link #there}, however far apart they are. */
    Manifold across();

    /** How a collider lies when they meet: the first one's way. */
    Flight first();

    /** The second one's. */
    Flight second();

    /** From the first one's centre to the second one's when they meet, world, m. */
    double apartX();

    /** See {@link #apartX}. */
    double apartY();

    /** See {@link #apartX}. */
    double apartZ();

    /**
     * Puts the contact of the meeting into a row, told of the start of the tick.
     *
     * @param row of the two colliders, the first of them its A
     * @param reach of the margin, s
     * @return the contact, of bodies where they are then
     */
    Manifold tell(int row, double reach);

    /**
     * Finds how a body lay and turned at the start of the tick, if it turns freely and does so at a
     * time.
     *
     * @param body slot
     * @param seconds that time, since the start of the tick
     * @param state orientation and angular velocity, world, at the time; receives those of the
     *     start
     */
    void back(int body, double seconds, double[] state);
}
