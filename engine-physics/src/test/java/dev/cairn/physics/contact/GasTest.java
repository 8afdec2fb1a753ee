package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A gas of elastic balls between walls: nobody leaves, energy is kept to rounding, and two that
 * have met part. Some balls are fast, some slow, so that a ball meets several others in a tick, and
 * in the tick in which it meets a slow one.
 */
class GasTest {
    private static final int TICKS = 300;
    private static final double RADIUS = 0.2;

    @Test
    void keepsItsEnergy() {
        long digest = run(1, 1);
        assertEquals(digest, run(2, 4), "workers and lanes");
    }

    private static long run(int workers, int lanes) {
        PhysicsSettings settings =
                PhysicsSettings.DEFAULT
                        .withSleeping(false)
                        .withRestitutionThreshold(0)
                        .withLanes(lanes);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, 0, 0)
                        .settings(settings)
                        .workers(workers)
                        .build()) {
            Material surface = new Material(0, 1, 1000);
            for (int i = 0; i < 6; i++) {
                double[] at = new double[3];
                double[] half = {3.1, 3.1, 3.1};
                at[i / 2] = (i % 2 == 0 ? -1 : 1) * 3.05;
                half[i / 2] = 0.05;
                world.add(
                        Body.fixed()
                                .shape(Box.ofHalfExtents(half[0], half[1], half[2]))
                                .at(at[0], at[1], at[2])
                                .material(surface));
            }
            SplittableRandom random = new SplittableRandom(7);
            List<BodyRef> balls = new ArrayList<>();
            for (int i = 0; i < 125; i++) {
                double fast = 100 * random.nextDouble() * random.nextDouble();
                balls.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(RADIUS))
                                        .mass(1)
                                        .at(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2)
                                        .velocity(
                                                fast * (2 * random.nextDouble() - 1),
                                                fast * (2 * random.nextDouble() - 1),
                                                fast * (2 * random.nextDouble() - 1))
                                        .material(surface)));
            }
            double start = world.kineticEnergy();
            for (int tick = 0; tick < TICKS; tick++) {
                world.step(Scenes.STEP);
            }
            double energy = world.kineticEnergy() / start - 1;
            assertTrue(Math.abs(energy) < 1e-11, "seed 7, energy is off by " + energy);
            for (BodyRef ball : balls) {
                Vector3d p = ball.position();
                double far = Math.max(Math.abs(p.x), Math.max(Math.abs(p.y), Math.abs(p.z)));
                assertTrue(far < 3 - RADIUS + 1e-9, "seed 7, a ball is at " + p);
            }
            return world.digest();
        }
    }
}
