package dev.cairn.core.ecs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.storage.ChunkSizes;
import dev.cairn.core.job.Jobs;

import org.junit.jupiter.api.Test;

/** Chunks cover the rows without gap, grow with the table, and are full but for the last. */
class ChunkSizesTest {

    @Test
    void everyRowHasItsPlace() {
        int chunk = 0;
        int local = 0;
        for (int row = 0; row < 3_000_000; row++) {
            assertEquals(chunk, ChunkSizes.chunk(row), () -> "chunk");
            assertEquals(local, ChunkSizes.local(row), () -> "local");
            assertEquals(chunk + 1, ChunkSizes.count(row + 1), () -> "count");
            local++;
            if (local == ChunkSizes.capacity(chunk)) {
                chunk++;
                local = 0;
            }
        }
        assertEquals(0, ChunkSizes.count(0));
        assertEquals(ChunkSizes.LARGEST, ChunkSizes.capacity(chunk));
        assertEquals((1 << 31 - 14) + 32 - 1, ChunkSizes.chunk(Integer.MAX_VALUE));
        assertEquals(ChunkSizes.LARGEST - 1, ChunkSizes.local(Integer.MAX_VALUE));
    }

    @Test
    void noChunkIsMoreThanAnEighthOfTheRowsBefore() {
        int before = 0;
        int last = 0;
        for (int chunk = 0; chunk < 100; chunk++) {
            int capacity = ChunkSizes.capacity(chunk);
            assertTrue(capacity >= last, "chunk " + chunk);
            assertTrue(capacity == ChunkSizes.SMALLEST || 8 * capacity <= before, "chunk " + chunk);
            before += capacity;
            last = capacity;
        }
    }

    /** Structural changes at the borders between chunks, also of different size. */
    @Test
    void tablesGrowAndShrinkOverTheBorders() {
        try (World world = World.builder().workers(1).build()) {
            int count = 40_000; // 16 chunks of 1024, 8 of 2048, then 4096
            long[] made = new long[count];
            for (int i = 0; i < count; i++) {
                made[i] = world.spawn(new Fixtures.Position(i, -i));
            }
            Query all = world.query(Fixtures.POSITION);
            assertEquals(16 + 8 + 2, all.chunkCount());
            assertEquals(1024, all.chunk(15).size());
            assertEquals(2048, all.chunk(16).size());
            assertEquals(2048, all.chunk(23).size());
            assertEquals(4096, all.chunk(24).size());
            for (int i = 0; i < count; i++) {
                assertEquals(i, world.get(made[i], Fixtures.POSITION).x(), "entity " + i);
            }
            for (int i = 0; i < count - 1; i++) {
                world.delete(made[i]);
            }
            assertEquals(1, all.chunkCount());
            assertEquals(count - 1, world.get(made[count - 1], Fixtures.POSITION).x());
        }
    }

    /** Commands of chunks of different size are made in the same order by any workers. */
    @Test
    void theDigestDoesNotDependOnWorkers() {
        long expected = digest(Jobs.of(1));
        assertEquals(expected, digest(Jobs.of(2)));
        assertEquals(expected, digest(Jobs.of(3)));
        assertEquals(expected, digest(Jobs.perturbed(4, 7)));
    }

    private static long digest(Jobs jobs) {
        ChunkSystem split =
                Fixtures.chunks(
                        "split",
                        access -> access.writesAll(Fixtures.POSITION).commands(),
                        (chunk, tick) -> {
                            double[] from = chunk.in(Fixtures.X);
                            double[] to = chunk.out(Fixtures.X);
                            for (int row = 0; row < chunk.size(); row++) {
                                to[row] = from[row] / 3;
                            }
                            tick.commands().delete(chunk.entity(chunk.size() / 2));
                            tick.commands().spawn(new Fixtures.Position(chunk.size(), 1));
                        });
        try (jobs;
                World world = World.builder().systems(split).jobs(jobs).build()) {
            world.spawnMany(70_000, new Fixtures.Position(1, 2));
            for (int tick = 0; tick < 5; tick++) {
                world.step(1);
            }
            return world.digest();
        }
    }
}
