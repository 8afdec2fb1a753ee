package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Nobody passes a wall: any shape, turned and spinning anyhow, at 10 to 1e5 m/s, against walls of 1
 * to 300 mm that are fixed, driven, or free and heavy; bouncing or not, rough or not.
 */
class WallTest {
    private static final double HEAVY = 1e6;

    @Test
    void nothingPassesAWall() {
        search(1, 400);
    }

    @Test
    @Tag("soak")
    void nothingPassesAWallForLong() {
        search(1_000_000, 100_000);
    }

    /** A free wall turns when it is struck; so it is asked in its own frame, within its edges. */
    @Test
    void nothingPassesAFreeWallThatTurns() {
        searchFree(300);
    }

    @Test
    @Tag("soak")
    void nothingPassesAFreeWallThatTurnsForLong() {
        searchFree(800);
    }

    private static void searchFree(int runs) {
        List<Long> passed = new ArrayList<>();
        for (long seed = 1; seed <= runs; seed++) {
            if (passesFree(new SplittableRandom(seed * 0x9E3779B97F4A7C15L))) {
                passed.add(seed);
            }
        }
        assertTrue(passed.isEmpty(), "passed, by seed: " + passed);
    }

    private static boolean passesFree(SplittableRandom random) {
        Shape shape = shape(random);
        double speed = StrictMath.pow(10, 1 + 3 * random.nextDouble());
        double thick = StrictMath.pow(10, -3 + 2 * random.nextDouble());
        double ratio = StrictMath.pow(10, 3 * random.nextDouble());
        double restitution = random.nextBoolean() ? random.nextDouble() : 0;
        Material surface = new Material(random.nextDouble(), restitution, 1000);
        double half = 5;
        try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, 0, 0).build()) {
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .shape(shape)
                                    .at(-2 - random.nextDouble() * speed / 60, 0, 0)
                                    .rotation(Scenes.turn(random))
                                    .velocity(speed, 0, 0)
                                    .material(surface));
            BodyRef wall =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(thick / 2, half, half))
                                    .mass(ratio * body.mass())
                                    .at(
                                            0,
                                            half * (random.nextDouble() - 0.5),
                                            half * (random.nextDouble() - 0.5))
                                    .material(surface));
            Vector3d before = seenFrom(wall, body);
            for (int tick = 0; tick < 6 + 240 / speed; tick++) {
                world.step(Scenes.STEP);
                Vector3d now = seenFrom(wall, body);
                double edge = Math.max(Math.abs(now.y), Math.abs(now.z));
                edge = Math.max(edge, Math.max(Math.abs(before.y), Math.abs(before.z)));
                boolean isTold = Scenes.STEP * wall.angularVelocity().length() < 0.5;
                if (edge > 0.9 * half || !isTold) {
                    return false;
                }
                if (!(now.x <= 0)) {
                    return true;
                }
                before = now;
            }
            return false;
        }
    }

    private static Vector3d seenFrom(BodyRef wall, BodyRef body) {
        return wall.orientation().transformInverse(body.position().sub(wall.position()));
    }

    private static void search(long first, int runs) {
        int passed = 0;
        double momentum = 0;
        StringBuilder who = new StringBuilder();
        for (long seed = first; seed < first + runs; seed++) {
            double off = run(new SplittableRandom(seed * 0x9E3779B97F4A7C15L));
            if (Double.isNaN(off)) {
                passed++;
                who.append(' ').append(seed);
            } else {
                momentum = Math.max(momentum, off);
            }
        }
        assertEquals(0, passed, "of " + runs + " passed, seeds" + who);
        assertTrue(momentum < 1e-12, "momentum against a free wall is off by " + momentum);
    }

    /** By how much momentum along x is off, as a share; NaN if the body is behind the wall. */
    private static double run(SplittableRandom random) {
        int kind = random.nextInt(3);
        double restitution = random.nextBoolean() ? random.nextDouble() : 0;
        Shape shape = shape(random);
        double speed = StrictMath.pow(10, 1 + 4 * random.nextDouble());
        double thick = StrictMath.pow(10, -3 + 2.5 * random.nextDouble());
        double spin = random.nextInt(3) == 0 ? 0 : StrictMath.pow(10, 6 * random.nextDouble());
        double drive =
                kind == 0
                        ? 0
                        : 2
                                * (random.nextDouble() - 0.5)
                                * StrictMath.pow(10, 2 * random.nextDouble());
        double friction = random.nextDouble() < 0.3 ? 0 : random.nextDouble();
        Material surface = new Material(friction, restitution, 1000);
        double tilt = random.nextBoolean() ? 0 : 1.2 * (random.nextDouble() - 0.5);
        double slant = random.nextBoolean() ? 0 : random.nextDouble() - 0.5;
        double gravity = random.nextBoolean() ? -9.81 : 0;
        try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, gravity, 0).build()) {
            Body plan = kind == 0 ? Body.fixed() : kind == 1 ? Body.kinematic() : Body.dynamic();
            plan.shape(Box.ofHalfExtents(thick / 2, 50, 50))
                    .rotationAbout(0, 0, 1, tilt)
                    .material(surface);
            if (kind > 0) {
                plan.velocity(drive, 0, 0);
            }
            if (kind == 2) {
                plan.mass(HEAVY).gravityScale(0);
            }
            BodyRef wall = world.add(plan);
            double far = 2 + random.nextDouble() * Math.max(speed, Math.abs(drive)) / 60;
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .shape(shape)
                                    .at(-far, 0.3 - slant * far, 0.2)
                                    .rotationAbout(
                                            random.nextDouble() - 0.5,
                                            random.nextDouble() - 0.5,
                                            random.nextDouble() - 0.5,
                                            6 * random.nextDouble())
                                    .angularVelocity(
                                            spin * (random.nextDouble() - 0.5),
                                            spin * (random.nextDouble() - 0.5),
                                            spin * (random.nextDouble() - 0.5))
                                    .velocity(speed, slant * speed, 0)
                                    .material(surface));
            double mass = body.mass();
            double start = mass * speed + HEAVY * drive;
            int ticks = (int) (6 + 240 / speed);
            for (int tick = 0; tick < ticks; tick++) {
                world.step(Scenes.STEP);
                Vector3d at = body.position().sub(wall.position());
                wall.orientation().conjugate(new Quaterniond()).transform(at);
                if (Math.abs(at.y) > 49 || Math.abs(at.z) > 49) {
                    break;
                }
                if (!(at.x <= 0)) {
                    return Double.NaN;
                }
            }
            double now = mass * body.velocity().x + HEAVY * wall.velocity().x;
            double all = mass * speed + HEAVY * Math.abs(drive);
            return kind == 2 ? Math.abs(now - start) / all : 0;
        }
    }

    private static Shape shape(SplittableRandom random) {
        double half = 0.5 * StrictMath.pow(10, -2 + 2 * random.nextDouble());
        double thin = half * StrictMath.pow(10, -1.5 * random.nextDouble());
        switch (random.nextInt(8)) {
            case 0:
                return Sphere.of(half);
            case 1:
                return Box.ofHalfExtents(half, thin, thin);
            case 2:
                return Box.ofHalfExtents(half, half, thin);
            case 3:
                return Box.ofHalfExtents(
                        half,
                        half * (0.3 + 0.7 * random.nextDouble()),
                        half * (0.3 + 0.7 * random.nextDouble()));
            case 4:
                return Capsule.of(thin, half);
            case 5:
                return Cylinder.of(thin, half);
            case 6:
                return Cylinder.of(half, thin);
            default:
                double[] points = new double[36];
                for (int i = 0; i < 36; i += 3) {
                    points[i] = 2 * half * (random.nextDouble() - 0.5);
                    points[i + 1] = 2 * half * (random.nextDouble() - 0.5);
                    points[i + 2] = 2 * thin * (random.nextDouble() - 0.5);
                }
                return aboutItsCentre(points);
        }
    }

    /** A hull whose origin is its centre of mass, which is what may not be behind the wall. */
    private static Shape aboutItsCentre(double[] points) {
        MassProperties mass = ConvexHull.of(points).massProperties(1);
        for (int i = 0; i < points.length; i += 3) {
            points[i] -= mass.comX();
            points[i + 1] -= mass.comY();
            points[i + 2] -= mass.comZ();
        }
        return ConvexHull.of(points);
    }
}
