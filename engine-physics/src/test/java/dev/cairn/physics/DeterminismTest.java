package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;

/** The same bits for any number of workers, and for helpers that are late. */
class DeterminismTest {

    private interface Scenario {
        long[] run(PhysicsWorld world);
    }

    private static void sameForAllWorkers(Scenario scenario) {
        sameForAllWorkers(false, scenario);
    }

    private static void sameForAllWorkers(boolean sleeping, Scenario scenario) {
        long[] reference = null;
        for (int workers = 1; workers <= 4; workers++) {
            long[] digests;
            try (PhysicsWorld world =
                    PhysicsWorld.builder().sleeping(sleeping).workers(workers).build()) {
                digests = scenario.run(world);
            }
            if (reference == null) {
                reference = digests;
            }
            compare(reference, digests, workers + " workers");
        }
        for (long seed = 1; seed <= 3; seed++) {
            try (Jobs jobs = Jobs.perturbed(3, seed);
                    PhysicsWorld world =
                            PhysicsWorld.builder().sleeping(sleeping).jobs(jobs).build()) {
                compare(reference, scenario.run(world), "perturbed, seed " + seed);
            }
        }
    }

    private static void compare(long[] expected, long[] actual, String what) {
        int tick = Arrays.mismatch(expected, actual);
        assertEquals(-1, tick, what + ": first tick that differs");
    }

    @Test
    void aHeapOfTwoHundredBodies() {
        sameForAllWorkers(world -> {
            Scenes.drop(world, 200, 4711);
            long[] digests = new long[150];
            for (int tick = 0; tick < digests.length; tick++) {
                world.step(Scenes.STEP);
                digests[tick] = world.digest();
            }
            assertTrue(world.contacts().count() > 200, "the heap must have contacts");
            return digests;
        });
    }

    @Test
    void bodiesThatComeAndGoWhileItRuns() {
        sameForAllWorkers(world -> {
            Random random = new Random(815);
            Scenes.ground(world);
            List<BodyRef> bodies = new ArrayList<>();
            long[] digests = new long[200];
            for (int tick = 0; tick < digests.length; tick++) {
                for (int i = 0; i < 2; i++) {
                    bodies.add(world.add(Scenes.any(random, random.nextInt(3))));
                }
                if (bodies.size() > 60) {
                    bodies.remove(random.nextInt(bodies.size())).remove();
                    BodyRef gone = bodies.remove(random.nextInt(bodies.size()));
                    world.ecs().delete(gone.entity());
                }
                if (tick % 20 == 10) {
                    bodies.get(random.nextInt(bodies.size())).teleport(1, 6, 1);
                }
                bodies.get(random.nextInt(bodies.size())).applyForce(0, 500, 30);
                world.step(Scenes.STEP);
                digests[tick] = world.digest();
            }
            assertEquals(bodies.size() + 1, world.bodyCount());
            return digests;
        });
    }

    /** Piles that sleep, are woken by what falls on them, lose bodies, and sleep again. */
    @Test
    void bodiesThatSleepAndWakeWhileOthersComeAndGo() {
        sameForAllWorkers(
                true,
                world -> {
                    Random random = new Random(99);
                    Scenes.ground(world);
                    List<BodyRef> bodies = new ArrayList<>();
                    for (int i = 0; i < 40; i++) {
                        bodies.add(
                                world.add(
                                        Body.dynamic()
                                                .shape(Box.cubeOfHalfExtent(0.25))
                                                .at(0.8 * (i % 10), 0.25 + 0.5 * (i / 10), 0)));
                    }
                    SleepLedger ledger = new SleepLedger();
                    long[] digests = new long[900];
                    for (int tick = 0; tick < digests.length; tick++) {
                        if (tick % 150 == 140) {
                            double x = 8 * random.nextDouble();
                            Body ball = Body.dynamic().shape(Sphere.of(0.2));
                            bodies.add(world.add(ball.at(x, 4, 0).material(Material.WOOD)));
                            bodies.remove(random.nextInt(bodies.size())).remove();
                        }
                        world.step(Scenes.STEP);
                        ledger.note(world);
                        digests[tick] = world.digest();
                    }
                    assertTrue(
                            ledger.fell > 50 && ledger.woke > 40, ledger.fell + " " + ledger.woke);
                    return digests;
                });
    }

    /** For each body sleep and waking alternate, as do begin and end of each touch. */
    private static final class SleepLedger {
        final Set<BodyRef> asleep = new HashSet<>();
        final Set<List<BodyRef>> touching = new HashSet<>();
        int fell;
        int woke;

        void note(PhysicsWorld world) {
            SleepEvents sleep = world.sleepEvents();
            for (int i = 0; i < sleep.wokeCount(); i++) {
                assertTrue(asleep.remove(sleep.woke(i)), "woke without having slept");
                woke++;
            }
            for (int i = 0; i < sleep.fellAsleepCount(); i++) {
                assertTrue(asleep.add(sleep.fellAsleep(i)), "fell asleep twice");
                fell++;
            }
            assertEquals(asleep.size(), sleep.asleepCount());
            for (BodyRef body : world.bodies()) {
                assertEquals(asleep.contains(body), body.isAsleep());
            }
            Contacts contacts = world.contacts();
            for (int i = 0; i < contacts.ended().count(); i++) {
                List<BodyRef> pair = List.of(contacts.ended().bodyA(i), contacts.ended().bodyB(i));
                assertTrue(touching.remove(pair), "a touch ended that had not begun");
            }
            for (int i = 0; i < contacts.began().count(); i++) {
                List<BodyRef> pair = List.of(contacts.began().bodyA(i), contacts.began().bodyB(i));
                assertTrue(touching.add(pair), "a touch began twice");
            }
            int count = 0;
            for (int i = 0; i < contacts.count(); i++) {
                count += contacts.touching(i) ? 1 : 0;
            }
            assertEquals(touching.size(), count);
        }
    }

    @Test
    void theDigestSeesOneBit() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            BodyRef crate = Scenes.stack(world, 2).get(1);
            world.step(Scenes.STEP);
            long before = world.digest();
            double vx = crate.velocity().x;
            crate.setVelocity(vx + Double.MIN_VALUE, crate.velocity().y, crate.velocity().z);
            if (crate.velocity().x != vx) {
                assertNotEquals(before, world.digest());
            }
            crate.setVelocity(1, 2, 3);
            assertNotEquals(before, world.digest());
        }
    }
}
