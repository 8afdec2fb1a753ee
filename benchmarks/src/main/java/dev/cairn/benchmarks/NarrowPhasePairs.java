package dev.cairn.benchmarks;

import dev.cairn.benchmarks.narrowphase.PairSet;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.box.BoxContacts;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.wide.BoxBatch;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import java.util.concurrent.TimeUnit;

/**
 * The contact of one pair, from two shapes and their poses to named points, averaged over a set of
 * pairs: cold (nothing known of the last tick), warm (with the word of the last tick, poses
 * unchanged), and in batches.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 1, jvmArgsAppend = "--add-modules=jdk.incubator.vector")
public class NarrowPhasePairs {

    /** Pairs of one kind, one after another. */
    @State(Scope.Thread)
    public static class Single {
        /** What collides. */
        @Param({
            "STACKED_BOXES",
            "TUMBLED_BOXES",
            "HULLS_32",
            "HULLS_32_SHALLOW",
            "BALL_ON_BOX",
            "BALLS",
            "BALL_ON_CAPSULE",
            "CAPSULES"
        })
        public PairSet.Kind pairs = PairSet.Kind.STACKED_BOXES;

        /** How axes are found. */
        @Param({"SPECIALISED", "GENERAL"})
        public NarrowPhase.Method method = NarrowPhase.Method.SPECIALISED;

        /** Whether the word of the last tick is handed on. */
        @Param({"true", "false"})
        public boolean warm;

        PairSet set = new PairSet(pairs, 0);
        NarrowPhase narrowPhase = new NarrowPhase();
        final long[] words = new long[PairSet.SIZE];
        final Manifold manifold = new Manifold();

        /** Makes the pairs. */
        @Setup
        public void build() {
            set = new PairSet(pairs, 1);
            narrowPhase = new NarrowPhase(method);
        }
    }

    /** Pairs of boxes, in batches, warm. */
    @State(Scope.Thread)
    public static class Batched {
        /** What collides. */
        @Param({"STACKED_BOXES", "TUMBLED_BOXES"})
        public PairSet.Kind boxes = PairSet.Kind.STACKED_BOXES;

        PairSet set = new PairSet(boxes, 0);
        final BoxContacts contacts = new BoxContacts(new NarrowPhase());
        final long[] words = new long[PairSet.SIZE];
        final Manifold manifold = new Manifold();

        /** Makes the pairs. */
        @Setup
        public void build() {
            set = new PairSet(boxes, 1);
        }
    }

    /** Pairs of boxes that are apart. */
    @State(Scope.Thread)
    public static class Apart {
        final PairSet set = new PairSet(PairSet.Kind.BOXES_APART, 1);
        final NarrowPhase narrowPhase = new NarrowPhase(NarrowPhase.Method.GENERAL);
        final long[] words = new long[PairSet.SIZE];
        int tick;
    }

    /**
     * The contact of a pair.
     *
     * @param s the pairs
     * @return a number of points
     */
    @Benchmark
    @OperationsPerInvocation(PairSet.SIZE)
    public int collide(Single s) {
        int points = 0;
        for (int i = 0; i < PairSet.SIZE; i++) {
            long word = s.warm ? s.words[i] : 0;
            s.words[i] = s.set.collide(i, s.narrowPhase, word, s.manifold);
            points += s.manifold.pointCount;
        }
        return points;
    }

    /**
     * The contact of a pair of boxes in a batch.
     *
     * @param s the pairs
     * @return a number of points
     */
    @Benchmark
    @OperationsPerInvocation(PairSet.SIZE)
    public int batched(Batched s) {
        int points = 0;
        for (int begin = 0; begin < PairSet.SIZE; begin += BoxBatch.CAPACITY) {
            points += s.set.collideBoxes(begin, s.contacts, s.words, s.manifold);
        }
        return points;
    }

    /**
     * The distance of two boxes by GJK.
     *
     * @param s the pairs
     * @return a sum, m
     */
    @Benchmark
    @OperationsPerInvocation(PairSet.SIZE)
    public double distance(Apart s) {
        double sum = 0;
        for (int i = 0; i < PairSet.SIZE; i++) {
            sum += s.set.distance(i, s.narrowPhase);
        }
        return sum;
    }

    /**
     * The distance of two boxes that move by GJK, from the features that were nearest in the last
     * tick.
     *
     * @param s the pairs
     * @return a sum, m
     */
    @Benchmark
    @OperationsPerInvocation(PairSet.SIZE)
    public double distanceWarm(Apart s) {
        s.set.move(s.tick++ & 0xFFFF);
        double sum = 0;
        for (int i = 0; i < PairSet.SIZE; i++) {
            sum += s.set.distance(i, s.narrowPhase, s.words[i]);
            s.words[i] = s.narrowPhase.distanceKey();
        }
        return sum;
    }
}
