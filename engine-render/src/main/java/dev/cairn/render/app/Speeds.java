package dev.cairn.render.app;

/** How many seconds pass in a scene in one of the user, in steps of two. Stateless. */
final class Speeds {
    static final double SLOWEST = 1.0 / 64;
    static final double FASTEST = 16;

    private static final String[] TEXTS = {
        "1/64x", "1/32x", "1/16x", "1/8x", "1/4x", "1/2x", "1x", "2x", "4x", "8x", "16x"
    };

    private Speeds() {}

    /** "1/4x"; no new object for a power of two from 1/64 to 16. */
    static String text(double scale) {
        double power = SLOWEST;
        for (String text : TEXTS) {
            if (scale == power) {
                return text;
            }
            power *= 2;
        }
        return scale >= 1 ? trimmed(scale) + "x" : "1/" + trimmed(1 / scale) + "x";
    }

    private static String trimmed(double value) {
        double rounded = Math.rint(10 * value) / 10;
        return rounded == Math.rint(rounded)
                ? Long.toString((long) rounded)
                : Double.toString(rounded);
    }
}
