package dev.cairn.physics.collider;

import org.jspecify.annotations.Nullable;

/**
 * Looks at each contact of a step before it is solved, and may change it: a one-way platform, a
 * patch of oil. See {@link Change}.
 *
 * <p>Called by any worker, once for each contact with points in each step, for bodies that are
 * awake. So it must depend on nothing but what the change tells and what stays as it is meanwhile,
 * and must write nowhere else; then results do not depend on workers. It should not allocate.
 */
@FunctionalInterface
public interface ContactHook {
    /**
     * Looks at a contact.
     *
     * @param contact valid during the call only
     */
    void change(Change contact);

    /** A contact before it is solved. World axes, SI units. */
    interface Change {
        /**
         * What the user attached to the first collider.
         *
         * @return the object, or {@code null}
         */
        @Nullable Object userDataA();

        /**
         * What the user attached to the second collider.
         *
         * @return the object, or {@code null}
         */
        @Nullable Object userDataB();

        /**
         * Which triangle of a mesh or a height field touches: that under the deepest point.
         *
         * @return the number that it was given with, or -1 if both are solids
         */
        int triangle();

        /**
         * Of the unit normal from A to B.
         *
         * @return x
         */
        double normalX();

        /**
         * Of the unit normal from A to B.
         *
         * @return y
         */
        double normalY();

        /**
         * Of the unit normal from A to B.
         *
         * @return z
         */
        double normalZ();

        /**
         * The least distance of the surfaces at the contact's points.
         *
         * @return m, negative where they overlap
         */
        double separation();

        /**
         * How fast the centres of mass approach along the normal, at the start of the step.
         *
         * @return m/s, negative when they part
         */
        double approachSpeed();

        /**
         * The Coulomb coefficient, as mixed or as set in this step.
         *
         * @return dimensionless, at least 0
         */
        double friction();

        /**
         * Sets friction and restitution for this step.
         *
         * @param friction Coulomb coefficient, finite, at least 0
         * @param restitution 0 to 1
         */
        void surface(double friction, double restitution);

        /** There is no contact in this step: the two go through each other. */
        void disable();

        /**
         * A number that the contact remembers from step to step while the boxes of the two overlap;
         * 0 at first.
         *
         * @return what {@link #remember} was given last
         */
        int memory();

        /**
         * Remembers a number.
         *
         * @param value any
         */
        void remember(int value);
    }
}
