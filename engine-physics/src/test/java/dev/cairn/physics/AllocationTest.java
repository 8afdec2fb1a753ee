package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.mesh.Grounds;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;
import dev.cairn.physics.support.StringConstants;
import dev.cairn.physics.tuning.Precision;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.URISyntaxException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.IntConsumer;

/** A steady tick allocates nothing, on no thread. */
class AllocationTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    @BeforeAll
    static void makeStringConstants() throws IOException, URISyntaxException {
        StringConstants.make(Jobs.class);
        StringConstants.make(PhysicsWorld.class);
        StringConstants.make(AllocationTest.class);
    }

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
            Scenes.column(world, 40, 0);
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
     * Everything at once that is told or asked: listeners that are told of shapes, bodies, hits and
     * sensors, a hook, a question for pairs, filters that change while the world runs, belts,
     * polled lists and sleep. Balls bounce without end on each other's layer or through it, bodies
     * of two shapes are thrown up again and again.
     */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void listenersHooksSensorsAndFiltersAtOnce(boolean sleeping) {
        try (PhysicsWorld world = scalar().sleeping(sleeping).workers(2).build()) {
            Counter told = new Counter();
            world.contacts().listen(told);
            world.contacts().listen(new Counter());
            world.contacts().setHitSpeed(.1);
            world.collisions()
                    .setHook(contact -> {
                        contact.remember(contact.memory() + 1);
                        if (contact.friction() > 0) { // not those that bounce
                            contact.surface(.5 * contact.friction(), .1);
                        }
                    });
            world.collisions().setPairFilter((a, b) -> a.userData() == b.userData());
            Scenes.ground(world);
            Filter[] filters = {new Filter(1, 3), new Filter(2, 1)};
            List<BodyRef> thrown = new ArrayList<>();
            for (int i = 0; i < 8; i++) {
                Collider half = Collider.of(Box.cubeOfHalfExtent(.3)).filter(filters[i % 2]);
                thrown.add(
                        world.add(
                                Body.dynamic()
                                        .collider(half.at(-.3, 0, 0))
                                        .collider(half.at(.3, 0, 0))
                                        .at(2 * (i / 2), .4 + .7 * (i % 2), 5)));
            }
            Collider belt = Collider.of(Box.ofHalfExtents(3, .1, 1)).surfaceVelocity(.5, 0, 0);
            world.add(Body.fixed().collider(belt).at(0, .1, 12));
            for (int i = 0; i < 4; i++) {
                world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.2)).at(-i, .4, 12));
            }
            Material lively = new Material(0, 1, 1000);
            world.add(Body.fixed().shape(Box.ofHalfExtents(2, .1, 2)).at(0, 9, 0).material(lively));
            Collider gate = Collider.of(Box.ofHalfExtents(2, .5, 2)).sensor(true);
            world.add(Body.fixed().collider(gate).at(0, 12, 0));
            for (int i = 0; i < 3; i++) {
                world.add(
                        Body.dynamic()
                                .shape(Sphere.of(.2))
                                .at(i - 1, 12.5, 0)
                                .gravityScale(.5)
                                .material(lively));
            }
            int[] polled = new int[1];
            measure(
                    world,
                    900,
                    tick -> {
                        polled[0] += poll(world);
                        if (tick % 20 == 0) {
                            BodyRef body = thrown.get(tick / 20 % thrown.size());
                            body.setVelocity(0, 4, 0);
                            body.setFilter(filters[tick / 160 % 2]);
                        }
                    });
            for (int kind = 0; kind < told.counts.length; kind++) {
                assertTrue(told.counts[kind] > 10, "kind " + kind + ": " + told.counts[kind]);
            }
            assertTrue(polled[0] > 0);
        }
    }

    /** How much there is to see after a tick. */
    private static int poll(PhysicsWorld world) {
        Contacts contacts = world.contacts();
        int seen = contacts.count() + contacts.began().count() + contacts.ended().count();
        seen += contacts.bodiesBegan().count() + contacts.bodiesEnded().count();
        seen += contacts.hits().count() + contacts.bodiesHit().count();
        seen += contacts.entered().count() + contacts.left().count();
        for (int i = 0; i < contacts.bodiesHit().count(); i++) {
            seen += contacts.bodiesHit().bodyA(i).isAlive() ? 1 : 0;
        }
        return seen + world.sleepEvents().wokeCount();
    }

    /** How often each kind of event was told. */
    private static final class Counter implements ContactListener {
        final int[] counts = new int[8];

        @Override
        public void began(ColliderRef a, ColliderRef b) {
            counts[0]++;
        }

        @Override
        public void ended(ColliderRef a, ColliderRef b) {
            counts[1]++;
        }

        @Override
        public void bodiesBegan(BodyRef a, BodyRef b) {
            counts[2]++;
        }

        @Override
        public void bodiesEnded(BodyRef a, BodyRef b) {
            counts[3]++;
        }

        @Override
        public void hit(Contacts.Hits hits, int hit) {
            counts[4] += hits.approachSpeed(hit) > 0 ? 1 : 0;
        }

        @Override
        public void bodiesHit(Contacts.Hits hits, int hit) {
            counts[5] += hits.impulse(hit) > 0 ? 1 : 0;
        }

        @Override
        public void entered(ColliderRef sensor, ColliderRef visitor) {
            counts[6]++;
        }

        @Override
        public void left(ColliderRef sensor, ColliderRef visitor) {
            counts[7]++;
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

    /** Room for rows to leave is made when there are rows: it came with the first that left. */
    @Test
    void theFirstContactThatPartsAllocatesNothing() {
        // the first world links the methods
        bytesOfParting();
        assertEquals(0, bytesOfParting(), "bytes in the ticks in which a contact parts");
    }

    private static long bytesOfParting() {
        try (PhysicsWorld world = scalar().sleeping(false).workers(1).build()) {
            Scenes.stack(world, 3);
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.2)).at(5, 0.2, 0));
            for (int tick = 0; tick < 100; tick++) {
                world.step(Scenes.STEP);
            }
            ball.setVelocity(0, 20, 0);
            long bytes = 0;
            for (int tick = 0; tick < 20; tick++) {
                long before = THREADS.getCurrentThreadAllocatedBytes();
                world.step(Scenes.STEP);
                bytes += THREADS.getCurrentThreadAllocatedBytes() - before;
            }
            return bytes;
        }
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
        long[] reading = new long[ids.length];
        Arrays.fill(least, Long.MAX_VALUE);
        Arrays.fill(reading, Long.MAX_VALUE);
        for (int round = 0; round < 3; round++) {
            long[] before = THREADS.getThreadAllocatedBytes(ids);
            long[] again = THREADS.getThreadAllocatedBytes(ids);
            for (int tick = 0; tick < 300; tick++) {
                eachTick.accept(tick);
                world.step(Scenes.STEP);
            }
            long[] after = THREADS.getThreadAllocatedBytes(ids);
            for (int worker = 0; worker < ids.length; worker++) {
                reading[worker] = Math.min(reading[worker], again[worker] - before[worker]);
                least[worker] = Math.min(least[worker], after[worker] - again[worker]);
            }
        }
        assertArrayEquals(reading, least, "bytes of a reading, and of 300 ticks, by worker");
    }
}
