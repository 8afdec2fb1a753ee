package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.function.BiFunction;

/**
 * Joints that want what contacts, locks or other joints do not allow: not all can hold, and no
 * energy comes of it. Nothing is faster than a few times what moves it.
 */
class ContradictionTest {
    private static final double STEP = 1.0 / 60;

    private static final List<BiFunction<BodyRef, BodyRef, Joint>> KINDS =
            List.of(
                    Joint::ball,
                    Joint::fixed,
                    (a, b) -> Joint.hinge(a, b).axis(0, 0, 1).limits(-1, 1),
                    (a, b) -> Joint.slider(a, b).axis(1, 0, 0),
                    (a, b) -> Joint.slider(a, b).axis(1, 0, 0).motor(1, 50));

    private static double fastest(PhysicsWorld world) {
        double most = 0;
        for (BodyRef body : world.bodies()) {
            most = Math.max(most, body.velocity(new Vector3d()).length());
        }
        return most;
    }

    private static PhysicsWorld world() {
        return PhysicsWorld.builder().workers(1).sleeping(false).build();
    }

    /**
     * A box on a plate that moves on and turns under it is held by a joint to the floor. Normal
     * impulses, friction and the joint share the load in more ways than one.
     */
    @Test
    void aBoxIsHeldWhileThePlateBelowMovesOn() {
        for (BiFunction<BodyRef, BodyRef, Joint> kind : KINDS) {
            for (double speed : new double[] {0, 0.3}) {
                for (double spin : new double[] {0, 0.2}) {
                    try (PhysicsWorld world = world()) {
                        BodyRef floor = floor(world, 0.6);
                        world.add(
                                Body.kinematic()
                                        .shape(Box.ofHalfExtents(2, 0.2, 2))
                                        .at(0, 0.2, 0)
                                        .velocity(0, 0, speed)
                                        .angularVelocity(0, spin, 0));
                        BodyRef box =
                                world.add(
                                        Body.dynamic()
                                                .shape(Box.ofHalfExtents(0.4, 0.2, 0.4))
                                                .at(0.5, 0.6, 0.3));
                        for (int t = 0; t < 20; t++) {
                            world.step(STEP);
                        }
                        Vector3d at = box.position(new Vector3d());
                        world.add(
                                kind.apply(box, floor)
                                        .at(0.5 * at.x, 0.5 * at.y - 0.5, 0.5 * at.z));
                        for (int t = 0; t < 120; t++) {
                            world.step(STEP);
                            double most = fastest(world);
                            assertTrue(most < 2, "tick " + t + ", " + most + " m/s");
                        }
                    }
                }
            }
        }
    }

    private static BodyRef floor(PhysicsWorld world, double friction) {
        return world.add(
                Body.fixed()
                        .shape(Box.ofHalfExtents(20, 1, 20))
                        .at(0, -1, 0)
                        .material(new Material(friction, 0, 1000)));
    }

    /** A kinematic body presses what is jointed to it into the floor, and through it. */
    @Test
    void aBodyIsPressedThroughTheFloor() {
        List<Shape> shapes =
                List.of(Box.ofHalfExtents(0.4, 0.2, 0.3), Capsule.of(0.2, 0.3), Sphere.of(0.3));
        for (BiFunction<BodyRef, BodyRef, Joint> kind : KINDS.subList(0, 3)) {
            for (Shape shape : shapes) {
                for (double friction : new double[] {0, 0.6}) {
                    for (double speed : new double[] {0.3, 3}) {
                        press(kind, shape, friction, speed);
                    }
                }
            }
        }
    }

    private static void press(
            BiFunction<BodyRef, BodyRef, Joint> kind, Shape shape, double friction, double speed) {
        try (PhysicsWorld world = world()) {
            floor(world, friction);
            BodyRef press =
                    world.add(
                            Body.kinematic()
                                    .shape(Sphere.of(0.1))
                                    .at(0.7, 1.5, 0.2)
                                    .velocity(0.5 * speed, -speed, 0.2 * speed)
                                    .angularVelocity(0, 0.3 * speed, 0.2 * speed));
            BodyRef body = world.add(Body.dynamic().shape(shape).at(0, 0.45, 0));
            world.add(Body.dynamic().shape(Box.ofHalfExtents(0.3, 0.1, 0.3)).at(0, 0.9, 0));
            world.add(kind.apply(press, body).at(0.35, 0.9, 0.1));
            // what lies on it falls for two seconds where it is pushed off
            double bound = 10 * speed + 10;
            for (int t = 0; t < 60; t++) {
                world.step(STEP);
                double most = fastest(world);
                assertTrue(most < bound, "tick " + t + ", " + most + " m/s, " + shape);
            }
        }
    }

    /** A kinematic body that spins would move by a joint what is locked along some axes. */
    @Test
    void aLockedBodyIsPulled() {
        List<BiFunction<BodyRef, BodyRef, Joint>> kinds =
                List.of(Joint::ball, Joint::fixed, Joint::universal);
        for (BiFunction<BodyRef, BodyRef, Joint> kind : kinds) {
            for (int locks = 1; locks < 64; locks++) {
                try (PhysicsWorld world = world()) {
                    BodyRef crank =
                            world.add(
                                    Body.kinematic()
                                            .shape(Sphere.of(0.5))
                                            .velocity(-2.9, -1.2, 4.1)
                                            .angularVelocity(2.8, 4.7, -0.3));
                    BodyRef box =
                            world.add(
                                    Body.dynamic()
                                            .shape(Box.ofHalfExtents(0.4, 0.07, 0.4))
                                            .at(-2, 0.03, 1.15)
                                            .velocity(-2.1, 0, -0.3)
                                            .angularVelocity(2.8, 0, 0));
                    box.setLocks(Lock.of(locks));
                    world.add(kind.apply(crank, box).at(-1, 0.01, 0.58));
                    for (int t = 0; t < 60; t++) {
                        world.step(STEP);
                        double most = fastest(world);
                        assertTrue(most < 20, "locks " + locks + ", " + most + " m/s");
                    }
                }
            }
        }
    }
}
