package dev.cairn.physics.state;

import dev.cairn.core.ecs.component.Component;

import java.lang.invoke.MethodHandles;

/**
 * Marks the entity of a body. {@code PhysicsWorld.add} puts it there; a body lives as long as its
 * entity has it together with {@code Pose} and {@code Velocity}. Entities that are given one by
 * hand are refused at the next tick.
 *
 * @param slot row of the body in the working arrays of the physics, at least 0; reused after the
 *     body's end
 */
public record RigidBody(int slot) {
    /** The component key. */
    public static final Component<RigidBody> COMPONENT =
            Component.of(MethodHandles.lookup(), RigidBody.class);
}
