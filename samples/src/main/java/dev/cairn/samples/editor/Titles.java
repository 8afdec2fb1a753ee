package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.SceneFile;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * The lines of the list of entities and joints, made anew only when what they tell of changes.
 * Window thread.
 */
@SuppressWarnings("ReferenceEquality") // what has changed is another object
final class Titles {
    private @Nullable EntitySpec[] entities = new EntitySpec[64];
    private String[] titles = new String[64];
    private @Nullable SceneFile shown;
    private String[] joints = {};

    /** The line of an entity. */
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
        String shape = entity.shape().type();
        boolean says = !entity.name().isEmpty() && !entity.name().equals(shape);
        return "%d  %s%s%s"
                .formatted(
                        index,
                        says ? entity.name() + ", " : "",
                        shape,
                        switch (entity.body()) {
                            case DYNAMIC -> "";
                            case FIXED -> ", fixed";
                            case KINEMATIC -> ", kinematic";
                            case NONE -> ", only drawn";
                        });
    }

    /** The line of a joint. */
    String joint(int index, SceneFile scene) {
        if (scene != shown) {
            shown = scene;
            joints = new String[scene.joints().size()];
            for (int i = 0; i < joints.length; i++) {
                joints[i] = jointTitle(i, scene);
            }
        }
        return joints[index];
    }

    static String jointTitle(int index, SceneFile scene) {
        JointSpec joint = scene.joints().get(index);
        return "joint %d  %s%s, %s and %s"
                .formatted(
                        index,
                        joint.name().isEmpty() ? "" : joint.name() + ", ",
                        joint.kind(),
                        name(scene, joint.a()),
                        name(scene, joint.b()));
    }

    /** What an entity is called, by its place if it has no name. */
    static String name(SceneFile scene, int index) {
        EntitySpec entity = scene.entities().get(index);
        return entity.name().isEmpty() ? "entity " + index : entity.name();
    }
}
