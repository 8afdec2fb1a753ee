package dev.cairn.physics.component;

import dev.cairn.core.ecs.component.Component;

/**
 * Velocity of a body, written each tick by the physics system; changing it has no effect on the
 * body (use {@code BodyRef.setVelocity}).
 *
 * @param vx velocity of the centre of mass, world x, m/s
 * @param vy velocity of the centre of mass, world y, m/s
 * @param vz velocity of the centre of mass, world z, m/s
 * @param wx angular velocity, world x, rad/s
 * @param wy angular velocity, world y, rad/s
 * @param wz angular velocity, world z, rad/s
 */
public record Velocity(double vx, double vy, double vz, double wx, double wy, double wz) {
    /** The component key. */
    public static final Component<Velocity> COMPONENT = Component.of(Velocity.class);

    /** At rest. */
    public static final Velocity ZERO = new Velocity(0, 0, 0, 0, 0, 0);
}
