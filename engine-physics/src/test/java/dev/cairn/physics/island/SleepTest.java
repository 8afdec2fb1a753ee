package dev.cairn.physics.island;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.Query;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.SleepEvents;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** Falling asleep: when it may happen, when it must not, and what it costs. */
class SleepTest {
    private static final Material ROUGH = new Material(0.6, 0, 1000);

    private static PhysicsWorld world() {
        return PhysicsWorld.builder().workers(1).build();
    }

    private static PhysicsWorld weightless() {
        return PhysicsWorld.builder().workers(1).gravity(0, 0, 0).build();
    }

    @Test
    void aStackOfTenSleepsWithinThreeSecondsAndThenNothingChanges() {
        try (PhysicsWorld world = world()) {
            List<BodyRef> stack = Scenes.stack(world, 10);
            int fell = 0;
            int ended = 0;
            for (int tick = 0; tick < 180; tick++) {
                world.step(Scenes.STEP);
                fell += world.sleepEvents().fellAsleepCount();
                ended += world.contacts().ended().count();
            }
            assertTrue(Scenes.allAsleep(stack), "asleep after 3 s");
            assertEquals(10, fell);
            assertEquals(0, ended, "a pair that sleeps still touches");
            assertEquals(10, world.contacts().count());
            Query poses = world.ecs().query(Pose.COMPONENT, Velocity.COMPONENT);
            long version = poses.chunk(0).version(Pose.COMPONENT.doubleField("x"));
            long digest = world.digest();
            for (int tick = 0; tick < 120; tick++) {
                world.step(Scenes.STEP);
                assertEquals(digest, world.digest());
                assertEquals(0, world.contacts().began().count());
            }
            assertEquals(
                    version,
                    poses.chunk(0).version(Pose.COMPONENT.doubleField("x")),
                    "nothing was published");
            for (int i = 0; i < 10; i++) {
                assertEquals(i + 0.5, stack.get(i).position().y, 5e-3, "box " + i);
                assertEquals(0, stack.get(i).velocity().length());
            }
        }
    }

    /** Its box in the trees is made by the call: it has none yet. */
    @Test
    void whoIsPutToSleepAtBirthIsMetAndWakes() {
        try (PhysicsWorld world = world()) {
            BodyRef box = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.5, 0));
            box.sleep();
            world.validate();
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.3)).at(0, 2, 0));
            Scenes.run(world, 15);
            assertTrue(box.isAsleep(), "nothing has met it");
            Scenes.run(world, 30);
            assertFalse(box.isAsleep(), "the ball woke it");
            assertTrue(ball.position().y > box.position().y + 0.7, "the ball is above it");
        }
    }

    @Test
    void inAWorldWithoutSleepNobodySleeps() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            List<BodyRef> stack = Scenes.stack(world, 2);
            Scenes.run(world, 300);
            assertFalse(stack.get(0).isAsleep());
            IllegalStateException refused =
                    assertThrows(IllegalStateException.class, () -> stack.get(0).sleep());
            assertTrue(refused.getMessage().contains("sleeping(true)"), refused.getMessage());
        }
    }

    @Test
    void aBodyThatMayNotSleepKeepsItsIslandAwake() {
        try (PhysicsWorld world = world()) {
            Scenes.ground(world);
            BodyRef lower =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.5, 0));
            BodyRef upper =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .at(0, 1.5, 0)
                                    .canSleep(false));
            BodyRef alone =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(5, 0.5, 0));
            Scenes.run(world, 300);
            assertFalse(lower.isAsleep());
            assertFalse(upper.isAsleep());
            assertTrue(alone.isAsleep());
        }
    }

    /** tan of the slope is 0.45; friction 0.6 holds the box, 0.3 does not. */
    @Test
    void aBoxThatFrictionHoldsOnASlopeSleepsAndOneThatSlidesDoesNot() {
        double gx = 4;
        double gy = -8.9;
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).gravity(gx, gy, 0).build()) {
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(9000, 1, 50))
                            .at(0, -1, 0)
                            .material(new Material(0.6, 0, 1)));
            BodyRef held =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .at(0, 0.5, 0)
                                    .material(ROUGH));
            Material slick = new Material(0.15, 0, 1000);
            BodyRef slides =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .at(0, 0.5, 5)
                                    .material(slick));
            double seconds = 10;
            for (int tick = 0; tick < 600; tick++) {
                world.step(Scenes.STEP);
                assertFalse(slides.isAsleep());
            }
            assertTrue(held.isAsleep());
            assertEquals(0, held.position().x, 1e-3);
            // mu = sqrt(0.6 * 0.15) = 0.3; x = 1/2 (gx - mu |gy|) t²
            double x = 0.5 * (gx + 0.3 * gy) * seconds * seconds;
            assertEquals(x, slides.position().x, 0.01 * x);
        }
    }

    /** Nothing slows a ball that rolls without slip: a minute later it has gone 60 mm. */
    @Test
    void aBallThatRollsAtAMillimetreASecondIsNotStopped() {
        try (PhysicsWorld world = world()) {
            Scenes.ground(world);
            double speed = 1e-3;
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.5))
                                    .at(0, 0.5, 0)
                                    .velocity(speed, 0, 0)
                                    .angularVelocity(0, 0, -speed / 0.5));
            for (int tick = 0; tick < 3600; tick++) {
                world.step(Scenes.STEP);
                assertFalse(ball.isAsleep(), "tick " + tick);
            }
            assertEquals(60 * speed, ball.position().x, 1e-3 * 60 * speed);
        }
    }

    /** A ball on a point has nothing to stop its spin about the vertical: 2 mm/s at its rim. */
    @Test
    void aBallThatSpinsSlowlyInItsPlaceIsNotStopped() {
        try (PhysicsWorld world = world()) {
            Scenes.ground(world);
            double spin = 0.004;
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.5))
                                    .at(0, 0.5, 0)
                                    .angularVelocity(0, spin, 0));
            for (int tick = 0; tick < 600; tick++) {
                world.step(Scenes.STEP);
                assertFalse(ball.isAsleep(), "tick " + tick);
            }
            assertEquals(spin, ball.angularVelocity().y, 1e-9 * spin);
        }
    }

    /** Friction holds the box against a push of a tenth of its weight, but it is pushed. */
    @Test
    void aBoxThatIsPushedInEachTickDoesNotSleepThoughItDoesNotMove() {
        try (PhysicsWorld world = world()) {
            Scenes.ground(world);
            BodyRef box =
                    world.add(
                            Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).mass(1).at(0, 0.5, 0));
            for (int tick = 0; tick < 300; tick++) {
                box.applyForce(0.981, 0, 0);
                world.step(Scenes.STEP);
                assertFalse(box.isAsleep(), "tick " + tick);
            }
            assertEquals(0, box.position().x, 1e-4);
            Scenes.run(world, 300);
            assertTrue(box.isAsleep(), "nobody pushes any more");
        }
    }

    @Test
    void withoutGravityOnlyWhatDoesNotMoveAtAllSleeps() {
        try (PhysicsWorld world = weightless()) {
            BodyRef still = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0, 0));
            BodyRef drifts =
                    world.add(
                            Body.dynamic().shape(Sphere.of(0.5)).at(5, 0, 0).velocity(0, 1e-9, 0));
            BodyRef turns =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.5))
                                    .at(9, 0, 0)
                                    .angularVelocity(0, 1e-9, 0));
            Scenes.run(world, 600);
            assertTrue(still.isAsleep());
            assertFalse(drifts.isAsleep());
            assertFalse(turns.isAsleep());
            assertEquals(1e-8, drifts.position().y, 1e-16);
        }
    }

    /** At its apex a body is slow for a moment. */
    @Test
    void aBodyThatFallsUnderWeakGravityDoesNotSleepInTheAir() {
        double g = 1e-6;
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).gravity(0, -g, 0).build()) {
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.5))
                                    .at(0, 10, 0)
                                    .velocity(0, 10 * g, 0));
            for (int tick = 0; tick < 1200; tick++) {
                world.step(Scenes.STEP);
                assertFalse(body.isAsleep());
            }
            // up for 10 s and down for 10 s
            assertEquals(10, body.position().y, 1e-9);
        }
    }

    /**
     * The rule has no length in it: scenes that differ by size and gravity sleep at the same tick.
     */
    @Test
    void scenesOfAnySizeSleepAtTheSameTick() {
        int reference = ticksToSleep(1);
        for (double size : new double[] {1.0 / 1024, 64}) {
            assertEquals(reference, ticksToSleep(size), "size " + size);
        }
    }

    private static int ticksToSleep(double size) {
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .workers(1)
                        .gravity(0, -9.8125 * size, 0)
                        .settings(PhysicsSettings.DEFAULT.withRestitutionThreshold(0))
                        .build()) {
            Material plain = new Material(0.6, 0, 1000);
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(50 * size, size, 50 * size))
                            .at(0, -size, 0)
                            .material(plain));
            BodyRef box =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5 * size))
                                    .mass(1)
                                    .at(0, 0.5 * size, 0)
                                    .material(plain));
            for (int tick = 1; tick <= 600; tick++) {
                world.step(Scenes.STEP);
                if (box.isAsleep()) {
                    return tick;
                }
            }
            return -1;
        }
    }

    @Test
    void sleepEventsComeInPairsAndTellOfThoseThatAreRemoved() {
        try (PhysicsWorld world = world()) {
            List<BodyRef> stack = Scenes.stack(world, 3);
            Scenes.run(world, 240);
            assertTrue(Scenes.allAsleep(stack));
            SleepEvents events = world.sleepEvents();
            assertEquals(3, events.asleepCount());
            stack.get(2).remove();
            world.step(Scenes.STEP);
            assertEquals(3, events.wokeCount());
            assertEquals(0, events.fellAsleepCount());
            List<BodyRef> woke = new ArrayList<>();
            for (int i = 0; i < 3; i++) {
                woke.add(events.woke(i));
            }
            assertTrue(woke.containsAll(stack));
            assertFalse(stack.get(2).isAlive());
            // Asleep and awake again between two steps: nothing to tell.
            stack.get(0).sleep();
            assertTrue(stack.get(1).isAsleep(), "the island sleeps as a whole");
            stack.get(1).wake();
            world.step(Scenes.STEP);
            assertEquals(0, events.wokeCount() + events.fellAsleepCount());
        }
    }

    @Test
    void aPileThatSleepsAndWakesByNothingStaysAsItIs() {
        double[] awake = halfASecondAfter(false);
        double[] slept = halfASecondAfter(true);
        for (int i = 0; i < awake.length; i++) {
            assertEquals(awake[i], slept[i], 1e-9, "coordinate " + i);
        }
    }

    /** Where a settled stack is 0.5 s after it slept for 0.5 s, or stayed awake meanwhile. */
    private static double[] halfASecondAfter(boolean sleeps) {
        try (PhysicsWorld world = world()) {
            Scenes.ground(world);
            List<BodyRef> stack = new ArrayList<>();
            for (int i = 0; i < 10; i++) {
                stack.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(0.5))
                                        .at(1e-3 * (i % 3), 0.5 + i, 0)
                                        .canSleep(false)));
            }
            Scenes.run(world, 1200);
            double energy = world.kineticEnergy();
            if (sleeps) {
                stack.get(4).sleep();
                assertTrue(Scenes.allAsleep(stack));
                Scenes.run(world, 30);
                stack.get(7).wake();
            } else {
                Scenes.run(world, 30);
            }
            for (int tick = 0; tick < 30; tick++) {
                world.step(Scenes.STEP);
                assertTrue(world.kineticEnergy() <= 2 * energy + 1e-12, "no jump");
            }
            double[] at = new double[30];
            Vector3d p = new Vector3d();
            for (int i = 0; i < 10; i++) {
                stack.get(i).position(p);
                at[3 * i] = p.x;
                at[3 * i + 1] = p.y;
                at[3 * i + 2] = p.z;
            }
            return at;
        }
    }
}
