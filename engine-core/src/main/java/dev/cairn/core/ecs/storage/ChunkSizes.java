package dev.cairn.core.ecs.storage;

/**
 * Which chunk a row of a table lies in. Decided by the row's number alone, so block boundaries
 * never depend on workers or on history.
 *
 * <pre>
 *   row         0      16 k     32 k     64 k     128 k        ...
 *   chunks of   | 1024 |  2048  |  4096  |  8192  |  16384
 *   chunk       0      16       24       32       40
 * </pre>
 *
 * <p>A chunk has at most an eighth of the rows before it. Small tables get small chunks, so that
 * there is a block for every worker. Large tables get large ones: each column that starts anew
 * waits for memory once, since processors fetch ahead within a page and along a stream, but not
 * from one array to the next, and a 4 KiB array is over before that has paid. With a million
 * entities chunks of 16384 rows took half the time of chunks of 1024, and a single array for all
 * was hardly faster. At most an eighth of a table's memory lies idle in its last chunk.
 */
public final class ChunkSizes {
    private static final int MIN_SHIFT = 10;
    private static final int MAX_SHIFT = 14;

    /** Chunks by doubling of the table, as a shift: 8. */
    private static final int OCTAVE_SHIFT = 3;

    /** Rows of the first chunks, a power of two. */
    public static final int SMALLEST = 1 << MIN_SHIFT;

    /** Rows of the chunks of a large table, a power of two. */
    public static final int LARGEST = 1 << MAX_SHIFT;

    private ChunkSizes() {}

    /** Binary logarithm of the size of the row's chunk. */
    private static int shift(int row) {
        int octave = 31 - Integer.numberOfLeadingZeros(row | 1);
        return Math.min(MAX_SHIFT, Math.max(MIN_SHIFT, octave - OCTAVE_SHIFT));
    }

    /** The chunk of a row. */
    public static int chunk(int row) {
        int shift = shift(row);
        return (row >>> shift) + ((shift - MIN_SHIFT) << OCTAVE_SHIFT);
    }

    /** The row within its chunk. */
    public static int local(int row) {
        return row & ((1 << shift(row)) - 1);
    }

    /** Number of chunks that so many rows need. */
    public static int count(int rows) {
        return rows == 0 ? 0 : chunk(rows - 1) + 1;
    }

    /** Rows of a full chunk. */
    public static int capacity(int chunk) {
        int doublings = Math.max(0, (chunk >>> OCTAVE_SHIFT) - 1);
        return 1 << Math.min(MAX_SHIFT, MIN_SHIFT + doublings);
    }
}
