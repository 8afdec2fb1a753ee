package dev.cairn.physics.collider;

/**
 * How a number of two surfaces that meet becomes one: the friction, or the restitution. Each
 * surface names a rule; of two different ones the stronger wins, which is the later one here.
 */
public enum Mix {
    /** What the world does if nobody says otherwise: friction sqrt(a b), restitution max(a, b). */
    DEFAULT,
    /** (a + b)/2. */
    AVERAGE,
    /** The smaller one. */
    MINIMUM,
    /** a b. */
    MULTIPLY,
    /** The larger one. */
    MAXIMUM;

    private static final Mix[] ALL = values();

    /**
     * Mixes two numbers.
     *
     * @param rules ordinals of the two rules, one in the lower four bits, one in the upper
     * @param a one number
     * @param b the other
     * @param standard the result of {@link #DEFAULT}
     * @return the result of the stronger rule
     */
    public static double of(int rules, double a, double b, double standard) {
        return switch (ALL[Math.max(rules & 15, rules >> 4)]) {
            case DEFAULT -> standard;
            case AVERAGE -> 0.5 * (a + b);
            case MINIMUM -> Math.min(a, b);
            case MULTIPLY -> a * b;
            case MAXIMUM -> Math.max(a, b);
        };
    }
}
