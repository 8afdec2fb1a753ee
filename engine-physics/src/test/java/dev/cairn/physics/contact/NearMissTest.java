package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/**
 * F7 for any shape: what passes over something at a clearance of 1e-9 to 0.1 of its size, at 0.5 to
 * 1e4 m/s, moves as if nothing were there: its velocity to the bit, its spin to rounding.
 */
class NearMissTest {
    private static final double[] FLAT = new double[25];

    /**
     * Of a size: a face of triangles goes on beyond its edge by half of it, by which points are on
     * planes.
     */
    private static final double LEAST = 2e-5;

    @Test
    void whatPassesIsNotDeflected() {
        search(1, 150, false);
    }

    /** A box of twelve triangles, or a height field: edges deflected a third of what passed. */
    @Test
    void whatPassesTrianglesIsNotDeflected() {
        search(1, 150, true);
    }

    @Test
    @Tag("soak")
    void whatPassesIsNotDeflectedForLong() {
        search(1_000_000, 10_000, false);
        search(1_000_000, 10_000, true);
    }

    private static void search(long first, int runs, boolean triangles) {
        StringBuilder who = new StringBuilder();
        for (long seed = first; seed < first + runs; seed++) {
            if (isDeflected(seed, triangles)) {
                who.append(' ').append(seed);
            }
        }
        assertEquals("", who.toString(), "deflected, by seed");
    }

    private static boolean isDeflected(long seed, boolean triangles) {
        SplittableRandom random = new SplittableRandom(seed * 0x9E3779B97F4A7C15L);
        double half = 0.5 * StrictMath.pow(10, -2 + 2 * random.nextDouble());
        Shape shape = shape(random, half);
        Quaterniond turn = Scenes.turn(random);
        double speed = StrictMath.pow(10, -0.3 + 4.3 * random.nextDouble());
        double spin = random.nextBoolean() ? 0 : StrictMath.pow(10, 2 * random.nextDouble());
        double clearance = half * StrictMath.pow(10, -9 + 8 * random.nextDouble());
        clearance = triangles ? Math.max(clearance, LEAST * half) : clearance;
        // who turns is met by none outside of the ball around it
        double height = clearance + (spin > 0 ? shape.outerRadius() : below(shape, turn));
        Body plan =
                Body.dynamic()
                        .shape(shape)
                        .at(-0.5 - 3 * half - random.nextDouble() * speed / 40, height, 0.05)
                        .rotation(turn)
                        .velocity(speed, 0, 0.05 * speed)
                        .angularVelocity(
                                spin * (random.nextDouble() - 0.5),
                                spin * (random.nextDouble() - 0.5),
                                spin * (random.nextDouble() - 0.5));
        Shape below =
                switch (random.nextInt(3)) {
                    case 0 -> Box.ofHalfExtents(0.5, 0.5, 0.5);
                    case 1 -> Cylinder.of(0.4, 0.5);
                    default -> Sphere.of(0.5);
                };
        boolean isTiled = random.nextInt(4) == 0 && !triangles;
        Shape surface = random.nextBoolean() ? block() : HeightField.of(5, 5, .25, .25, FLAT);
        Vector3d[] moved = new Vector3d[4];
        for (int with = 0; with < 2; with++) {
            try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, 0, 0).build()) {
                for (int i = 0; with > 0 && i < (isTiled ? 4 : 1); i++) {
                    world.add(
                            isTiled
                                    ? Body.fixed()
                                            .shape(Box.ofHalfExtents(0.125, 0.1, 0.5))
                                            .at(0.25 * i - 0.375, -0.1, 0)
                                    : triangles
                                            ? Body.fixed().shape(surface).at(-.5, 0, -.5)
                                            : Body.fixed().shape(below).at(0, -0.5, 0));
                }
                BodyRef body = world.add(plan);
                for (int tick = 0; tick < Math.min(40 + 120 / speed, 250); tick++) {
                    world.step(Scenes.STEP);
                }
                moved[2 * with] = body.velocity();
                moved[2 * with + 1] = body.angularVelocity();
            }
        }
        double turned = moved[1].distance(moved[3]);
        return moved[0].distance(moved[2]) != 0 || turned > 1e-9 * (1 + moved[1].length());
    }

    /** A box from the origin to (1, 1), 1 m deep. */
    private static Shape block() {
        double[] corners = new double[24];
        for (int i = 0; i < 8; i++) {
            corners[3 * i] = i & 1;
            corners[3 * i + 1] = (i >> 1 & 1) - 1;
            corners[3 * i + 2] = i >> 2;
        }
        int[] sides = {
            0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4,
            6, 1, 3, 5, 3, 7, 5
        };
        return TriangleMesh.of(corners, sides);
    }

    private static Shape shape(SplittableRandom random, double half) {
        double thin = half * StrictMath.pow(10, -random.nextDouble());
        return switch (random.nextInt(5)) {
            case 0 -> Sphere.of(half);
            case 1 -> Box.ofHalfExtents(half, thin, thin);
            case 2 -> Box.ofHalfExtents(half, half * (0.3 + 0.7 * random.nextDouble()), thin);
            case 3 -> Capsule.of(thin, half);
            default -> Cylinder.of(thin, half);
        };
    }

    /** How far a shape reaches down from its centre, m. */
    private static double below(Shape shape, Quaterniond turn) {
        Vector3d d = turn.conjugate(new Quaterniond()).transform(new Vector3d(0, -1, 0));
        return switch (shape) {
            case Sphere s -> s.radius();
            case Box b ->
                    Math.abs(d.x) * b.halfX()
                            + Math.abs(d.y) * b.halfY()
                            + Math.abs(d.z) * b.halfZ();
            case Capsule c -> c.radius() + Math.abs(d.y) * c.halfLength();
            case Cylinder c -> Math.abs(d.y) * c.halfHeight() + c.radius() * Math.hypot(d.x, d.z);
            default -> throw new AssertionError(shape);
        };
    }
}
