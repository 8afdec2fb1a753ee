package dev.cairn.core.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;

/** Shutdown in every state of the helpers: none of these may hang, and no thread may stay. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class JobsCloseTest {

    /** The helpers of a job system, found by a stage that each worker must join. */
    private static List<Thread> helpersOf(Jobs jobs) {
        Thread[] threads = new Thread[jobs.workers()];
        CountDownLatch all = new CountDownLatch(jobs.workers());
        jobs.run(
                (block, worker) -> {
                    threads[worker] = Thread.currentThread();
                    all.countDown();
                    await(all);
                },
                jobs.workers());
        return List.of(threads).subList(1, threads.length);
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException interrupted) {
            throw new AssertionError(interrupted);
        }
    }

    private static void awaitParked(Thread thread) {
        while (thread.getState() != Thread.State.WAITING) {
            Thread.onSpinWait();
        }
    }

    @Test
    void closesWhileParked() {
        Jobs jobs = Jobs.of(4);
        List<Thread> helpers = helpersOf(jobs);
        helpers.forEach(JobsCloseTest::awaitParked);
        jobs.close();
        helpers.forEach(helper -> assertFalse(helper.isAlive(), helper.getName()));
    }

    @Test
    void closesWhileTheHelpersSpinInsideATick() {
        Jobs jobs = Jobs.of(3);
        jobs.beginTick();
        List<Thread> helpers = helpersOf(jobs);
        jobs.close();
        helpers.forEach(helper -> assertFalse(helper.isAlive(), helper.getName()));
    }

    @Test
    void closesRightAfterTheStart() {
        for (int round = 0; round < 100; round++) {
            Jobs.of(3).close();
        }
    }

    @Test
    void closesBetweenSpinningAndParking() {
        for (int round = 0; round < 300; round++) {
            Jobs jobs = Jobs.of(2);
            List<Thread> helpers = helpersOf(jobs);
            for (int i = 0; i < round * 31 % 1500; i++) {
                Thread.onSpinWait();
            }
            jobs.close();
            assertFalse(helpers.getFirst().isAlive(), "round " + round);
        }
    }

    /** Another thread closes while stages run: the running one ends whole, the next is refused. */
    @Test
    void closesWhileStagesRun() throws InterruptedException {
        for (int round = 0; round < 20; round++) {
            Jobs jobs = Jobs.of(3);
            CountDownLatch started = new CountDownLatch(1);
            AtomicReference<Throwable> end = new AtomicReference<>();
            AtomicInteger blocks = new AtomicInteger();
            AtomicInteger stages = new AtomicInteger();
            Thread simulation =
                    new Thread(() -> {
                        try {
                            while (true) {
                                jobs.run((block, worker) -> blocks.incrementAndGet(), 50);
                                stages.incrementAndGet();
                                started.countDown();
                            }
                        } catch (Throwable thrown) {
                            end.set(thrown);
                        }
                    });
            simulation.start();
            await(started);
            jobs.close();
            simulation.join();
            assertTrue(end.get() instanceof IllegalStateException, () -> "" + end.get());
            assertEquals(50 * stages.get(), blocks.get());
        }
    }

    /** A block that does not end must not keep close from returning. */
    @Test
    void closesAlthoughABlockDoesNotEnd() throws InterruptedException {
        Jobs jobs = Jobs.of(2);
        CountDownLatch both = new CountDownLatch(2);
        CountDownLatch release = new CountDownLatch(1);
        Thread simulation =
                new Thread(() ->
                        jobs.run(
                                (block, worker) -> {
                                    both.countDown();
                                    await(release);
                                },
                                2));
        simulation.start();
        await(both);
        jobs.close(); // returns although the helper is inside its block
        release.countDown();
        simulation.join();
    }

    @Test
    void closesInsideABlockOfTheCallerAndOfAHelper() {
        for (int closer = 0; closer < 2; closer++) {
            int by = closer;
            Jobs jobs = Jobs.of(2);
            CountDownLatch both = new CountDownLatch(2);
            jobs.run(
                    (block, worker) -> {
                        both.countDown();
                        await(both);
                        if (worker == by) {
                            jobs.close();
                        }
                    },
                    2);
            assertThrows(IllegalStateException.class, () -> jobs.run((b, w) -> {}, 2));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void closeTwiceIsFineAndRunAfterwardsIsRefusedWithARemedy(int workers) {
        Jobs jobs = Jobs.of(workers);
        jobs.close();
        jobs.close();
        for (int blocks = 0; blocks < 3; blocks++) {
            int count = blocks;
            AtomicInteger runs = new AtomicInteger();
            IllegalStateException thrown =
                    assertThrows(
                            IllegalStateException.class,
                            () -> jobs.run((b, w) -> runs.incrementAndGet(), count));
            assertTrue(thrown.getMessage().contains("closed"), thrown.getMessage());
            assertTrue(thrown.getMessage().contains("Jobs.of(" + workers), thrown.getMessage());
            assertEquals(0, runs.get());
        }
        jobs.beginTick();
        jobs.endTick();
        jobs.close();
    }

    @Test
    void helpersAreDaemonsWithNames() {
        try (Jobs jobs = Jobs.of(3)) {
            List<Thread> helpers = helpersOf(jobs);
            assertTrue(helpers.stream().allMatch(Thread::isDaemon));
            assertEquals(
                    List.of("cairn-job-1", "cairn-job-2"),
                    helpers.stream().map(Thread::getName).toList());
        }
    }
}
