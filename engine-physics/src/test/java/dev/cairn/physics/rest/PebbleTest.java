package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;

/**
 * A crate of 64 kg falls by 5 cm onto a ball of a centimetre that lies on a floor and is up to ten
 * thousand times as light. It lies on it after five seconds, and neither has gone into the other or
 * the floor.
 */
class PebbleTest {
    private static final double HALF = 0.2;
    private static final double MASS = 64;
    private static final int TICKS = 300;

    @ParameterizedTest
    @ValueSource(doubles = {100, 1000, 10_000})
    void aBallBearsACrate(double ratio) {
        SplittableRandom random = new SplittableRandom(20261201);
        for (int k = 0; k < 6; k++) {
            double radius = 0.005 + 0.01 * random.nextDouble();
            try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
                drop(world, random, Sphere.of(radius), radius, ratio);
                assertEquals(0, Overlap.deepest(world), 0.01 * radius, "seed 20261201, " + k);
            }
        }
    }

    @Test
    void allWorkersAndLanesGoOneWay() {
        Shape pebble = Box.ofHalfExtents(.02, .01, .02);
        Scenes.assertSameBits(world -> drop(world, new SplittableRandom(3), pebble, .01, 1000));
    }

    /** Five seconds of a crate over a thing on the floor. */
    private static void drop(
            PhysicsWorld world, SplittableRandom random, Shape shape, double half, double ratio) {
        Material material = new Material(0.5, 0, 1000);
        Shape floor = Box.ofHalfExtents(20, 1, 20);
        world.add(Body.fixed().shape(floor).at(0, -1, 0).material(material));
        double x = (random.nextDouble() - 0.5) * HALF;
        double z = (random.nextDouble() - 0.5) * HALF;
        world.add(turned(random, shape).mass(MASS / ratio).at(x, half, z).material(material));
        Shape crate = Box.cubeOfHalfExtent(HALF);
        double y = HALF + 2 * half + 0.05;
        world.add(turned(random, crate).mass(MASS).at(0, y, 0).material(material));
        for (int t = 0; t < TICKS; t++) {
            world.step(Scenes.STEP);
        }
    }

    private static Body turned(SplittableRandom random, Shape shape) {
        double turn = 6 * random.nextDouble();
        return Body.dynamic().shape(shape).rotation(new Quaterniond().rotateY(turn));
    }
}
