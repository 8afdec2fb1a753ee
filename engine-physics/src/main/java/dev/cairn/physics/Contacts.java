package dev.cairn.physics;

import org.joml.Vector3d;

/**
 * The contacts of the last step: pairs of bodies that touch or are about to. Their order is a
 * function of the world's history, never of the number of workers.
 *
 * <p>A view: the same object for the life of the world, its contents replaced by each step.
 * Simulation thread, between steps. Nothing here allocates. World axes, SI units. Bodies that were
 * removed since the step are still named here; ask {@link BodyRef#isAlive}.
 */
public interface Contacts {
    /**
     * How many contacts have at least one point.
     *
     * @return the number, at least 0
     */
    int count();

    /**
     * One body of a contact.
     *
     * @param contact 0 to count - 1
     * @return the body
     */
    BodyRef bodyA(int contact);

    /**
     * The other body of a contact.
     *
     * @param contact 0 to count - 1
     * @return the body
     */
    BodyRef bodyB(int contact);

    /**
     * The collider of body A that touches. A contact is one of two colliders: two bodies of several
     * may have more than one.
     *
     * @param contact 0 to count - 1
     * @return the collider
     */
    ColliderRef colliderA(int contact);

    /**
     * The collider of body B that touches.
     *
     * @param contact 0 to count - 1
     * @return the collider
     */
    ColliderRef colliderB(int contact);

    /**
     * How many points the contact has.
     *
     * @param contact 0 to count - 1
     * @return 1 to 4
     */
    int pointCount(int contact);

    /**
     * Which triangle of a mesh or a height field touches: that under the deepest point. What you
     * know of it, keep in an array of your own by this number.
     *
     * @param contact 0 to count - 1
     * @return the number that it was given with, or -1 if both are solids
     */
    int triangle(int contact);

    /**
     * The direction from A to B, along which the normal impulses are told. Balls that met more than
     * once in the step, along other lines, pushed each other along their sum: the direction of
     * that.
     *
     * @param contact 0 to count - 1
     * @param destination receives the unit normal
     * @return destination
     */
    Vector3d normal(int contact, Vector3d destination);

    /**
     * A point, midway between the surfaces: as the narrow phase found it at the start of the step,
     * carried along with the centre of mass of body A.
     *
     * @param contact 0 to count - 1
     * @param point 0 to pointCount - 1
     * @param destination receives m
     * @return destination
     */
    Vector3d point(int contact, int point, Vector3d destination);

    /**
     * The distance of the surfaces along the normal, at the start of the step.
     *
     * @param contact 0 to count - 1
     * @param point 0 to pointCount - 1
     * @return m, negative when they overlap
     */
    double separation(int contact, int point);

    /**
     * What the bodies pushed each other with at the point.
     *
     * @param contact 0 to count - 1
     * @param point 0 to pointCount - 1
     * @return N s, summed over the step, at least 0
     */
    double normalImpulse(int contact, int point);

    /**
     * Whether the bodies touch: since they last came within reach, they have overlapped or pushed
     * each other.
     *
     * @param contact 0 to count - 1
     * @return true between the events of {@link #began} and {@link #ended}
     */
    boolean touching(int contact);

    /**
     * The pairs that began to touch in the last step.
     *
     * @return the same view each time
     */
    Events began();

    /**
     * The pairs that ceased to touch in the last step, or whose body was removed before it. Each
     * had begun before.
     *
     * @return the same view each time
     */
    Events ended();

    /**
     * The pairs of bodies that began to touch in the last step: with how many of their shapes does
     * not matter, each pair is told once. The body of the lower slot is A; the colliders are those
     * of the last pair of shapes that began to. In the order in which {@link #ended} and {@link
     * #began} first name the two.
     *
     * @return the same view each time
     */
    Events bodiesBegan();

    /**
     * The pairs of bodies that ceased to touch in the last step: no pair of their shapes touches
     * any more, or one of the two is gone. Each had begun before; what parts and meets again in one
     * step is not told. Named and ordered as in {@link #bodiesBegan}.
     *
     * @return the same view each time
     */
    Events bodiesEnded();

    /**
     * The bodies that entered a sensor in the last step; also those that flew through it within the
     * step, which are among {@link #left} too: who reads both lists, reads this one first. {@code
     * A} is the sensor, {@code B} the body that entered. Who is in before and after a change of
     * shapes or colliders has neither left nor entered.
     *
     * @return the same view each time
     */
    Events entered();

    /**
     * Visitors that left a sensor in the last step, or were removed before it, as the sensor may
     * have been. Each had entered before. {@code A} is the sensor, {@code B} the body that left.
     *
     * @return the same view each time
     */
    Events left();

    /**
     * The pairs of colliders that met at speed in the last step. There are none until {@link
     * #setHitSpeed} says from which speed on.
     *
     * @return the same view each time
     */
    Hits hits();

    /**
     * The pairs of bodies that met at speed in the last step, each once: by the strongest of the
     * {@link #hits} of their shapes, that of the largest impulse and of equal ones the first. Also
     * bodies that touched already, if further shapes of them met. The body of the lower slot is A.
     * In the order in which {@link #hits} first names the two.
     *
     * @return the same view each time
     */
    Hits bodiesHit();

    /**
     * Says from which speed of approach on a touch that begins is among the {@link #hits} and
     * {@link #bodiesHit}; infinite by default. Between steps.
     *
     * @param metresPerSecond at least 0
     */
    void setHitSpeed(double metresPerSecond);

    /**
     * Tells a listener, after each step and in the order in which they came, what happened.
     *
     * @param listener the listener
     */
    void listen(ContactListener listener);

    /**
     * Tells a listener nothing more.
     *
     * @param listener one that listens
     */
    void unlisten(ContactListener listener);

    /**
     * Pairs of colliders, in a deterministic order. Simulation thread, between steps; does not
     * allocate.
     */
    interface Events {
        /**
         * How many pairs there are.
         *
         * @return the number, at least 0
         */
        int count();

        /**
         * One body of a pair.
         *
         * @param event 0 to count - 1
         * @return the body
         */
        BodyRef bodyA(int event);

        /**
         * The other body of a pair.
         *
         * @param event 0 to count - 1
         * @return the body
         */
        BodyRef bodyB(int event);

        /**
         * The collider of body A.
         *
         * @param event 0 to count - 1
         * @return the collider; it may be gone
         */
        ColliderRef colliderA(int event);

        /**
         * The collider of body B.
         *
         * @param event 0 to count - 1
         * @return the collider; it may be gone
         */
        ColliderRef colliderB(int event);
    }

    /** Pairs that met at speed, until the next step. World axes, SI units. */
    interface Hits extends Events {
        /**
         * Where: the point that was pushed most.
         *
         * @param hit 0 to count - 1
         * @param destination receives m
         * @return destination
         */
        Vector3d point(int hit, Vector3d destination);

        /**
         * The unit normal from A to B.
         *
         * @param hit 0 to count - 1
         * @param destination receives the normal
         * @return destination
         */
        Vector3d normal(int hit, Vector3d destination);

        /**
         * Which triangle was hit, as in {@link Contacts#triangle}.
         *
         * @param hit 0 to count - 1
         * @return its number, or -1 if both are solids
         */
        int triangle(int hit);

        /**
         * How fast the two approached at the start of the step, along the normal, at the point that
         * approached fastest.
         *
         * @param hit 0 to count - 1
         * @return m/s
         */
        double approachSpeed(int hit);

        /**
         * With what the two pushed each other along the normal.
         *
         * @param hit 0 to count - 1
         * @return N s, summed over points and step
         */
        double impulse(int hit);
    }
}
