package dev.cairn.physics;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.physics.internal.Checks;

/**
 * A body to be, as a component: an entity that has it when a step ends becomes that body, with
 * {@code Pose}, {@code Velocity} and the components of the description, and loses it. So any system
 * makes bodies: {@code tick.commands().spawn(new NewBody(Body.dynamic().shape(ball).at(0, 5, 0)))}.
 * {@code world.ecs().resolve(handle)} gives the entity, {@link PhysicsWorld#bodyOf} the body.
 *
 * @param body the description; do not change it until the step has ended
 */
public record NewBody(Body body) {
    /** The component key. */
    public static final Component<NewBody> COMPONENT = Component.of(NewBody.class);

    /** Refuses null. */
    public NewBody {
        Checks.notNull("body", body);
    }
}
