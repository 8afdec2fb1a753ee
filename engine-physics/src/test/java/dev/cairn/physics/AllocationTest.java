package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.mesh.Grounds;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.tuning.Precision;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.IntConsumer;

/** A steady tick allocates nothing, on no thread. */
class AllocationTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    /**
     * Learns which threads the workers are: each must take one block, because it waits for the
     * others.
     */
    private static long[] threadsOf(Jobs jobs) {
        int workers = jobs.workers();
        long[] ids = new long[workers];
        CountDownLatch all = new CountDownLatch(workers);
        BlockJob job =
                (block, worker) -> {
                    ids[worker] = Thread.currentThread().threadId();
                    all.countDown();
                    try {
                        all.await();
                    } catch (InterruptedException interrupted) {
                        throw new AssertionError(interrupted);
                    }
                };
        jobs.run(job, workers);
        return ids;
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void aStackAtRest(int workers) {
        try (PhysicsWorld world = scalar().sleeping(false).workers(workers).build()) {
            Scenes.stack(world, 8);
            measure(world, 600);
        }
    }

    /** Long and slender: its contacts are solved directly. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void aTallColumn(int workers) {
        try (PhysicsWorld world = scalar().sleeping(false).workers(workers).build()) {
            Scenes.ground(world);
            DirectTest.column(world, 40, 0);
            measure(world, 600);
        }
    }

    @Test
    void aHeapAtRest() {
        try (PhysicsWorld world = scalar().sleeping(false).workers(2).build()) {
            Scenes.drop(world, 60, 3);
            measure(world, 1500);
        }
    }

    @Test
    void aHeapAtRestInSinglePrecision() {
        PhysicsSettings settings =
                PhysicsSettings.DEFAULT.withLanes(1).withPrecision(Precision.SINGLE);
        try (PhysicsWorld world =
                PhysicsWorld.builder().settings(settings).sleeping(false).workers(2).build()) {
            Scenes.drop(world, 60, 3);
            measure(world, 1500);
        }
    }

    /** Balls that roll, and stop one after the other; boxes beside them. */
    @Test
    void aHeapWithRollingFriction() {
        for (Precision precision : new Precision[] {Precision.DOUBLE, Precision.SINGLE}) {
            PhysicsSettings settings =
                    PhysicsSettings.DEFAULT.withLanes(1).withPrecision(precision);
            try (PhysicsWorld world =
                    PhysicsWorld.builder().settings(settings).sleeping(false).workers(2).build()) {
                Scenes.drop(world, 60, 3);
                for (int i = 0; i < 20; i++) {
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.2))
                                    .at(12, 0.2, i)
                                    .velocity(0.5 + 0.1 * i, 0, 0)
                                    .material(Material.DEFAULT.withRollingArm(1e-3)));
                }
                measure(world, 1500);
            }
        }
    }

    /** On hills of triangles, pushed now and then. */
    @Test
    void aHeapOnTriangles() {
        try (PhysicsWorld world = scalar().sleeping(false).workers(2).build()) {
            List<BodyRef> bodies = Grounds.drop(world, 40, 3);
            measure(
                    world,
                    900,
                    tick -> {
                        if (tick % 100 == 0) {
                            BodyRef body = bodies.get(tick / 100 % bodies.size());
                            body.applyImpulse(10, 20, 5);
                        }
                    });
        }
    }

    @Test
    void everyKindOnEveryKindAtRest() {
        try (PhysicsWorld world = scalar().sleeping(false).workers(2).build()) {
            Scenes.everyKindOnEveryKind(world);
            measure(world, 600);
        }
    }

    /** It falls asleep, is woken by a push, and falls asleep again. */
    @Test
    void aStackThatSleepsAndIsWoken() {
        try (PhysicsWorld world = scalar().workers(2).build()) {
            BodyRef top = Scenes.stack(world, 4).get(3);
            measure(
                    world,
                    900,
                    tick -> {
                        if (tick % 150 == 0) {
                            top.applyImpulse(0, 1, 0);
                        }
                    });
        }
    }

    /** Bodies of two colliders, a hook, hits, a listener, and a ball that bounces in a sensor. */
    @Test
    void collidersHooksSensorsAndListeners() {
        try (PhysicsWorld world = scalar().sleeping(false).workers(2).build()) {
            Scenes.ground(world);
            world.collisions().setHook(contact -> contact.remember(contact.memory() + 1));
            world.contacts().setHitSpeed(.1);
            int[] told = new int[2];
            world.contacts()
                    .listen(
                            new ContactListener() {
                                @Override
                                public void hit(Contacts.Hits hits, int hit) {
                                    told[0] += hits.approachSpeed(hit) > 0 ? 1 : 0;
                                }

                                @Override
                                public void entered(ColliderRef sensor, ColliderRef visitor) {
                                    told[1]++;
                                }
                            });
            for (int i = 0; i < 8; i++) {
                world.add(
                        Body.dynamic()
                                .collider(Collider.of(Box.cubeOfHalfExtent(.3)).at(-.3, 0, 0))
                                .collider(Collider.of(Box.cubeOfHalfExtent(.3)).at(.3, 0, 0))
                                .at(2 * i, .4 + .7 * (i % 2), 5));
            }
            Material lively = new Material(0, 1, 1000);
            world.add(Body.fixed().shape(Box.ofHalfExtents(2, .1, 2)).at(0, 9, 0).material(lively));
            world.add(
                    Body.fixed()
                            .collider(Collider.of(Box.ofHalfExtents(2, .5, 2)).sensor(true))
                            .at(0, 12, 0));
            world.add(
                    Body.dynamic()
                            .shape(Sphere.of(.2))
                            .at(0, 12.5, 0)
                            .gravityScale(.5)
                            .material(lively));
            measure(world, 900);
            assertTrue(told[0] > 10 && told[1] > 10, told[0] + " hits, " + told[1] + " entered");
        }
    }

    /**
     * A world without lanes. Other tests in this JVM try several numbers of them, and leave type
     * profiles behind with which the Vector API's vectors are objects; the system tests measure
     * lanes in a JVM of their own.
     */
    private static PhysicsWorldBuilder scalar() {
        return PhysicsWorld.builder().settings(PhysicsSettings.DEFAULT.withLanes(1));
    }

    private static void measure(PhysicsWorld world, int warmUp) {
        measure(world, warmUp, tick -> {});
    }

    private static void measure(PhysicsWorld world, int warmUp, IntConsumer eachTick) {
        long[] ids = threadsOf(world.ecs().jobs());
        for (int tick = 0; tick < warmUp; tick++) {
            eachTick.accept(tick);
            world.step(Scenes.STEP);
        }
        // A path that is taken for the first time may link a method once; what a tick allocates
        // shows in every round.
        long[] least = new long[ids.length];
        Arrays.fill(least, Long.MAX_VALUE);
        for (int round = 0; round < 3; round++) {
            long[] before = THREADS.getThreadAllocatedBytes(ids);
            long[] again = THREADS.getThreadAllocatedBytes(ids);
            for (int tick = 0; tick < 300; tick++) {
                eachTick.accept(tick);
                world.step(Scenes.STEP);
            }
            long[] after = THREADS.getThreadAllocatedBytes(ids);
            for (int worker = 0; worker < ids.length; worker++) {
                long reading = again[worker] - before[worker];
                least[worker] = Math.min(least[worker], after[worker] - again[worker] - reading);
            }
        }
        assertArrayEquals(new long[ids.length], least, "bytes in 300 ticks, by worker");
    }
}
