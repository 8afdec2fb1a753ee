package dev.cairn.render.ui.nuklear;

/**
 * Which value lies where along a slider: evenly, or evenly in the logarithm where the largest value
 * is more than a thousand times the least. Stateless.
 */
final class SliderScale {
    private SliderScale() {}

    /** Where a value lies, 0..1; the nearer end for what is beyond it. */
    static double share(double min, double max, double value) {
        double low = along(min, max, min);
        return Math.clamp((along(min, max, value) - low) / (along(min, max, max) - low), 0.0, 1.0);
    }

    /** The value at a place of 0..1. */
    static double value(double min, double max, double share) {
        double low = along(min, max, min);
        double point = low + share * (along(min, max, max) - low);
        return isLogarithmic(min, max) ? Math.exp(point) : point;
    }

    private static double along(double min, double max, double value) {
        return isLogarithmic(min, max) ? Math.log(value) : value;
    }

    private static boolean isLogarithmic(double min, double max) {
        return min > 0 && max > 1000 * min;
    }
}
