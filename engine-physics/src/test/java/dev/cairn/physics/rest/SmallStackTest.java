package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Stacks of small cubes stand: a contact yields by some {@code g h²}, 0.28 mm, which is a third of
 * a cube of 1 mm, whatever the size.
 */
final class SmallStackTest {
    @ParameterizedTest(name = "{1} cubes of {0} m, lanes {2}")
    @CsvSource({
        "0.02, 10, 1",
        "0.01, 10, 1",
        "0.005, 10, 8",
        "0.001, 3, 1",
        "0.001, 10, 1",
        "0.001, 10, 8"
    })
    void standsForAMinute(double edge, int cubes, int lanes) {
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -9.81, 0)
                        .workers(1)
                        .settings(PhysicsSettings.DEFAULT.withSleeping(false).withLanes(lanes))
                        .build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            BodyRef[] cube = new BodyRef[cubes];
            for (int i = 0; i < cubes; i++) {
                Box shape = Box.cubeOfHalfExtent(edge / 2);
                cube[i] = world.add(Body.dynamic().shape(shape).at(0, edge * (0.5 + i), 0));
            }
            for (int tick = 0; tick < 3600; tick++) {
                world.step(1.0 / 60);
            }
            for (int i = 0; i < cubes; i++) {
                double off = cube[i].position().distance(0, edge * (0.5 + i), 0);
                // lateral creep of direct solves, see docs/direct-solve.md
                assertEquals(0, off / edge, 0.01, "cube " + i + ", edges off its place");
            }
        }
    }
}
