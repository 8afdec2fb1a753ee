package dev.cairn.physics;

import dev.cairn.core.ecs.Component;

import java.lang.invoke.MethodHandles;

/**
 * Marks the entity of a body. {@link PhysicsWorld#add} puts it there; a body lives as long as its
 * entity has it together with {@code Pose} and {@link Velocity}. Entities that are given one by
 * hand are refused at the next tick.
 *
 * @param slot row of the body in the working arrays of the physics, at least 0; reused after the
 *     body's end
 */
record RigidBody(int slot) {
    /** The component key. */
    static final Component<RigidBody> COMPONENT =
            Component.of(MethodHandles.lookup(), RigidBody.class);
}
