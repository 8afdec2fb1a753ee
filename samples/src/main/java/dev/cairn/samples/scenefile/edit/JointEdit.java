package dev.cairn.samples.scenefile.edit;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.JointSpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.UnaryOperator;

/**
 * What can be done to the joints of a scene: functions from a scene to another. Stateless; any
 * thread.
 *
 * <p>All but {@link #carried} and {@link #delete} throw {@link IllegalArgumentException} where the
 * engine would refuse the joint.
 */
public final class JointEdit {
    private JointEdit() {}

    /**
     * Puts a joint at the end of the list.
     *
     * @param scene the scene
     * @param joint what to add
     * @return the scene with it
     */
    public static SceneFile add(SceneFile scene, JointSpec joint) {
        List<JointSpec> joints = new ArrayList<>(scene.joints());
        joints.add(check(scene, joint));
        return scene.withJoints(joints);
    }

    /**
     * Takes a joint away.
     *
     * @param scene the scene
     * @param index which joint
     * @return the scene without it
     */
    public static SceneFile delete(SceneFile scene, int index) {
        List<JointSpec> joints = new ArrayList<>(scene.joints());
        joints.remove(Objects.checkIndex(index, joints.size()));
        return scene.withJoints(joints);
    }

    /**
     * Changes a joint.
     *
     * @param scene the scene
     * @param index which joint
     * @param change from what it is to what it shall be
     * @return the scene with the changed joint
     */
    public static SceneFile change(SceneFile scene, int index, UnaryOperator<JointSpec> change) {
        List<JointSpec> joints = new ArrayList<>(scene.joints());
        joints.set(index, check(scene, change.apply(joints.get(index))));
        return scene.withJoints(joints);
    }

    /**
     * Takes along what of the joints is fixed to an entity that was put elsewhere. A joint's point
     * and axes are fixed to its first entity; where the second one has a point of its own, that
     * goes with the second one.
     *
     * @param scene the scene with the entity where it is now
     * @param index which entity
     * @param before the entity as it was
     * @param after the entity as it is
     * @return the scene with its joints where they belong; the same object if nothing moved
     */
    public static SceneFile carried(
            SceneFile scene, int index, EntitySpec before, EntitySpec after) {
        boolean stays =
                before.position().equals(after.position())
                        && before.rotation().equals(after.rotation());
        if (stays || scene.joints().stream().noneMatch(j -> j.a() == index || j.b() == index)) {
            return scene;
        }
        Move move = new Move(before, after);
        List<JointSpec> joints = new ArrayList<>();
        for (JointSpec each : scene.joints()) {
            JointSpec joint = each;
            JointSpec.Place place = joint.place();
            Xyz pa = place.anchorA();
            Xyz pb = place.anchorB();
            boolean isOne = pa != null && pa.equals(pb);
            if (joint.a() == index && joint.kind().equals("path")) {
                joint = joint.measuring(move.points(joint.parameters()), joint.length());
            }
            if (joint.a() == index) {
                Xyz second = place.secondAxis();
                Xyz moved = pa == null ? null : move.point(pa);
                joints.add(
                        joint.withPlace(
                                new JointSpec.Place(
                                        moved,
                                        isOne ? moved : pb,
                                        move.direction(place.axis()),
                                        second == null ? null : move.direction(second))));
            } else if (joint.b() == index && pb != null && !isOne) {
                joints.add(
                        joint.withPlace(
                                new JointSpec.Place(
                                        pa, move.point(pb), place.axis(), place.secondAxis())));
            } else {
                joints.add(joint);
            }
        }
        return scene.withJoints(joints);
    }

    /** From where an entity was to where it is. */
    private static final class Move {
        private final @Nullable Quaterniond turn;
        private final Vector3d from;
        private final Vector3d to;

        Move(EntitySpec before, EntitySpec after) {
            from = vector(before.position());
            to = vector(after.position());
            turn =
                    before.rotation().equals(after.rotation())
                            ? null
                            : quaternion(after.rotation())
                                    .mul(quaternion(before.rotation()).conjugate())
                                    .normalize();
        }

        Xyz point(Xyz p) {
            Vector3d v = vector(p).sub(from);
            v = turn == null ? v : turn.transform(v);
            v.add(to);
            return new Xyz(rounded(v.x), rounded(v.y), rounded(v.z));
        }

        /** Of a path: what is said first, and its points. */
        List<Double> points(List<Double> numbers) {
            List<Double> moved = new ArrayList<>(numbers.subList(0, 1));
            for (int i = 1; i + 2 < numbers.size(); i += 3) {
                Xyz p = point(new Xyz(numbers.get(i), numbers.get(i + 1), numbers.get(i + 2)));
                moved.addAll(List.of(p.x(), p.y(), p.z()));
            }
            return moved;
        }

        Xyz direction(Xyz d) {
            Vector3d v = vector(d);
            v = turn == null ? v : turn.transform(v);
            return turn == null ? d : new Xyz(v.x, v.y, v.z);
        }

        /** To a nanometre, so that a place to and back again is the same one. */
        private static double rounded(double metres) {
            double steps = Math.rint(metres * 1e9);
            return Math.abs(steps) < 0x1p52 ? steps / 1e9 : metres;
        }

        private static Vector3d vector(Xyz p) {
            return new Vector3d(p.x(), p.y(), p.z());
        }

        private static Quaterniond quaternion(Turn t) {
            return new Quaterniond(t.x(), t.y(), t.z(), t.w()).normalize();
        }
    }

    /** Asks the engine, in a world with two balls where the entities are. */
    private static JointSpec check(SceneFile scene, JointSpec joint) {
        if (joint.a() == joint.b()) {
            throw new IllegalArgumentException(
                    "a joint holds two entities, and this one is the same twice; choose another");
        }
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef a = world.add(body(scene.entities().get(joint.a())));
            BodyRef b = world.add(body(scene.entities().get(joint.b())));
            world.add(joint.joint(a, b));
        }
        return joint;
    }

    private static Body body(EntitySpec entity) {
        Body body =
                switch (entity.body()) {
                    case DYNAMIC -> Body.dynamic();
                    case KINEMATIC -> Body.kinematic();
                    case FIXED -> Body.fixed();
                    case NONE ->
                            throw new IllegalArgumentException(
                                    "\"%s\" is only drawn; a joint holds two bodies"
                                            .formatted(entity.name()));
                };
        Xyz at = entity.position();
        return body.shape(Sphere.of(0.5)).at(at.x(), at.y(), at.z());
    }
}
