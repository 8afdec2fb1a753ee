package dev.cairn.physics.solver.load;

import dev.cairn.physics.internal.ContactStore;

/**
 * The numbers of an island that is swept, and where the next sweep starts from: all impulses, and
 * the velocities of its bodies, which are linear in impulses, so that both stay in step.
 */
abstract class SweepLeaps {
    /** Numbers of a row that have a say in how far it is from the end: all but the twist. */
    static final int COUNTED = 6;

    /** Of a body: its velocity. */
    static final int SPEEDS = 6;

    /** Changes below this share of the largest impulse that do not get smaller are rounding. */
    private static final double ROUNDING = 1e-10;

    /** Sweeps in which a change has not come to half of the least so far. */
    private static final int PATIENCE = 16;

    /** Places of the island's rows, and where its bodies are; how many there are. */
    int[] place = {};

    int[] body = {};
    int rows, bodies;

    /**
     * Before a sweep, and after it: of each row four normal impulses and two of friction; then all
     * twists; then all velocities.
     */
    double[] before = {}, after = {};

    /** The least change so far, and sweeps since one came to half of that before. */
    private double least;

    private int inVain;

    /** Another island; allocates where it is larger than those before. */
    void begin(int rowCount, int bodyCount) {
        rows = 0;
        bodies = 0;
        least = Double.POSITIVE_INFINITY;
        inVain = 0;
        if (place.length < rowCount) {
            place = new int[rowCount];
        }
        if (body.length < bodyCount) {
            body = new int[bodyCount];
        }
        int size = (COUNTED + 1) * rowCount + SPEEDS * bodyCount;
        if (before.length < size) {
            before = new double[size];
            after = new double[size];
        }
    }

    /** How many numbers there are. */
    final int size() {
        return (COUNTED + 1) * rows + SPEEDS * bodies;
    }

    /** Where the twist of a row is among the numbers. */
    final int twist(int row) {
        return COUNTED * rows + row;
    }

    /** Where the velocity of a body is among the numbers. */
    final int speed(int index) {
        return (COUNTED + 1) * rows + SPEEDS * index;
    }

    /** Tells a number before the first sweep. */
    final void start(int at, double value) {
        before[at] = value;
    }

    /** Tells a number after a sweep. */
    final void end(int at, double value) {
        after[at] = value;
    }

    /** A number from which the next sweep starts. */
    final double next(int at) {
        return before[at];
    }

    /**
     * After a sweep: whether it was the last one.
     *
     * @param change the largest of an impulse in it
     * @param largest impulse
     * @param agrees share of the largest at which impulses agree
     */
    final boolean areDone(double change, double largest, double agrees) {
        inVain++;
        if (change < least / 2) {
            least = change;
            inVain = 0;
        }
        return !(change > agrees * largest) || (inVain > PATIENCE && change < ROUNDING * largest);
    }

    /**
     * After a sweep: finds from where the next one starts.
     *
     * @param change the largest of an impulse in the sweep
     */
    abstract void leap(double change);

    /** Whether a number is a normal impulse. */
    static boolean isNormal(int at) {
        return at % COUNTED < ContactStore.POINTS;
    }
}
