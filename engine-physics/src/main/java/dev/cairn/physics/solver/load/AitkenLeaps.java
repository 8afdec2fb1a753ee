package dev.cairn.physics.solver.load;

/**
 * Leaps along what the last sweep did, for islands whose contacts open, slip and close while they
 * are swept, see {@link CarriedIslands}.
 *
 * <p>If each sweep leaves the share q of an error, then what is left after one is q/(1 - q) of what
 * it did. Every fourth sweep the share is measured, and all numbers leap as far. Sweeps that are
 * longer past, as {@link SweepMixing} goes by, lead astray here: of 1200 rides 5 slipped with it.
 *
 * <p>Source: A. C. Aitken, "On Bernoulli's numerical solution of algebraic equations", Proceedings
 * of the Royal Society of Edinburgh 46 (1926).
 */
final class AitkenLeaps extends SweepLeaps {
    /** Sweeps from leap to leap. */
    private static final int EVERY = 4;

    /** Of a leap, in changes of a sweep. */
    private static final double LONGEST = 100;

    /** A leap that did not help was too long, by so much; after one that did it may be longer. */
    private static final double SHORTER = 0.25, LONGER = 2;

    private double[] last = {};
    private int sweeps;

    /** Of the sweep before, and of that before the last leap. */
    private double lastChange, changeAtLeap;

    /** Of the next leap, at most, and of the last one. */
    private double longest, leapt;

    @Override
    void begin(int rowCount, int bodyCount) {
        super.begin(rowCount, bodyCount);
        if (last.length < before.length) {
            last = new double[before.length];
        }
        sweeps = 0;
        lastChange = 0;
        changeAtLeap = Double.POSITIVE_INFINITY;
        longest = LONGEST;
        leapt = 0;
    }

    @Override
    void leap(double change) {
        int size = size();
        int phase = sweeps++ % EVERY;
        double s = 0;
        if (phase == EVERY - 1) {
            // without a profit by the next one it is made shorter
            longest = change < changeAtLeap ? Math.min(LONGER * longest, LONGEST) : SHORTER * leapt;
            changeAtLeap = change;
            double q = change / lastChange;
            s = q < 1 ? Math.min(q / (1 - q), reach()) : 0;
            leapt = s;
        }
        for (int i = 0; i < size; i++) {
            before[i] = after[i] + s * (after[i] - last[i]);
        }
        System.arraycopy(after, 0, last, 0, size);
        lastChange = change;
    }

    /** No normal impulse may become negative. */
    private double reach() {
        double reach = longest;
        for (int i = 0; i < COUNTED * rows; i++) {
            double less = last[i] - after[i];
            if (less > 0 && isNormal(i)) {
                reach = Math.min(reach, after[i] / less);
            }
        }
        return reach;
    }
}
