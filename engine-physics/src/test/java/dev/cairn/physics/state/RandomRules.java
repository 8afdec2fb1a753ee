package dev.cairn.physics.state;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.collider.ContactHook;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;

/** What {@link RandomUser} does now and then: rules of who meets whom, grounds, belts, joints. */
final class RandomRules {
    /** How many kinds of change there are. */
    static final int KINDS = 12;

    private static final JointAxis[] AXES = JointAxis.values();

    private final PhysicsWorld world;

    /** Pairs of bodies, each as often as it was taken apart. */
    private final List<Set<BodyRef>> excluded = new ArrayList<>();

    private final long seed;

    RandomRules(PhysicsWorld world, long seed) {
        this.world = world;
        this.seed = seed;
        begin();
    }

    /** Whether rules, other than filters and joints, keep two bodies from meeting. */
    boolean excludes(BodyRef a, BodyRef b) {
        return excluded.contains(Set.of(a, b)) || (seed % 7 == 0 && !mayMeet(a, b));
    }

    private static boolean mayMeet(BodyRef a, BodyRef b) {
        return (a.entity() + b.entity()) % 5 != 0;
    }

    /** Rules that no saved state holds: what a world of this seed has from the start. */
    private void begin() {
        if (seed % 5 == 0) {
            world.collisions().setHook(RandomRules::look);
        }
        if (seed % 7 == 0) {
            world.collisions().setPairFilter((a, b) -> mayMeet(a.body(), b.body()));
        }
    }

    /** One-way from below, and slippery when it has been met often. */
    private static void look(ContactHook.Change contact) {
        if (contact.normalY() < -0.95 && contact.approachSpeed() > 1) {
            contact.disable();
        } else if (contact.friction() > 0.5) {
            contact.surface(0.1, 0.3);
        }
    }

    /** A change of a kind; what was done. */
    String change(int kind, SplittableRandom random, BodyRef body) {
        List<BodyRef> bodies = world.bodies();
        BodyRef other = bodies.get(random.nextInt(bodies.size()));
        List<ColliderRef> colliders = body.colliders();
        ColliderRef collider = colliders.get(random.nextInt(colliders.size()));
        switch (kind) {
            case 0 -> {
                world.collisions().exclude(body, other);
                excluded.add(Set.of(body, other));
            }
            case 1 -> {
                world.collisions().include(body, other);
                excluded.remove(Set.of(body, other));
            }
            case 2 -> collider.setFilter(filter(random));
            case 3 -> {
                Collider belt = Collider.of(Box.ofHalfExtents(0.6, 0.1, 0.6));
                body.add(belt.surfaceVelocity(random.nextDouble(-3, 3), 0, 1));
            }
            case 4 -> bodies.get(0).colliders().get(0).replace(Collider.of(ground(random)));
            case 5 -> {
                if (collider.shape() instanceof HeightField field) {
                    double[] heights = new double[4];
                    Arrays.setAll(heights, i -> random.nextDouble(-0.5, 0.5));
                    int at = random.nextInt(field.samplesX() - 2);
                    collider.replace(Collider.of(field.withHeights(at, at, 2, heights)));
                }
            }
            case 6 -> body.setMaterial(new Material(0.5, 0.1, 1000).withRollingArm(0.02));
            case 7 -> {
                for (int i = 0; i < 3 && bodies.size() < 20; i++) {
                    world.add(Body.dynamic().shape(Sphere.of(0.2)).at(1, 2, 1));
                }
            }
            case 8 -> body.setMass(Math.pow(10, random.nextDouble(-3, 5)));
            case 9 -> retune(random);
            case 10 -> joint(random, body, other);
            default -> {
                Shape shape = Box.ofHalfExtents(0.3, 0.2, random.nextDouble(0.01, 0.4));
                Quaterniond turn = new Quaterniond().rotationX(random.nextDouble(3));
                collider.replace(Collider.of(shape.moved(0.2, 0, 0, turn)));
            }
        }
        return " rule " + kind + " with " + bodies.indexOf(other) + ";";
    }

    private static Filter filter(SplittableRandom random) {
        Filter some = new Filter(1L << random.nextInt(3), random.nextInt(8));
        return switch (random.nextInt(4)) {
            case 0 -> some;
            case 1 -> some.alwaysWith(1 + random.nextInt(2));
            case 2 -> some.neverWith(1 + random.nextInt(2));
            default -> Filter.ALL;
        };
    }

    private static Shape ground(SplittableRandom random) {
        int n = 12;
        double[] heights = new double[n * n];
        Arrays.setAll(heights, i -> random.nextDouble(0.3));
        HeightField field = HeightField.of(n, n, 1, 1, heights);
        return switch (random.nextInt(4)) {
            case 0 -> HalfSpace.of();
            case 1 -> Box.ofHalfExtents(20, 1, 20);
            case 2 -> field;
            default -> field.toMesh();
        };
    }

    private void retune(SplittableRandom random) {
        List<JointRef> joints = world.joints().all();
        if (joints.isEmpty()) {
            return;
        }
        JointRef joint = joints.get(random.nextInt(joints.size()));
        JointAxis axis = AXES[random.nextInt(AXES.length)];
        switch (random.nextInt(4)) {
            case 0 -> joint.limits(axis, -random.nextDouble(), random.nextDouble());
            case 1 -> joint.spring(axis, random.nextDouble(), 3, 0.2);
            case 2 -> joint.target(axis, random.nextDouble());
            default -> joint.motorOff(axis);
        }
    }

    private void joint(SplittableRandom random, BodyRef a, BodyRef b) {
        Vector3d at = a.position(new Vector3d());
        double x = at.x;
        double y = at.y;
        double z = at.z;
        Joint joint =
                switch (random.nextInt(6)) {
                    case 0 -> Joint.wheel(a, b, 4, 0.7).at(at);
                    case 1 -> Joint.pull(a, b, 5, 1, 1000).at(at);
                    case 2 -> Joint.generic(a, b).at(at).locked(AXES[random.nextInt(6)]);
                    case 3 -> Joint.gear(a, b, 10, 20).at(at);
                    case 4 -> Joint.pulley(a, b, new Vector3d(x, 6, z), new Vector3d(0, 6, 0), 2);
                    default -> Joint.path(a, b, false, x, y, z, x + 1, y, z, x + 2, y + 1, z);
                };
        world.add(joint.collide(random.nextBoolean()));
    }
}
