package dev.cairn.core.job;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.sun.management.ThreadMXBean;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.lang.management.ManagementFactory;
import java.util.concurrent.CountDownLatch;

/** Dispatch allocates nothing, neither on the caller nor on a helper. */
@Timeout(60)
class JobsAllocationTest {

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    /** Gathers each worker's own counter; the write to a plain array is all that it does. */
    private static final class Counters implements BlockJob {
        final long[] ids;
        CountDownLatch all = new CountDownLatch(0);

        Counters(int workers) {
            ids = new long[workers];
        }

        @Override
        public void run(int block, int worker) {
            ids[worker] = Thread.currentThread().threadId();
            all.countDown();
            try {
                all.await();
            } catch (InterruptedException interrupted) {
                throw new AssertionError(interrupted);
            }
        }
    }

    private static final class Work implements BlockJob {
        final double[] values = new double[4096];

        @Override
        public void run(int block, int worker) {
            for (int i = Blocks.begin(block, 512), end = Blocks.end(block, 512, 4096);
                    i < end;
                    i++) {
                values[i] = values[i] * 0.5 + block;
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4})
    void steadyTicksAllocateNothing(int workers) {
        try (Jobs jobs = Jobs.of(workers)) {
            Counters counters = new Counters(workers);
            counters.all = new CountDownLatch(workers);
            jobs.run(counters, workers);
            Work work = new Work();
            ticks(jobs, work, 2_000); // warm-up
            long[] before = THREADS.getThreadAllocatedBytes(counters.ids);
            long[] again = THREADS.getThreadAllocatedBytes(counters.ids);
            long ownReading = again[0] - before[0]; // what the reading itself allocates here
            ticks(jobs, work, 2_000);
            long[] after = THREADS.getThreadAllocatedBytes(counters.ids);
            assertEquals(ownReading, after[0] - again[0], "caller");
            for (int worker = 1; worker < workers; worker++) {
                assertEquals(0, after[worker] - again[worker], "helper " + worker);
            }
        }
    }

    private static void ticks(Jobs jobs, Work work, int count) {
        for (int tick = 0; tick < count; tick++) {
            jobs.beginTick();
            jobs.run(work, 8);
            jobs.run(work, 2);
            jobs.run(work, 1);
            jobs.endTick();
            if (tick % 50 == 0) {
                jobs.run(work, 8); // outside a tick
            }
        }
    }

    @Test
    void theMeasurementSeesAnAllocation() {
        long id = Thread.currentThread().threadId();
        long before = THREADS.getThreadAllocatedBytes(id);
        long again = THREADS.getThreadAllocatedBytes(id);
        byte[] garbage = new byte[1000 + (int) (before & 1)];
        long after = THREADS.getThreadAllocatedBytes(id);
        assertEquals(true, after - again - (again - before) >= 1000, () -> "" + garbage.length);
    }
}
