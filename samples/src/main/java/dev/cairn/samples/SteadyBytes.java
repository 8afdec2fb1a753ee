package dev.cairn.samples;

/**
 * Bytes per tick that a simulation allocates once it runs steadily, from the count of each tick.
 *
 * <p>A run also allocates what it needs once: arrays that grow when more bodies touch than ever
 * before, classes that load at the first contact, and, as late as the JIT compiler gets to a hot
 * method, the string literals of its error messages, which HotSpot resolves on the thread that asks
 * for the compilation. So the second half of the run is cut into {@value #WINDOWS} windows, and the
 * quietest counts. What every tick, or any regular share of the ticks, allocates is in each window
 * and cannot hide. Not thread-safe; {@link #add} allocates nothing.
 */
final class SteadyBytes {
    static final int WINDOWS = 4;

    private final int ticks;
    private final long[] windows = new long[WINDOWS];
    private int seen;

    /**
     * @param ticks length of the run, at least 0
     */
    SteadyBytes(int ticks) {
        this.ticks = ticks;
    }

    /** Notes the bytes of one more tick. */
    void add(long bytes) {
        int tick = seen++;
        for (int w = 0; w < WINDOWS; w++) {
            if (tick >= begin(w) && tick < begin(w + 1)) {
                windows[w] += bytes;
            }
        }
    }

    /** Returns the bytes per tick of the quietest window that has ticks; 0 if there is none. */
    double perTick() {
        double least = Double.POSITIVE_INFINITY;
        for (int w = 0; w < WINDOWS; w++) {
            int length = begin(w + 1) - begin(w);
            if (length > 0) {
                least = Math.min(least, windows[w] / (double) length);
            }
        }
        return least == Double.POSITIVE_INFINITY ? 0 : least;
    }

    /** First tick of a window; the windows share the second half of the run. */
    private int begin(int window) {
        int half = ticks / 2;
        return half + (int) ((long) window * (ticks - half) / WINDOWS);
    }
}
