package dev.cairn.benchmarks;

import com.sun.management.ThreadMXBean;

import java.lang.management.ManagementFactory;

/**
 * Waits for the vector kernels: threads of their own warm them up and put their vectors on the heap
 * until the compiler is through, some seconds on a quiet machine and many on a busy one. JMH's
 * {@code -prof gc} counts all threads, and times change when the kernels are taken into use.
 */
public final class WarmUp {
    /** Fewer bytes are the JVM's own doing. */
    private static final long QUIET_BYTES = 64 * 1024;

    private static final long MOST_NANOS = 60_000_000_000L;
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private WarmUp() {}

    /**
     * Steps at least once, and until no thread allocates any more, at most a minute.
     *
     * @param steps a hundred steps of a world or so
     */
    public static void untilQuiet(Runnable steps) {
        long start = System.nanoTime();
        long bytes = Long.MAX_VALUE;
        while (bytes > QUIET_BYTES && System.nanoTime() - start < MOST_NANOS) {
            long before = THREADS.getTotalThreadAllocatedBytes();
            steps.run();
            bytes = THREADS.getTotalThreadAllocatedBytes() - before;
        }
    }
}
