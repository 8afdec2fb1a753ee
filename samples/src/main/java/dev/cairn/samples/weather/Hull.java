package dev.cairn.samples.weather;

import dev.cairn.core.ecs.component.Component;

/**
 * What water and wind know of a body: an upright prism about its origin.
 *
 * @param waterplane area of its horizontal cut, m²
 * @param halfHeight m
 * @param drag force over its speed against the air, N s/m
 */
public record Hull(double waterplane, double halfHeight, double drag) {
    /** The component key. */
    public static final Component<Hull> COMPONENT = Component.of(Hull.class);
}
