package dev.cairn.benchmarks.compare;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.benchmarks.compare.measure.CpuClock;

import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.concurrent.CountDownLatch;

/** What other threads did before counts for nothing, whether they are still there or not. */
final class CpuClockTest {
    private static final long WORK_NANOS = 50_000_000;

    @Test
    void aThreadThatEndsTakesNothingAway() throws InterruptedException {
        CountDownLatch worked = new CountDownLatch(1);
        CountDownLatch end = new CountDownLatch(1);
        Thread other =
                new Thread(() -> {
                    burn();
                    worked.countDown();
                    await(end);
                });
        other.start();
        worked.await();

        CpuClock clock = new CpuClock();
        clock.start();
        end.countDown();
        other.join();
        long nanos = clock.stop();

        assertTrue(nanos >= 0, () -> nanos + " ns");
    }

    @Test
    void workOfAnotherThreadCounts() throws InterruptedException {
        CountDownLatch begin = new CountDownLatch(1);
        CountDownLatch worked = new CountDownLatch(1);
        CountDownLatch end = new CountDownLatch(1);
        Thread other =
                new Thread(() -> {
                    await(begin);
                    burn();
                    worked.countDown();
                    await(end);
                });
        other.start();

        CpuClock clock = new CpuClock();
        clock.start();
        begin.countDown();
        worked.await();
        long nanos = clock.stop();
        end.countDown();
        other.join();

        assertTrue(nanos >= WORK_NANOS, () -> nanos + " ns");
    }

    /** Takes so much CPU time, by the thread's own clock. */
    private static void burn() {
        var threads = ManagementFactory.getThreadMXBean();
        long start = threads.getCurrentThreadCpuTime();
        while (threads.getCurrentThreadCpuTime() - start < WORK_NANOS) {
            Thread.onSpinWait();
        }
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException interrupted) {
            throw new IllegalStateException(interrupted);
        }
    }
}
