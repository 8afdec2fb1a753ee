package dev.cairn.physics.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.List;

/** What can no longer be computed with is stopped and fixed; its neighbours live on. */
class QuarantineTest {

    private static void allFinite(PhysicsWorld world) {
        for (BodyRef body : world.bodies()) {
            assertTrue(body.position().isFinite(), body + " at " + body.position());
            assertTrue(body.velocity().isFinite(), body + " moves " + body.velocity());
            assertTrue(body.orientation().isFinite());
        }
    }

    @Test
    void aForceThatOverflowsStopsItsBodyOnly() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            List<BodyRef> boxes = Scenes.stack(world, 3);
            for (int tick = 0; tick < 60; tick++) {
                world.step(Scenes.STEP);
            }
            Vector3d before = boxes.get(1).position();
            boxes.get(1).applyForce(1e308, 0, 0);
            boxes.get(1).applyForce(1e308, 0, 0);
            world.step(Scenes.STEP);
            assertEquals(List.of(boxes.get(1)), world.quarantined());
            assertTrue(boxes.get(1).isFixed());
            assertEquals(before, boxes.get(1).position());
            for (int tick = 0; tick < 60; tick++) {
                world.step(Scenes.STEP);
                allFinite(world);
            }
            assertEquals(1, world.quarantined().size());
            assertEquals(2.5, boxes.get(2).position().y, 0.01);
            assertEquals(0.5, boxes.get(0).position().y, 0.01);
            boxes.get(1).remove();
            assertEquals(List.of(), world.quarantined());
            for (int tick = 0; tick < 120; tick++) {
                world.step(Scenes.STEP);
            }
            assertEquals(1.5, boxes.get(2).position().y, 0.01);
        }
    }

    @Test
    void torquesImpulsesAndSpeedsThatOverflow() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            BodyRef[] balls = new BodyRef[5];
            for (int i = 0; i < balls.length; i++) {
                balls[i] =
                        world.add(Body.dynamic().shape(Sphere.of(0.5)).at(3 * i, 9, 0).mass(0.1));
            }
            balls[0].applyTorque(0, 1e308, 0);
            balls[1].applyImpulse(1e308, 0, 0);
            balls[2].setVelocity(0, 0, -1e100);
            balls[3].setAngularVelocity(0, 1e200, 0);
            world.step(Scenes.STEP);
            assertEquals(List.of(balls[0], balls[1], balls[2], balls[3]), world.quarantined());
            allFinite(world);
            world.step(Scenes.STEP);
            assertEquals(4, world.quarantined().size());
            assertTrue(balls[4].position().y < 9);
        }
    }

    @Test
    void aBodyNearTheEndOfSpaceIsStoppedThere() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            BodyRef far =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(1))
                                    .at(9e59, 0, 0)
                                    .velocity(9e59, 0, 0));
            world.step(1);
            world.step(1);
            allFinite(world);
            assertEquals(List.of(far), world.quarantined());
            assertEquals(9e59, far.position().x);
        }
    }

    @Test
    void manyWildBodiesInAHeap() {
        try (PhysicsWorld world = Scenes.awake().workers(2).build()) {
            Scenes.drop(world, 60, 5);
            List<BodyRef> bodies = world.bodies();
            for (int tick = 0; tick < 120; tick++) {
                bodies.get(1 + tick % 60).applyForce(1e150 * (tick % 7), 1e40, -1e30);
                world.step(Scenes.STEP);
                allFinite(world);
            }
        }
    }
}
