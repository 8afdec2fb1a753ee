package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.LongStream;

/**
 * Bodies of foam, wood and steel fall onto one another, without restitution. The steel may push the
 * foam aside, but nobody leaves a heap at a multiple of the speed at which bodies fell into it.
 */
class LightAmongHeavyTest {
    private static final double FOAM = 30;
    private static final double STEEL = 8000;

    /** Speed over that of the longest fall: levers and wedges make some of it, up to here. */
    private static final double MOST = 1.5;

    /** Heaps of which somebody left at 1.9 to 3.2 times that speed. */
    private static final long[] THROWN = {78, 150, 305, 335, 477};

    private static Shape shape(SplittableRandom random) {
        double size = .15 + .35 * random.nextDouble();
        double a = Scenes.part(size, random);
        double b = Scenes.part(size, random);
        double c = Scenes.part(size, random);
        return switch (random.nextInt(6)) {
            case 0 -> Sphere.of(.7 * size);
            case 1 -> Capsule.of(a, b);
            case 2 -> Cylinder.of(a, b);
            case 3 -> Cone.of(a, b);
            case 4 -> ConvexHull.of(new double[] {a, b, c, -a, b, -c, -a, -b, c, a, -b, -c});
            default -> Box.ofHalfExtents(a, b, c);
        };
    }

    /** Fills a world; the speed of a fall from the top, m/s. */
    private static double heap(
            PhysicsWorld world, long seed, int side, int layers, List<BodyRef> refs) {
        SplittableRandom random = new SplittableRandom(seed);
        double friction = .2 + .7 * random.nextDouble();
        world.add(Body.fixed().shape(HalfSpace.of()).material(new Material(friction, 0, 1000, 0)));
        double y = .6;
        for (int i = 0; i < side * side * layers; i++) {
            y += i > 0 && i % (side * side) == 0 ? .7 : 0;
            double density = FOAM * Math.pow(STEEL / FOAM, random.nextDouble());
            double x = .6 * (i % side) + .4 * (random.nextDouble() - .5);
            double z = .6 * (i / side % side) + .4 * (random.nextDouble() - .5);
            refs.add(
                    world.add(
                            Body.dynamic()
                                    .shape(shape(random))
                                    .at(x, y, z)
                                    .rotation(Scenes.turn(random))
                                    .material(new Material(friction, 0, density, 0))));
        }
        return Math.sqrt(2 * 9.81 * y);
    }

    /** The fastest that any body is within five seconds, over the speed of a fall. */
    static double fastest(long seed) {
        List<BodyRef> refs = new ArrayList<>();
        try (PhysicsWorld world = Scenes.awake().build()) {
            double fall = heap(world, seed, 1, 4 + (int) (seed % 10), refs);
            double most = 0;
            for (int t = 0; t < 300; t++) {
                world.step(Scenes.STEP);
                for (BodyRef body : refs) {
                    most = Math.max(most, body.velocity(new Vector3d()).length());
                }
            }
            return most / fall;
        }
    }

    @Test
    void nobodyIsThrown() {
        LongStream.concat(LongStream.of(THROWN), LongStream.range(0, 25))
                .forEach(seed -> {
                    double ratio = fastest(seed);
                    assertTrue(ratio < MOST, "seed " + seed + ": " + ratio + " of a fall");
                });
    }

    /** A user presses a light body onto a heavy one: that is no warm start gone wrong. */
    @Test
    void whatIsPressedByAForceHolds() {
        try (PhysicsWorld world = Scenes.awake().build()) {
            Scenes.ground(world);
            Shape cube = Box.cubeOfHalfExtent(.5);
            world.add(Body.dynamic().shape(cube).at(0, .5, 0).mass(100));
            BodyRef light = world.add(Body.dynamic().shape(cube).at(0, 1.5, 0).mass(1));
            for (int t = 0; t < 300; t++) {
                light.applyForce(0, -2000, 0);
                world.step(Scenes.STEP);
            }
            assertEquals(1.5, light.position().y, 1e-3);
            double normal = 0;
            for (int p = 0; p < world.contacts().pointCount(1); p++) {
                normal += world.contacts().normalImpulse(1, p);
            }
            assertEquals((2000 + 9.81) * Scenes.STEP, normal, 1e-3);
        }
    }

    /** One island that is solved in lockstep, and small ones. */
    @Test
    void sameBits() {
        Scenes.assertSameBits(world -> {
            heap(world, 1, 12, 5, new ArrayList<>());
            for (int t = 0; t < 60; t++) {
                world.step(Scenes.STEP);
            }
            assertTrue(world.contacts().count() > 1500);
        });
    }
}
