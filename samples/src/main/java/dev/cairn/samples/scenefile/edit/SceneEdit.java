package dev.cairn.samples.scenefile.edit;

import dev.cairn.samples.scenefile.EntityRules;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.LookSpec;
import dev.cairn.samples.scenefile.PartSpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.UnaryOperator;

/**
 * What can be done to a scene: functions from a scene to another, which leave the first as it is.
 * Stateless; any thread.
 *
 * <p>All throw {@link IllegalArgumentException} where the result could not be built: a round shape
 * that would be squashed, a size below the engine's least; or where no file could hold it. Broken
 * mesh files are found when a scene is shown.
 */
public final class SceneEdit {
    private SceneEdit() {}

    /**
     * Puts an entity at the end of the list.
     *
     * @param scene the scene
     * @param entity what to add
     * @return the scene with it
     */
    public static SceneFile add(SceneFile scene, EntitySpec entity) {
        List<EntitySpec> entities = new ArrayList<>(scene.entities());
        entities.add(check(entity));
        return scene.withEntities(entities);
    }

    /**
     * Takes an entity away, and the joints that hold it.
     *
     * @param scene the scene
     * @param index which entity
     * @return the scene without it
     */
    public static SceneFile delete(SceneFile scene, int index) {
        List<EntitySpec> entities = new ArrayList<>(scene.entities());
        entities.remove(Objects.checkIndex(index, entities.size()));
        List<JointSpec> joints = new ArrayList<>();
        for (JointSpec joint : scene.joints()) {
            int a = joint.a();
            int b = joint.b();
            if (a != index && b != index) {
                joints.add(joint.between(a > index ? a - 1 : a, b > index ? b - 1 : b));
            }
        }
        return scene.withEntities(entities).withJoints(joints);
    }

    /**
     * Adds an entity like another one, at the end of the list.
     *
     * @param scene the scene
     * @param index which entity
     * @param offset from the other one to the new one, m
     * @return the scene with it
     */
    public static SceneFile duplicate(SceneFile scene, int index, Xyz offset) {
        EntitySpec like = scene.entities().get(index);
        return add(scene, like.at(sum(like.position(), offset), like.rotation()));
    }

    /**
     * Changes an entity in any way that its {@code with} methods offer. Joints go along, as {@link
     * JointEdit#carried} says.
     *
     * @param scene the scene
     * @param index which entity
     * @param change from what it is to what it shall be
     * @return the scene with the changed entity
     */
    public static SceneFile change(SceneFile scene, int index, UnaryOperator<EntitySpec> change) {
        List<EntitySpec> entities = new ArrayList<>(scene.entities());
        EntitySpec before = entities.get(index);
        EntitySpec after = check(change.apply(before));
        entities.set(index, after);
        return JointEdit.carried(scene.withEntities(entities), index, before, after);
    }

    /**
     * Puts an entity elsewhere.
     *
     * @param scene the scene
     * @param index which entity
     * @param position of the origin of its shape's frame, m
     * @return the changed scene
     */
    public static SceneFile move(SceneFile scene, int index, Xyz position) {
        return change(scene, index, entity -> entity.at(position, entity.rotation()));
    }

    /**
     * Turns an entity in its place.
     *
     * @param scene the scene
     * @param index which entity
     * @param rotation its new orientation
     * @return the changed scene
     */
    public static SceneFile turn(SceneFile scene, int index, Turn rotation) {
        return change(scene, index, entity -> entity.at(entity.position(), rotation));
    }

    /**
     * Rewrites the relative paths of meshes and pictures for a file that is kept elsewhere.
     *
     * @param scene a scene whose paths are relative to {@code from}
     * @param from a folder
     * @param to the folder of the new file
     * @return the same scene with paths relative to {@code to}; absolute paths stay
     */
    public static SceneFile rebase(SceneFile scene, Path from, Path to) {
        Path source = from.toAbsolutePath().normalize();
        Path target = to.toAbsolutePath().normalize();
        if (source.equals(target)) {
            return scene;
        }
        List<EntitySpec> entities = new ArrayList<>();
        for (EntitySpec entity : scene.entities()) {
            LookSpec look = entity.look();
            String texture = look.texture();
            boolean own = look.hasTextureFile();
            EntitySpec moved =
                    entity.withLook(
                            new LookSpec(
                                    look.visible(),
                                    look.rgb(),
                                    own ? rebase(texture, source, target) : texture,
                                    look.tileMetres(),
                                    rebase(look.mesh(), source, target),
                                    look.meshScale()));
            if (entity.physics().parts().isEmpty()) {
                moved = moved.withShape(rebase(entity.shape(), source, target));
            } else {
                List<PartSpec> parts = new ArrayList<>();
                for (PartSpec part : entity.physics().parts()) {
                    parts.add(part.withShape(rebase(part.shape(), source, target)));
                }
                moved = moved.withPhysics(entity.physics().withParts(parts));
            }
            entities.add(moved);
        }
        return scene.withEntities(entities).withState(rebase(scene.state(), source, target));
    }

    private static ShapeSpec rebase(ShapeSpec shape, Path source, Path target) {
        if (!(shape instanceof MeshShape mesh)) {
            return shape;
        }
        String there = rebase(mesh.file(), source, target);
        return there == null ? mesh : mesh.withFile(there);
    }

    private static @Nullable String rebase(@Nullable String path, Path source, Path target) {
        if (path == null || Path.of(path).isAbsolute()) {
            return path;
        }
        Path whole = source.resolve(path).normalize();
        boolean sameRoot = Objects.equals(whole.getRoot(), target.getRoot());
        return (sameRoot ? target.relativize(whole) : whole).toString().replace('\\', '/');
    }

    private static EntitySpec check(EntitySpec entity) {
        EntityRules.check(entity);
        return entity;
    }

    private static Xyz sum(Xyz a, Xyz b) {
        return new Xyz(a.x() + b.x(), a.y() + b.y(), a.z() + b.z());
    }
}
