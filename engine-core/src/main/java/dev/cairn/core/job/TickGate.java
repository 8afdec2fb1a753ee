package dev.cairn.core.job;

import static dev.cairn.core.job.Lines.WORD;

/**
 * Whether a tick is open, and which helpers are asleep: decides who must be woken.
 *
 * <p>Both sides write and then read what the other wrote, each with a full fence between (Dekker's
 * scheme): a helper raises its parked flag and then looks at the tick; the caller opens the tick
 * and then looks at the flags. So at least one of them sees the other, and no wake-up is lost.
 *
 * <pre>
 *   line          word 0         word 1      written by
 *   0             tick open?     closed?     caller, every tick
 *   1 + worker    parked?                    that helper, and the caller that wakes it
 * </pre>
 */
final class TickGate {

    private static final int OPEN = Lines.line(0);
    private static final int CLOSED = OPEN + 1;

    private final long[] words;

    TickGate(int workers) {
        words = Lines.create(1 + workers);
    }

    private static int parked(int worker) {
        return Lines.line(1 + worker);
    }

    /** Opens a tick. Caller only; then {@link #takeParked} for each helper. */
    void open() {
        WORD.setVolatile(words, OPEN, 1L);
    }

    /** Ends a tick. Caller only. */
    void end() {
        WORD.setRelease(words, OPEN, 0L);
    }

    /** Whether a tick is open. */
    boolean isOpen() {
        return (long) WORD.getVolatile(words, OPEN) != 0L;
    }

    /** Closes for ever. Any thread. */
    void close() {
        WORD.setVolatile(words, CLOSED, 1L);
    }

    /** Whether closed for ever. */
    boolean isClosed() {
        return (long) WORD.getVolatile(words, CLOSED) != 0L;
    }

    /** Whether a helper sleeps or is about to; lowers its flag, so that it is woken once. */
    boolean takeParked(int worker) {
        if ((long) WORD.getVolatile(words, parked(worker)) == 0L) {
            return false;
        }
        WORD.setVolatile(words, parked(worker), 0L);
        return true;
    }

    /**
     * Raises the helper's parked flag, then tells whether it may sleep. To be asked before each
     * sleep, also after one that ended: the caller lowers the flag when it wakes the helper.
     */
    boolean mayPark(int worker) {
        WORD.setVolatile(words, parked(worker), 1L);
        return !isOpen() && !isClosed();
    }

    /** Lowers the helper's parked flag: it is awake. */
    void unparked(int worker) {
        WORD.setRelease(words, parked(worker), 0L);
    }
}
