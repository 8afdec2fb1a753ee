package dev.cairn.physics.component;

import dev.cairn.core.ecs.component.Component;

/**
 * The force on the centre of mass of a body, in each tick as long as the component says so: any
 * system may write it in parallel, and the physics reads it in the same tick. Beside what {@code
 * BodyRef.applyForce} adds. A body asleep wakes when it changes, and stays awake while it is not 0.
 *
 * @param x world, N
 * @param y world, N
 * @param z world, N
 */
public record Force(double x, double y, double z) {
    /** The component key. */
    public static final Component<Force> COMPONENT = Component.of(Force.class);

    /** No force. */
    public static final Force ZERO = new Force(0, 0, 0);
}
