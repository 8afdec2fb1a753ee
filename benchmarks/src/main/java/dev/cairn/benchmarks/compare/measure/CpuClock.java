package dev.cairn.benchmarks.compare.measure;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;

/**
 * CPU time of a piece of work on all threads that took part: the calling one, an engine's workers,
 * the garbage collector; not the JIT compilers.
 *
 * <p>The calling thread's part comes from the JVM, in nanoseconds, close around the work. On Linux
 * the other threads' parts come from {@code /proc/self/task/T/schedstat}, whose first number is the
 * nanoseconds on a core (Documentation/scheduler/sched-stats.rst); reading them is outside the
 * work. A thread that ends within the work is left out of it from the start: what it took is gone
 * with it. Elsewhere the process's time is taken for all, the compilers in it. One thread.
 */
public final class CpuClock {
    private static final Path TASKS = Path.of("/proc/self/task");

    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final boolean perThread = Files.isDirectory(TASKS);
    private final String own = ownTask();
    private final com.sun.management.@Nullable OperatingSystemMXBean bean =
            ManagementFactory.getOperatingSystemMXBean()
                            instanceof com.sun.management.OperatingSystemMXBean known
                    ? known
                    : null;
    private long ownBefore;
    private long compilers;

    /** By number of the thread, ns at the start. */
    private final Map<String, Long> before = new HashMap<>();

    /** Number of the calling thread, as /proc/thread-self tells it; empty elsewhere. */
    private static String ownTask() {
        try {
            Path name = Path.of("/proc/thread-self").toRealPath().getFileName();
            return name == null ? "" : name.toString();
        } catch (IOException absent) {
            return "";
        }
    }

    public void start() {
        before.clear();
        look((task, name, nanos) -> before.put(task, nanos));
        ownBefore = ownNanos();
    }

    /** Returns the CPU time since the start, ns. */
    public long stop() {
        long mine = ownNanos() - ownBefore;
        compilers = 0;
        long[] others = {0};
        look((task, name, nanos) -> {
            long since = nanos - before.getOrDefault(task, 0L);
            if (name.startsWith("C1 Comp") || name.startsWith("C2 Comp")) {
                compilers += since;
            } else {
                others[0] += since;
            }
        });
        return mine + others[0];
    }

    /** Returns the JIT compilers' CPU time between start and stop, ns; -1 if it is not known. */
    public long compilerNanos() {
        return perThread ? compilers : -1;
    }

    /** Returns the process's CPU time, compilers and collector included, ns; 0 if unknown. */
    long processNanos() {
        return bean == null ? 0 : bean.getProcessCpuTime();
    }

    private long ownNanos() {
        return perThread || bean == null ? threads.getCurrentThreadCpuTime() : processNanos();
    }

    /** What is read of another thread. */
    private interface Reading {
        void of(String task, String name, long nanos);
    }

    private void look(Reading reading) {
        if (!perThread) {
            return;
        }
        try (DirectoryStream<Path> tasks = Files.newDirectoryStream(TASKS)) {
            for (Path task : tasks) {
                if (!task.endsWith(own)) {
                    read(task, reading);
                }
            }
        } catch (IOException unreadable) {
            throw new IllegalStateException("/proc/self/task cannot be read", unreadable);
        }
    }

    private static void read(Path task, Reading reading) {
        String name;
        String line;
        try {
            name = Files.readString(task.resolve("comm"));
            line = Files.readString(task.resolve("schedstat"));
        } catch (IOException ended) {
            // A thread that ended between the listing and the look.
            return;
        }
        long nanos = Long.parseLong(line.substring(0, line.indexOf(' ')));
        reading.of(String.valueOf(task.getFileName()), name, nanos);
    }
}
