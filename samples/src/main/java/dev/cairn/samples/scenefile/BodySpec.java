package dev.cairn.samples.scenefile;

import dev.cairn.physics.Body;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.collider.Filter;

import org.jspecify.annotations.Nullable;

import java.util.List;

/**
 * What an entity's body can have beside shape, material and motion. Immutable.
 *
 * @param parts the shapes that it is made of; empty if it has one, at its origin, and nothing is
 *     said of it
 * @param filter whom it meets
 * @param inertia about the shape's axes, kg m², or null for that of the shapes
 * @param products the entries xy, xz, yz of that inertia, kg m²
 * @param centre of mass in the body's frame, m, or null for that of the shapes
 * @param gravityScale how much of the gravity acts on it
 * @param linearDamping rate at which velocity decays, 1/s
 * @param angularDamping rate at which angular momentum decays, 1/s
 * @param speedLimit m/s; infinite for none
 * @param locks degrees of freedom that it does not have, in the order of {@link Lock}
 * @param canSleep whether it may fall asleep
 * @param userData a word or a number ({@code Double}) for the program; null for none
 */
public record BodySpec(
        List<PartSpec> parts,
        Filter filter,
        @Nullable Xyz inertia,
        Xyz products,
        @Nullable Xyz centre,
        double gravityScale,
        double linearDamping,
        double angularDamping,
        double speedLimit,
        List<Lock> locks,
        boolean canSleep,
        @Nullable Object userData) {
    /** One shape that meets all, under all of the gravity. */
    public static final BodySpec DEFAULT =
            new BodySpec(
                    List.of(),
                    Filter.ALL,
                    null,
                    Xyz.ZERO,
                    null,
                    1,
                    0,
                    0,
                    Double.POSITIVE_INFINITY,
                    List.of(),
                    true,
                    null);

    /** Copies the lists. */
    public BodySpec {
        parts = List.copyOf(parts);
        locks = List.of(Lock.of(Lock.bits(locks.toArray(new Lock[0]))));
    }

    /**
     * The same of other shapes.
     *
     * @param value all of them, in their order
     * @return a copy
     */
    public BodySpec withParts(List<PartSpec> value) {
        return new BodySpec(
                value,
                filter,
                inertia,
                products,
                centre,
                gravityScale,
                linearDamping,
                angularDamping,
                speedLimit,
                locks,
                canSleep,
                userData);
    }

    /**
     * The same, meeting others.
     *
     * @param value the filter
     * @return a copy
     */
    public BodySpec withFilter(Filter value) {
        return new BodySpec(
                parts,
                value,
                inertia,
                products,
                centre,
                gravityScale,
                linearDamping,
                angularDamping,
                speedLimit,
                locks,
                canSleep,
                userData);
    }

    /**
     * The same with another inertia.
     *
     * @param value kg m², or null for that of the shapes
     * @return a copy
     */
    public BodySpec withInertia(@Nullable Xyz value) {
        return withInertia(value, Xyz.ZERO);
    }

    /**
     * The same with another tensor.
     *
     * @param value kg m², or null for that of the shapes
     * @param off its entries xy, xz, yz, kg m²
     * @return a copy
     */
    public BodySpec withInertia(@Nullable Xyz value, Xyz off) {
        return new BodySpec(
                parts,
                filter,
                value,
                off,
                centre,
                gravityScale,
                linearDamping,
                angularDamping,
                speedLimit,
                locks,
                canSleep,
                userData);
    }

    /**
     * The same, moving otherwise.
     *
     * @param gravity how much of it acts
     * @param linear damping, 1/s
     * @param angular damping, 1/s
     * @param limit of the speed, m/s
     * @return a copy
     */
    public BodySpec moving(double gravity, double linear, double angular, double limit) {
        return new BodySpec(
                parts, filter, inertia, products, centre, gravity, linear, angular, limit, locks,
                canSleep, userData);
    }

    /**
     * The same with other locks.
     *
     * @param value degrees of freedom that it does not have
     * @return a copy
     */
    public BodySpec withLocks(List<Lock> value) {
        return new BodySpec(
                parts,
                filter,
                inertia,
                products,
                centre,
                gravityScale,
                linearDamping,
                angularDamping,
                speedLimit,
                value,
                canSleep,
                userData);
    }

    /**
     * The same with another centre of mass.
     *
     * @param value in the body's frame, m, or null for that of the shapes
     * @return a copy
     */
    public BodySpec withCentre(@Nullable Xyz value) {
        return new BodySpec(
                parts,
                filter,
                inertia,
                products,
                value,
                gravityScale,
                linearDamping,
                angularDamping,
                speedLimit,
                locks,
                canSleep,
                userData);
    }

    /**
     * The same, sleeping or not.
     *
     * @param value whether it may fall asleep
     * @return a copy
     */
    public BodySpec withSleep(boolean value) {
        return new BodySpec(
                parts,
                filter,
                inertia,
                products,
                centre,
                gravityScale,
                linearDamping,
                angularDamping,
                speedLimit,
                locks,
                value,
                userData);
    }

    /**
     * The same with other user data.
     *
     * @param value a word or a {@code Double}, or null for none
     * @return a copy
     */
    public BodySpec withUserData(@Nullable Object value) {
        return new BodySpec(
                parts,
                filter,
                inertia,
                products,
                centre,
                gravityScale,
                linearDamping,
                angularDamping,
                speedLimit,
                locks,
                canSleep,
                value);
    }

    /**
     * Tells a body all of this but the shapes.
     *
     * @param body gets it
     * @throws IllegalArgumentException if a number is out of its range
     */
    public void tell(Body body) {
        body.filter(filter)
                .gravityScale(gravityScale)
                .damping(linearDamping, angularDamping)
                .speedLimit(speedLimit)
                .lock(locks.toArray(new Lock[0]))
                .canSleep(canSleep)
                .userData(userData);
        if (inertia != null) {
            body.inertia(
                    inertia.x(),
                    inertia.y(),
                    inertia.z(),
                    products.x(),
                    products.y(),
                    products.z());
        }
        if (centre != null) {
            body.centreOfMass(centre.x(), centre.y(), centre.z());
        }
    }
}
