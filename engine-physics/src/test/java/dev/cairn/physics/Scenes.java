package dev.cairn.physics;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Scenes for tests of the pipeline. */
final class Scenes {
    static final double STEP = 1.0 / 60.0;

    private Scenes() {}

    /** A world to be, in which nothing sleeps: truths are stated of bodies that are awake. */
    static PhysicsWorld.Builder awake() {
        return PhysicsWorld.builder().sleeping(false);
    }

    static BodyRef ground(PhysicsWorld world) {
        return world.add(Body.fixed().shape(Box.of(50, 1, 50)).at(0, -1, 0).name("ground"));
    }

    static List<BodyRef> stack(PhysicsWorld world, int height) {
        ground(world);
        List<BodyRef> boxes = new ArrayList<>();
        for (int i = 0; i < height; i++) {
            boxes.add(world.add(Body.dynamic().shape(Box.cube(0.5)).at(0, 0.5 + i, 0)));
        }
        return boxes;
    }

    /** A heap of boxes, balls and hulls that falls on the ground. */
    static void drop(PhysicsWorld world, int bodies, long seed) {
        ground(world);
        Random random = new Random(seed);
        for (int i = 0; i < bodies; i++) {
            world.add(any(random, i));
        }
    }

    static Body any(Random random, int i) {
        Shape shape =
                switch (i % 3) {
                    case 0 -> Box.of(0.2 + 0.3 * random.nextDouble(), 0.3, 0.25);
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
}
