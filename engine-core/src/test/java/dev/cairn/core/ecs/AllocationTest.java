package dev.cairn.core.ecs;

import static dev.cairn.core.ecs.Fixtures.*;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;

import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.SnapshotExchange;
import dev.cairn.core.snapshot.Visual;

import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;

/** A steady tick, its snapshot included, allocates nothing, on no thread. */
@Timeout(120)
class AllocationTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private static EcsSystem[] systems() {
        long[] sink = new long[1];
        DoubleField px = Pose.COMPONENT.doubleField("x");
        return new EcsSystem[] {
            move(),
            chunks(
                    "drift",
                    a -> a.next(POSITION).out(Pose.COMPONENT),
                    (chunk, tick) -> {
                        double[] x = chunk.out(px);
                        double[] from = chunk.next(X);
                        for (int row = 0; row < chunk.size(); row++) {
                            x[row] = from[row] + tick.random(row, 0).nextDouble();
                        }
                    }),
            world(
                    "sum",
                    a -> a.next(Pose.COMPONENT),
                    tick -> {
                        for (int i = 0; i < tick.chunkCount(); i++) {
                            sink[0] += (long) tick.chunk(i).next(px)[0];
                        }
                        sink[0] += tick.resource(String.class).length();
                    })
        };
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4})
    void aThousandSteadyTicks(int workers) {
        try (Jobs jobs = Jobs.of(workers);
                World world = World.builder().systems(systems()).jobs(jobs).build()) {
            world.putResource("text");
            for (int i = 0; i < 5000; i++) {
                world.spawn(
                        Pose.at(i, 0, 0),
                        new Visual("cube"),
                        new Position(0, 0),
                        new Velocity(1, 0));
            }
            SnapshotExchange exchange = new SnapshotExchange();
            long[] ids = threads(jobs);
            run(world, exchange, 1500);
            // When a thread asks for a compilation, HotSpot may resolve string constants of the
            // method's class on it, once: a thousand ticks with such a moment tell nothing.
            List<String> seen = new ArrayList<>();
            boolean quiet = false;
            for (int thousand = 0; !quiet && thousand < 5; thousand++) {
                long[] first = THREADS.getThreadAllocatedBytes(ids);
                long[] before = THREADS.getThreadAllocatedBytes(ids);
                run(world, exchange, 1000);
                long[] after = THREADS.getThreadAllocatedBytes(ids);
                long[] bytes = new long[workers];
                for (int worker = 0; worker < workers; worker++) {
                    bytes[worker] = after[worker] - before[worker];
                }
                bytes[0] -= before[0] - first[0];
                quiet = Arrays.stream(bytes).allMatch(b -> b == 0);
                seen.add(Arrays.toString(bytes));
            }
            assertTrue(quiet, "bytes by worker in each thousand ticks: " + seen);
        }
    }

    private static void run(World world, SnapshotExchange exchange, int ticks) {
        for (int tick = 0; tick < ticks; tick++) {
            world.step(1.0 / 60);
            exchange.publish(world);
        }
    }

    /** Ids of all worker threads: each worker waits in its block until all have come. */
    private static long[] threads(Jobs jobs) {
        long[] ids = new long[jobs.workers()];
        CountDownLatch all = new CountDownLatch(ids.length);
        jobs.run(
                (block, worker) -> {
                    ids[worker] = Thread.currentThread().threadId();
                    all.countDown();
                    try {
                        all.await();
                    } catch (InterruptedException interrupted) {
                        throw new AssertionError(interrupted);
                    }
                },
                ids.length);
        return ids;
    }
}
