package dev.cairn.samples.accuracy;

import java.util.Map;

/**
 * What came out of one case.
 *
 * @param of the case
 * @param values metrics by the number of sub-steps; numbers that were not run are missing
 * @param micros µs of a body and tick at 4 sub-steps; NaN if too short to measure
 * @param seconds wall time of all runs, s
 */
record AccuracyRow(AccuracyCase of, Map<Integer, double[]> values, double micros, double seconds) {

    /** Whether a metric reaches its bar at the engine's default of 4 sub-steps. */
    boolean holds(int metric) {
        double[] at = values.get(AccuracyCommand.DEFAULT_SUBSTEPS);
        return at != null && at[metric] <= of.metrics().get(metric).bar();
    }
}
