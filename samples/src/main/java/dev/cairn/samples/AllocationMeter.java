package dev.cairn.samples;

import com.sun.management.ThreadMXBean;

import java.lang.management.ManagementFactory;
import java.util.Arrays;

/**
 * Counts the bytes that a simulation's threads allocate: the thread that steps, and the helpers
 * that its world started.
 *
 * <p>The helpers are found by difference: threads that live once the world is there and did not
 * before. The counters are the JVM's own, exact, and reading them allocates nothing. Simulation
 * thread.
 */
public final class AllocationMeter {
    private final ThreadMXBean threads;
    private final long[] before;
    private long[] counted = new long[0];

    /** Notes which threads there are; call before the world is built. */
    public AllocationMeter() {
        threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        before = threads.getAllThreadIds();
        Arrays.sort(before);
    }

    /** Finds the simulation's threads; call once the world is built. */
    public void attach() {
        long own = Thread.currentThread().threadId();
        counted =
                Arrays.stream(threads.getAllThreadIds())
                        .filter(id -> id == own || Arrays.binarySearch(before, id) < 0)
                        .toArray();
    }

    /**
     * All that those threads have allocated since they started.
     *
     * @return bytes; only differences mean something
     */
    public long bytes() {
        long sum = 0;
        for (long id : counted) {
            long bytes = threads.getThreadAllocatedBytes(id);
            if (bytes > 0) {
                sum += bytes;
            }
        }
        return sum;
    }

    /**
     * How many threads are counted.
     *
     * @return at least 1 after {@link #attach}
     */
    public int threadCount() {
        return counted.length;
    }
}
