package dev.cairn.core.job;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;

/**
 * Arrays of words that different threads write, one word (or group of words) per 128 bytes.
 *
 * <p>Two such words must not lie in one cache line, nor in two lines that the prefetcher fetches as
 * a pair; so each has a line pair of its own. They live in a {@code long[]} with a stride, because
 * the layout of an array is known while that of fields is the JVM's choice. A guard line at either
 * end keeps the neighbours on the heap away.
 */
final class Lines {

    /**
     * Access to the elements of a {@code long[]}, with the memory order in the name of the method.
     */
    static final VarHandle WORD = MethodHandles.arrayElementVarHandle(long[].class);

    /** Longs per line: 128 bytes, a pair of cache lines. */
    static final int LINE = 16;

    private Lines() {}

    /** Makes an array of {@code lines} lines of zeros between two guard lines. */
    static long[] create(int lines) {
        return new long[(lines + 2) * LINE];
    }

    /** Index of the first word of a line. */
    static int line(int line) {
        return (line + 1) * LINE;
    }
}
