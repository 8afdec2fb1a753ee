package dev.cairn.physics;

/**
 * Is told what happened to contacts and sensors in a step, after it, on the thread that called it:
 * so it may change the world. The order is part of the contract: ends of shapes, ends of bodies,
 * begins of bodies, begins of shapes, then hits of shapes, hits of bodies, visitors that entered
 * sensors, visitors that left (so that what flew through enters first); each list in the order of
 * {@link Contacts}. See {@link Contacts#listen}.
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
     * Two bodies touch no more with any of their shapes, or one of them is gone. Each end had its
     * begin.
     *
     * @param a the one of the lower slot, perhaps no longer alive
     * @param b the other one
     */
    default void bodiesEnded(BodyRef a, BodyRef b) {}

    /**
     * Two bodies have begun to touch, with one or more of their shapes.
     *
     * @param a the one of the lower slot
     * @param b the other one
     */
    default void bodiesBegan(BodyRef a, BodyRef b) {}

    /**
     * Two colliders have met at speed.
     *
     * @param hits all hits of the step
     * @param hit the number of this one
     */
    default void hit(Contacts.Hits hits, int hit) {}

    /**
     * Two bodies have met at speed, with one or more of their shapes: the strongest of their hits.
     *
     * @param hits all hits of bodies of the step
     * @param hit the number of this one
     */
    default void bodiesHit(Contacts.Hits hits, int hit) {}

    /**
     * A collider has entered a sensor.
     *
     * @param sensor the sensor
     * @param visitor the body that is in it, or flew through it within the step
     */
    default void entered(ColliderRef sensor, ColliderRef visitor) {}

    /**
     * A collider has left a sensor, or one of the two is gone. Each had entered.
     *
     * @param sensor the sensor
     * @param visitor the body that was in it
     */
    default void left(ColliderRef sensor, ColliderRef visitor) {}
}
