package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cylinder;

import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;

/**
 * A contact is soft, but nothing is pressed into what does not move by more than half of itself.
 */
final class PressedTest {
    private static final long SEED = 20261126;

    private static PhysicsWorld world(int substeps) {
        return PhysicsWorld.builder()
                .gravity(0, -9.81, 0)
                .workers(1)
                .settings(PhysicsSettings.DEFAULT.withSubsteps(substeps).withSleeping(false))
                .build();
    }

    /**
     * Plates and coins from 10 um on fall by up to 2 cm, in ticks of 1/120 and 1/30 s in turns.
     * Without the ball in them 16 to 25 of 40 sink through the floor.
     */
    @ParameterizedTest(name = "{0} sub-steps")
    @ValueSource(ints = {1, 2, 4})
    void theMiddleOfAThinPlateStaysAboveTheFloor(int substeps) {
        System.out.println("seed " + SEED);
        SplittableRandom random = new SplittableRandom(SEED);
        for (int round = 0; round < 40; round++) {
            double half = StrictMath.pow(10, -5 + 1.5 * random.nextDouble());
            double width = 0.01 + 0.09 * random.nextDouble();
            try (PhysicsWorld world = world(substeps)) {
                world.add(Body.fixed().shape(Box.ofHalfExtents(1, 1, 1)).at(0, -1, 0));
                Body plate =
                        Body.dynamic()
                                .at(0, half + 0.02 * random.nextDouble(), 0)
                                .angularVelocity(random.nextDouble(), 0, 2 * random.nextDouble())
                                .mass(StrictMath.pow(10, -3 + 2 * random.nextDouble()));
                BodyRef thin =
                        world.add(
                                round % 2 == 0
                                        ? plate.shape(Box.ofHalfExtents(width, half, width))
                                        : plate.shape(Cylinder.of(width, half)));
                for (int tick = 0; tick < 120; tick++) {
                    world.step(tick % 2 == 0 ? 1.0 / 120 : 1.0 / 30);
                    int now = tick;
                    double height = thin.position().y;
                    // half of it by the sub-step, a quarter by the guard of the tick
                    assertTrue(
                            height > 0.25 * half * (1 - 1e-6),
                            () -> "tick " + now + ": " + height + " m of " + half);
                }
            }
        }
    }

    /** The head of a hammer hangs beside a table, lower than what the handle lies on, and falls. */
    @Test
    void whatHangsBesideATableIsNotHeld() {
        try (PhysicsWorld world = world(4)) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(1, 0.5, 1)).at(-1, -0.5, 0));
            BodyRef hammer =
                    world.add(
                            Body.dynamic()
                                    .shape(
                                            Box.ofHalfExtents(0.5, 0.02, 0.02)
                                                    .moved(-0.2, 0.02, 0, new Quaterniond()))
                                    .shape(
                                            Box.cubeOfHalfExtent(0.1)
                                                    .moved(0.2, -0.2, 0, new Quaterniond()))
                                    .mass(40));
            BodyRef stick =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.5, 0.02, 0.02))
                                    .at(-0.2, 0.02, 0.5)
                                    .centreOfMass(0.4, -0.2, 0)
                                    .mass(1));
            for (int tick = 0; tick < 90; tick++) {
                world.step(1.0 / 60);
            }
            assertTrue(hammer.position().y < -1, () -> "hammer at " + hammer.position());
            assertTrue(stick.position().y < -1, () -> "stick at " + stick.position());
        }
    }
}
