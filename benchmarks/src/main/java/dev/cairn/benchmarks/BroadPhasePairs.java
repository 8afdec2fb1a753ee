package dev.cairn.benchmarks;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.broadphase.BroadPhase;

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

import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;

/** A tick of the broad phase: some boxes have moved, new pairs are looked for. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 4, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 1, jvmArgsAppend = "--add-modules=jdk.incubator.vector")
public class BroadPhasePairs {

    /** Cubes at random places, about one neighbour each. */
    @State(Scope.Thread)
    public static class Cloud {
        private static final double SIZE = 1;

        /** Boxes in the trees; a fifth of them never moves. */
        @Param({"1000", "10000"})
        public int bodies;

        /** Share of the others that move in a tick, percent. */
        @Param({"1", "20", "100"})
        public int movedPercent;

        /** Number of workers. */
        @Param({"1", "2"})
        public int workers;

        private BroadPhase phase = new BroadPhase();
        private Jobs jobs = Jobs.of(1);
        private double[] boxes = new double[0];
        private SplittableRandom random = new SplittableRandom(1);

        /** Fills the trees. */
        @Setup
        public void fill() {
            jobs.close();
            jobs = Jobs.of(workers);
            phase = new BroadPhase();
            random = new SplittableRandom(1);
            boxes = new double[6 * bodies];
            phase.ensureSlots(bodies);
            double reach = SIZE * Math.cbrt(4.0 * bodies);
            for (int b = 0; b < bodies; b++) {
                for (int axis = 0; axis < 3; axis++) {
                    double low = random.nextDouble(reach);
                    boxes[6 * b + axis] = low;
                    boxes[6 * b + 3 + axis] = low + SIZE;
                }
                phase.place(b, b % 5 == 0, boxes, 6 * b);
            }
            tick();
        }

        /** Moves some; this is part of what is measured. */
        private void move() {
            for (int b = 0; b < bodies; b++) {
                if (b % 5 == 0 || random.nextInt(100) >= movedPercent) {
                    continue;
                }
                int axis = random.nextInt(3);
                double step = random.nextDouble(-0.2, 0.2) * SIZE;
                boxes[6 * b + axis] += step;
                boxes[6 * b + 3 + axis] += step;
                phase.place(b, false, boxes, 6 * b);
            }
        }

        private int tick() {
            jobs.beginTick();
            try {
                phase.findPairs(jobs);
            } finally {
                jobs.endTick();
            }
            int found = phase.newPairCount();
            phase.endTick();
            return found;
        }

        /** Forgets pairs that have parted, as their owner would. */
        @Setup(Level.Iteration)
        public void refresh() {
            fill();
        }

        /** Ends the workers. */
        @TearDown
        public void close() {
            jobs.close();
        }
    }

    /**
     * One tick: boxes move, new pairs are found.
     *
     * @param cloud the boxes
     * @return the number of new pairs
     */
    @Benchmark
    public int tick(Cloud cloud) {
        cloud.move();
        return cloud.tick();
    }
}
