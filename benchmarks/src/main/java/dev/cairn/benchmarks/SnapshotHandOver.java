package dev.cairn.benchmarks;

import dev.cairn.core.ecs.World;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.core.snapshot.SnapshotExchange;
import dev.cairn.core.snapshot.TripleBuffer;
import dev.cairn.core.snapshot.Visual;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

import java.util.concurrent.TimeUnit;

/** What the simulation thread pays to publish the poses of all visible entities, per tick. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 1, jvmArgsAppend = "--add-modules=jdk.incubator.vector")
public class SnapshotHandOver {

    /** A world of visible entities. */
    @State(Scope.Thread)
    public static class Visible {
        /** Number of entities. */
        @Param({"1000", "10000"})
        public int entities;

        final World world = World.builder().workers(1).build();
        final SnapshotExchange exchange = new SnapshotExchange();
        final TripleBuffer<long[]> buffer = new TripleBuffer<>(() -> new long[1]);

        /** Fills the world. */
        @Setup
        public void fill() {
            Visual visual = new Visual("model");
            for (int i = 0; i < entities; i++) {
                world.spawn(Pose.at(i, 0, 0), visual);
            }
            world.step(1.0 / 60.0);
        }

        /** Ends the world. */
        @TearDown
        public void close() {
            world.close();
        }
    }

    /**
     * Publishes all poses and fetches them.
     *
     * @param state the world
     * @return the snapshot
     */
    @Benchmark
    public PoseSnapshot publishAndFetch(Visible state) {
        state.exchange.publish(state.world);
        return state.exchange.latest();
    }

    /**
     * The exchange of the slots alone.
     *
     * @param state the world
     * @return the slot
     */
    @Benchmark
    public long[] swapOnly(Visible state) {
        state.buffer.writing()[0]++;
        state.buffer.publish();
        return state.buffer.latest();
    }
}
