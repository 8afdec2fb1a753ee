package dev.cairn.physics.island;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Waking: who wakes whom, when, and that nobody can tell from the motion that there was sleep. */
class WakeTest {
    private static PhysicsWorld world() {
        return PhysicsWorld.builder().workers(1).build();
    }

    /** Two boxes on each other, and a third far away. */
    private static final class Pair implements AutoCloseable {
        final PhysicsWorld world = world();
        final BodyRef ground = Scenes.ground(world);
        final BodyRef table =
                world.add(
                        Body.fixed()
                                .shape(Box.ofHalfExtents(1, 0.5, 1))
                                .at(0, 0.5, 0)
                                .name("table"));
        final BodyRef lower =
                world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 1.5, 0));
        final BodyRef upper =
                world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 2.5, 0));
        final BodyRef far =
                world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(20, 0.5, 0));

        Pair() {
            Scenes.run(world, 300);
            assertTrue(Scenes.allAsleep(List.of(lower, upper, far)));
        }

        @Override
        public void close() {
            world.close();
        }
    }

    private static void wakes(Consumer<Pair> deed) {
        try (Pair pair = new Pair()) {
            deed.accept(pair);
            pair.world.step(Scenes.STEP);
            assertFalse(pair.lower.isAsleep(), "lower");
            assertFalse(pair.upper.isAsleep(), "upper");
            assertTrue(pair.far.isAsleep(), "a box far away");
            assertEquals(2, pair.world.sleepEvents().wokeCount());
        }
    }

    private static void leavesAsleep(Consumer<Pair> deed) {
        try (Pair pair = new Pair()) {
            deed.accept(pair);
            Scenes.run(pair.world, 3);
            assertTrue(Scenes.allAsleep(List.of(pair.lower, pair.upper, pair.far)));
        }
    }

    @Test
    void whateverTheUserChangesWakes() {
        wakes(p -> p.upper.applyForce(1, 0, 0));
        wakes(p -> p.upper.applyForceAt(0, 0, 1, 0, 2, 0));
        wakes(p -> p.lower.applyTorque(0, 1, 0));
        wakes(p -> p.upper.applyImpulse(0, 0, 1e-6));
        wakes(p -> p.upper.applyImpulseAt(0, 0, 1e-6, 0, 2, 0));
        wakes(p -> p.upper.applyAngularImpulse(0, 0, 1e-6));
        wakes(p -> p.upper.setVelocity(0, 1, 0));
        wakes(p -> p.upper.setAngularVelocity(0, 1, 0));
        wakes(p -> p.upper.teleport(0, 2.6, 0));
        wakes(p -> p.upper.teleport(0, 2.5, 0, new Quaterniond().rotateY(0.1)));
        wakes(p -> p.lower.wake());
    }

    @Test
    void whatChangesNothingDoesNot() {
        leavesAsleep(p -> p.upper.applyForce(0, 0, 0));
        leavesAsleep(p -> p.upper.applyImpulse(0, 0, 0));
        leavesAsleep(p -> p.upper.setVelocity(0, 0, 0));
        leavesAsleep(p -> p.world.setGravity(0, -9.81, 0));
        leavesAsleep(p -> p.far.position());
    }

    @Test
    void anotherGravityWakesAll() {
        try (Pair pair = new Pair()) {
            pair.world.setGravity(0, -1.6, 0);
            pair.world.step(Scenes.STEP);
            assertEquals(0, pair.world.sleepEvents().asleepCount());
        }
    }

    @Test
    void whoLosesASupportWakesAndFalls() {
        wakes(p -> p.table.remove());
        wakes(p -> p.table.teleport(0, 0.5, 30));
        wakes(p -> p.table.teleport(0, 0.499, 0));
        try (Pair pair = new Pair()) {
            Vector3d before = pair.upper.position();
            pair.table.remove();
            Scenes.run(pair.world, 12);
            // free fall for 0.2 s
            assertEquals(before.y - 0.5 * 9.81 * 0.04, pair.upper.position().y, 1e-2);
        }
        try (Pair pair = new Pair()) {
            pair.lower.remove();
            pair.world.step(Scenes.STEP);
            assertFalse(pair.upper.isAsleep(), "its support was a body asleep");
            assertTrue(pair.far.isAsleep());
        }
    }

    /** Catalogue B13, asleep: what the solver knew of the load must survive the sleep. */
    @Test
    void aLoadThatIsTakenOffASleepingColumnLeavesItAtRest() {
        try (PhysicsWorld world = world()) {
            Scenes.ground(world);
            List<BodyRef> column = new ArrayList<>();
            for (int i = 0; i < 5; i++) {
                column.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(0.5))
                                        .mass(1)
                                        .at(0, 0.5 + i, 0)));
            }
            BodyRef load =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .mass(100)
                                    .at(0, 5.5, 0));
            Scenes.run(world, 600);
            assertTrue(Scenes.allAsleep(column) && load.isAsleep(), "all sleep");
            double[] before = new double[5];
            for (int i = 0; i < 5; i++) {
                before[i] = column.get(i).position().y;
            }
            load.remove();
            Vector3d velocity = new Vector3d();
            for (int tick = 0; tick < 60; tick++) {
                world.step(Scenes.STEP);
                for (int i = 0; i < 5; i++) {
                    column.get(i).velocity(velocity);
                    assertTrue(velocity.y < 0.02, "box " + i + " jumps at " + velocity.y);
                    assertEquals(before[i], column.get(i).position().y, 1e-3);
                }
            }
        }
    }

    @Test
    void aFixedBodyThatComesWakesWhomItTouchesOnly() {
        wakes(p -> p.world.add(Body.fixed().shape(Box.cubeOfHalfExtent(0.5)).at(0.95, 2.5, 0)));
        leavesAsleep(
                p -> p.world.add(Body.fixed().shape(Box.cubeOfHalfExtent(0.5)).at(1.05, 2.5, 0)));
        leavesAsleep(p -> p.world.add(Body.fixed().shape(Box.cubeOfHalfExtent(0.5)).at(5, 0.5, 0)));
    }

    @Test
    void anAwakeBodyInsideOneAsleepWakesIt() {
        wakes(p ->
                p.world.add(Body.dynamic().shape(Sphere.of(0.2)).at(0, 2.5, 0).name("in the box")));
    }

    /** A hundred boxes in a row touch each other; a ball strikes the first. */
    @Test
    void aChainOfAHundredWakesInTheTickOfTheHit() {
        try (PhysicsWorld world = world()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(200, 1, 200)).at(0, -1, 0));
            List<BodyRef> chain = new ArrayList<>();
            for (int i = 0; i < 100; i++) {
                chain.add(world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(i, 0.5, 0)));
            }
            Scenes.run(world, 240);
            assertTrue(Scenes.allAsleep(chain));
            world.add(Body.dynamic().shape(Sphere.of(0.4)).at(-3, 0.5, 0).velocity(20, 0, 0));
            for (int tick = 0; tick < 60; tick++) {
                world.step(Scenes.STEP);
                int woke = world.sleepEvents().wokeCount();
                if (woke > 0) {
                    assertEquals(100, woke);
                    assertTrue(
                            world.contacts().began().count() == 1 || tick < 8,
                            "the hit is in the tick of the waking, or in the next");
                    return;
                }
            }
            throw new AssertionError("nobody woke");
        }
    }

    /**
     * The ball flies to the hit as where nothing sleeps, bit for bit, and leaves the tick of the
     * hit with the same velocity to a thousandth. What the collapse makes of the rest is not
     * compared.
     */
    @Test
    void aBallThatHitsASleepingPileMeetsTheSamePile() {
        Hit awake = new Hit(false);
        Hit asleep = new Hit(true);
        double speed = Hit.SPEED;
        int hit = 0;
        while (awake.ball[0][hit] == speed) {
            hit++;
        }
        assertTrue(awake.ball[0][hit] < 0.5 * speed, "there was a hit");
        for (int tick = 0; tick <= hit; tick++) {
            double bound = tick < hit ? 0 : 1e-3 * speed;
            for (int i = 0; i < awake.ball.length; i++) {
                double difference = Math.abs(awake.ball[i][tick] - asleep.ball[i][tick]);
                assertTrue(difference <= bound, "tick " + tick + ": " + difference);
            }
        }
        assertEquals(10, asleep.wokeAtOnce, "the pile wakes as a whole");
    }

    /** A ball thrown at a pyramid that has stood for 20 s, and slept the last 0.5 s or not. */
    private static final class Hit {
        static final int TICKS = 40;
        static final double SPEED = 15;
        int wokeAtOnce;
        final double[][] ball = new double[6][TICKS];

        Hit(boolean sleeps) {
            try (PhysicsWorld world = world();
                    PhysicsWorld empty = world()) {
                Scenes.ground(world);
                List<BodyRef> boxes = new ArrayList<>();
                for (int i = 0; i < 4; i++) {
                    for (int j = i; j < 4; j++) {
                        double x = 0.5 * i + (j - i);
                        boxes.add(
                                world.add(
                                        Body.dynamic()
                                                .shape(Box.cubeOfHalfExtent(0.5))
                                                .at(x, 0.5 + i, 0)
                                                .canSleep(false)));
                    }
                }
                Scenes.run(world, 1200);
                if (sleeps) {
                    boxes.forEach(BodyRef::sleep);
                }
                Scenes.run(world, 30);
                assertEquals(sleeps, Scenes.allAsleep(boxes));
                Body thrown =
                        Body.dynamic().shape(Sphere.of(0.4)).at(-6, 2, 0.1).velocity(SPEED, 1, 0);
                BodyRef one = world.add(thrown);
                BodyRef free = empty.add(thrown);
                boolean before = true;
                Vector3d p = new Vector3d();
                Vector3d q = new Vector3d();
                for (int tick = 0; tick < TICKS; tick++) {
                    world.step(Scenes.STEP);
                    empty.step(Scenes.STEP);
                    one.position(p);
                    free.position(q);
                    before &= one.position(p).x < -1.2;
                    if (before) {
                        assertEquals(q, p, "before the hit it flies freely");
                        assertEquals(sleeps, Scenes.allAsleep(boxes));
                    }
                    wokeAtOnce = Math.max(wokeAtOnce, world.sleepEvents().wokeCount());
                    one.velocity(q);
                    ball[0][tick] = q.x;
                    ball[1][tick] = q.y;
                    ball[2][tick] = q.z;
                    ball[3][tick] = p.x;
                    ball[4][tick] = p.y;
                    ball[5][tick] = p.z;
                }
            }
        }
    }

    @Test
    void aBodyAsleepThatIsPushedBeyondNumbersIsQuarantined() {
        try (Pair pair = new Pair()) {
            pair.upper.applyForce(1e300, 0, 0);
            Scenes.run(pair.world, 30);
            assertEquals(List.of(pair.upper), pair.world.quarantined());
            assertTrue(Double.isFinite(pair.lower.position().y));
            Scenes.run(pair.world, 300);
            assertTrue(pair.lower.isAsleep(), "what is left sleeps again");
        }
    }
}
