package dev.cairn.physics.joint;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.physics.internal.Checks;

import java.util.function.Consumer;

/**
 * A change of a joint that is asked for in a step, made when the step ends: {@code
 * tick.commands().spawn(new JointChange(entity, joint -> joint.motor(JointAxis.TWIST, 2, 40)))}.
 * Changes are made in the order of their commands, each by itself. The entity that asked is gone
 * then. What was asked for a joint that ended in the same step is forgotten with it.
 *
 * @param entity of the joint
 * @param change what to do; the step throws what it throws, and changes behind it are made when the
 *     next step ends
 */
public record JointChange(long entity, Consumer<JointRef> change) {
    /** The component key. */
    public static final Component<JointChange> COMPONENT = Component.of(JointChange.class);

    /** Refuses null. */
    public JointChange {
        Checks.notNull("change", change);
    }
}
