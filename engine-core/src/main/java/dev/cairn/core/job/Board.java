package dev.cairn.core.job;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;

/**
 * The words that the workers share, one per 128 bytes.
 *
 * <p>Two words that different threads write must not lie in one cache line, nor in two lines that
 * the prefetcher fetches as a pair; so each has a line pair of its own. They live in one {@code
 * long[]} with a stride, because the layout of an array is known while that of fields is the JVM's
 * choice. A guard line at either end keeps the neighbours on the heap away.
 *
 * <pre>
 *   line                    word 0                      word 1                written by
 *   0                       guard
 *   STAGE                   stage word (epoch, units)   blocks of the stage   caller, every stage
 *   CONTROL                 tick open?                  closed?               caller, every tick
 *   HELPER + worker         units completed, ever       parked?               that helper
 *   claims + unit           last stage word claimed                           whoever claims
 *   last                    guard
 * </pre>
 */
final class Board {

    /** Access to the elements of the board. */
    static final VarHandle WORD = MethodHandles.arrayElementVarHandle(long[].class);

    /** Longs per line: 128 bytes, a pair of cache lines. */
    static final int LINE = 16;

    /** Index of the stage word. The number of blocks follows it, plain, in the same line. */
    static final int STAGE = LINE;

    /** Index of the number of blocks of the stage. */
    static final int BLOCKS = STAGE + 1;

    /** Index of the tick word: 1 while a tick is open. */
    static final int TICK = 2 * LINE;

    /** Index of the closed word: 1 for ever after {@code close}. */
    static final int CLOSED = TICK + 1;

    private static final int HELPER = 3 * LINE;

    /** Low bits of a stage word that hold the number of units. */
    static final int UNIT_BITS = 14;

    private Board() {}

    /** Makes a board of zeros. */
    static long[] create(int workers, int maxUnits) {
        return new long[claim(workers, maxUnits) + LINE];
    }

    /** Index of a helper's count of completed units; written by that helper only. */
    static int completed(int worker) {
        return HELPER + worker * LINE;
    }

    /** Index of a helper's parked flag. */
    static int parked(int worker) {
        return completed(worker) + 1;
    }

    /** Index of a unit's claim slot. */
    static int claim(int workers, int unit) {
        return HELPER + (workers + unit) * LINE;
    }

    /** Packs a stage word. Grows with the epoch; 2^49 epochs are years of nothing but dispatch. */
    static long stageWord(long epoch, int units) {
        return epoch << UNIT_BITS | units;
    }

    /** Number of units of a stage word. */
    static int units(long stageWord) {
        return (int) stageWord & (1 << UNIT_BITS) - 1;
    }
}
