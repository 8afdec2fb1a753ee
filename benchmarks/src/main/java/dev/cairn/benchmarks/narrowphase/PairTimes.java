package dev.cairn.benchmarks.narrowphase;

import dev.cairn.benchmarks.peer.PairCalls;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.NarrowPhase.Method;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.wide.BoxWarmUp;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Nanoseconds of thread CPU time per pair: one after another, cold (nothing known of the last
 * tick), warm (poses unchanged), and moving (the word of the last tick, and poses that differ by
 * what a slow body moves in it); and in the stage of a step, gather and store included. Then the
 * other engines' calls for two shapes, see {@link PairCalls}.
 *
 * <p>{@code java --add-modules=jdk.incubator.vector -jar benchmarks.jar narrow-phase times}
 */
public final class PairTimes {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    /** Repetitions at least. */
    private static final int REPETITIONS = 1000;

    /**
     * And for so long at least, ns of CPU time: what ran before has left code that is compiled anew
     * for other shapes, in the background.
     */
    private static final long LEAST_TIME = 2_000_000_000L;

    private static final int PEER_REPETITIONS = 300;

    /** Sets of pairs, 256 each, whose iterations are counted. */
    private static final int ITERATION_SETS = 40;

    /**
     * Receives all contacts. Reachable from everywhere, so that each number is written: of a
     * manifold that nobody else can see the compiler need keep only what is read.
     */
    private static final Manifold[] RESULT = {new Manifold()};

    private PairTimes() {}

    /**
     * Measures.
     *
     * @param args names of kinds, or nothing for all
     */
    public static void main(String[] args) {
        System.out.printf(
                Locale.ROOT,
                "%-16s %-12s %8s %8s %8s %8s %8s %12s %8s   (fast turns, ns of thread CPU time)%n",
                "pairs",
                "method",
                "cold",
                "warm",
                "moving",
                "distance",
                "warm",
                "iterations",
                "stage");
        List<PairSet.Kind> kinds = new ArrayList<>();
        for (PairSet.Kind kind : PairSet.Kind.values()) {
            if (args.length > 0 && !Arrays.asList(args).contains(kind.name())) {
                continue;
            }
            kinds.add(kind);
            for (Method method : Method.values()) {
                System.out.printf(
                        Locale.ROOT,
                        "%-16s %-12s %8.0f %8.0f %8.0f %8.0f %8.0f",
                        kind,
                        method,
                        collide(kind, method, false, false),
                        collide(kind, method, true, false),
                        collide(kind, method, true, true),
                        distance(kind, method, false),
                        distance(kind, method, true));
                System.out.printf(Locale.ROOT, " %12s", iterations(kind, method));
                if (method == Method.SPECIALISED) {
                    System.out.printf(Locale.ROOT, " %8.0f", stage(kind));
                }
                System.out.println();
            }
        }
        peers(kinds);
    }

    /** The other engines' calls for single pairs, cold, and what crossing to them costs alone. */
    private static void peers(List<PairSet.Kind> kinds) {
        List<String> missing = new ArrayList<>();
        PairCalls.all(missing);
        missing.forEach(System.out::println);
        for (PairSet.Kind kind : kinds) {
            PairSet set = new PairSet(kind, 1);
            for (PairCalls calls : PairCalls.all(new ArrayList<>())) {
                set.addTo(calls);
                int found = calls.run();
                Fastest call = new Fastest();
                Fastest cross = new Fastest();
                long sum = 0;
                for (int k = 0; k < PEER_REPETITIONS; k++) {
                    long begin = THREADS.getCurrentThreadCpuTime();
                    sum += calls.run();
                    long middle = THREADS.getCurrentThreadCpuTime();
                    sum += calls.cross();
                    long end = THREADS.getCurrentThreadCpuTime();
                    call.add(middle - begin);
                    cross.add(end - middle);
                }
                System.out.printf(
                        Locale.ROOT,
                        "%-16s %-40s cold %6.0f, of it the crossing %4.0f (%d found in %d pairs)%n",
                        kind,
                        calls.title(),
                        call.nanos() / PairSet.SIZE,
                        cross.nanos() / PairSet.SIZE,
                        sum == 0 ? 0 : found,
                        PairSet.SIZE);
            }
        }
    }

    private static double collide(PairSet.Kind kind, Method method, boolean warm, boolean moves) {
        PairSet set = new PairSet(kind, 1);
        NarrowPhase n = new NarrowPhase(method);
        Manifold manifold = RESULT[0];
        long[] words = new long[PairSet.SIZE];
        Fastest fastest = new Fastest();
        int points = 0;
        long until = THREADS.getCurrentThreadCpuTime() + LEAST_TIME;
        for (int k = 0; k < REPETITIONS || THREADS.getCurrentThreadCpuTime() < until; k++) {
            if (moves) {
                set.move(k);
            }
            long begin = THREADS.getCurrentThreadCpuTime();
            for (int i = 0; i < PairSet.SIZE; i++) {
                words[i] = set.collide(i, n, warm ? words[i] : 0, manifold);
                points += manifold.pointCount;
            }
            long nanos = THREADS.getCurrentThreadCpuTime() - begin;
            fastest.add(nanos);
        }
        if (points < 0 || Double.isNaN(manifold.normalX)) {
            throw new IllegalStateException("the contacts of " + kind + " are no numbers");
        }
        return fastest.nanos() / PairSet.SIZE;
    }

    private static double distance(PairSet.Kind kind, Method method, boolean warm) {
        long[] words = new long[PairSet.SIZE];
        PairSet set = new PairSet(kind, 1);
        NarrowPhase n = new NarrowPhase(method);
        Fastest fastest = new Fastest();
        double sum = 0;
        long until = THREADS.getCurrentThreadCpuTime() + LEAST_TIME;
        for (int k = 0; k < REPETITIONS || THREADS.getCurrentThreadCpuTime() < until; k++) {
            set.move(k);
            long begin = THREADS.getCurrentThreadCpuTime();
            for (int i = 0; i < PairSet.SIZE; i++) {
                sum += set.distance(i, n, warm ? words[i] : 0);
                words[i] = n.distanceKey();
            }
            long nanos = THREADS.getCurrentThreadCpuTime() - begin;
            fastest.add(nanos);
        }
        if (Double.isNaN(sum)) {
            throw new IllegalStateException("a distance of " + kind + " is NaN");
        }
        return fastest.nanos() / PairSet.SIZE;
    }

    /** Median, 99.9th percentile and most steps of GJK and EPA together, cold. */
    private static String iterations(PairSet.Kind kind, Method method) {
        NarrowPhase n = new NarrowPhase(method);
        Manifold manifold = new Manifold();
        int[] steps = new int[ITERATION_SETS * PairSet.SIZE];
        for (int s = 0; s < ITERATION_SETS; s++) {
            PairSet set = new PairSet(kind, 1000 + s);
            for (int i = 0; i < PairSet.SIZE; i++) {
                n.forgetIterations();
                set.collide(i, n, 0, manifold);
                steps[s * PairSet.SIZE + i] = n.iterations();
            }
        }
        Arrays.sort(steps);
        int rare = steps[(int) (0.999 * (steps.length - 1))];
        return steps[steps.length / 2] + "/" + rare + "/" + steps[steps.length - 1];
    }

    private static double stage(PairSet.Kind kind) {
        Fastest fastest = new Fastest();
        try (StageSet set = new StageSet(kind)) {
            // The stage goes without lanes until their kernels are compiled.
            if (!BoxWarmUp.await()) {
                System.out.print(" (without lanes)");
            }
            long until = THREADS.getCurrentThreadCpuTime() + LEAST_TIME;
            for (int k = 0; k < REPETITIONS || THREADS.getCurrentThreadCpuTime() < until; k++) {
                set.move(k);
                long begin = THREADS.getCurrentThreadCpuTime();
                set.run();
                long nanos = THREADS.getCurrentThreadCpuTime() - begin;
                fastest.add(nanos);
            }
        }
        return fastest.nanos() / StageSet.ROWS;
    }
}
