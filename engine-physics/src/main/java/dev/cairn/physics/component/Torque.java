package dev.cairn.physics.component;

import dev.cairn.core.ecs.component.Component;

/**
 * The torque on a body, as {@link Force}.
 *
 * @param x world, N m
 * @param y world, N m
 * @param z world, N m
 */
public record Torque(double x, double y, double z) {
    /** The component key. */
    public static final Component<Torque> COMPONENT = Component.of(Torque.class);

    /** No torque. */
    public static final Torque ZERO = new Torque(0, 0, 0);
}
