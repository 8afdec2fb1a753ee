package dev.cairn.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.TreeMap;

/** A history by deltas holds what a history of whole states would hold. */
class HistoryTest {
    private static final double STEP = 1.0 / 60;

    /** What is remembered, whole: the oracle. */
    private static void matches(History history, TreeMap<Long, WorldState> whole, long tick) {
        assertTrue(history.has(tick), "tick " + tick);
        assertNull(whole.get(tick).difference(history.state(tick)), "tick " + tick);
    }

    /** Bodies come and go, the world goes back and takes other ways, old ticks are forgotten. */
    @Test
    void anyWalkThroughManyFutures() {
        for (long seed = 1; seed <= 4; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
                world.add(Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).at(0, -1, 0));
                History history = new History(world, 50, seed == 4 ? 1_500_000 : Long.MAX_VALUE);
                TreeMap<Long, WorldState> whole = new TreeMap<>();
                for (int round = 0; round < 300; round++) {
                    happens(world, random);
                    history.remember();
                    long tick = world.ecs().tickNumber();
                    whole.tailMap(tick, true).clear();
                    whole.put(tick, world.save());
                    whole.headMap(history.oldestTick()).clear();
                    assertEquals(whole.size(), history.tickCount(), "seed " + seed);
                    assertEquals(whole.lastKey(), history.latestTick());
                    List<Long> ticks = new ArrayList<>(whole.keySet());
                    for (int i = 0; i < 3; i++) {
                        matches(history, whole, ticks.get(random.nextInt(ticks.size())));
                    }
                    if (random.nextInt(12) == 0) {
                        long then = ticks.get(random.nextInt(ticks.size()));
                        history.rewind(then);
                        assertEquals(then, world.ecs().tickNumber());
                        assertEquals(then, history.floorTick(then));
                    }
                    world.step(STEP);
                }
                for (long tick : whole.keySet()) {
                    matches(history, whole, tick);
                }
                for (long tick : whole.descendingKeySet()) {
                    matches(history, whole, tick);
                }
            }
        }
    }

    /**
     * A heap that is awake for longer than memory lasts: all of its past, the older the coarser.
     */
    @Test
    void aThinningHistoryReachesBack() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).sleeping(false).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).at(0, -1, 0));
            SplittableRandom random = new SplittableRandom(6);
            for (int i = 0; i < 20; i++) {
                double x = random.nextDouble(-1, 1);
                world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.3)).at(x, 1 + i * 0.7, 0));
            }
            int span = 900;
            long bound = 2_700_000;
            History history = History.thinning(world, span, bound);
            History plain = new History(world, span, bound);
            List<Long> digests = new ArrayList<>();
            TreeMap<Long, WorldState> whole = new TreeMap<>();
            long first = 0;
            for (int t = 0; t < 1200; t++) {
                history.remember();
                plain.remember();
                digests.add(world.digest());
                whole.put((long) t, world.save());
                assertTrue(history.byteCount() <= bound, history.byteCount() + " bytes");
                // Memory never costs the oldest one, only age does; behind it is the next of the
                // grid, whose gaps are a twelfth of how long ago they are.
                long oldest = history.oldestTick();
                assertTrue(oldest == first || first <= t - span, first + " went at " + t);
                assertTrue(oldest - first <= span / 12, "from " + first + " to " + oldest);
                first = oldest;
                if (t > 400 && random.nextInt(40) == 0) {
                    history.state(history.floorTick(random.nextInt(t - 200, t)));
                }
                world.step(STEP);
            }
            assertTrue(plain.oldestTick() > 600, "memory is short: " + plain.oldestTick());
            assertTrue(first <= 1199 - span + span / 12, "from " + first);
            assertEquals(1199, history.latestTick());
            long widest = 0;
            long before = history.oldestTick();
            for (long t = before; t < 1200; t++) {
                if (history.has(t)) {
                    assertNull(whole.get(t).difference(history.state(t)), "tick " + t);
                    widest = Math.max(widest, t - before);
                    before = t;
                }
            }
            assertTrue(history.has(1198) && history.has(1195), "the last ticks are all there");
            assertTrue(widest <= 75, widest + " ticks are the widest gap");
            for (int i = 0; i < 30; i++) {
                long tick = history.floorTick(random.nextInt(310, 1200));
                history.rewind(tick);
                assertEquals(digests.get((int) tick), world.digest());
            }
        }
    }

    private static void happens(PhysicsWorld world, SplittableRandom random) {
        List<BodyRef> bodies = world.bodies();
        int what = random.nextInt(8);
        if (what == 0 || bodies.size() < 4) {
            double x = random.nextDouble(-3, 3);
            world.add(Body.dynamic().shape(Sphere.of(0.4)).at(x, 2, random.nextDouble(-3, 3)));
        } else if (what == 1) {
            bodies.get(1 + random.nextInt(bodies.size() - 1)).remove();
        } else if (what == 2) {
            bodies.getLast().applyImpulse(5, 9, 0);
        }
    }

    /** Three minutes of a world in which little moves. */
    @Test
    void threeMinutesOfAWorldThatMostlySleeps() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(60, 1, 60)).at(0, -1, 0));
            for (int i = 0; i < 300; i++) {
                double x = i % 20 * 1.5 - 15;
                world.add(
                        Body.dynamic()
                                .shape(Box.cubeOfHalfExtent(0.4))
                                .at(x, 0.4, i / 20 * 1.5 - 12));
            }
            int ticks = 10_800;
            History history = new History(world, ticks, 256L << 20);
            long[] digests = new long[ticks];
            BodyRef pushed = world.bodies().get(7);
            for (int t = 0; t < ticks; t++) {
                if (t % 300 == 299) {
                    pushed.applyImpulse(0, 900, 0);
                }
                history.remember();
                digests[t] = world.digest();
                world.step(STEP);
            }
            assertEquals(ticks, history.tickCount());
            long whole = world.save().byteCount();
            assertTrue(
                    history.byteCount() < 60L << 20,
                    history.byteCount() + " bytes, of states of " + whole);
            SplittableRandom random = new SplittableRandom(2);
            for (int i = 0; i < 30; i++) {
                int tick = random.nextInt(ticks);
                history.rewind(tick);
                assertEquals(digests[tick], world.digest(), "tick " + tick);
            }
        }
    }

    /** A thousand moments of a thousand bodies of which ten move take less than five of them. */
    @Test
    void aThousandMomentsShareWhatHasNotChanged() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(60, 1, 60)).at(0, -1, 0));
            Box box = Box.cubeOfHalfExtent(0.4);
            for (int i = 0; i < 1000; i++) {
                world.add(Body.dynamic().shape(box).at(i % 33 * 1.5 - 24, 0.4, i / 33 * 1.5 - 24));
            }
            History history = new History(world, 1000, 256L << 20);
            for (int t = 0; t < 1100; t++) {
                for (int n = 0; t % 50 == 0 && n < 10; n++) {
                    BodyRef body = world.bodies().get(1 + 100 * n);
                    body.applyImpulse(0.1 * body.mass(), 3 * body.mass(), 0);
                }
                if (t >= 100) {
                    history.remember();
                }
                world.step(STEP);
            }
            assertEquals(1000, history.tickCount());
            long whole = world.save().byteCount();
            assertTrue(history.byteCount() < 5 * whole, history.byteCount() + " of " + whole);
        }
    }
}
