package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
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

    /**
     * An overlap that is pushed out is no load: the ground is raised under boxes that lie on it.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.002, 0.02, 0.1, 0.3})
    void whatIsPushedOutOfTheGroundLiesOnIt(double rise) {
        double[] heights = new double[2];
        int[] lanes = {1, 8};
        for (int k = 0; k < 2; k++) {
            PhysicsSettings settings =
                    PhysicsSettings.DEFAULT.withSleeping(k > 0).withLanes(lanes[k]);
            try (PhysicsWorld world =
                    PhysicsWorld.builder().gravity(0, -9.81, 0).settings(settings).build()) {
                BodyRef ground =
                        world.add(Body.fixed().shape(Box.ofHalfExtents(9, .5, 9)).at(0, -.5, 0));
                BodyRef[] boxes = new BodyRef[12];
                for (int i = 0; i < boxes.length; i++) {
                    Body box = Body.dynamic().shape(Box.cubeOfHalfExtent(.3));
                    boxes[i] = world.add(box.at(i % 4 * 2 - 3, .3, i / 4 * 2 - 2));
                }
                for (int tick = 0; tick < 120; tick++) {
                    world.step(1.0 / 60);
                }
                ground.teleport(0, rise - .5, 0);
                for (int tick = 0; tick < 180; tick++) {
                    world.step(1.0 / 60);
                }
                for (BodyRef box : boxes) {
                    assertEquals(rise + .3, box.position().y, 1e-5);
                }
                heights[k] = boxes[0].position().y;
            }
        }
        assertEquals(heights[0], heights[1], 1e-5, "awake and scalar, asleep and in lanes");
    }
}
