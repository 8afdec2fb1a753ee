package dev.cairn.samples.accuracy;

import java.util.List;

/**
 * One case of the table: a set-up, its truth, and how far the engine is from it.
 *
 * @param id short name: letter of the group and number
 * @param title a few words
 * @param setup what is simulated, with its numbers
 * @param truth what must come out, and from where that is known
 * @param metrics what is compared, each with the bar to reach at 4 sub-steps
 * @param published the best published figure of another engine, with the tag of its source; empty
 *     where none is known
 * @param effort how long a run takes
 * @param experiment runs it
 */
public record AccuracyCase(
        String id,
        String title,
        String setup,
        String truth,
        List<Metric> metrics,
        String published,
        Effort effort,
        Experiment experiment) {

    /** Copies the list. */
    public AccuracyCase {
        metrics = List.copyOf(metrics);
    }

    /** How long a case takes, which says when it is run. */
    public enum Effort {
        /** Below a second at each number of sub-steps; always run. */
        SHORT,
        /** Some seconds; left out by {@code --quick}. */
        MEDIUM,
        /** Many bodies; run at 4 sub-steps only, at all with {@code --long}. */
        HEAVY,
        /** Minutes; only with {@code --long}, at 4 sub-steps. */
        LONG
    }

    /**
     * One number that a case is judged by.
     *
     * @param name what it is
     * @param unit its unit; empty for ratios
     * @param bar the largest value that is good enough, at least 0
     */
    public record Metric(String name, String unit, double bar) {}

    /** Runs a case. */
    @FunctionalInterface
    public interface Experiment {
        /**
         * Simulates, and compares with the truth.
         *
         * @param trial makes and steps worlds
         * @return the value of each metric, in the order of the case; NaN or infinity where the
         *     scene fell apart before it could be measured
         */
        double[] run(Trial trial);
    }

    /**
     * Returns a metric.
     *
     * @param name what it is
     * @param unit its unit
     * @param bar the largest good value
     * @return the metric
     */
    static Metric metric(String name, String unit, double bar) {
        return new Metric(name, unit, bar);
    }
}
