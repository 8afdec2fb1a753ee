package dev.cairn.physics.hand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Box;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** A hand as a user has it: it lifts, is no stronger than it may be, and lets go. */
final class HandTest {
    private static final double STEP = 1 / 60.0;
    private static final double G = 9.81;

    private static BodyRef box(PhysicsWorld world) {
        return world.add(
                Body.dynamic()
                        .shape(Box.ofHalfExtents(0.2, 0.3, 0.1))
                        .mass(3)
                        .at(0, 1, 0)
                        .name("box"));
    }

    private static PhysicsWorld world() {
        return PhysicsWorld.builder().workers(1).sleeping(false).build();
    }

    /** The point that was taken comes to where it is told, the centre hangs below it. */
    @Test
    void liftsWhereItIsTold() {
        try (PhysicsWorld world = world()) {
            BodyRef box = box(world);
            Hand hand = new Hand(world);
            hand.grab(box, new Vector3d(0.2, 1.3, 0.1));
            assertTrue(hand.isHolding());
            for (int tick = 0; tick < 1800; tick++) {
                hand.pull(4, 3, -2);
                world.step(STEP);
            }
            assertEquals(0, hand.point(new Vector3d()).distance(4, 3, -2), 1e-6, "the point");
            Vector3d centre = box.position(new Vector3d());
            double arm = new Vector3d(0.2, 0.3, 0.1).length();
            assertEquals(0, centre.distance(4, 3 - arm, -2), 1e-4, "the centre " + centre);
            assertEquals(3 * G, hand.force(new Vector3d()).y, 1e-5, "the weight");
        }
    }

    @Test
    void isNoStrongerThanAHundredWeights() {
        try (PhysicsWorld world = world()) {
            BodyRef box = box(world);
            BodyRef wall = world.add(Body.fixed().shape(Box.ofHalfExtents(1, 1, 1)).at(0, 5, 0));
            world.add(Joint.fixed(wall, box).at(0, 1, 0));
            Hand hand = new Hand(world);
            hand.grab(box, new Vector3d(0, 1, 0));
            for (int tick = 0; tick < 30; tick++) {
                hand.pull(40, 30, -20);
                world.step(STEP);
                double force = hand.force(new Vector3d()).length();
                assertEquals(100 * 3 * G, force, 1e-6 * 100 * 3 * G);
            }
            assertEquals(0, box.position(new Vector3d()).distance(0, 1, 0), 1e-9, "held");
        }
    }

    @Test
    void letsGo() {
        try (PhysicsWorld world = world()) {
            BodyRef box = box(world);
            BodyRef wall = world.add(Body.fixed().shape(Box.ofHalfExtents(1, 1, 1)).at(0, 5, 0));
            Hand hand = new Hand(world);
            assertFalse(hand.isHolding());
            assertNull(hand.body());
            hand.pull(1, 1, 1);
            hand.release();
            Vector3d at = new Vector3d(0, 1, 0);
            assertThrows(IllegalArgumentException.class, () -> hand.grab(wall, at));
            hand.grab(box, at);
            world.step(STEP);
            hand.release();
            assertEquals(2, world.bodyCount(), "nothing is left of the hand");
            assertEquals(0, world.joints().count());
            hand.grab(box, at);
            box.remove();
            assertFalse(hand.isHolding(), "what was removed");
            hand.pull(1, 1, 1);
            world.step(STEP);
            hand.release();
            assertEquals(1, world.bodyCount());
        }
    }
}
