package dev.cairn.physics.support;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.PhysicsWorldBuilder;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;

/** Scenes for tests of the pipeline. */
public final class Scenes {
    public static final double STEP = 1.0 / 60.0;

    /** Of a card of a house, to the vertical. */
    private static final double LEAN = StrictMath.toRadians(25);

    private Scenes() {}

    /** A world to be, in which nothing sleeps: truths are stated of bodies that are awake. */
    public static PhysicsWorldBuilder awake() {
        return PhysicsWorld.builder().sleeping(false);
    }

    /**
     * Plays a scene with one and two workers and with 1, 4 and 8 lanes, nothing sleeping: all end
     * in the same bits, and each in a world whose data agree.
     *
     * @param scene fills a world and steps it
     */
    public static void assertSameBits(Consumer<PhysicsWorld> scene) {
        Set<Long> digests = new HashSet<>();
        int[] lanes = {1, 4, 8};
        for (int workers = 1; workers <= lanes.length; workers++) {
            PhysicsSettings settings =
                    PhysicsSettings.DEFAULT.withSleeping(false).withLanes(lanes[workers - 1]);
            try (PhysicsWorld world =
                    PhysicsWorld.builder().settings(settings).workers(workers).build()) {
                scene.accept(world);
                world.validate();
                digests.add(world.digest());
            }
        }
        assertEquals(1, digests.size());
    }

    public static BodyRef ground(PhysicsWorld world) {
        return world.add(
                Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0).name("ground"));
    }

    public static List<BodyRef> stack(PhysicsWorld world, int height) {
        ground(world);
        List<BodyRef> boxes = new ArrayList<>();
        for (int i = 0; i < height; i++) {
            boxes.add(world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.5 + i, 0)));
        }
        return boxes;
    }

    /** One shape of each kind, half a metre or so; and one that is moved within its body. */
    public static Shape[] kinds() {
        return new Shape[] {
            Sphere.of(.3),
            Capsule.of(.25, .3),
            Cylinder.of(.35, .3),
            Cone.of(.4, .35),
            Box.ofHalfExtents(.35, .25, .3),
            ConvexHull.of(
                    new double[] {
                        .4, 0, 0, -.4, 0, 0, 0, .4, 0, 0, -.4, 0, 0, 0, .4, 0, 0, -.4, .3, .3, .3
                    }),
            Cylinder.of(.2, .3).moved(0, .1, 0, new Quaterniond().rotationZ(1.2)),
        };
    }

    /** On a half-space, each kind below each kind: all pairs of kinds there are. */
    public static void everyKindOnEveryKind(PhysicsWorld world) {
        world.add(Body.fixed().shape(HalfSpace.of()).name("HalfSpace"));
        Shape[] kinds = kinds();
        Random random = new Random(5);
        for (int i = 0; i < kinds.length; i++) {
            for (int j = 0; j < kinds.length; j++) {
                world.add(Body.dynamic().shape(kinds[i]).at(1.6 * i, .7, 1.6 * j));
                world.add(
                        Body.dynamic()
                                .shape(kinds[j])
                                .at(1.6 * i + .05, 1.7, 1.6 * j)
                                .rotationAbout(1, random.nextDouble(), 0, random.nextDouble()));
            }
        }
    }

    /** A heap of boxes, balls and hulls that falls on the ground. */
    public static void drop(PhysicsWorld world, int bodies, long seed) {
        ground(world);
        Random random = new Random(seed);
        for (int i = 0; i < bodies; i++) {
            world.add(any(random, i));
        }
    }

    public static Body any(Random random, int i) {
        Shape shape =
                switch (i % 3) {
                    case 0 -> Box.ofHalfExtents(0.2 + 0.3 * random.nextDouble(), 0.3, 0.25);
                    case 1 -> Sphere.of(0.2 + 0.2 * random.nextDouble());
                    default ->
                            ConvexHull.of(
                                    new double[] {
                                        0.4, 0, 0, -0.4, 0, 0, 0, 0.4, 0, 0, -0.4, 0, 0, 0, 0.4, 0,
                                        0, -0.4
                                    });
                };
        return Body.dynamic()
                .shape(shape)
                .at(3 * random.nextDouble(), 1 + 6 * random.nextDouble(), 3 * random.nextDouble())
                .rotationAbout(1, random.nextDouble(), random.nextDouble(), 6 * random.nextDouble())
                .velocity(0, -4 * random.nextDouble(), 0)
                .angularVelocity(random.nextDouble(), random.nextDouble(), 0)
                .material(Material.WOOD);
    }

    /** Two cards of 2 mm that lean against each other, and one on two such peaks. */
    public static void cards(PhysicsWorld world, int tents) {
        double half = .2;
        double thin = .001;
        double wide = half * StrictMath.sin(LEAN) + thin * StrictMath.cos(LEAN);
        double high = half * StrictMath.cos(LEAN) + thin * StrictMath.sin(LEAN);
        double pitch = 4 * wide + .002;
        Material rough = new Material(.7, 0, 1000);
        for (int i = 0; i < tents; i++) {
            for (int side = -1; side <= 1; side += 2) {
                world.add(
                        Body.dynamic()
                                .shape(Box.ofHalfExtents(thin, half, .1))
                                .at(10 + pitch * i + side * wide, high, 0)
                                .rotationAbout(0, 0, 1, side * LEAN)
                                .material(rough));
            }
            if (i > 0) {
                world.add(
                        Body.dynamic()
                                .shape(Box.ofHalfExtents(.5 * pitch - .0005, thin, .1))
                                .at(10 + pitch * (i - .5), 2 * high + thin, 0)
                                .material(rough));
            }
        }
    }

    public static double[] places(List<BodyRef> bodies) {
        double[] all = new double[3 * bodies.size()];
        for (int i = 0; i < bodies.size(); i++) {
            Vector3d at = bodies.get(i).position();
            all[3 * i] = at.x;
            all[3 * i + 1] = at.y;
            all[3 * i + 2] = at.z;
        }
        return all;
    }

    /** From three tenths of a size to all of it. */
    public static double part(double size, RandomGenerator random) {
        return size * (.3 + .7 * random.nextDouble());
    }

    /** Any orientation: a unit quaternion, evenly over all. */
    public static Quaterniond turn(RandomGenerator random) {
        while (true) {
            double x = 2 * random.nextDouble() - 1;
            double y = 2 * random.nextDouble() - 1;
            double z = 2 * random.nextDouble() - 1;
            double w = 2 * random.nextDouble() - 1;
            double square = x * x + y * y + z * z + w * w;
            if (square > 0.01 && square <= 1) {
                double unit = 1 / Math.sqrt(square);
                return new Quaterniond(x * unit, y * unit, z * unit, w * unit);
            }
        }
    }

    /** Neighbouring seeds give like numbers at first. */
    public static Random random(long seed) {
        Random random = new Random(seed * 0x9E3779B97F4A7C15L);
        random.nextLong();
        return random;
    }

    public static void run(PhysicsWorld world, int ticks) {
        for (int tick = 0; tick < ticks; tick++) {
            world.step(STEP);
        }
    }

    public static boolean allAsleep(List<BodyRef> bodies) {
        return bodies.stream().allMatch(BodyRef::isAsleep);
    }

    /** Unit cubes, 1 mm and 10 mrad untidy. */
    public static List<BodyRef> column(PhysicsWorld world, int height, double x) {
        Random random = new Random(20261123);
        List<BodyRef> boxes = new ArrayList<>();
        for (int i = 0; i < height; i++) {
            boxes.add(
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(.5))
                                    .at(
                                            x + .002 * random.nextDouble() - .001,
                                            .5 + i,
                                            .002 * random.nextDouble() - .001)
                                    .rotationAbout(0, 1, 0, .02 * random.nextDouble() - .01)));
        }
        return boxes;
    }
}
