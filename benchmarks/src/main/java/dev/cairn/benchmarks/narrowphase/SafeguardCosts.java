package dev.cairn.benchmarks.narrowphase;

import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.NarrowPhase.Method;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Safeguard;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * What each {@link Safeguard} costs: all pairs of a set with it and without it, by turns in one
 * JVM, by thread CPU time. Of each block of pairs, at each place of the motion, the least time
 * counts; told is the ratio of the sums, and in how many pairs the contact is another one without.
 * The first row leaves nothing out: how far it is from 1 is the noise.
 *
 * <p>{@code java --add-modules=jdk.incubator.vector -jar benchmarks.jar narrow-phase safeguards}
 */
public final class SafeguardCosts {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    /** Turns of all pairs; the motion repeats within {@link #PLACES}. */
    private static final int TURNS = 320, PLACES = 16;

    /** Pairs timed together. */
    private static final int BLOCK = 32;

    private static final int BLOCKS = PairSet.SIZE / BLOCK;

    private static final PairSet.Kind[] KINDS = {
        PairSet.Kind.TUMBLED_BOXES, PairSet.Kind.HULLS_32, PairSet.Kind.HULLS_32_SHALLOW
    };

    private final PairSet set;
    private final boolean warm;
    private final Manifold manifold = new Manifold();
    private final long[] hash = new long[PairSet.SIZE];

    private SafeguardCosts(PairSet.Kind kind, boolean warm) {
        this.set = new PairSet(kind, 1);
        this.warm = warm;
    }

    /** One way to collide, with the words that it keeps for itself, and its least times, ns. */
    private static final class Way {
        final NarrowPhase narrowPhase;
        final long[] words = new long[PairSet.SIZE];
        final double[] least = new double[BLOCKS * PLACES];

        Way(NarrowPhase narrowPhase) {
            this.narrowPhase = narrowPhase;
            Arrays.fill(least, Double.MAX_VALUE);
        }

        /** Of all blocks at all places that were run. */
        double used() {
            double sum = 0;
            for (double nanos : least) {
                sum += nanos < Double.MAX_VALUE ? nanos : 0;
            }
            return sum;
        }
    }

    /** With all and without one, each with a history of its own. */
    private record Both(String without, Way all, Way less) {}

    /**
     * Measures.
     *
     * @param args names of kinds, or nothing for boxes and hulls
     */
    public static void main(String[] args) {
        System.out.printf(
                Locale.ROOT,
                "%-17s %-12s %-7s %-18s %12s %7s%n",
                "pairs",
                "method",
                "",
                "safeguard",
                "its share, %",
                "differ");
        List<PairSet.Kind> kinds = new ArrayList<>();
        for (String name : args) {
            kinds.add(PairSet.Kind.valueOf(name));
        }
        for (PairSet.Kind kind : kinds.isEmpty() ? List.of(KINDS) : kinds) {
            boolean boxes = kind.name().endsWith("BOXES");
            Method method = boxes ? Method.GENERAL : Method.SPECIALISED;
            new SafeguardCosts(kind, false).measure(kind, method);
            new SafeguardCosts(kind, true).measure(kind, method);
        }
    }

    private void measure(PairSet.Kind kind, Method method) {
        List<Both> all = new ArrayList<>();
        all.add(both("(none)", method, new NarrowPhase(method)));
        for (Safeguard s : Safeguard.values()) {
            all.add(both(s.name(), method, new NarrowPhase(method, s)));
        }
        for (int turn = 0; turn < TURNS; turn++) {
            int place = warm ? turn % PLACES : 0;
            set.move(place);
            for (Both both : all) {
                boolean swap = (turn / PLACES) % 2 == 1;
                for (int block = 0; block < BLOCKS; block++) {
                    run(swap ? both.less : both.all, block, place);
                    run(swap ? both.all : both.less, block, place);
                }
            }
        }
        String row = String.format(Locale.ROOT, "%-17s %-12s %-7s", kind, method, title());
        for (Both both : all) {
            double share = 100 * (1 - both.less.used() / both.all.used());
            System.out.printf(
                    Locale.ROOT,
                    "%s %-18s %12.1f %7d%n",
                    row,
                    both.without,
                    share,
                    differing(both));
        }
        double ns = all.get(0).all.used() / (PairSet.SIZE * (warm ? PLACES : 1));
        System.out.printf(Locale.ROOT, "%s with all of them %8.0f ns a pair%n", row, ns);
    }

    private String title() {
        return warm ? "moving" : "cold";
    }

    private static Both both(String without, Method method, NarrowPhase less) {
        return new Both(without, new Way(new NarrowPhase(method)), new Way(less));
    }

    private void run(Way way, int block, int place) {
        long begin = THREADS.getCurrentThreadCpuTime();
        for (int i = block * BLOCK; i < (block + 1) * BLOCK; i++) {
            way.words[i] = set.collide(i, way.narrowPhase, warm ? way.words[i] : 0, manifold);
        }
        double nanos = (double) (THREADS.getCurrentThreadCpuTime() - begin);
        int at = block * PLACES + place;
        way.least[at] = Math.min(way.least[at], nanos);
    }

    private int differing(Both both) {
        contacts(both.all);
        long[] with = hash.clone();
        contacts(both.less);
        int count = 0;
        for (int i = 0; i < PairSet.SIZE; i++) {
            count += with[i] == hash[i] ? 0 : 1;
        }
        return count;
    }

    /** A hash of each contact. */
    private void contacts(Way way) {
        for (int i = 0; i < PairSet.SIZE; i++) {
            set.collide(i, way.narrowPhase, warm ? way.words[i] : 0, manifold);
            long h = manifold.pointCount;
            for (int k = 0; k < manifold.pointCount; k++) {
                h = 31 * h + Double.doubleToLongBits(manifold.separation[k]);
                h = 31 * h + manifold.feature[k];
            }
            hash[i] = 31 * h + Double.doubleToLongBits(manifold.normalX);
        }
    }
}
