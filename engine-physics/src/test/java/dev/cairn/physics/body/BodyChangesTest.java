package dev.cairn.physics.body;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.PhysicsWorldBuilder;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;

import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/** What a body is can be changed while the world runs, and read back; sleepers notice. */
class BodyChangesTest {
    private static final double STEP = 1.0 / 60;

    private static PhysicsWorldBuilder awake() {
        return PhysicsWorld.builder().workers(1).sleeping(false);
    }

    private static void run(PhysicsWorld world, int ticks) {
        for (int tick = 0; tick < ticks; tick++) {
            world.step(STEP);
        }
    }

    @Test
    void aFixedBodyFallsOnceItIsDynamicAndStopsOnceItIsFixed() {
        try (PhysicsWorld world = awake().build()) {
            BodyRef body = world.add(Body.fixed().shape(Box.cubeOfHalfExtent(0.5)).at(0, 100, 0));
            run(world, 10);
            assertEquals(BodyType.FIXED, body.type());
            assertEquals(100, body.position().y, 0.0);
            body.setType(BodyType.DYNAMIC);
            assertEquals(1000, body.mass(), 1e-9);
            run(world, 30);
            double t = 30 * STEP;
            assertEquals(100 - 0.5 * 9.81 * t * t, body.position().y, 1e-12);
            body.setType(BodyType.KINEMATIC);
            run(world, 30);
            assertEquals(100 - 0.5 * 9.81 * t * t - 9.81 * t * t, body.position().y, 1e-9);
            body.setType(BodyType.FIXED);
            Vector3d there = body.position();
            run(world, 10);
            assertEquals(there, body.position());
            assertEquals(new Vector3d(), body.velocity());
            world.validate();
        }
    }

    /** F = m a before and after; the push of a spring would not do, a force does. */
    @Test
    void massAndInertiaAnswerToForceAndTorque() {
        try (PhysicsWorld world = awake().gravity(0, 0, 0).build()) {
            BodyRef body = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)));
            body.setMass(2);
            assertEquals(2, body.mass(), 1e-15);
            assertEquals(2.0 / 6, body.inertia(new Matrix3d()).m00, 1e-15);
            body.applyForce(6, 0, 0);
            world.step(STEP);
            assertEquals(3 * STEP, body.velocity().x, 1e-15);
            body.setInertia(4, 4, 4);
            body.applyTorque(0, 8, 0);
            world.step(STEP);
            assertEquals(2 * STEP, body.angularVelocity().y, 1e-15);
            assertThrows(IllegalArgumentException.class, () -> body.setMass(0));
            assertThrows(IllegalArgumentException.class, () -> body.setInertia(1, 1, 3));
            assertEquals(2, body.mass(), 1e-15);
        }
    }

    @Test
    void aBoxThatShrinksFallsOntoItsNewFace() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            BodyRef box = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.5, 0));
            BodyRef top = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 1.5, 0));
            run(world, 200);
            assertTrue(box.isAsleep() && top.isAsleep());
            Box small = Box.cubeOfHalfExtent(0.25);
            box.setShape(small);
            assertFalse(top.isAsleep(), "what stood on it notices");
            assertSame(small, box.shape());
            assertEquals(125, box.mass(), 1e-9);
            run(world, 200);
            assertEquals(0.25, box.position().y, 1e-3);
            assertEquals(1.0, top.position().y, 1e-3);
            world.validate();
        }
    }

    @Test
    void aBoxSlidesOnceItsSlopeIsIce() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            double angle = 0.3;
            BodyRef slope =
                    world.add(
                            Body.fixed()
                                    .shape(Box.ofHalfExtents(50, 1, 5))
                                    .rotationAbout(0, 0, 1, angle)
                                    .at(0, 0, 0));
            double y = 1.5;
            BodyRef box =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .rotationAbout(0, 0, 1, angle)
                                    .at(-Math.sin(angle) * y, Math.cos(angle) * y, 0));
            run(world, 200);
            assertTrue(box.isAsleep());
            slope.setMaterial(Material.DEFAULT.withFriction(0));
            assertFalse(box.isAsleep(), "friction is gone under a sleeper");
            run(world, 60);
            assertEquals(9.81 * Math.sin(angle), box.velocity().length(), 1e-3);
        }
    }

    @Test
    void allOfItCanBeRead() {
        try (PhysicsWorld world = awake().build()) {
            Object mine = new Object();
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(1))
                                    .at(new Vector3d(1, 2, 3))
                                    .velocity(new Vector3d(4, 5, 6))
                                    .angularVelocity(new Vector3d(7, 8, 9))
                                    .gravityScale(0.5)
                                    .damping(0.1, 0.2)
                                    .speedLimit(50)
                                    .lock(Lock.MOVE_Z, Lock.TURN_X)
                                    .userData(mine));
            assertEquals(new Vector3d(1, 2, 3), body.position());
            assertEquals(new Vector3d(4, 5, 6), body.velocity());
            assertEquals(new Vector3d(7, 8, 9), body.angularVelocity());
            assertEquals(0.5, body.gravityScale(), 0.0);
            assertEquals(0.1, body.linearDamping(), 0.0);
            assertEquals(0.2, body.angularDamping(), 0.0);
            assertEquals(50, body.speedLimit(), 0.0);
            assertArrayEquals(new Lock[] {Lock.MOVE_Z, Lock.TURN_X}, body.locks());
            assertSame(mine, body.userData());
            body.setUserData(null);
            assertEquals(null, body.userData());
            body.setVelocity(new Vector3d());
            body.applyImpulse(new Vector3d(body.mass(), 0, 0));
            assertEquals(1, body.velocity().x, 1e-12);
        }
    }

    /** Any order of changes leaves a world that is whole, and the same one for two workers. */
    @Test
    void anyOrderOfChangesLeavesAWholeWorld() {
        assertEquals(changes(1), changes(2));
    }

    private static long changes(int workers) {
        SplittableRandom random = new SplittableRandom(25);
        try (PhysicsWorld world = PhysicsWorld.builder().workers(workers).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).at(0, -1, 0));
            BodyRef[] bodies = new BodyRef[25];
            for (int i = 0; i < bodies.length; i++) {
                bodies[i] =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(0.4))
                                        .at(i % 5, 0.4 + i / 5, random.nextDouble(0.2)));
            }
            for (int tick = 0; tick < 240; tick++) {
                BodyRef body = bodies[random.nextInt(bodies.length)];
                switch (random.nextInt(8)) {
                    case 0 -> body.setType(BodyType.values()[random.nextInt(3)]);
                    case 1 ->
                            body.setShape(
                                    random.nextBoolean()
                                            ? Sphere.of(random.nextDouble(0.2, 0.5))
                                            : Box.cubeOfHalfExtent(random.nextDouble(0.2, 0.5)));
                    case 2 -> body.setMass(random.nextDouble(1, 1000));
                    case 3 -> body.setMaterial(random.nextBoolean() ? Material.ICE : Material.WOOD);
                    default -> {}
                }
                world.step(STEP);
                if (tick % 20 == 0) {
                    world.validate();
                }
            }
            return world.digest();
        }
    }
}
