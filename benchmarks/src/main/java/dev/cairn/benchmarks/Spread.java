package dev.cairn.benchmarks;

import java.util.Arrays;
import java.util.List;

/** Median and its standard error. */
public final class Spread {
    private Spread() {}

    /**
     * The median.
     *
     * @param values any number of them
     * @return the middle one, or the mean of the two in the middle; NaN of none
     */
    public static double median(List<Double> values) {
        double[] sorted = values.stream().mapToDouble(Double::doubleValue).sorted().toArray();
        int n = sorted.length;
        if (n == 0) {
            return Double.NaN;
        }
        return n % 2 == 1 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
    }

    /**
     * The standard error of the median, as a share of it: 1.4826 x the median deviation is the
     * standard deviation of what is normally distributed, and the median's error is 1.2533 x that
     * over the root of the number (Kenney and Keeping 1962). The deviation is corrected for small
     * numbers by n / (n - 0.8) (Croux and Rousseeuw 1992).
     *
     * @param values at least two
     * @return at least 0
     */
    public static double error(List<Double> values) {
        double median = median(values);
        int n = values.size();
        double[] away = values.stream().mapToDouble(value -> Math.abs(value - median)).toArray();
        double deviation = median(Arrays.stream(away).boxed().toList());
        return 1.2533 * 1.4826 * deviation * n / (n - 0.8) / Math.sqrt(n) / Math.abs(median);
    }
}
