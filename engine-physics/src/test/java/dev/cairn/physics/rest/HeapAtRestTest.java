package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A heap of dry bodies that nothing disturbs stays as it is. It did not: offsets that held all of
 * the load of inclined contacts wound forces up until it gave way, every ten seconds, and 200
 * bodies sank by centimetres within a minute.
 */
class HeapAtRestTest {
    private static final int SIDE = 7;
    private static final int LAYERS = 10;

    /** Half of the width of the pit, m. */
    private static final double PIT = 2.75;

    private static final double WALL = 20;

    /** A hundredth of a small body's size, m; within ten seconds this heap sank by 10 mm. */
    private static final double HUNDREDTH = 2e-3;

    private static Shape shape(SplittableRandom random) {
        double size = .15 + .35 * random.nextDouble();
        double a = Scenes.part(size, random);
        double b = Scenes.part(size, random);
        double c = Scenes.part(size, random);
        return switch (random.nextInt(5)) {
            case 0 -> Sphere.of(.7 * size);
            case 1 -> Capsule.of(a, b);
            case 2 -> Box.ofHalfExtents(a, b, a);
            case 3 -> ConvexHull.of(new double[] {a, b, c, -a, b, -c, -a, -b, c, a, -b, -c});
            default -> Box.ofHalfExtents(a, b, c);
        };
    }

    private static void fix(
            PhysicsWorld world, Material material, Shape shape, double x, double y, double z) {
        world.add(Body.fixed().shape(shape).at(x, y, z).material(material));
    }

    private static List<BodyRef> heap(PhysicsWorld world, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double friction = .2 + .7 * random.nextDouble();
        Material dry = new Material(friction, 0, 1000);
        fix(world, dry, Box.ofHalfExtents(PIT + 1, .5, PIT + 1), 0, -.5, 0);
        for (int side = -1; side <= 1; side += 2) {
            fix(world, dry, Box.ofHalfExtents(.5, WALL, PIT + 1), side * (PIT + .5), WALL, 0);
            fix(world, dry, Box.ofHalfExtents(PIT + 1, WALL, .5), 0, WALL, side * (PIT + .5));
        }
        List<BodyRef> bodies = new ArrayList<>();
        for (int i = 0; i < SIDE * SIDE * LAYERS; i++) {
            double density = 300 * Math.pow(10, random.nextDouble());
            double x = .6 * (i % SIDE - (SIDE - 1) * .5) + .2 * (random.nextDouble() - .5);
            double z = .6 * (i / SIDE % SIDE - (SIDE - 1) * .5) + .2 * (random.nextDouble() - .5);
            double y = .6 + .7 * (i / (SIDE * SIDE));
            bodies.add(
                    world.add(
                            Body.dynamic()
                                    .shape(shape(random))
                                    .at(x, y, z)
                                    .rotation(Scenes.turn(random))
                                    .material(new Material(friction, 0, density))));
        }
        return bodies;
    }

    private static double height(List<BodyRef> bodies) {
        return bodies.stream().mapToDouble(body -> body.position().y).average().orElseThrow();
    }

    @Test
    void keepsItsHeight() {
        try (PhysicsWorld world = Scenes.awake().build()) {
            List<BodyRef> bodies = heap(world, 1);
            Scenes.run(world, 600);
            double before = height(bodies);
            Scenes.run(world, 600);
            assertEquals(before, height(bodies), HUNDREDTH, "seed 1");
        }
    }

    @Test
    void sameBits() {
        Scenes.assertSameBits(world -> {
            heap(world, 4);
            Scenes.run(world, 120);
        });
    }
}
