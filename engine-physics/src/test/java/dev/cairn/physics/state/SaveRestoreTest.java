package dev.cairn.physics.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.WorldSystem;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.state.StateException;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.PhysicsWorldBuilder;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;

/** A world that is restored goes on as the one that was saved did, whatever happened in between. */
@Tag("compiled")
class SaveRestoreTest {
    private static final double STEP = 1.0 / 60;

    private static PhysicsWorldBuilder builder() {
        return PhysicsWorld.builder().workers(1);
    }

    private static PhysicsWorld world() {
        PhysicsWorld world = builder().build();
        world.add(Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).at(0, -1, 0));
        return world;
    }

    private static void steps(PhysicsWorld world, int count) {
        for (int i = 0; i < count; i++) {
            world.step(STEP);
        }
    }

    private static List<Long> digests(PhysicsWorld world, int count) {
        List<Long> digests = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            digests.add(world.digest());
            world.step(STEP);
        }
        return digests;
    }

    /** A mass that was given stays when the shape changes; one that was not follows the shape. */
    @Test
    void whichMassesWereGiven() {
        try (PhysicsWorld world = world();
                PhysicsWorld other = world()) {
            BodyRef first = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 1, 0));
            BodyRef last = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(4, 1, 0));
            WorldState none = world.save();
            double own = first.mass();
            last.setMass(7);
            WorldState given = world.save();
            first.setShape(Box.cubeOfHalfExtent(1));
            last.setShape(Box.cubeOfHalfExtent(1));
            assertEquals(8 * own, first.mass(), 1e-9 * own);
            assertEquals(7, last.mass());
            world.restore(none);
            last.setShape(Box.cubeOfHalfExtent(1));
            assertEquals(8 * own, last.mass(), 1e-9 * own, "it was not given in that state");
            world.restore(given);
            first.setShape(Box.cubeOfHalfExtent(1));
            last.setShape(Box.cubeOfHalfExtent(1));
            assertEquals(8 * own, first.mass(), 1e-9 * own);
            assertEquals(7, last.mass(), "it was given in that state");
            other.restore(given);
            BodyRef copy = other.bodies().get(2);
            copy.setShape(Box.cubeOfHalfExtent(1));
            assertEquals(7, copy.mass(), "in another world too");
        }
    }

    /** Saves now; whatever is done then, the future is what it was, here and in another world. */
    private static void holds(PhysicsWorld world, int ticks, Runnable meddling) {
        WorldState state = world.save();
        List<Long> future = digests(world, ticks);
        meddling.run();
        steps(world, 5);
        world.restore(state);
        assertEquals(future, digests(world, ticks), "in the same world");
        try (PhysicsWorld other =
                builder().workers(2).settings(world.settings().withLanes(4)).build()) {
            other.restore(state);
            assertEquals(future, digests(other, ticks), "in another world");
        }
    }

    private static BodyRef box(PhysicsWorld world, double x, double y) {
        return world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(x, y, 0));
    }

    @Test
    void aStackThatFallsAsleepAndIsWoken() {
        try (PhysicsWorld world = world()) {
            BodyRef top = null;
            for (int i = 0; i < 4; i++) {
                top = box(world, 0, 0.5 + i);
            }
            BodyRef last = top;
            steps(world, 20);
            holds(world, 120, () -> last.applyImpulse(100, 0, 0)); // falls asleep meanwhile
            steps(world, 200);
            assertTrue(last.isAsleep());
            holds(world, 20, () -> box(world, 0, 4.4));
            world.add(Body.dynamic().shape(Sphere.of(0.3)).at(-6, 2, 0).velocity(12, 0, 0));
            holds(world, 100, () -> world.setGravity(0, -3, 0)); // the ball wakes it
        }
    }

    @Test
    void removalAndNewBodiesInTheirSlots() {
        try (PhysicsWorld world = world()) {
            List<BodyRef> all = new ArrayList<>();
            for (int i = 0; i < 8; i++) {
                all.add(box(world, 1.5 * i, 0.6));
            }
            steps(world, 10);
            all.get(2).remove();
            all.get(5).remove();
            holds(world, 30, () -> box(world, 3, 3)); // removed, and not yet gone
            steps(world, 1);
            box(world, 3, 2);
            WorldState state = world.save();
            BodyRef later = box(world, 7.5, 2);
            steps(world, 3);
            world.restore(state);
            assertFalse(later.isAlive(), "was never there");
            assertTrue(all.get(0).isAlive());
            assertFalse(all.get(2).isAlive());
            BodyRef again = box(world, 7.5, 2);
            assertEquals(later.entity(), again.entity(), "ids are given again");
        }
    }

    @Test
    void jointsWithMotorsThatBreak() {
        try (PhysicsWorld world = world()) {
            BodyRef a = world.add(Body.fixed().shape(Box.cubeOfHalfExtent(0.2)).at(0, 6, 0));
            BodyRef b =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(0.6, 0.1, 0.1)).at(0.6, 6, 0));
            BodyRef c = world.add(Body.dynamic().shape(Sphere.of(0.3)).at(1.4, 6, 0));
            JointRef hinge = world.add(Joint.hinge(a, b).at(0, 6, 0).axis(0, 0, 1).motor(2, 500));
            JointRef rod = world.add(Joint.ball(b, c).at(1.2, 6, 0).breakAt(500, 1e9));
            steps(world, 5);
            WorldState state = world.save();
            List<Long> future = digests(world, 90);
            hinge.motor(JointAxis.TWIST, -3, 800);
            rod.remove();
            world.add(Joint.ball(b, c).at(b.position().x, b.position().y, 0));
            steps(world, 10);
            world.restore(state);
            assertTrue(rod.isAlive());
            assertEquals(future, digests(world, 90));
            try (PhysicsWorld fork = world.fork()) {
                fork.restore(state);
                assertEquals(2, fork.joints().count());
                fork.joints().all().get(0).motor(JointAxis.TWIST, -3, 800);
                world.restore(state);
                hinge.motor(JointAxis.TWIST, -3, 800);
                assertEquals(digests(world, 60), digests(fork, 60), "a motor in a fork");
            }
            world.restore(state);
            c.applyImpulse(0, -400, 0);
            int ticks = 0;
            while (world.joints().brokenCount() == 0 && ticks++ < 60) {
                world.step(STEP);
            }
            assertSame(rod, world.joints().broken(0), "after " + ticks + " ticks");
            WorldState broken = world.save();
            List<Long> fall = digests(world, 30);
            world.restore(broken);
            assertSame(rod, world.joints().broken(0));
            assertEquals(fall, digests(world, 30));
        }
    }

    @Test
    void referencesEventsAndComponentsComeBack() {
        try (PhysicsWorld world = world()) {
            BodyRef box = box(world, 0, 0.45);
            box.setUserData("mine");
            BodyRef pushed =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.5))
                                    .with(new Force(3, 0, 0))
                                    .at(4, 0.5, 0)
                                    .name("ball"));
            ColliderRef only = box.colliders().get(0);
            world.step(STEP);
            int began = world.contacts().began().count();
            assertTrue(began > 0, "events to be saved");
            WorldState state = world.save();
            ColliderRef added = box.add(Collider.of(Sphere.of(0.2)).at(0, 0.7, 0));
            box.setUserData("other");
            steps(world, 10);
            assertEquals(0, world.contacts().began().count());
            world.restore(state);
            assertEquals(began, world.contacts().began().count());
            assertSame(only, box.colliders().get(0));
            assertTrue(only.isAlive());
            assertFalse(added.isAlive(), "was never there");
            assertEquals("mine", box.userData());
            assertEquals(1, world.ecs().tickNumber());
            try (PhysicsWorld fork = world.fork()) {
                BodyRef twin = fork.bodyOf(pushed.entity());
                assertNotSame(pushed, twin);
                assertEquals("ball", twin.name());
                assertEquals(began, fork.contacts().began().count());
                assertEquals(new Force(3, 0, 0), fork.ecs().get(twin.entity(), Force.COMPONENT));
                assertSame(twin, fork.bodyOf(pushed.entity()));
                fork.restore(state);
                assertSame(twin, fork.bodyOf(pushed.entity()), "references of a fork last, too");
                twin.remove();
                steps(fork, 2);
                assertTrue(pushed.isAlive());
                assertEquals(digests(world, 20), restored(fork, state, 20));
            }
        }
    }

    private static List<Long> restored(PhysicsWorld world, WorldState state, int ticks) {
        world.restore(state);
        return digests(world, ticks);
    }

    @Test
    void aKinematicBodyOnItsWay() {
        try (PhysicsWorld world = world()) {
            BodyRef lift =
                    world.add(Body.kinematic().shape(Box.ofHalfExtents(1, 0.1, 1)).at(0, 0.3, 0));
            box(world, 0, 0.95);
            steps(world, 10);
            lift.moveTo(0, 0.35, 0);
            holds(world, 20, () -> lift.moveTo(1, 0.35, 0));
            world.step(STEP);
            holds(world, 20, () -> {}); // it has arrived, and stops in the next tick
        }
    }

    @Test
    void forksStepBesideEachOther() {
        try (PhysicsWorld world = world();
                Jobs jobs = Jobs.of(2)) {
            for (int i = 0; i < 10; i++) {
                box(world, 0.3 * i, 1 + 1.2 * i);
            }
            steps(world, 30);
            try (PhysicsWorld fork = world.fork(jobs)) {
                assertEquals(world.digest(), fork.digest());
                for (int t = 0; t < 60; t++) {
                    world.step(STEP);
                    fork.step(STEP);
                    assertEquals(world.digest(), fork.digest(), "tick " + t);
                }
                fork.bodies().get(3).applyImpulse(10, 0, 0);
                world.step(STEP);
                fork.step(STEP);
                assertNotEquals(world.digest(), fork.digest());
            }
        }
    }

    @Test
    void ticksOfOtherLengthAndSubsteps() {
        try (PhysicsWorld world = world()) {
            for (int i = 0; i < 5; i++) {
                box(world, 0, 0.5 + i);
            }
            steps(world, 60);
            world.step(STEP / 2);
            holds(world, 30, () -> world.setSubsteps(2));
            world.setSubsteps(8);
            holds(world, 30, () -> world.setSubsteps(2));
        }
    }

    @Test
    void aWorldThatFailedGoesOnFromAnEarlierState() {
        try (PhysicsWorld world = world()) {
            box(world, 0, 2);
            steps(world, 3);
            WorldState state = world.save();
            List<Long> future = digests(world, 10);
            world.restore(state);
            // by hand, which is refused in the step
            world.ecs().spawn(Pose.at(0, 0, 0), Velocity.ZERO, new RigidBody(0));
            assertThrows(RuntimeException.class, () -> world.step(STEP));
            assertTrue(world.hasFailed());
            assertThrows(RuntimeException.class, world::save);
            world.restore(state);
            assertFalse(world.hasFailed());
            assertEquals(future, digests(world, 10));
        }
    }

    @Test
    void whatDoesNotFitIsRefusedAndChangesNothing() {
        try (PhysicsWorld world = world();
                PhysicsWorld sleepless = builder().sleeping(false).build()) {
            box(world, 0, 2);
            long before = sleepless.digest();
            StateException refusal =
                    assertThrows(StateException.class, () -> sleepless.restore(world.save()));
            assertTrue(refusal.getMessage().contains("build the world with"), refusal.getMessage());
            assertEquals(before, sleepless.digest());
            StateException empty =
                    assertThrows(StateException.class, () -> world.restore(new WorldState()));
            assertTrue(empty.getMessage().contains("empty"), empty.getMessage());
            StateException other =
                    assertThrows(StateException.class, () -> world.restore(world.ecs().save()));
            assertTrue(other.getMessage().contains("another kind"), other.getMessage());
            assertThrows(IllegalArgumentException.class, () -> world.restore(null));
        }
        PhysicsWorld closed = builder().settings(PhysicsSettings.DEFAULT).build();
        closed.close();
        assertThrows(IllegalStateException.class, closed::save);
        assertThrows(IllegalStateException.class, closed::fork);
    }

    /** The same state again and again, by several threads into a world each. */
    @Test
    void manyThreadsRestoreOneState() throws Exception {
        try (PhysicsWorld world = world()) {
            for (int i = 0; i < 5; i++) {
                box(world, 0.1 * i, 0.5 + i);
            }
            steps(world, 10);
            WorldState state = world.save();
            List<Long> future = digests(world, 30);
            List<List<Long>> futures = Collections.synchronizedList(new ArrayList<>());
            List<Thread> threads = new ArrayList<>();
            for (int i = 0; i < 4; i++) {
                threads.add(
                        Thread.ofPlatform()
                                .start(() -> {
                                    try (PhysicsWorld own = builder().build()) {
                                        own.restore(state);
                                        own.restore(state);
                                        futures.add(digests(own, 30));
                                    }
                                }));
            }
            for (Thread thread : threads) {
                thread.join();
            }
            assertEquals(Collections.nCopies(4, future), futures);
        }
    }

    @Test
    void aForkOfAForkOutlivesBoth() {
        try (PhysicsWorld world = world()) {
            box(world, 0, 3);
            steps(world, 5);
            PhysicsWorld fork = world.fork();
            steps(fork, 3);
            PhysicsWorld second = fork.fork();
            WorldState state = fork.save();
            List<Long> future = digests(fork, 20);
            fork.close();
            steps(world, 2); // the parent steps while a fork is closed
            assertEquals(future, digests(second, 20));
            world.restore(state);
            assertEquals(future, digests(world, 20), "a state outlives its world");
            second.close();
            steps(world, 1);
        }
    }

    /** During a step, by a system or a listener of it. */
    @Test
    void whileAStepRunsNothingIsSavedOrRestored() {
        AtomicReference<PhysicsWorld> of = new AtomicReference<>();
        AtomicReference<WorldState> state = new AtomicReference<>();
        List<String> told = new ArrayList<>();
        WorldSystem meddler =
                new WorldSystem() {
                    @Override
                    public String name() {
                        return "meddler";
                    }

                    @Override
                    public void describe(Access access) {
                        access.before("physics");
                    }

                    @Override
                    public void run(Tick tick) {
                        PhysicsWorld world = of.get();
                        for (Runnable each :
                                List.<Runnable>of(
                                        world::save,
                                        () -> world.restore(state.get()),
                                        world::fork)) {
                            told.add(
                                    assertThrows(IllegalStateException.class, each::run)
                                            .getMessage());
                        }
                    }
                };
        try (PhysicsWorld world = builder().systems(meddler).build()) {
            of.set(world);
            state.set(world.save());
            steps(world, 1);
            assertEquals(3, told.size());
            told.forEach(message -> assertTrue(message.contains("step"), message));
        }
    }

    @Test
    void twoStatesTellWhereTheyDiffer() {
        try (PhysicsWorld world = world()) {
            BodyRef box = box(world, 0, 2);
            WorldState one = world.save();
            assertNull(one.difference(world.save()));
            box.setVelocity(0, 0.5, 0);
            String difference = one.difference(world.save());
            assertEquals("bodies.velocityY[1]: 0.0 and 0.5", difference);
        }
    }
}
