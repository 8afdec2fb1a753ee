package dev.cairn.core.ecs;

import static dev.cairn.core.ecs.Fixtures.*;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.storage.Hash;
import dev.cairn.core.job.Jobs;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;

/** The same bits for any number of workers, any timing and any order of registration. */
class DeterminismTest {
    private static final int TICKS = 25;

    /** Digest after this scenario; a change of it is a change of results, and has to be wanted. */
    private static final long GOLDEN = 6295747442730179355L;

    /** Systems that move, force, spawn, delete, add and remove, with random numbers. */
    private static List<EcsSystem> systems() {
        List<EcsSystem> systems = new ArrayList<>();
        systems.add(move());
        systems.add(
                chunks(
                        "force",
                        a -> a.next(POSITION).writesAll(FORCE),
                        (chunk, tick) -> {
                            double[] x = chunk.next(X);
                            float[] f = chunk.out(F);
                            for (int row = 0; row < chunk.size(); row++) {
                                f[row] = (float) (x[row] * 0.25);
                            }
                        }));
        systems.add(
                chunks(
                        "steer",
                        a -> a.out(VELOCITY),
                        (chunk, tick) -> {
                            double[] vx = chunk.out(VX);
                            for (int row = 0; row < chunk.size(); row++) {
                                RandomStream random = tick.random(chunk.entity(row), 1);
                                vx[row] += random.nextDouble(-1, 1);
                            }
                        }));
        systems.add(
                chunks(
                        "life",
                        a -> a.in(POSITION).optional(FORCE).commands().before("tags"),
                        (chunk, tick) -> {
                            for (int row = 0; row < chunk.size(); row++) {
                                live(chunk, row, tick);
                            }
                        }));
        systems.add(
                chunks(
                        "tags",
                        a -> a.in(VELOCITY).with(TAG).commands(),
                        (chunk, tick) -> {
                            for (int row = 0; row < chunk.size(); row += 3) {
                                tick.commands().remove(chunk.entity(row), TAG);
                            }
                        }));
        return systems;
    }

    private static void live(Chunk chunk, int row, Tick tick) {
        long entity = chunk.entity(row);
        int roll = tick.random(entity, 2).nextInt(100);
        Commands commands = tick.commands();
        if (roll < 3) {
            commands.delete(entity);
        } else if (roll < 7) {
            double x = chunk.in(X)[row];
            long child = commands.spawn(new Position(x, 1), new Velocity(roll, 0));
            if (roll == 4) {
                commands.add(child, new Force(1));
            }
        } else if (roll < 9) {
            commands.add(entity, new Tag());
        } else if (roll == 9 && chunk.has(FORCE)) {
            commands.remove(entity, FORCE);
        }
    }

    private static long run(List<EcsSystem> systems, Jobs jobs) {
        try (World world =
                World.builder()
                        .systems(systems.toArray(EcsSystem[]::new))
                        .jobs(jobs)
                        .seed(11)
                        .build()) {
            for (int i = 0; i < 4000; i++) {
                if (i % 3 == 0) {
                    world.spawn(new Position(i, 0), new Velocity(1, 0));
                } else {
                    world.spawn(new Position(i, 0), new Velocity(1, 0), new Force(i));
                }
            }
            for (int tick = 0; tick < TICKS; tick++) {
                world.step(1.0 / 60);
            }
            assertTrue(world.entityCount() > 4000);
            return world.digest();
        }
    }

    @Test
    void theDigestDoesNotDependOnWorkersTimingOrRegistration() {
        Set<Long> digests = new HashSet<>();
        for (int workers = 1; workers <= 4; workers++) {
            try (Jobs jobs = Jobs.of(workers)) {
                digests.add(run(systems(), jobs));
            }
        }
        for (int seed = 0; seed < 6; seed++) {
            List<EcsSystem> systems = systems();
            Collections.shuffle(systems, new Random(seed));
            try (Jobs jobs = Jobs.perturbed(2 + seed % 3, seed)) {
                digests.add(run(systems, jobs));
            }
        }
        assertEquals(Set.of(GOLDEN), digests, "one digest, and the golden one");
    }

    @Test
    void theDigestSeesEveryKindOfDifference() {
        Set<Long> digests = new HashSet<>();
        int made = 0;
        for (int variant = 0; variant < 8; variant++) {
            try (World world = World.builder().workers(1).seed(variant == 7 ? 1 : 0).build()) {
                long a = world.spawn(new Position(variant == 1 ? -0.0 : 0.0, 2));
                long b = world.spawn(new Position(0.0, 2));
                switch (variant) {
                    case 2 -> world.set(b, new Position(2, 0));
                    case 3 -> world.add(b, new Tag());
                    case 4 -> world.delete(b);
                    case 5 -> {
                        world.delete(a);
                        world.delete(b);
                        world.spawn(new Position(0.0, 2));
                        world.spawn(new Position(0.0, 2));
                    }
                    case 6 -> world.step(1);
                    default -> {}
                }
                made++;
                digests.add(world.digest());
            }
        }
        assertEquals(made, digests.size());
    }

    @Test
    void allNansAreOne() {
        double odd = Double.longBitsToDouble(0xFFF8_0000_0000_0001L);
        assertEquals(Hash.of(new double[] {Double.NaN}, 1), Hash.of(new double[] {odd}, 1));
        assertNotEquals(Hash.of(new int[] {1, 2}, 2), Hash.of(new int[] {2, 1}, 2));
        assertNotEquals(Hash.of(new int[] {0}, 1), Hash.of(new int[] {0, 0}, 2));
        Object[] texts = {"a", null, Thread.State.NEW, 1, 'c', true, new Object()};
        Object[] same = {new String("a"), null, Thread.State.NEW, 1, 'c', true, new Object()};
        assertEquals(Hash.of(texts, 7), Hash.of(same, 7));
    }
}
