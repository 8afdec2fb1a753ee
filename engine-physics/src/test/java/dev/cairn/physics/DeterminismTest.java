package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** The same bits for any number of workers, and for helpers that are late. */
class DeterminismTest {

    private interface Scenario {
        long[] run(PhysicsWorld world);
    }

    private static void sameForAllWorkers(Scenario scenario) {
        long[] reference = null;
        for (int workers = 1; workers <= 4; workers++) {
            long[] digests;
            try (PhysicsWorld world = Scenes.awake().workers(workers).build()) {
                digests = scenario.run(world);
            }
            if (reference == null) {
                reference = digests;
            }
            compare(reference, digests, workers + " workers");
        }
        for (long seed = 1; seed <= 3; seed++) {
            try (Jobs jobs = Jobs.perturbed(3, seed);
                    PhysicsWorld world = Scenes.awake().jobs(jobs).build()) {
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
