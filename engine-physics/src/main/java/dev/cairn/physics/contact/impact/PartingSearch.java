package dev.cairn.physics.contact.impact;

import dev.cairn.physics.sweep.TimeOfImpact;

/**
 * What becomes of two that have met, until the tick ends: they part, or sink into each other, or
 * neither.
 *
 * <p>Looks are apart by 2^-k of a tick, and never so far that the one could pass the other's middle
 * between two. The gaps themselves have no mirrored bits, and so nothing but comparisons may be
 * made of them. One worker's; does not allocate.
 */
public final class PartingSearch {
    /** How a search ends. */
    public enum End {
        /** They are apart. */
        PARTS,
        /** They overlap so deep that they are struck again. */
        SINKS,
        /** They are in touch. */
        STAYS
    }

    /** Of the smaller inner radius: the first look after an impact is that far on. */
    private static final double SHORT = 0x1p-12;

    /** The same: no two looks are farther apart, by the fastest way of any of their points. */
    private static final double LONG = 0.25;

    /** Of a time between two looks. */
    private static final int MOST_HALVINGS = 40;

    /**
     * Of the smaller inner radius: a pair that overlaps so deep after an impact is struck again.
     */
    private static final double SUNK = 0x1p-8;

    private final int mostLooks;

    /** When they part or sink, s after the start of the tick. */
    public double time;

    /** A search that gives up after some looks: then they stay. */
    public PartingSearch(int mostLooks) {
        this.mostLooks = mostLooks;
    }

    /**
     * Looks on from a meeting.
     *
     * @param search of the two
     * @param from when they met, s
     * @param step length of the tick, s
     * @param met nearer than that counts as met, m
     * @param inner radius of the thinner one, m
     */
    public End run(TimeOfImpact search, double from, double step, double met, double inner) {
        double fastest = search.fastest();
        double least = power(step, SHORT * inner / fastest);
        double most = Math.max(least, power(step, LONG * inner / fastest));
        double span = least;
        double before = search.gap(from);
        double deep = Math.min(before, 0) - SUNK * inner;
        double t = from;
        for (int i = 0; i < mostLooks && t < step; i++) {
            double next = Math.min(Math.max(t + span, Math.nextUp(t)), step);
            double gap = search.gap(next);
            if (gap > 3 * met) {
                time = next;
                return End.PARTS;
            }
            if (gap < deep) {
                time = sinking(search, t, next, gap, deep, inner);
                return End.SINKS;
            }
            // twice as far, but not so far that it would sink much deeper meanwhile
            double sunk = before - gap;
            span = Math.min(2 * span, most);
            for (double way = 2 * sunk; way > SUNK * inner && span > least; way *= 0.5) {
                span *= 0.5;
            }
            before = gap;
            t = next;
        }
        return End.STAYS;
    }

    /**
     * When two that sink have sunk too deep, and not much deeper: between two looks, by halving.
     */
    private static double sinking(
            TimeOfImpact search,
            double above,
            double below,
            double gap,
            double deep,
            double inner) {
        double low = above;
        double high = below;
        double there = gap;
        for (int i = 0; i < MOST_HALVINGS && there < deep - SUNK * inner; i++) {
            double mid = low + 0.5 * (high - low);
            double here = search.gap(mid);
            if (here < deep) {
                high = mid;
                there = here;
            } else {
                low = mid;
            }
        }
        return high;
    }

    /** The largest power of two, times the tick, that is no longer than a time. */
    private static double power(double step, double seconds) {
        double span = step;
        while (span > seconds) {
            span *= 0.5;
        }
        return span;
    }
}
