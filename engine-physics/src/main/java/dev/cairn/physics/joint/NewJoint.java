package dev.cairn.physics.joint;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.physics.internal.Checks;

/**
 * A joint to be, as a component: an entity that has it when a step ends becomes that joint, has
 * {@link RigidJoint} from then on, and loses it. So any system makes joints: {@code
 * tick.commands().spawn(new NewJoint(Joint.ball(Jointed.of(a), Jointed.of(b)).at(0, 5, 0)))}.
 * Bodies that are spawned in the same step may be named by their handles; their joint is made after
 * them.
 *
 * <p>A joint to a body that was deleted in the same step is forgotten, and its entity deleted.
 * {@code world.ecs().resolve(handle)} gives the entity, {@link Joints#of} the joint.
 *
 * @param joint the description; do not change it until the step has ended
 */
public record NewJoint(Joint joint) {
    /** The component key. */
    public static final Component<NewJoint> COMPONENT = Component.of(NewJoint.class);

    /** Refuses null. */
    public NewJoint {
        Checks.notNull("joint", joint);
    }
}
