package dev.cairn.benchmarks.compare;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Map;

/** What goes between the report's JVM and an engine's, one JSON object a line. */
final class Protocol {
    /** Marks an answer among what native libraries print. */
    static final String MARK = "@@cairn ";

    private Protocol() {}

    /** What an engine's JVM is asked to do. */
    enum Kind {
        /** Run the whole scene once and measure errors. */
        JUDGE,
        /** Run until times settle. */
        WARM,
        /** Take times. */
        TIME
    }

    /**
     * A request.
     *
     * @param kind what to do
     * @param scene id of the case
     * @param settings parameters of the scene that differ from the case's own
     * @param workers threads
     * @param substeps sub-steps per tick
     * @param seconds how long to step at least, for {@code TIME}, or at most, for {@code WARM}
     */
    record Request(
            Kind kind,
            String scene,
            Map<String, String> settings,
            int workers,
            int substeps,
            double seconds) {}

    /**
     * An answer. Numbers are null where they do not apply: JSON has no NaN.
     *
     * @param failure null, or why there are no numbers
     * @param missing true if the engine is not there at all
     * @param error the drawn error
     * @param deepest deepest overlap, m
     * @param pairs contacts after the last tick
     * @param points contact points after the last tick
     * @param bodies movable bodies
     * @param ticks ticks timed, or judged
     * @param cpuMicros CPU time per movable body and tick
     * @param medianMillis wall time of a tick, median
     * @param p99Millis wall time of a tick, 99th percentile
     * @param notes of the engine
     */
    record Answer(
            @Nullable String failure,
            boolean missing,
            @Nullable Double error,
            @Nullable Double deepest,
            int pairs,
            int points,
            int bodies,
            long ticks,
            @Nullable Double cpuMicros,
            @Nullable Double medianMillis,
            @Nullable Double p99Millis,
            List<String> notes) {

        static Answer failed(String why, boolean missing) {
            return new Answer(why, missing, null, null, -1, -1, 0, 0, null, null, null, List.of());
        }
    }
}
