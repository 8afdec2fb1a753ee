package dev.cairn.physics.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.api.Test;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Going back, trying futures, playing over a network: all worlds are those of an honest run. */
class TimeTest {
    private static final double STEP = 1.0 / 60;

    /** Two balls that their players push, and boxes in their way. */
    private static PhysicsWorld world(int workers) {
        PhysicsWorld world = PhysicsWorld.builder().workers(workers).build();
        world.add(Body.dynamic().shape(Sphere.of(0.5)).at(-3, 0.5, 0));
        world.add(Body.dynamic().shape(Sphere.of(0.5)).at(3, 0.5, 0));
        for (int i = 0; i < 9; i++) {
            world.add(
                    Body.dynamic().shape(Box.cubeOfHalfExtent(0.4)).at(i % 3 - 1, 0.4 + i / 3, 0));
        }
        world.add(Body.fixed().shape(Box.ofHalfExtents(20, 1, 20)).at(0, -1, 0));
        return world;
    }

    private static void push(PhysicsWorld world, long tick, List<Integer> inputs) {
        List<BodyRef> bodies = world.bodies();
        for (int p = 0; p < inputs.size(); p++) {
            bodies.get(p).applyForce(inputs.get(p), 0, 0);
        }
    }

    private static int wish(int player, long tick) {
        long mixed = new SplittableRandom(player * 1000L + tick / 7).nextLong();
        return (int) Math.floorMod(mixed, 5L) * 4000 - 8000;
    }

    @Test
    void aHistoryGoesBackAndForgets() {
        try (PhysicsWorld world = world(1)) {
            History history = new History(world, 20, Long.MAX_VALUE);
            List<Long> digests = new ArrayList<>();
            for (int t = 0; t <= 50; t++) {
                history.remember();
                digests.add(world.digest());
                world.step(STEP);
            }
            assertEquals(31, history.oldestTick());
            assertEquals(50, history.latestTick());
            assertFalse(history.has(30));
            assertThrows(IllegalArgumentException.class, () -> history.rewind(30));
            for (long tick : new long[] {45, 31, 50, 38}) {
                history.rewind(tick);
                assertEquals(tick, world.ecs().tickNumber());
                assertEquals(digests.get((int) tick), world.digest(), "tick " + tick);
            }
            world.bodies().get(0).applyImpulse(100, 0, 0);
            world.step(STEP);
            history.remember(); // another future: 40 to 50 never were
            assertEquals(39, history.latestTick());
            long one = history.state(39).byteCount();
            History small = new History(world, 100, 5 * one);
            for (int t = 0; t < 30; t++) {
                small.remember();
                world.step(STEP);
                assertTrue(small.byteCount() <= 5 * one, small.byteCount() + " bytes");
            }
            assertTrue(small.latestTick() - small.oldestTick() >= 2, "keeps what it may");
        }
        try (PhysicsWorld world = world(1)) {
            assertThrows(IllegalArgumentException.class, () -> new History(world, 0, 1));
        }
    }

    @Test
    void branchesAreWhatEachWouldBeAlone() {
        List<Long> alone = new ArrayList<>();
        for (int b = 0; b < 12; b++) {
            try (PhysicsWorld world = world(1)) {
                alone.add(branch(world, b));
            }
        }
        for (int workers = 1; workers <= 3; workers++) {
            try (PhysicsWorld world = world(workers)) {
                long before = world.digest();
                assertEquals(alone, Ensemble.run(world, 12, TimeTest::branch));
                assertEquals(before, world.digest(), "the world itself stays");
                assertEquals(List.of(), Ensemble.run(world, 0, TimeTest::branch));
            }
        }
    }

    private static long branch(PhysicsWorld world, int number) {
        world.bodies().get(0).setVelocity(number, 0, 0);
        for (int t = 0; t < 40; t++) {
            world.step(STEP);
        }
        return world.digest();
    }

    private record Packet(int arrives, int player, long tick, int input) {}

    /**
     * Late, out of order, doubled, lost and sent again: both peers end where an honest run does.
     */
    @Test
    void peersOverABadNetworkEndInTheSameWorld() {
        int ticks = 240;
        long truth;
        try (PhysicsWorld world = world(1)) {
            for (int t = 0; t < ticks; t++) {
                push(world, t, List.of(wish(0, t), wish(1, t)));
                world.step(STEP);
            }
            truth = world.digest();
        }
        for (long seed = 1; seed <= 3; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            List<PhysicsWorld> worlds = List.of(world(1), world(2));
            List<Rollback<Integer>> peers = new ArrayList<>();
            List<ArrayDeque<Packet>> wires = List.of(new ArrayDeque<>(), new ArrayDeque<>());
            for (PhysicsWorld world : worlds) {
                peers.add(new Rollback<>(world, STEP, 2, 12, 0, TimeTest::push));
            }
            int clock = 0;
            int waits = 0;
            while (Math.min(peers.get(0).settledTick(), peers.get(1).settledTick()) < ticks) {
                for (int p = 0; p < 2; p++) {
                    Rollback<Integer> peer = peers.get(p);
                    receive(peer, wires.get(p), clock);
                    long tick = peer.tick();
                    if (tick < ticks) {
                        peer.input(p, tick, wish(p, tick));
                        waits += peer.advance() ? 0 : 1;
                    } else {
                        peer.settle();
                    }
                    send(p, peer, wires.get(1 - p), clock, random, ticks);
                }
                clock++;
                assertTrue(clock < 5000, "the network stands still");
            }
            for (int p = 0; p < 2; p++) {
                peers.get(p).settle();
                assertEquals(ticks, peers.get(p).tick());
                assertEquals(truth, worlds.get(p).digest(), "peer " + p + ", seed " + seed);
                assertTrue(peers.get(p).rewinds() > 5, "rewinds " + peers.get(p).rewinds());
                worlds.get(p).close();
            }
            assertTrue(waits < clock, "somebody advances");
        }
    }

    private static void receive(Rollback<Integer> peer, ArrayDeque<Packet> wire, int clock) {
        List<Packet> there = wire.stream().filter(packet -> packet.arrives <= clock).toList();
        wire.removeAll(there);
        there.forEach(packet -> peer.input(packet.player, packet.tick, packet.input));
    }

    /** Each packet carries one of the last inputs again, in case it was lost. */
    private static void send(
            int player,
            Rollback<Integer> peer,
            ArrayDeque<Packet> wire,
            int clock,
            SplittableRandom random,
            int ticks) {
        for (long tick = Math.max(0, peer.tick() - 12);
                tick <= peer.tick() && tick < ticks;
                tick++) {
            boolean isLost = random.nextInt(100) < 30;
            boolean isOwn = tick < peer.tick();
            if (isOwn && !isLost) {
                int delay = 2 + random.nextInt(6);
                wire.add(new Packet(clock + delay, player, tick, wish(player, tick)));
            }
        }
    }

    @Test
    void whatCannotBeHeldIsRefused() {
        try (PhysicsWorld world = world(1)) {
            Rollback<Integer> peer = new Rollback<>(world, STEP, 2, 3, 0, TimeTest::push);
            for (int t = 0; t < 3; t++) {
                peer.input(0, t, 1);
                assertTrue(peer.advance());
            }
            assertFalse(peer.advance(), "three ticks ahead of player 1");
            assertEquals(3, peer.tick());
            assertThrows(IllegalArgumentException.class, () -> peer.input(2, 0, 1));
            assertThrows(IllegalArgumentException.class, () -> peer.input(1, 8, 1));
            peer.input(1, 1, 5);
            assertThrows(IllegalArgumentException.class, () -> peer.input(1, 1, 6));
            peer.input(1, 0, 0);
            assertEquals(2, peer.settledTick());
            peer.input(0, 0, 77); // told long ago
            peer.input(0, 3, 1);
            assertTrue(peer.advance());
            assertEquals(1, peer.rewinds());
            assertThrows(
                    IllegalArgumentException.class,
                    () -> new Rollback<>(world, STEP, 0, 3, 0, TimeTest::push));
        }
    }
}
