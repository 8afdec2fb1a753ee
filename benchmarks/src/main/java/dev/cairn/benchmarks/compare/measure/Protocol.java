package dev.cairn.benchmarks.compare.measure;

import dev.cairn.benchmarks.peer.PeerSettings;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Map;

/** What goes between the report's JVM and an engine's, one JSON object a line. */
public final class Protocol {
    /** Marks an answer among what native libraries print. */
    public static final String MARK = "@@cairn ";

    private Protocol() {}

    /** What an engine's JVM is asked to do. */
    public enum Kind {
        /** Run the whole scene once and measure errors. */
        JUDGE,
        /** Run until times settle. */
        WARM,
        /** Take times. */
        TIME,
        /** Take the time of every tick since the JVM started. */
        COLD
    }

    /**
     * A request.
     *
     * @param kind what to do
     * @param scene id of the case
     * @param settings parameters of the scene that differ from the case's own
     * @param peer how the engine is set
     * @param seconds how long to step: at least, for {@code TIME}; at most, for the others
     */
    public record Request(
            Kind kind,
            String scene,
            Map<String, String> settings,
            PeerSettings peer,
            double seconds) {}

    /**
     * An answer. Numbers are null where they do not apply: JSON has no NaN.
     *
     * @param failure null, or why there are no numbers
     * @param missing true if the engine is not there at all
     * @param error the drawn error
     * @param errors all of the scene's errors that apply, by name; of a cold start, its figures
     * @param deepest deepest overlap, m
     * @param pairs contacts after the last tick
     * @param points contact points after the last tick
     * @param bodies movable bodies
     * @param ticks ticks timed, or judged
     * @param cpuMicros CPU time of the process per movable body and tick, compilers' left out
     * @param medianMillis wall time of a tick, median
     * @param p99Millis wall time of a tick, 99th percentile
     * @param compilerShare CPU time of the JIT compilers as a share of what counts, or -1
     * @param cold pairs of ms since the start of the JVM and ms of the tick that ended then
     * @param notes of the engine
     */
    public record Answer(
            @Nullable String failure,
            boolean missing,
            @Nullable Double error,
            Map<String, Double> errors,
            @Nullable Double deepest,
            int pairs,
            int points,
            int bodies,
            long ticks,
            @Nullable Double cpuMicros,
            @Nullable Double medianMillis,
            @Nullable Double p99Millis,
            double compilerShare,
            List<Double> cold,
            List<String> notes) {

        public static Answer failed(String why, boolean missing) {
            return new Answer(
                    why, missing, null, Map.of(), null, -1, -1, 0, 0, null, null, null, -1,
                    List.of(), List.of());
        }

        /** What is too slow by expectation, with its expected cost. */
        public static Answer slow(String why, int bodies, double micros) {
            return new Answer(
                    why, false, null, Map.of(), null, -1, -1, bodies, 0, micros, null, null, -1,
                    List.of(), List.of());
        }

        /** The same without errors, overlaps and counts. */
        public Answer withoutErrors() {
            return new Answer(
                    failure,
                    missing,
                    null,
                    Map.of(),
                    null,
                    -1,
                    -1,
                    bodies,
                    ticks,
                    cpuMicros,
                    medianMillis,
                    p99Millis,
                    compilerShare,
                    cold,
                    notes);
        }

        public static Answer timed(
                int bodies, long ticks, double cpu, double median, double p99, double compilers) {
            return new Answer(
                    null, false, null, Map.of(), null, -1, -1, bodies, ticks, cpu, median, p99,
                    compilers, List.of(), List.of());
        }
    }
}
