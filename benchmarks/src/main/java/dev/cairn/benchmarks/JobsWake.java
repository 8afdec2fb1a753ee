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
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * From {@code beginTick} with a parked helper to the end of a stage that the helper must join, two
 * workers: what the first stage of a tick pays if it wants all hands. And the cost of the wake-up
 * for the caller alone.
 */
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 1, jvmArgsAppend = "--add-modules=jdk.incubator.vector")
public class JobsWake {

    /** Each of two blocks waits until the other is there too. */
    private static final class Meeting implements BlockJob {
        final AtomicInteger present = new AtomicInteger();
        volatile Thread helper = Thread.currentThread();

        @Override
        @SuppressWarnings("ThreadPriorityCheck") // the machine may have one core
        public void run(int block, int worker) {
            if (worker == 1) {
                helper = Thread.currentThread();
            }
            present.incrementAndGet();
            for (int spins = 0; present.get() < 2; spins++) {
                if (spins < 1000) {
                    Thread.onSpinWait();
                } else {
                    Thread.yield();
                }
            }
        }
    }

    /** A job system whose helper is parked before each call. */
    @State(Scope.Thread)
    public static class Parked {
        final Jobs jobs = Jobs.of(2);
        private final Meeting meeting = new Meeting();

        /** Finds the helper's thread. */
        @Setup
        public void meet() {
            jobs.run(meeting, 2);
        }

        /** Waits until the helper sleeps. */
        @Setup(Level.Invocation)
        public void park() {
            while (meeting.helper.getState() != Thread.State.WAITING) {
                Thread.onSpinWait();
            }
            meeting.present.set(0);
        }

        /** Ends the helper. */
        @TearDown
        public void close() {
            jobs.close();
        }
    }

    /**
     * Wakes the helper and meets it.
     *
     * @param state the job system
     */
    @Benchmark
    public void wakeAndMeet(Parked state) {
        state.jobs.beginTick();
        state.jobs.run(state.meeting, 2);
        state.jobs.endTick();
    }

    /**
     * Wakes the helper and does not wait for it.
     *
     * @param state the job system
     */
    @Benchmark
    public void wakeOnly(Parked state) {
        state.jobs.beginTick();
        state.jobs.endTick();
    }
}
