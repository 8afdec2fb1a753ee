package dev.cairn.samples.scenefile.edit;

import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * What can be done to several entities of a scene at once: functions from a scene to another.
 * Joints go along as {@link JointEdit#carried} says; those between two entities of a group keep
 * their place in it. Stateless; any thread.
 *
 * <p>World frame, metres. All throw what {@link SceneEdit} throws.
 */
public final class GroupEdit {
    private GroupEdit() {}

    /**
     * Entities and the joints among them, apart from a scene.
     *
     * @param entities at least one
     * @param joints their ends are places in that list
     */
    public record Part(List<EntitySpec> entities, List<JointSpec> joints) {
        /** Copies the lists. */
        public Part {
            entities = List.copyOf(entities);
            joints = List.copyOf(joints);
        }
    }

    private static SceneFile each(SceneFile scene, int[] which, UnaryOperator<EntitySpec> change) {
        SceneFile now = scene;
        for (int index : which) {
            now = SceneEdit.change(now, index, change);
        }
        return now;
    }

    /**
     * Moves entities.
     *
     * @param scene the scene
     * @param which their places in its list
     * @param by how far
     * @return the changed scene
     */
    public static SceneFile move(SceneFile scene, int[] which, Xyz by) {
        return each(
                scene,
                which,
                e ->
                        e.at(
                                new Xyz(
                                        rounded(e.position().x() + by.x()),
                                        rounded(e.position().y() + by.y()),
                                        rounded(e.position().z() + by.z())),
                                e.rotation()));
    }

    /**
     * Turns entities about one point.
     *
     * @param scene the scene
     * @param which their places in its list
     * @param about the point that stays
     * @param by the turn
     * @return the changed scene
     */
    public static SceneFile turn(SceneFile scene, int[] which, Xyz about, Turn by) {
        Quaterniond q = quaternion(by);
        return each(
                scene,
                which,
                e -> {
                    Quaterniond turned =
                            new Quaterniond(q).mul(quaternion(e.rotation())).normalize();
                    Vector3d arm = q.transform(from(about, e.position()));
                    return e.at(sum(about, arm), new Turn(turned.x, turned.y, turned.z, turned.w));
                });
    }

    /**
     * Scales entities about one point.
     *
     * @param scene the scene
     * @param which their places in its list
     * @param about the point that stays
     * @param factors along the axes of each entity's own frame, above 0; the places of several move
     *     by the factor along x
     * @return the changed scene
     */
    public static SceneFile scale(SceneFile scene, int[] which, Xyz about, Xyz factors) {
        return each(
                scene,
                which,
                e -> {
                    Xyz s = e.scale();
                    Vector3d arm = from(about, e.position()).mul(factors.x());
                    return e.withScale(
                                    new Xyz(
                                            rounded(s.x() * factors.x()),
                                            rounded(s.y() * factors.y()),
                                            rounded(s.z() * factors.z())))
                            .at(sum(about, arm), e.rotation());
                });
    }

    /**
     * Takes entities away, and the joints that hold them.
     *
     * @param scene the scene
     * @param which their places in its list
     * @return the scene without them
     */
    public static SceneFile delete(SceneFile scene, int[] which) {
        int[] sorted = which.clone();
        Arrays.sort(sorted);
        SceneFile now = scene;
        for (int i = sorted.length - 1; i >= 0; i--) {
            now = SceneEdit.delete(now, sorted[i]);
        }
        return now;
    }

    /**
     * Takes a copy of entities and of the joints among them.
     *
     * @param scene the scene, which stays as it is
     * @param which their places in its list
     * @return the part
     */
    public static Part copy(SceneFile scene, int[] which) {
        int[] sorted = which.clone();
        Arrays.sort(sorted);
        List<EntitySpec> entities = new ArrayList<>();
        for (int index : sorted) {
            entities.add(scene.entities().get(index));
        }
        List<JointSpec> joints = new ArrayList<>();
        for (JointSpec joint : scene.joints()) {
            int a = Arrays.binarySearch(sorted, joint.a());
            int b = Arrays.binarySearch(sorted, joint.b());
            if (a >= 0 && b >= 0) {
                joints.add(joint.between(a, b));
            }
        }
        return new Part(entities, joints);
    }

    /**
     * Puts a part at the end of the lists.
     *
     * @param scene the scene
     * @param part what to add
     * @param offset from where it was to where it shall be
     * @return the scene with it; its entities are the last of the list
     */
    public static SceneFile paste(SceneFile scene, Part part, Xyz offset) {
        int first = scene.entities().size();
        SceneFile now = scene;
        for (EntitySpec entity : part.entities()) {
            now = SceneEdit.add(now, entity);
        }
        List<JointSpec> joints = new ArrayList<>(now.joints());
        for (JointSpec joint : part.joints()) {
            joints.add(joint.between(first + joint.a(), first + joint.b()));
        }
        return move(now.withJoints(joints), last(part.entities().size(), now), offset);
    }

    /**
     * The places of the last entities of a scene.
     *
     * @param count how many
     * @param scene the scene
     * @return their places, ascending
     */
    public static int[] last(int count, SceneFile scene) {
        int[] places = new int[count];
        for (int i = 0; i < count; i++) {
            places[i] = scene.entities().size() - count + i;
        }
        return places;
    }

    private static Quaterniond quaternion(Turn t) {
        return new Quaterniond(t.x(), t.y(), t.z(), t.w()).normalize();
    }

    private static Vector3d from(Xyz a, Xyz b) {
        return new Vector3d(b.x() - a.x(), b.y() - a.y(), b.z() - a.z());
    }

    private static Xyz sum(Xyz a, Vector3d b) {
        return new Xyz(rounded(a.x() + b.x), rounded(a.y() + b.y), rounded(a.z() + b.z));
    }

    /** To a nanometre, so that there and back again is the same place. */
    private static double rounded(double value) {
        double steps = Math.rint(value * 1e9);
        return Math.abs(steps) < 0x1p52 ? steps / 1e9 : value;
    }
}
