package dev.cairn.physics;

/**
 * The bodies that fell asleep and those that woke in the last step, and by calls since the step
 * before. For each body the two alternate, beginning with a sleep; a body that is removed asleep
 * wakes with it.
 *
 * <p>A view: the same object for the life of the world, its contents replaced by each step.
 * Simulation thread, between steps. Nothing here allocates. The order is the same for any number of
 * workers.
 */
public interface SleepEvents {
    /**
     * How many bodies fell asleep.
     *
     * @return at least 0
     */
    int fellAsleepCount();

    /**
     * A body that fell asleep.
     *
     * @param event 0 to fellAsleepCount - 1
     * @return the body
     */
    BodyRef fellAsleep(int event);

    /**
     * How many bodies woke.
     *
     * @return at least 0
     */
    int wokeCount();

    /**
     * A body that woke.
     *
     * @param event 0 to wokeCount - 1
     * @return the body; it may be gone
     */
    BodyRef woke(int event);

    /**
     * How many bodies sleep now.
     *
     * @return at least 0
     */
    int asleepCount();
}
