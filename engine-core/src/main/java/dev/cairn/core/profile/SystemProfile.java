package dev.cairn.core.profile;

/**
 * How much work each system of a world did. Off until {@link #enable} is called; then each block of
 * a {@code ChunkSystem} and each run of a {@code WorldSystem} reads the clock twice.
 *
 * <p>The time of a {@code ChunkSystem} is the sum over its chunks, whichever workers took them, so
 * it may exceed the length of the tick. That of a {@code WorldSystem} is wall time of the
 * simulation thread, waiting for the workers included. What publishing columns and making commands
 * takes belongs to no system.
 *
 * <p>Simulation thread, between steps; allocates nothing.
 */
public interface SystemProfile {
    /** Times the ticks that follow. */
    void enable();

    /** Stops; what was measured stays readable. */
    void disable();

    /** Forgets what was measured. */
    void reset();

    /**
     * The ticks that were timed.
     *
     * @return count since the last reset; ticks that failed do not count
     */
    long ticks();

    /**
     * The systems of the world, disabled ones included.
     *
     * @return how many there are
     */
    int count();

    /**
     * A system's name. Systems come in the order of the schedule.
     *
     * @param system which, in {@code [0, count())}
     * @return its name
     * @throws IndexOutOfBoundsException if there is no such system
     */
    String name(int system);

    /**
     * Work of a system in the last timed tick.
     *
     * @param system which, in {@code [0, count())}
     * @return ns; 0 if no tick was timed or the system was disabled
     * @throws IndexOutOfBoundsException if there is no such system
     */
    long lastNanos(int system);

    /**
     * Mean work of a system.
     *
     * @param system which, in {@code [0, count())}
     * @return s per timed tick; 0 if no tick was timed
     * @throws IndexOutOfBoundsException if there is no such system
     */
    double meanSeconds(int system);
}
