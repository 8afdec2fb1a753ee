package dev.cairn.physics;

/**
 * Is told what happened to contacts and sensors in a step, after it, on the thread that called it:
 * so it may change the world. The order is part of the contract: ends, then begins, then hits, then
 * who left, then who entered; each list in the order of {@link Contacts}. See {@link
 * Contacts#listen}.
 */
public interface ContactListener {
    /**
     * Two colliders touch no more, or one of them is gone. Each end had its begin.
     *
     * @param a one of them, perhaps no longer alive
     * @param b the other one
     */
    default void ended(ColliderRef a, ColliderRef b) {}

    /**
     * Two colliders have begun to touch.
     *
     * @param a one of them
     * @param b the other one
     */
    default void began(ColliderRef a, ColliderRef b) {}

    /**
     * Two colliders have met at speed.
     *
     * @param hits all hits of the step
     * @param hit the number of this one
     */
    default void hit(Contacts.Hits hits, int hit) {}

    /**
     * Somebody has left a sensor, or one of the two is gone. Each had entered.
     *
     * @param sensor the sensor
     * @param visitor who was in it
     */
    default void left(ColliderRef sensor, ColliderRef visitor) {}

    /**
     * Somebody has entered a sensor.
     *
     * @param sensor the sensor
     * @param visitor who is in it, or flew through it within the step
     */
    default void entered(ColliderRef sensor, ColliderRef visitor) {}
}
