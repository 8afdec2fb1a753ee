package dev.cairn.physics.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Test;

import java.util.List;

/** A plane without end that rises: what lies on it rises too, what falls on it lands. */
class KinematicPlaneTest {
    private static final double HALF = 0.25;

    @Test
    void aPlaneWithoutEndMoves() {
        try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, -9.81, 0).build()) {
            BodyRef plane = world.add(Body.kinematic().shape(HalfSpace.of()).velocity(0.5, 2, 0));
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(HALF)).at(0, HALF, 0));
            BodyRef box = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(HALF)).at(4, 4, 0));
            run(world, 120);
            assertEquals(4, plane.position().y, 1e-12);
            for (BodyRef body : List.of(ball, box)) {
                assertEquals(4 + HALF, body.position().y, 1e-4, body.toString());
                assertEquals(2, body.velocity().y, 1e-5, body.toString());
            }
            assertEquals(0.5, box.velocity().x, 1e-5);
            plane.setVelocity(0, -1, 0);
            run(world, 120);
            assertEquals(2 + HALF, box.position().y, 1e-4);
        }
    }

    /** All points of it but a line's would be endlessly fast. */
    @Test
    void aPlaneWithoutEndDoesNotTurn() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            Body plane = Body.kinematic().shape(HalfSpace.of()).angularVelocity(0, 1, 0);
            assertThrows(IllegalArgumentException.class, () -> world.add(plane));
        }
    }

    private static void run(PhysicsWorld world, int ticks) {
        for (int tick = 0; tick < ticks; tick++) {
            world.step(Scenes.STEP);
        }
    }
}
