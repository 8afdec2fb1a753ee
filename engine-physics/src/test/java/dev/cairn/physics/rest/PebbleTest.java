package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
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
            assertEquals(0, deepest(random, Sphere.of(radius), radius, ratio, 0), 0.01 * radius);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4, 8})
    void allLanesGoOneWay(int lanes) {
        double[] deep = new double[2];
        for (int k = 0; k < 2; k++) {
            SplittableRandom random = new SplittableRandom(3);
            deep[k] = deepest(random, Box.ofHalfExtents(.02, .01, .02), .01, 1000, k * lanes);
        }
        assertEquals(deep[0], deep[1]);
    }

    /** Deepest overlap after five seconds, m; lanes as they are found for 0. */
    private static double deepest(
            SplittableRandom random, Shape shape, double half, double ratio, int lanes) {
        Material material = new Material(0.5, 0, 1000);
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withSleeping(false);
        settings = lanes == 0 ? settings : settings.withLanes(lanes);
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).settings(settings).build()) {
            Shape floor = Box.ofHalfExtents(20, 1, 20);
            world.add(Body.fixed().shape(floor).at(0, -1, 0).material(material));
            double x = (random.nextDouble() - 0.5) * HALF;
            double z = (random.nextDouble() - 0.5) * HALF;
            world.add(turned(random, shape).mass(MASS / ratio).at(x, half, z).material(material));
            Shape crate = Box.cubeOfHalfExtent(HALF);
            double y = HALF + 2 * half + 0.05;
            world.add(turned(random, crate).mass(MASS).at(0, y, 0).material(material));
            for (int t = 0; t < TICKS; t++) {
                world.step(1.0 / 60);
            }
            return Overlap.deepest(world);
        }
    }

    private static Body turned(SplittableRandom random, Shape shape) {
        double turn = 6 * random.nextDouble();
        return Body.dynamic().shape(shape).rotation(new Quaterniond().rotateY(turn));
    }
}
