package dev.cairn.physics.shape.decomposition;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.shape.ConvexHull;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * Makes one part of two where their common hull is hardly larger: first those that add least
 * volume, until there are few enough parts, and then all that stay within the allowed error.
 */
final class Merger {
    private final double tolerance;
    private final double allowed;

    /** Volumes that differ by less are equal, m³. */
    private final double tie;

    private final Jobs jobs;
    private final HullGap gap;

    Merger(Solid solid, double tolerance, double allowed, Jobs jobs) {
        this.tolerance = tolerance;
        this.allowed = allowed;
        tie = 1e-9 * solid.size * solid.size * solid.size;
        this.jobs = jobs;
        gap = new HullGap(solid);
    }

    /** Two parts, older ones first, as one. */
    private static final class Pair {
        final Part a, b;

        /** Null if they are apart, or the error of their hull is too large. */
        @Nullable ConvexHull hull;

        double added;

        Pair(Part a, Part b) {
            this.a = a;
            this.b = b;
        }
    }

    /**
     * Merges.
     *
     * @param parts in their order; changed
     * @param most how many may be left
     * @param told between merges
     */
    void merge(List<Part> parts, int most, Runnable told) {
        List<Pair> pairs = new ArrayList<>();
        for (int j = 1; j < parts.size(); j++) {
            for (int i = 0; i < j; i++) {
                pairs.add(new Pair(parts.get(i), parts.get(j)));
            }
        }
        weigh(pairs);
        while (true) {
            told.run();
            Pair best = best(pairs);
            if (best == null) {
                return;
            }
            boolean tooMany = parts.size() > most;
            Part merged = measured(best, tooMany ? Double.POSITIVE_INFINITY : allowed);
            if (!tooMany && merged.bound > allowed) {
                best.hull = null; // looked at no more
                continue;
            }
            parts.remove(best.a);
            parts.remove(best.b);
            pairs.removeIf(p -> p.a == best.a || p.b == best.a || p.a == best.b || p.b == best.b);
            List<Pair> more = new ArrayList<>();
            for (Part other : parts) {
                more.add(new Pair(other, merged));
            }
            parts.add(merged);
            weigh(more);
            pairs.addAll(more);
        }
    }

    private @Nullable Pair best(List<Pair> pairs) {
        Pair best = null;
        for (Pair pair : pairs) {
            if (pair.hull != null && (best == null || pair.added < best.added - tie)) {
                best = pair;
            }
        }
        return best;
    }

    private void weigh(List<Pair> pairs) {
        jobs.run(
                (i, worker) -> {
                    Pair pair = pairs.get(i);
                    double[] first = pair.a.hull.vertices();
                    double[] second = pair.b.hull.vertices();
                    double[] all = java.util.Arrays.copyOf(first, first.length + second.length);
                    System.arraycopy(second, 0, all, first.length, second.length);
                    pair.hull = Piece.hull(all, tolerance);
                    pair.added =
                            pair.hull == null
                                    ? Double.POSITIVE_INFINITY
                                    : pair.hull.volume()
                                            - pair.a.hull.volume()
                                            - pair.b.hull.volume();
                },
                pairs.size());
    }

    private Part measured(Pair pair, double hopeless) {
        ConvexHull hull = pair.hull;
        if (hull == null) {
            throw new IllegalStateException("two parts of a volume have a hull of none");
        }
        gap.measure(hull, allowed / 8, 0.25, allowed, hopeless);
        double[] points =
                java.util.Arrays.copyOf(pair.a.points, pair.a.points.length + pair.b.points.length);
        System.arraycopy(pair.b.points, 0, points, pair.a.points.length, pair.b.points.length);
        return new Part(null, hull, points, gap.found, gap.bound);
    }
}
