package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;

import org.joml.Quaterniond;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

/**
 * Cards that fall flat, of a fifth of a millimetre to one: the sag of a soft contact is a good part
 * of them. They slept in it, with half of their thickness in the floor, or not at all.
 */
class ThinTest {
    @ParameterizedTest
    @ValueSource(doubles = {1e-4, 2e-4, 5e-4})
    void aCardSleepsOnTheFloorAndNotInIt(double halfHeight) {
        for (int seed = 0; seed < 4; seed++) {
            Random random = new Random(seed);
            Material material = new Material(0.5, 0.1, 1000);
            try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
                world.add(Body.fixed().shape(HalfSpace.of()).material(material));
                Quaterniond turn =
                        new Quaterniond()
                                .rotateX(0.1 * random.nextGaussian())
                                .rotateZ(0.1 * random.nextGaussian());
                BodyRef card =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.02, halfHeight, 0.015))
                                        .at(0, 0.2, 0)
                                        .rotation(turn)
                                        .material(material));
                for (int tick = 0; tick < 300; tick++) {
                    world.step(1.0 / 60);
                }
                assertTrue(card.isAsleep(), "seed " + seed);
                double overlap = Overlap.deepest(world) / halfHeight;
                assertTrue(overlap < 0.05, () -> "overlap over half the height: " + overlap);
            }
        }
    }
}
