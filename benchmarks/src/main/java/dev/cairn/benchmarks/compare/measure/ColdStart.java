package dev.cairn.benchmarks.compare.measure;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleSupplier;

/**
 * What the first seconds of a JVM are told by: the scene is stepped from the JVM's start on, over
 * and over. One thread.
 */
public final class ColdStart {
    /** Wall time of the first tick, ms. */
    public static final String FIRST_TICK = "firstTickMilliseconds";

    /** Wall time of the first sixty ticks, s. */
    public static final String SIXTY = "sixtyTicksSeconds";

    /** CPU time of the whole process for these, compilers included, s. */
    public static final String SIXTY_CPU = "sixtyTicksCpuSeconds";

    /** Wall time of the scene's first run, s. */
    public static final String SCENE = "sceneSeconds";

    /** CPU time of the whole process for that, s. */
    public static final String SCENE_CPU = "sceneCpuSeconds";

    /**
     * From the JVM's start to the begin of the run of the scene from which on none takes more than
     * {@link #STEADY} times the last one, s.
     */
    public static final String SETTLED = "settledSeconds";

    /** All of them, in the order of tables. */
    public static final List<String> NAMES =
            List.of(FIRST_TICK, SIXTY, SIXTY_CPU, SCENE, SCENE_CPU, SETTLED);

    private static final int EARLY = 60;
    private static final double STEADY = 1.3;

    private final int sceneTicks;

    /** Pairs of ms since the JVM's start at a tick's end and ms that it took. */
    private final List<Double> ticks = new ArrayList<>();

    private final Map<String, Double> figures = new LinkedHashMap<>();

    /**
     * Before the first tick.
     *
     * @param sceneTicks length of the scene
     */
    ColdStart(int sceneTicks) {
        this.sceneTicks = sceneTicks;
    }

    /**
     * One more tick.
     *
     * @param sinceStartMillis from the JVM's start to the tick's end
     * @param tookMillis wall time of the tick
     * @param cpuSeconds of the process since before the first tick; asked for where it is told
     */
    void add(double sinceStartMillis, double tookMillis, DoubleSupplier cpuSeconds) {
        ticks.add(sinceStartMillis);
        ticks.add(tookMillis);
        int count = ticks.size() / 2;
        if (count == 1) {
            figures.put(FIRST_TICK, tookMillis);
        }
        if (count == EARLY) {
            figures.put(SIXTY, seconds(0, count));
            figures.put(SIXTY_CPU, cpuSeconds.getAsDouble());
        }
        if (count == sceneTicks) {
            figures.put(SCENE, seconds(0, count));
            figures.put(SCENE_CPU, cpuSeconds.getAsDouble());
        }
    }

    int count() {
        return ticks.size() / 2;
    }

    /** Returns the figures that were reached, by name. */
    Map<String, Double> figures() {
        int runs = count() / sceneTicks;
        if (runs > 1) {
            double last = seconds((runs - 1) * sceneTicks, runs * sceneTicks);
            int run = runs - 1;
            while (run > 0 && seconds((run - 1) * sceneTicks, run * sceneTicks) <= STEADY * last) {
                run--;
            }
            int first = 2 * run * sceneTicks;
            figures.put(SETTLED, (ticks.get(first) - ticks.get(first + 1)) / 1e3);
        }
        return figures;
    }

    private double seconds(int from, int to) {
        double sum = 0;
        for (int tick = from; tick < to; tick++) {
            sum += ticks.get(2 * tick + 1);
        }
        return sum / 1e3;
    }

    /** Returns the median tick of each of some spans of time, each a tenth longer than the last. */
    List<Double> thinned() {
        List<Double> kept = new ArrayList<>();
        int from = 0;
        while (from < ticks.size()) {
            double until = ticks.get(from) * 1.1;
            List<Double> span = new ArrayList<>();
            int at = from;
            while (at < ticks.size() && ticks.get(at) <= until) {
                span.add(ticks.get(at + 1));
                at += 2;
            }
            span.sort(null);
            kept.add(ticks.get(at - 2));
            kept.add(span.get(span.size() / 2));
            from = at;
        }
        return kept;
    }
}
