package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.SceneFile;

import org.jspecify.annotations.Nullable;

/** The lines of the list of joints, made anew only when the scene changes. Window thread. */
@SuppressWarnings("ReferenceEquality") // a changed scene is another object
final class JointTitles {
    private @Nullable SceneFile shown;
    private String[] titles = {};

    String of(int index, SceneFile scene) {
        if (scene != shown) {
            shown = scene;
            titles = new String[scene.joints().size()];
            for (int i = 0; i < titles.length; i++) {
                titles[i] = title(i, scene);
            }
        }
        return titles[index];
    }

    static String title(int index, SceneFile scene) {
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
