package dev.cairn.benchmarks.cost;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** CPU time of the calling thread: hardly moved by what else runs on the machine. */
final class ThreadTime {
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();

    long nanos() {
        return threads.getCurrentThreadCpuTime();
    }
}
