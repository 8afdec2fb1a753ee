package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a contact has learnt of a load goes with the load: nothing hovers over what it rests on. */
class HoverTest {
    /** The ball rolls over the edge slowly, so that less than half of the load goes in a tick. */
    @ParameterizedTest
    @ValueSource(ints = {1, 8})
    void aBoxLiesDownAgainWhenABallHasRolledOffIt(int lanes) {
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withSleeping(false).withLanes(lanes);
        try (PhysicsWorld world =
                PhysicsWorld.builder().gravity(0, -9.81, 0).settings(settings).build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            BodyRef lower =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.4)).at(0, 0.4, 0));
            BodyRef upper =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.1)).at(0, 0.9, 0));
            world.add(Body.dynamic().shape(Sphere.of(0.1)).at(0.02, 1.6, 0));
            for (int tick = 0; tick < 1800; tick++) {
                world.step(1.0 / 60);
            }
            assertEquals(0.4, lower.position().y, 1e-7);
            assertEquals(0.9, upper.position().y, 1e-7);
        }
    }
}
