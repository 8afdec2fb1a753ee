package dev.cairn.physics.collider;

/**
 * How a number of two surfaces that meet becomes one: the friction, or the restitution. Each
 * surface names a rule; of two different ones the stronger wins, which is the later one here.
 */
public enum Mix {
    /** What the world does if nobody says otherwise: friction sqrt(a b), restitution max(a, b). */
    DEFAULT(0),
    /** (a + b)/2. */
    AVERAGE(1),
    /** The smaller one. */
    MINIMUM(2),
    /** a b. */
    MULTIPLY(3),
    /** The larger one. */
    MAXIMUM(4);

    private final int strength;

    Mix(int strength) {
        this.strength = strength;
    }

    /**
     * How strong the rule is.
     *
     * @return 0 to 4
     */
    public int strength() {
        return strength;
    }

    /**
     * Mixes two numbers.
     *
     * @param rules strengths of the two rules, one in the lower four bits, one in the upper
     * @param a one number
     * @param b the other
     * @param standard the result of {@link #DEFAULT}
     * @return the result of the stronger rule
     */
    public static double of(int rules, double a, double b, double standard) {
        return switch (Math.max(rules & 15, rules >> 4)) {
            case 1 -> 0.5 * (a + b);
            case 2 -> Math.min(a, b);
            case 3 -> a * b;
            case 4 -> Math.max(a, b);
            default -> standard;
        };
    }
}
