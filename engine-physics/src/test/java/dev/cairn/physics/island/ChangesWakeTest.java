package dev.cairn.physics.island;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.component.Torque;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.function.Consumer;

/**
 * Each call that changes something wakes whom it concerns, and nobody else; what concerns nobody
 * leaves all asleep.
 */
class ChangesWakeTest {
    private static final Material ICE = new Material(.01, 0, 500);

    /**
     * Stacks of two on a fixed and on a kinematic table, two boxes that overlap and were taken
     * apart, two that a hinge binds, and one by itself; all asleep, all far from each other.
     */
    private static final class Bed implements AutoCloseable {
        final PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
        final BodyRef ground = Scenes.ground(world);
        final BodyRef fixed = world.add(table(Body.fixed()).at(0, .5, 0).name("fixed"));
        final BodyRef kinematic =
                world.add(table(Body.kinematic()).at(10, .5, 0).name("kinematic"));
        final List<BodyRef> dynamic = new ArrayList<>();
        final BodyRef lower = box("lower", 0, 1.5, 0);
        final BodyRef upper = box("upper", 0, 2.5, 0);
        final BodyRef rider = box("rider", 10, 1.5, 0);
        final BodyRef second = box("second", 10, 2.5, 0);
        final BodyRef ghostA = box("ghostA", -10, .5, 0);
        final BodyRef ghostB = box("ghostB", -10.5, .5, 0);
        final BodyRef doorA = box("doorA", 0, .5, 10);
        final BodyRef doorB = box("doorB", 1.5, .5, 10);
        final BodyRef alone = box("alone", 0, .5, -10);
        final JointRef hinge =
                world.add(
                        Joint.hinge(doorA, doorB)
                                .at(.75, .5, 10)
                                .axis(0, 1, 0)
                                .limits(-1, 1)
                                .spring(0, 1, 1));

        Bed(Random random) {
            world.collisions().exclude(ghostA, ghostB);
            Scenes.run(world, 200 + random.nextInt(20));
            assertTrue(Scenes.allAsleep(dynamic));
        }

        private static Body table(Body body) {
            return body.shape(Box.ofHalfExtents(1, .5, 1));
        }

        private BodyRef box(String name, double x, double y, double z) {
            Body box = Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(x, y, z).name(name);
            dynamic.add(world.add(box));
            return dynamic.get(dynamic.size() - 1);
        }

        TreeSet<String> awake() {
            TreeSet<String> names = new TreeSet<>();
            for (BodyRef body : dynamic) {
                if (body.isAlive() && body.type() == BodyType.DYNAMIC && !body.isAsleep()) {
                    names.add(body.name());
                }
            }
            return names;
        }

        @Override
        public void close() {
            world.close();
        }
    }

    private final TreeMap<String, String> wrong = new TreeMap<>();
    private final Random random = new Random(7);

    /** A deed, and the names of those that are awake one step after it. */
    private void awake(String deed, String expected, Consumer<Bed> does) {
        try (Bed bed = new Bed(random)) {
            does.accept(bed);
            bed.world.step(Scenes.STEP);
            bed.world.validate();
            TreeSet<String> names = new TreeSet<>(List.of(expected.split(" ")));
            names.remove("");
            if (!names.equals(bed.awake())) {
                wrong.put(deed, "awake " + bed.awake() + ", expected " + names);
            }
        }
    }

    private void onStack(String deed, BiConsumer<Bed, BodyRef> does) {
        awake(deed + " of upper", "lower upper", bed -> does.accept(bed, bed.upper));
        awake(deed + " of lower", "lower upper", bed -> does.accept(bed, bed.lower));
    }

    private void onTables(String deed, BiConsumer<Bed, BodyRef> does) {
        awake(deed + " of fixed", "lower upper", bed -> does.accept(bed, bed.fixed));
        awake(deed + " of kinematic", "rider second", bed -> does.accept(bed, bed.kinematic));
    }

    private void nobody(String deed, BiConsumer<Bed, BodyRef> does) {
        awake(deed + " of upper", "", bed -> does.accept(bed, bed.upper));
        nobodyOnTables(deed, does);
    }

    private void nobodyOnTables(String deed, BiConsumer<Bed, BodyRef> does) {
        awake(deed + " of fixed", "", bed -> does.accept(bed, bed.fixed));
        awake(deed + " of kinematic", "", bed -> does.accept(bed, bed.kinematic));
    }

    private double any(double from, double to) {
        return from + (to - from) * random.nextDouble();
    }

    @Test
    void whatABodyIs() {
        onStack("shape", (bed, b) -> b.setShape(Box.cubeOfHalfExtent(any(.4, .6))));
        onTables("shape", (bed, b) -> b.setShape(Box.ofHalfExtents(1, any(.45, .55), 1)));
        onStack("material", (bed, b) -> b.setMaterial(ICE));
        onTables("material", (bed, b) -> b.setMaterial(ICE));
        onStack("mass", (bed, b) -> b.setMass(any(1, 10)));
        onStack("inertia", (bed, b) -> b.setInertia(any(50, 90), 100, 100));
        nobodyOnTables("mass", (bed, b) -> b.setMass(any(1, 10)));
        nobodyOnTables("inertia", (bed, b) -> b.setInertia(any(50, 90), 100, 100));
        onStack("filter", (bed, b) -> b.setFilter(Filter.NOTHING));
        onTables("filter", (bed, b) -> b.setFilter(Filter.NOTHING));
        onTables("type", (bed, b) -> b.setType(BodyType.DYNAMIC));
        awake("fixed to kinematic", "lower upper", bed -> bed.fixed.setType(BodyType.KINEMATIC));
        awake("upper fixed", "lower", bed -> bed.upper.setType(BodyType.FIXED));
        awake("lower kinematic", "upper", bed -> bed.lower.setType(BodyType.KINEMATIC));
        onStack("gravity scale", (bed, b) -> b.setGravityScale(any(.2, .8)));
        onStack("damping", (bed, b) -> b.setDamping(any(.1, 1), any(.1, 1)));
        onStack("speed limit", (bed, b) -> b.setSpeedLimit(any(1, 2)));
        onStack("locks", (bed, b) -> b.setLocks(Lock.MOVE_Y, Lock.TURN_X));
        report();
    }

    @Test
    void itsColliders() {
        Collider knob = Collider.of(Sphere.of(.2)).at(0, .6, 0);
        Collider plate = Collider.of(Box.ofHalfExtents(.5, .1, .5)).at(0, -.4, 0);
        onStack("add", (bed, b) -> b.add(knob));
        onTables("add", (bed, b) -> b.add(knob));
        onStack("remove part", (bed, b) -> b.add(plate).remove());
        onStack("replace", (bed, b) -> b.colliders().get(0).replace(plate));
        onTables("replace", (bed, b) -> b.colliders().get(0).replace(plate));
        onStack("material of part", (bed, b) -> b.colliders().get(0).setMaterial(ICE));
        onTables("material of part", (bed, b) -> b.colliders().get(0).setMaterial(ICE));
        onStack("filter of part", (bed, b) -> b.colliders().get(0).setFilter(Filter.NOTHING));
        onTables("filter of part", (bed, b) -> b.colliders().get(0).setFilter(Filter.NOTHING));
        report();
    }

    @Test
    void itsMotion() {
        onStack("force", (bed, b) -> b.applyForce(any(1, 2), 0, 0));
        onStack("force at", (bed, b) -> b.applyForceAt(0, 0, any(1, 2), 0, 2, 0));
        onStack("torque", (bed, b) -> b.applyTorque(0, any(1, 2), 0));
        onStack("impulse", (bed, b) -> b.applyImpulse(0, 0, any(1e-6, 1)));
        onStack("impulse at", (bed, b) -> b.applyImpulseAt(0, 0, 1e-6, 0, 2, 0));
        onStack("angular impulse", (bed, b) -> b.applyAngularImpulse(0, any(1e-6, 1), 0));
        onStack("velocity", (bed, b) -> b.setVelocity(0, any(1e-3, 1), 0));
        onStack("angular velocity", (bed, b) -> b.setAngularVelocity(0, any(1e-3, 1), 0));
        onStack("teleport", (bed, b) -> b.teleport(any(.01, .1), b.position().y, 0));
        Quaterniond turn = new Quaterniond().rotateY(.1);
        onStack("turn", (bed, b) -> b.teleport(b.position(), turn));
        onTables("teleport", (bed, b) -> b.teleport(new Vector3d(b.position()).sub(0, .01, 0)));
        onStack("a pose that is set", (bed, b) -> pose(bed, b, any(.01, .1)));
        onTables("a pose that is set", (bed, b) -> pose(bed, b, any(-.1, -.01)));
        onStack("a force that is set", (bed, b) -> bed.world.ecs().add(b.entity(), FORCE));
        onStack("a torque that is set", (bed, b) -> bed.world.ecs().add(b.entity(), TORQUE));
        awake("target", "rider second", bed -> bed.kinematic.moveTo(10, .51, 0));
        awake("speed", "rider second", bed -> bed.kinematic.setVelocity(any(.1, 1), 0, 0));
        awake("turning", "rider second", bed -> bed.kinematic.setAngularVelocity(0, .1, 0));
        onStack("remove", (bed, b) -> bed.fixed.remove());
        awake("remove upper", "lower", bed -> bed.upper.remove());
        awake("remove lower", "upper", bed -> bed.lower.remove());
        awake("remove kinematic", "rider second", bed -> bed.kinematic.remove());
        report();
    }

    private static final Force FORCE = new Force(1, 0, 0);
    private static final Torque TORQUE = new Torque(0, 1, 0);

    private static void pose(Bed bed, BodyRef body, double dy) {
        Pose p = bed.world.ecs().get(body.entity(), Pose.COMPONENT);
        Pose moved = new Pose(p.x(), p.y() + dy, p.z(), p.qx(), p.qy(), p.qz(), p.qw(), p.jumps());
        bed.world.ecs().set(body.entity(), moved);
    }

    @Test
    void whomItMeets() {
        onStack("taken apart", (bed, b) -> bed.world.collisions().exclude(bed.lower, bed.upper));
        awake(
                "taken apart from its table",
                "lower upper",
                bed -> bed.world.collisions().exclude(bed.lower, bed.fixed));
        awake(
                "meets again",
                "ghostA ghostB",
                bed -> bed.world.collisions().include(bed.ghostA, bed.ghostB));
        String all = "alone doorA doorB ghostA ghostB lower rider second upper";
        awake(
                "a question that takes apart",
                all,
                bed -> {
                    ColliderRef one = bed.upper.colliders().get(0);
                    bed.world.collisions().setPairFilter((a, b) -> a != one && b != one);
                });
        awake("a hook", all, bed -> bed.world.collisions().setHook(c -> c.disable()));
        awake("gravity", all, bed -> bed.world.setGravity(0, -1.6, 0));
        report();
    }

    @Test
    void itsJoints() {
        String doors = "doorA doorB";
        awake(
                "a joint that comes",
                "alone lower upper",
                bed -> bed.world.add(Joint.rope(bed.alone, bed.upper)));
        awake(
                "a joint to the fixed",
                "alone",
                bed -> bed.world.add(Joint.ball(bed.ground, bed.alone).at(0, .5, -10)));
        awake("off", doors, bed -> bed.hinge.setEnabled(false));
        awake("gone", doors, bed -> bed.hinge.remove());
        awake("moved", doors, bed -> bed.hinge.moveTo(.8, .5, 10));
        awake("motor", doors, bed -> bed.hinge.motor(JointAxis.TWIST, any(.1, 1), 10));
        awake("target", doors, bed -> bed.hinge.target(JointAxis.TWIST, any(.1, 1)));
        awake("spring", doors, bed -> bed.hinge.spring(JointAxis.TWIST, .1, any(1, 2), 1));
        awake("limits", doors, bed -> bed.hinge.limits(JointAxis.TWIST, any(.1, .5), 1));
        awake("breaks", doors, bed -> bed.hinge.breakAt(any(1e-9, 1), 1e9));
        awake("breaks as before", "", bed -> bed.hinge.breakAt(1. / 0, 1. / 0));
        report();
    }

    @Test
    void whatConcernsNobody() {
        nobody("user data", (bed, b) -> b.setUserData("other"));
        nobody("reading", (bed, b) -> b.colliders().get(0).description().shape());
        nobody("the same filter", (bed, b) -> b.setFilter(Filter.ALL));
        nobody("the same type", (bed, b) -> b.setType(b.type()));
        nobody("the same material", (bed, b) -> b.setMaterial(b.material()));
        nobody("the same gravity scale", (bed, b) -> b.setGravityScale(1));
        nobody("the same damping", (bed, b) -> b.setDamping(0, 0));
        nobody("the same limit", (bed, b) -> b.setSpeedLimit(Double.POSITIVE_INFINITY));
        nobody("the same locks", (bed, b) -> b.setLocks());
        awake("no force", "", bed -> bed.upper.applyForce(0, 0, 0));
        awake("no torque", "", bed -> bed.upper.applyTorque(0, 0, 0));
        awake("no impulse", "", bed -> bed.upper.applyImpulse(0, 0, 0));
        awake("no velocity", "", bed -> bed.upper.setVelocity(0, 0, 0));
        awake("no velocity of a table", "", bed -> bed.kinematic.setVelocity(0, 0, 0));
        awake("the pose that it has", "", bed -> bed.kinematic.moveTo(10, .5, 0));
        nobodyOnTables("gravity scale", (bed, b) -> b.setGravityScale(any(.2, .8)));
        nobodyOnTables("damping", (bed, b) -> b.setDamping(any(.1, 1), any(.1, 1)));
        nobodyOnTables("speed limit", (bed, b) -> b.setSpeedLimit(any(1, 2)));
        nobodyOnTables("locks", (bed, b) -> b.setLocks(Lock.MOVE_Y));
        awake(
                "a body far away",
                "",
                bed -> bed.world.add(Body.fixed().shape(Sphere.of(1)).at(5, 5, 5)));
        awake("the same gravity", "", bed -> bed.world.setGravity(0, -9.81, 0));
        awake("the same hook", "", bed -> bed.world.collisions().setHook(null));
        report();
    }

    private void report() {
        assertEquals(new TreeMap<>(), wrong);
    }
}
