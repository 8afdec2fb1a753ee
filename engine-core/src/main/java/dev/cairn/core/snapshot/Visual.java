package dev.cairn.core.snapshot;

import dev.cairn.core.ecs.component.Component;

import java.util.Objects;

/**
 * What to draw at the entity's {@link Pose}; opaque to the core, which hands it to the reader of
 * the snapshot.
 *
 * @param model the model, which must be safe to share with the drawing thread
 */
public record Visual(Object model) {
    /** Key of this component. */
    public static final Component<Visual> COMPONENT = Component.of(Visual.class);

    /**
     * Checks the model.
     *
     * @throws NullPointerException if there is no model
     */
    public Visual {
        Objects.requireNonNull(
                model,
                "model must not be null: an entity that is not to be drawn has no Visual at all");
    }
}
