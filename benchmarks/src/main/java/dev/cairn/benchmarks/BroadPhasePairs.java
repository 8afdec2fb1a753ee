package dev.cairn.benchmarks;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.broadphase.BroadPhase;

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

import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;

/**
 * A tick of the broad phase: some boxes have moved, new pairs are looked for, those that parted are
 * dropped, as the owner of the pairs does it. The cloud is as dense after an hour as at the start,
 * so a tick allocates nothing once its buffers have their size.
 */
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
        private double reach;
        private long[] pairs = new long[0];
        private int pairCount;
        private SplittableRandom random = new SplittableRandom(1);

        /** Fills the trees. */
        @Setup
        public void fill() {
            jobs.close();
            jobs = Jobs.of(workers);
            phase = new BroadPhase();
            random = new SplittableRandom(1);
            boxes = new double[6 * bodies];
            pairs = new long[32 * bodies];
            pairCount = 0;
            phase.ensureSlots(bodies);
            reach = SIZE * Math.cbrt(4.0 * bodies);
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

        /** Moves some, within the cloud; this is part of what is measured. */
        private void move() {
            for (int b = 0; b < bodies; b++) {
                if (b % 5 == 0 || random.nextInt(100) >= movedPercent) {
                    continue;
                }
                int axis = random.nextInt(3);
                double step = random.nextDouble(-0.2, 0.2) * SIZE;
                double low = Math.clamp(boxes[6 * b + axis] + step, 0, reach);
                boxes[6 * b + axis] = low;
                boxes[6 * b + 3 + axis] = low + SIZE;
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
            System.arraycopy(phase.newPairs(), 0, pairs, pairCount, found);
            pairCount += found;
            dropParted();
            phase.endTick();
            return found;
        }

        /** Forgets the pairs that have parted, and closes ranks. */
        private void dropParted() {
            int kept = 0;
            for (int p = 0; p < pairCount; p++) {
                int a = (int) (pairs[p] >>> 32);
                int b = (int) pairs[p];
                if ((phase.moved(a) || phase.moved(b)) && !phase.overlap(a, b)) {
                    phase.forget(a, b);
                } else {
                    pairs[kept++] = pairs[p];
                }
            }
            pairCount = kept;
        }

        /** Ends the workers. */
        @TearDown
        public void close() {
            jobs.close();
        }
    }

    /**
     * One tick: boxes move, new pairs are found, parted ones dropped.
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
