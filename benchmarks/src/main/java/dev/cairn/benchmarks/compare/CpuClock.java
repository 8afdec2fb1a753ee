package dev.cairn.benchmarks.compare;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * CPU time of a piece of work on all threads that took part: the calling one, an engine's workers,
 * the garbage collector; not the JIT compilers.
 *
 * <p>The calling thread's part comes from the JVM, in nanoseconds, close around the work. On Linux
 * the other threads' parts come from {@code /proc/self/task/T/schedstat}, whose first number is the
 * nanoseconds on a core (Documentation/scheduler/sched-stats.rst); reading them is outside the
 * work. Elsewhere the process's time is taken for all, the compilers in it. One thread.
 */
final class CpuClock {
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
    private long othersBefore;
    private long compilersBefore;
    private long others;
    private long compilers;

    /** Number of the calling thread, as /proc/thread-self tells it; empty elsewhere. */
    private static String ownTask() {
        try {
            Path name = Path.of("/proc/thread-self").toRealPath().getFileName();
            return name == null ? "" : name.toString();
        } catch (IOException absent) {
            return "";
        }
    }

    void start() {
        look();
        othersBefore = others;
        compilersBefore = compilers;
        ownBefore = ownNanos();
    }

    /** Returns the CPU time since the start, ns. */
    long stop() {
        long mine = ownNanos() - ownBefore;
        look();
        return mine + others - othersBefore;
    }

    /** Returns the JIT compilers' CPU time between start and stop, ns; -1 if it is not known. */
    long compilerNanos() {
        return perThread ? compilers - compilersBefore : -1;
    }

    private long ownNanos() {
        if (perThread || bean == null) {
            return threads.getCurrentThreadCpuTime();
        }
        return bean.getProcessCpuTime();
    }

    private void look() {
        others = 0;
        compilers = 0;
        if (!perThread) {
            return;
        }
        try (DirectoryStream<Path> tasks = Files.newDirectoryStream(TASKS)) {
            for (Path task : tasks) {
                if (!task.endsWith(own)) {
                    add(task);
                }
            }
        } catch (IOException unreadable) {
            throw new IllegalStateException("/proc/self/task cannot be read", unreadable);
        }
    }

    private void add(Path task) {
        try {
            String name = Files.readString(task.resolve("comm"));
            String line = Files.readString(task.resolve("schedstat"));
            long nanos = Long.parseLong(line.substring(0, line.indexOf(' ')));
            if (name.startsWith("C1 Comp") || name.startsWith("C2 Comp")) {
                compilers += nanos;
            } else {
                others += nanos;
            }
        } catch (IOException ended) {
            // A thread that ended between the listing and the look.
        }
    }
}
