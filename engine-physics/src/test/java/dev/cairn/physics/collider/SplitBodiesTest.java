package dev.cairn.physics.collider;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;

/**
 * A body of parts that make a box moves as the body of the box: whatever the number of parts and
 * the planes by which the box was cut, at rest, in towers, and when it lands on an edge or a
 * corner.
 */
class SplitBodiesTest {
    private static final long SEED = 25;
    private static final int TICKS = 150;

    /** What may differ: rounding, of heights up to 8 m. */
    private static final double ROUNDING = 1e-12;

    /** Half extents of a box that is neither flat nor a rod. */
    private static double[] size(Random random) {
        return new double[] {
            .3 + .7 * random.nextDouble(),
            .2 + .4 * random.nextDouble(),
            .3 + .5 * random.nextDouble()
        };
    }

    /** Cuts a hull in two, at a plane through a point inside. */
    private static List<ConvexHull> cut(ConvexHull hull, Vector3d normal, Vector3d at) {
        double[] v = hull.vertices();
        List<Vector3d> above = new ArrayList<>();
        List<Vector3d> below = new ArrayList<>();
        for (int[] loop : hull.faceLoops()) {
            for (int i = 0; i < loop.length; i++) {
                Vector3d a = corner(v, loop[i]);
                Vector3d b = corner(v, loop[(i + 1) % loop.length]);
                double da = new Vector3d(a).sub(at).dot(normal);
                double db = new Vector3d(b).sub(at).dot(normal);
                (da >= 0 ? above : below).add(a);
                if (da >= 0 != db >= 0) {
                    Vector3d p = a.lerp(b, da / (da - db), new Vector3d());
                    above.add(p);
                    below.add(p);
                }
            }
        }
        return List.of(ConvexHull.of(above), ConvexHull.of(below));
    }

    private static Vector3d corner(double[] v, int i) {
        return new Vector3d(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
    }

    private static void cutByPlanes(ConvexHull hull, int parts, Random random, Body body) {
        if (parts == 1) {
            body.collider(Collider.of(hull));
            return;
        }
        Vector3d normal =
                new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                        .normalize();
        List<ConvexHull> two = cut(hull, normal, hull.centreOfMass(new Vector3d()));
        int first = 1 + random.nextInt(parts - 1);
        cutByPlanes(two.get(0), first, random, body);
        cutByPlanes(two.get(1), parts - first, random, body);
    }

    /** Boxes, each turned so that its axes are named anyhow. */
    private static void cutAlong(double[] lo, double[] hi, int parts, Random random, Body body) {
        if (parts == 1) {
            double[] half = new double[3];
            double[] centre = new double[3];
            for (int k = 0; k < 3; k++) {
                half[k] = (hi[k] - lo[k]) / 2;
                centre[k] = (hi[k] + lo[k]) / 2;
            }
            boolean turned = random.nextBoolean();
            Quaterniond quarter = new Quaterniond().rotateY(turned ? Math.PI / 2 : 0);
            Box box =
                    turned
                            ? Box.ofHalfExtents(half[2], half[1], half[0])
                            : Box.ofHalfExtents(half[0], half[1], half[2]);
            body.collider(Collider.of(box).at(centre[0], centre[1], centre[2]).rotation(quarter));
            return;
        }
        int axis = random.nextInt(3);
        double at = lo[axis] + (.2 + .6 * random.nextDouble()) * (hi[axis] - lo[axis]);
        double[] middleHigh = hi.clone();
        double[] middleLow = lo.clone();
        middleHigh[axis] = at;
        middleLow[axis] = at;
        int first = 1 + random.nextInt(parts - 1);
        cutAlong(lo, middleHigh, first, random, body);
        cutAlong(middleLow, hi, parts - first, random, body);
    }

    /** The five bricks of a pinwheel: no two of them make a box. */
    private static void pinwheel(double[] h, Body body) {
        double[][] bricks = {
            {-1, -1, .2, -.4},
            {.2, -1, 1, .3},
            {-.5, .3, 1, 1},
            {-1, -.4, -.5, 1},
            {-.5, -.4, .2, .3}
        };
        for (double[] b : bricks) {
            body.collider(
                    Collider.of(
                                    Box.ofHalfExtents(
                                            h[0] * (b[2] - b[0]) / 2,
                                            h[1],
                                            h[2] * (b[3] - b[1]) / 2))
                            .at(h[0] * (b[0] + b[2]) / 2, 0, h[2] * (b[1] + b[3]) / 2));
        }
    }

    private static Body brick(String cut, double[] h, Random random) {
        Body body = Body.dynamic();
        int parts = 2 + random.nextInt(11);
        switch (cut) {
            case "whole" -> body.shape(Box.ofHalfExtents(h[0], h[1], h[2]));
            case "planes" ->
                    cutByPlanes(ConvexHull.of(corners(h)), 2 + random.nextInt(5), random, body);
            case "pinwheel" -> pinwheel(h, body);
            default -> cutAlong(new double[] {-h[0], -h[1], -h[2]}, h.clone(), parts, random, body);
        }
        return body;
    }

    private static double[] corners(double[] h) {
        double[] corners = new double[24];
        for (int i = 0; i < 24; i++) {
            corners[i] = (i / 3 >> i % 3 & 1) == 0 ? h[i % 3] : -h[i % 3];
        }
        return corners;
    }

    private static Quaterniond anyTurn(Random random) {
        return new Quaterniond(
                        random.nextGaussian(),
                        random.nextGaussian(),
                        random.nextGaussian(),
                        random.nextGaussian())
                .normalize();
    }

    private static void build(PhysicsWorld world, String scene, String cut, long seed) {
        Random random = new Random(seed);
        Random cuts = new Random(seed + 1);
        double[] h = size(random);
        if (scene.equals("tiles")) {
            for (int i = 0; i < 64; i++) {
                world.add(
                        Body.fixed()
                                .shape(Box.ofHalfExtents(.45, .5, .45))
                                .at(.9 * (i % 8) - 2.5, -.5, .9 * (i / 8) - 3.1));
            }
        } else {
            world.add(Body.fixed().shape(HalfSpace.of()));
        }
        switch (scene) {
            case "tower", "falls" -> {
                double gap = scene.equals("falls") ? .2 : 0;
                int storeys = 2 + random.nextInt(9);
                for (int i = 0; i < storeys; i++) {
                    double x = .02 * random.nextGaussian();
                    world.add(brick(cut, h, cuts).at(x, h[1] * (2 * i + 1) + gap * (i + 1), 0));
                }
            }
            case "corner" ->
                    world.add(
                            brick(cut, h, cuts)
                                    .at(0, 2, 0)
                                    .rotation(anyTurn(random))
                                    .velocity(random.nextGaussian(), 0, 0)
                                    .angularVelocity(0, random.nextGaussian(), 1));
            default ->
                    world.add(
                            brick(cut, h, cuts)
                                    .at(0, h[1], 0)
                                    .velocity(3, 0, 1)
                                    .angularVelocity(0, 2, 0));
        }
    }

    private static double[] run(String scene, String cut, long seed) {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            build(world, scene, cut, seed);
            List<Double> path = new ArrayList<>();
            for (int t = 0; t < TICKS; t++) {
                world.step(Scenes.STEP);
                for (BodyRef body : world.bodies()) {
                    Vector3d p = body.position();
                    Quaterniond q = body.orientation();
                    path.addAll(List.of(p.x, p.y, p.z, q.x, q.y, q.z, q.w));
                }
            }
            world.validate();
            return path.stream().mapToDouble(d -> d).toArray();
        }
    }

    @ParameterizedTest
    @CsvSource({
        "tower, boxes",
        "falls, boxes",
        "corner, boxes",
        "slides, boxes",
        "tiles, boxes",
        "tower, planes",
        "falls, planes",
        "corner, planes",
        "tiles, planes",
        "tower, pinwheel",
        "corner, pinwheel"
    })
    void partsMoveAsTheBoxThatTheyMake(String scene, String cut) {
        for (int i = 0; i < 4; i++) {
            double[] whole = run(scene, "whole", SEED + 10 * i);
            double[] parts = run(scene, cut, SEED + 10 * i);
            double most = 0;
            for (int k = 0; k < whole.length; k++) {
                most = Math.max(most, Math.abs(whole[k] - parts[k]));
            }
            assertEquals(0, most, ROUNDING, scene + " of " + cut + ", seed " + (SEED + 10 * i));
        }
    }

    /** Of parts with two frictions none stands for all; of parts that a filter parts neither. */
    @Test
    void partsThatAreNotAlikeAreSolvedAsTheyAre() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            Body body = Body.dynamic();
            cutAlong(new double[] {-1, -.3, -.5}, new double[] {1, .3, .5}, 6, new Random(3), body);
            BodyRef brick = world.add(body.at(0, .3, 0));
            for (int round = 0; round < 4; round++) {
                ColliderRef part = brick.colliders().get(round);
                if (round % 2 == 0) {
                    part.setMaterial(Material.ICE);
                } else {
                    part.remove();
                }
                for (int t = 0; t < 30; t++) {
                    world.step(Scenes.STEP);
                    world.validate();
                }
                brick.setMaterial(Material.WOOD);
                for (int t = 0; t < 30; t++) {
                    world.step(Scenes.STEP);
                    world.validate();
                }
                double impulse = 0;
                Contacts contacts = world.contacts();
                for (int c = 0; c < contacts.count(); c++) {
                    assertTrue(contacts.colliderB(c).isAlive() && contacts.colliderA(c).isAlive());
                    for (int p = 0; p < contacts.pointCount(c); p++) {
                        impulse += contacts.normalImpulse(c, p);
                    }
                }
                assertEquals(brick.mass() * 9.81 * Scenes.STEP, impulse, .05 * impulse);
            }
        }
    }

    @Tag("compiled")
    @Test
    void theSameBitsForWorkersAndLanes() {
        Set<Long> digests = new HashSet<>();
        for (int workers = 1; workers <= 2; workers++) {
            for (int lanes : new int[] {1, 8}) {
                try (PhysicsWorld world =
                        Scenes.awake()
                                .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                                .workers(workers)
                                .build()) {
                    world.add(Body.fixed().shape(HalfSpace.of()));
                    Random random = new Random(SEED);
                    String[] cuts = {"boxes", "planes", "pinwheel", "whole"};
                    for (int i = 0; i < 24; i++) {
                        world.add(
                                brick(cuts[i % 4], size(random), random)
                                        .at(i % 3 * .2, .5 + 1.3 * i, i % 4 * .1)
                                        .rotation(anyTurn(random)));
                    }
                    for (int t = 0; t < 60; t++) {
                        world.step(Scenes.STEP);
                    }
                    world.validate();
                    digests.add(world.digest());
                }
            }
        }
        assertEquals(1, digests.size());
    }
}
