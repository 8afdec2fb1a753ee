package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.EntitySpec;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * The lines of the list of entities, each made anew only when its entity changes. Window thread.
 */
@SuppressWarnings("ReferenceEquality") // a changed entity is another object
final class EntityTitles {
    private @Nullable EntitySpec[] entities = new EntitySpec[64];
    private String[] titles = new String[64];

    String of(int index, EntitySpec entity) {
        if (index >= entities.length) {
            entities = Arrays.copyOf(entities, 2 * index);
            titles = Arrays.copyOf(titles, 2 * index);
        }
        if (entities[index] != entity) {
            entities[index] = entity;
            titles[index] = title(index, entity);
        }
        return titles[index];
    }

    static String title(int index, EntitySpec entity) {
        return "%d  %s, %s%s"
                .formatted(
                        index,
                        entity.name().isEmpty() ? "(no name)" : entity.name(),
                        entity.shape().type(),
                        switch (entity.body()) {
                            case DYNAMIC -> "";
                            case FIXED -> ", fixed";
                            case KINEMATIC -> ", kinematic";
                            case NONE -> ", only drawn";
                        });
    }
}
