package dev.cairn.physics.joint;

import dev.cairn.core.ecs.component.Component;

/**
 * Marks the entity of a joint that was made by {@link NewJoint}. The joint lives as long as its
 * entity has this: {@code tick.commands().delete(entity)} takes it out of the world. When one of
 * its bodies goes the entity is deleted, so that an observer of this component is told. It is not
 * to be given or changed by hand.
 *
 * @param number of the joint in the physics, at least 0; used again after the joint's end
 * @param entityA entity of the first body
 * @param entityB entity of the second one
 */
public record RigidJoint(int number, long entityA, long entityB) {
    /** The component key. */
    public static final Component<RigidJoint> COMPONENT = Component.of(RigidJoint.class);
}
