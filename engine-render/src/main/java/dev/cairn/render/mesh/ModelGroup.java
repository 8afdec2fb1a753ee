package dev.cairn.render.mesh;

import java.util.List;
import java.util.function.UnaryOperator;

/**
 * Several models that are one entity's look, for example the materials of an {@code .obj} file.
 * {@code Visual.model} may hold it in place of a {@link Model}. Immutable.
 *
 * @param parts what is drawn, at least one
 */
public record ModelGroup(List<Model> parts) {
    /** Copies the list. */
    public ModelGroup {
        parts = List.copyOf(parts);
        if (parts.isEmpty()) {
            throw new IllegalArgumentException("a group of 0 models, expected at least one");
        }
    }

    /**
     * The same with each part changed.
     *
     * @param change what happens to a part, say {@code part -> part.scale(2)}
     * @return a copy
     */
    public ModelGroup map(UnaryOperator<Model> change) {
        return new ModelGroup(parts.stream().map(change).toList());
    }

    /**
     * The farthest that any point can be from the entity's position.
     *
     * @return metres
     */
    public double radius() {
        return parts.stream().mapToDouble(Model::radius).max().orElse(0);
    }
}
