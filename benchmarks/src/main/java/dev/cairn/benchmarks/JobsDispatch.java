package dev.cairn.benchmarks;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Jobs;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
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

/** What a stage costs before its blocks do anything, inside a tick; and a whole empty tick. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 1, jvmArgsAppend = "--add-modules=jdk.incubator.vector")
public class JobsDispatch {

    /** Does nothing. */
    private static final class Empty implements BlockJob {
        @Override
        public void run(int block, int worker) {}
    }

    /** Marks its block, so that both workers write. */
    private static final class Touch implements BlockJob {
        private static final int STRIDE = 16;
        final long[] marks = new long[(8 + 2) * STRIDE];

        @Override
        public void run(int block, int worker) {
            marks[(block + 1) * STRIDE]++;
        }
    }

    /** A job system inside a tick: its helpers are awake. */
    @State(Scope.Thread)
    public static class Awake {
        /** Number of workers. */
        @Param({"1", "2"})
        public int workers;

        /** Number of blocks. */
        @Param({"1", "2", "8"})
        public int blocks;

        final BlockJob empty = new Empty();
        final BlockJob touch = new Touch();
        Jobs jobs = Jobs.of(1);

        /** Opens a tick. */
        @Setup(Level.Iteration)
        public void begin() {
            jobs.close();
            jobs = Jobs.of(workers);
            jobs.beginTick();
        }

        /** Ends the tick. */
        @TearDown(Level.Iteration)
        public void end() {
            jobs.endTick();
            jobs.close();
        }
    }

    /**
     * A stage whose blocks do nothing.
     *
     * @param state the job system
     */
    @Benchmark
    public void emptyStage(Awake state) {
        state.jobs.run(state.empty, state.blocks);
    }

    /**
     * A stage whose blocks write a word each.
     *
     * @param state the job system
     */
    @Benchmark
    public void touchingStage(Awake state) {
        state.jobs.run(state.touch, state.blocks);
    }
}
