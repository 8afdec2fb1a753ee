package dev.cairn.samples.weather;

import dev.cairn.core.ecs.Component;

/**
 * What the water does to a body.
 *
 * @param y upwards, N
 */
public record Lift(double y) {
    /** The component key. */
    public static final Component<Lift> COMPONENT = Component.of(Lift.class);

    /** In the air. */
    public static final Lift NONE = new Lift(0);
}
