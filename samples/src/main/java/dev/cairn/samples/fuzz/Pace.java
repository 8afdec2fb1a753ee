package dev.cairn.samples.fuzz;

import java.util.SplittableRandom;

/** How long the ticks of a world are. */
public enum Pace {
    /** All the same. */
    EVEN,
    /** Half and twice as long in turns. */
    TURNS,
    /** Every tenth a tenth as long. */
    HICCUP,
    /** Random, from a sixteenth to twice as long. */
    RANDOM;

    /**
     * The lengths of ticks.
     *
     * @param base length of an even tick, s
     * @param count how many
     * @param seed of those that are random
     * @return s, one by tick
     */
    public double[] seconds(double base, int count, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double[] seconds = new double[count];
        for (int i = 0; i < count; i++) {
            seconds[i] =
                    base
                            * switch (this) {
                                case EVEN -> 1;
                                case TURNS -> i % 2 == 0 ? 0.5 : 2;
                                case HICCUP -> i % 10 == 9 ? 0.1 : 1;
                                case RANDOM -> StrictMath.pow(2, 5 * random.nextDouble() - 4);
                            };
        }
        return seconds;
    }
}
