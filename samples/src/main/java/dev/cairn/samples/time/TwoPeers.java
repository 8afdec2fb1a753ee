package dev.cairn.samples.time;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.time.Rollback;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * Two peers of a game, each with a world of its own, over a simulated network of 3 to 9 ticks of
 * latency that loses every fifth packet: each steps on at once with what it knows, and goes back
 * when it learns more. Both end in the same world, which is that of a run without a network.
 *
 * <p>A packet holds the last inputs of its player, so that one that comes makes good for those that
 * were lost before it.
 */
public final class TwoPeers {
    private static final int PLAYERS = 2;
    private static final int WINDOW = 20;

    /** A player's wish for a tick: which way to push, N. */
    record Push(int forceX, int forceZ) {
        static final Push NONE = new Push(0, 0);
    }

    private record Packet(long firstTick, List<Push> pushes) {}

    /**
     * What a run has come to.
     *
     * @param ticks that both peers have gone
     * @param digests of their worlds
     * @param truth digest of a world that knew all inputs in time
     * @param rewinds how often each went back
     * @param ticksAgain how many ticks each stepped again
     * @param lost packets
     */
    public record Result(
            long ticks,
            List<Long> digests,
            long truth,
            List<Long> rewinds,
            List<Long> ticksAgain,
            int lost) {}

    private TwoPeers() {}

    /**
     * Plays a game and prints how it went.
     *
     * @param arguments none
     */
    public static void main(String[] arguments) {
        Result r = play(600, 1);
        System.out.printf(
                Locale.ROOT,
                "%d ticks: both peers have digest %016x, %s that of a run without a network%n",
                r.ticks,
                r.digests.get(0),
                r.digests.equals(List.of(r.truth, r.truth)) ? "and so has" : "which is NOT");
        System.out.printf(
                "rewound %s times, stepped %s ticks again, %d packets lost%n",
                r.rewinds, r.ticksAgain, r.lost);
    }

    /**
     * Plays a game.
     *
     * @param ticks how long
     * @param seed of network and players
     * @return what it has come to
     */
    public static Result play(int ticks, long seed) {
        List<PhysicsWorld> worlds = List.of(arena(1), arena(2));
        List<Rollback<Push>> peers = new ArrayList<>();
        List<Wire<Packet>> toPeer = new ArrayList<>();
        for (int p = 0; p < PLAYERS; p++) {
            peers.add(
                    new Rollback<>(
                            worlds.get(p), 1.0 / 60, PLAYERS, WINDOW, Push.NONE, TwoPeers::apply));
            toPeer.add(new Wire<>(seed + p, 3, 6, 0.2));
        }
        for (long clock = 0; settled(peers) < ticks; clock++) {
            for (int p = 0; p < PLAYERS; p++) {
                frame(p, peers.get(p), toPeer.get(p), toPeer.get(1 - p), clock, ticks, seed);
            }
        }
        List<Long> digests = new ArrayList<>();
        for (int p = 0; p < PLAYERS; p++) {
            peers.get(p).settle();
            digests.add(worlds.get(p).digest());
            worlds.get(p).close();
        }
        return new Result(
                ticks,
                digests,
                truth(ticks, seed),
                peers.stream().map(Rollback::rewinds).toList(),
                peers.stream().map(Rollback::ticksAgain).toList(),
                toPeer.stream().mapToInt(Wire::lost).sum());
    }

    /** What a peer does in a frame: receive, play, send. */
    private static void frame(
            int own,
            Rollback<Push> peer,
            Wire<Packet> in,
            Wire<Packet> out,
            long clock,
            int ticks,
            long seed) {
        in.receive(
                clock,
                packet -> {
                    for (int i = 0; i < packet.pushes.size(); i++) {
                        peer.input(1 - own, packet.firstTick + i, packet.pushes.get(i));
                    }
                });
        if (peer.tick() < ticks) {
            peer.input(own, peer.tick(), wish(own, peer.tick(), seed));
            peer.advance(); // or wait for the other one
        } else {
            peer.settle();
        }
        long first = Math.max(0, peer.tick() - WINDOW);
        List<Push> pushes = new ArrayList<>();
        for (long tick = first; tick < peer.tick(); tick++) {
            pushes.add(wish(own, tick, seed));
        }
        out.send(clock, new Packet(first, pushes));
    }

    private static long settled(List<Rollback<Push>> peers) {
        return peers.stream().mapToLong(Rollback::settledTick).min().orElse(0);
    }

    /** All inputs in time. */
    private static long truth(int ticks, long seed) {
        try (PhysicsWorld world = arena(1)) {
            for (long tick = 0; tick < ticks; tick++) {
                apply(world, tick, List.of(wish(0, tick, seed), wish(1, tick, seed)));
                world.step(1.0 / 60);
            }
            return world.digest();
        }
    }

    /** A player changes its mind every few ticks. */
    private static Push wish(int player, long tick, long seed) {
        SplittableRandom mind = new SplittableRandom(seed * 31 + player * 1009L + tick / 9);
        return new Push(mind.nextInt(-1, 2) * 6000, mind.nextInt(-1, 2) * 6000);
    }

    private static void apply(PhysicsWorld world, long tick, List<Push> pushes) {
        List<BodyRef> bodies = world.bodies();
        for (int p = 0; p < PLAYERS; p++) {
            bodies.get(p).applyForce(pushes.get(p).forceX, 0, pushes.get(p).forceZ);
        }
    }

    /** A ball for each player, first, and a wall of boxes between them. */
    private static PhysicsWorld arena(int workers) {
        PhysicsWorld world = PhysicsWorld.builder().workers(workers).build();
        world.add(Body.dynamic().shape(Sphere.of(0.5)).at(-3, 0.5, 0));
        world.add(Body.dynamic().shape(Sphere.of(0.5)).at(3, 0.5, 0));
        for (int i = 0; i < 24; i++) {
            int layer = i / 8;
            world.add(
                    Body.dynamic()
                            .shape(Box.cubeOfHalfExtent(0.3))
                            .at(0, 0.3 + 0.6 * layer, 0.62 * (i % 8 - 3.5)));
        }
        world.add(Body.fixed().shape(Box.ofHalfExtents(30, 1, 30)).at(0, -1, 0));
        return world;
    }
}
