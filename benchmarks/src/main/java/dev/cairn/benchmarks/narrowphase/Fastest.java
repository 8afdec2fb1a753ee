package dev.cairn.benchmarks.narrowphase;

import java.util.Arrays;

/**
 * The time of a turn that nothing disturbs: the sixteenth fastest of some hundred at least. Not the
 * fastest, for on a busy machine the clock of a thread's CPU time sometimes tells too little: 0 or
 * 13 ns a pair instead of 29, once in some ten thousand turns.
 */
final class Fastest {
    private static final int KEPT = 16;

    /** Ascending, ns. */
    private final long[] least = new long[KEPT];

    Fastest() {
        Arrays.fill(least, Long.MAX_VALUE);
    }

    /** Adds a turn. */
    void add(long nanos) {
        if (nanos >= least[KEPT - 1]) {
            return;
        }
        int at = KEPT - 1;
        while (at > 0 && least[at - 1] > nanos) {
            least[at] = least[at - 1];
            at--;
        }
        least[at] = nanos;
    }

    /** Of the sixteenth fastest turn, ns. */
    double nanos() {
        return least[KEPT - 1];
    }
}
