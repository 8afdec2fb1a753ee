package dev.cairn.physics.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;

import dev.cairn.core.state.StateDelta;
import dev.cairn.core.state.StateException;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** A delta leads from one state to the other and back, and is as large as what has changed. */
class StateDeltaTest {
    private static final double STEP = 1.0 / 60;

    private static PhysicsWorld ground() {
        PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
        world.add(Body.fixed().shape(Box.ofHalfExtents(100, 1, 100)).at(0, -1, 0));
        return world;
    }

    /** Bodies come, go and change their table; a joint breaks; a pile falls asleep. */
    private static List<WorldState> past(PhysicsWorld world, long seed, int ticks) {
        SplittableRandom random = new SplittableRandom(seed);
        List<BodyRef> bodies = new ArrayList<>();
        List<WorldState> states = new ArrayList<>();
        for (int tick = 0; tick < ticks; tick++) {
            int what = random.nextInt(6);
            double x = random.nextDouble(-3, 3);
            if (what < 3 || bodies.size() < 3) {
                Body body = Body.dynamic().shape(Sphere.of(0.3)).at(x, 1, random.nextDouble(3));
                bodies.add(world.add(what == 1 ? body.with(new Force(1, 0, 0)) : body));
            } else if (what == 3) {
                bodies.remove(random.nextInt(bodies.size())).remove();
            } else if (what == 4) {
                BodyRef a = bodies.get(bodies.size() - 1);
                BodyRef b = bodies.get(bodies.size() - 2);
                world.add(Joint.ball(a, b).breakAt(x < 0 ? 1e-9 : 1e9, 1e9).at(x, 1, 0));
            } else {
                bodies.getFirst().applyImpulse(1, 2, 0);
            }
            world.step(STEP);
            states.add(world.save());
        }
        return states;
    }

    @Test
    void anyTwoTicksOfAnEventfulWorld() throws IOException {
        long seed = 11;
        try (PhysicsWorld world = ground()) {
            List<WorldState> states = past(world, seed, 60);
            SplittableRandom random = new SplittableRandom(seed);
            WorldState moved = new WorldState();
            for (int i = 0; i < 300; i++) {
                WorldState a = states.get(random.nextInt(states.size()));
                WorldState b = states.get(random.nextInt(states.size()));
                StateDelta delta = StateDelta.between(a, b);
                moved.set(a);
                delta.apply(moved);
                assertNull(moved.difference(b), "seed " + seed + ", forward " + i);
                delta.revert(moved);
                assertNull(moved.difference(a), "seed " + seed + ", back " + i);
                assertEquals(a == b, delta.isEmpty());
            }
            // all the way forward and back, and a world goes on from there
            List<StateDelta> deltas = new ArrayList<>();
            for (int t = 1; t < states.size(); t++) {
                deltas.add(StateDelta.between(states.get(t - 1), states.get(t)));
            }
            moved.set(states.getFirst());
            deltas.forEach(delta -> delta.apply(moved));
            assertTrue(moved.matches(states.getLast()));
            for (int t = deltas.size() - 1; t >= 20; t--) {
                deltas.get(t).revert(moved);
            }
            world.restore(states.get(20));
            long digest = after(world, 40);
            world.restore(moved);
            assertEquals(digest, after(world, 40));
        }
    }

    private static long after(PhysicsWorld world, int ticks) {
        for (int t = 0; t < ticks; t++) {
            world.step(STEP);
        }
        return world.digest();
    }

    private static long awake(PhysicsWorld world) {
        return world.bodies().stream()
                .filter(body -> body.type() == BodyType.DYNAMIC && !body.isAsleep())
                .count();
    }

    private static byte[] bytes(StateDelta delta) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        delta.writeTo(out, PhysicsWorld.codecs());
        return out.toByteArray();
    }

    private static StateDelta read(byte[] bytes) throws IOException {
        return StateDelta.read(new ByteArrayInputStream(bytes), PhysicsWorld.codecs());
    }

    /** What ten of a thousand bodies do while the others sleep. */
    enum Doing {
        FLYING,
        /** Asleep at first: they wake, their contacts leave, others come, and they sleep again. */
        HOPPING,
        SLIDING,
        /** Not as the others, so that columns come that were not there. */
        ROLLING,
        TUMBLING,
        /** Capsules that fall on each other. */
        CAPSULES,
        CYLINDERS,
        /** Boxes that fall on each other, with dozens of points that are all new in each tick. */
        HEAP,
        /** Two stacks, of which the uppermost boxes are pushed so that all rock. */
        STACKS,
        /** One stack, asleep at first, whose uppermost box or whose lowest one is pushed. */
        TOWER,
        TOWER_ON_A_BLOW,
        /** Bricks in two rows with 22 contacts, asleep at first, of which one is pushed over. */
        WALL,
        PLANKS,
        /** They were not there, each with a shape of its own. */
        COMING,
        LEAVING_THE_WORLD
    }

    private static List<BodyRef> aThousand(PhysicsWorld world, Doing doing) {
        Box box = Box.cubeOfHalfExtent(0.4);
        List<BodyRef> ten = new ArrayList<>();
        for (int i = 0; i < 1000; i++) {
            Body body = Body.dynamic().shape(box).at(i % 33 * 1.5 - 24, 0.4, i / 33 * 1.5 - 24);
            int n = i / 99;
            if (i % 99 == 98) {
                switch (doing) {
                    case FLYING ->
                            body.at(2 * n, 100, 0).velocity(1, 9, 2).angularVelocity(1, 2, 3);
                    case ROLLING -> body.shape(Sphere.of(0.4)).at(32 + 2 * n, 20 + n, 0);
                    case TUMBLING ->
                            body.at(32 + 2 * (n % 5), 13 + 0.1 * n, 2 * (n / 5))
                                    .velocity(1, 0, 0.5 * n)
                                    .angularVelocity(1 + n, 2, 3 - n);
                    case CAPSULES -> fall(body.shape(Capsule.of(0.3, 0.4)), n);
                    case CYLINDERS -> fall(body.shape(Cylinder.of(0.4, 0.5)), n);
                    case HEAP -> fall(body, n);
                    case PLANKS -> fall(body.shape(Box.ofHalfExtents(0.6, 0.1, 0.3)), n);
                    case STACKS -> body.at(32 + 3 * (n / 5), 0.4 + 0.8 * (n % 5), 0);
                    case TOWER, TOWER_ON_A_BLOW -> body.at(34, 0.4 + 0.8 * n, 0);
                    case WALL -> body.at(34 + 0.4 * n, 0.4 + 0.8 * (n % 2), 0);
                    case COMING -> {
                        continue;
                    }
                    default -> {}
                }
            }
            BodyRef ref = world.add(body);
            if (i % 99 == 98) {
                ten.add(ref);
            }
        }
        return ten;
    }

    /** So far from those that sleep that none rolls to them: 36 m, in the 3 s after its landing. */
    private static void fall(Body body, int n) {
        body.at(60 + 0.3 * (n % 3), 17 + n, 0.2 * (n % 2)).angularVelocity(1 + n, 2, 3 - n);
    }

    /** Each tick of it, whatever happens there, is at most 5 kB. */
    @ParameterizedTest
    @EnumSource
    void ofAThousandBodiesTenMove(Doing doing) throws IOException {
        try (PhysicsWorld world = ground()) {
            List<BodyRef> ten = aThousand(world, doing);
            for (int t = 0; t < 90; t++) {
                world.step(STEP);
            }
            for (BodyRef body : ten) {
                switch (doing) {
                    case HOPPING -> body.applyImpulse(0, 3 * body.mass(), 0);
                    case SLIDING -> body.applyImpulse(body.mass(), 0, 0.3 * body.mass());
                    case LEAVING_THE_WORLD -> body.remove();
                    default -> {}
                }
            }
            switch (doing) {
                case TOWER, WALL -> ten.get(9).applyImpulse(2 * ten.get(9).mass(), 0, 0);
                case TOWER_ON_A_BLOW -> ten.get(0).applyImpulse(4 * ten.get(0).mass(), 0, 0);
                default -> {}
            }
            if (doing == Doing.STACKS) {
                ten.get(4).applyImpulse(ten.get(4).mass(), 0, 0);
                ten.get(9).applyImpulse(0, 0, ten.get(9).mass());
            }
            WorldState before = world.save();
            for (int t = 0; t < 200; t++) {
                for (int n = 0; n < 10 && t == 5 && doing == Doing.COMING; n++) {
                    Box own = Box.ofHalfExtents(0.3 + 0.01 * n, 0.4, 0.5);
                    world.add(Body.dynamic().shape(own).at(32 + 2 * n, 0.7, 0));
                }
                world.step(STEP);
                WorldState after = world.save();
                StateDelta delta = StateDelta.between(before, after);
                assertTrue(awake(world) <= 10);
                int length = bytes(delta).length;
                String where = doing + ", tick " + t + ": ";
                assertTrue(length <= 5000, where + length + " bytes of " + after.byteCount());
                assertTrue(delta.byteCount() <= 5000, where + delta.byteCount() + " in memory");
                before = after;
            }
        }
    }

    @Test
    void whatSleepsCostsNothing() throws IOException {
        try (PhysicsWorld world = ground()) {
            for (int i = 0; i < 200; i++) {
                double x = i % 20 * 1.5 - 15;
                world.add(
                        Body.dynamic()
                                .shape(Box.cubeOfHalfExtent(0.4))
                                .at(x, 0.4, i / 20 * 1.5 - 15));
            }
            for (int t = 0; t < 120; t++) {
                world.step(STEP);
            }
            assertEquals(0, awake(world));
            WorldState before = world.save();
            world.step(STEP);
            StateDelta delta = StateDelta.between(before, world.save());
            assertFalse(delta.isEmpty(), "the tick has another number");
            assertTrue(bytes(delta).length <= 200, bytes(delta).length + " bytes");
        }
    }

    @Test
    void bytesOfADeltaLeadEitherWay() throws IOException {
        try (PhysicsWorld world = ground()) {
            List<WorldState> states = past(world, 5, 40);
            for (int t = 1; t < states.size(); t++) {
                WorldState a = states.get(t - 1);
                byte[] bytes = bytes(StateDelta.between(a, states.get(t)));
                StateDelta delta = read(bytes);
                WorldState moved = new WorldState();
                moved.set(a);
                delta.apply(moved);
                assertTrue(moved.isRead());
                world.restore(states.get(t));
                long digest = after(world, 3);
                world.restore(moved);
                assertEquals(digest, after(world, 3), "tick " + t);
                delta.revert(moved);
                world.restore(moved);
                assertEquals(states.get(t - 1).byteCount(), moved.byteCount());
            }
        }
    }

    @Test
    void theWrongStateIsRefusedAndStaysAsItIs() {
        try (PhysicsWorld world = ground()) {
            List<WorldState> states = past(world, 7, 30);
            WorldState moved = new WorldState();
            for (int t = 2; t < states.size(); t++) {
                StateDelta delta = StateDelta.between(states.get(t - 1), states.get(t));
                WorldState wrong = states.get(t - 2);
                moved.set(wrong);
                StateException refusal =
                        assertThrows(StateException.class, () -> delta.apply(moved));
                assertTrue(refusal.getMessage().contains("starts from"), refusal.getMessage());
                assertNull(moved.difference(wrong));
                assertThrows(StateException.class, () -> delta.revert(moved));
                assertNull(moved.difference(wrong));
            }
        }
    }

    /** Flipped and cut: refused with a reason when it is read or applied. */
    @Test
    void damagedBytesAreRefused() throws IOException {
        fuzz(31, 2000, false);
    }

    /** With sums made anew: what stands behind them is read, and refused, or is a delta. */
    @Test
    void forgedBytesAreRefusedOrADelta() throws IOException {
        fuzz(33, 10_000, true);
    }

    @Test
    @Tag("soak")
    void aHundredThousandForgedDeltas() throws IOException {
        fuzz(34, 100_000, true);
    }

    private static void fuzz(long seed, int mutations, boolean forged) throws IOException {
        SplittableRandom random = new SplittableRandom(seed);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        try (PhysicsWorld world = ground()) {
            List<WorldState> states = past(world, 5, 12);
            byte[] whole = bytes(StateDelta.between(states.get(9), states.get(11)));
            int refused = 0;
            for (int i = 0; i < mutations; i++) {
                byte[] bad = StateBytesTest.mutate(whole, random);
                if (forged) {
                    StateBytesTest.sign(bad);
                }
                String what = "seed " + seed + ", mutation " + i;
                WorldState moved = new WorldState();
                moved.set(states.get(9));
                long before = threads.getCurrentThreadAllocatedBytes();
                try {
                    read(bad).apply(moved);
                } catch (StateException told) {
                    refused++;
                    assertTrue(told.getMessage().length() > 20, what);
                    assertNull(moved.difference(states.get(9)), what);
                }
                try {
                    world.restore(moved);
                    world.restore(states.get(11));
                } catch (StateException told) {
                    assertTrue(forged && told.getMessage().length() > 20, what);
                }
                long took = threads.getCurrentThreadAllocatedBytes() - before;
                assertTrue(took < 256_000_000 + 40L * whole.length, what + " takes " + took);
            }
            assertTrue(refused > mutations / 10, refused + " were refused");
        }
    }
}
