package dev.cairn.core.job;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import java.util.stream.IntStream;

@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class JobsTest {

    private static final int[] WORKERS = {1, 2, 3, 4, 8};
    private static final int[] BLOCKS = {0, 1, 2, 3, 5, 8, 63, 64, 65, 257, 1000};

    @Test
    void everyBlockRunsExactlyOnce() {
        for (int workers : WORKERS) {
            try (Jobs jobs = Jobs.of(workers)) {
                assertExactlyOnce(jobs, "workers " + workers);
            }
        }
    }

    @Test
    void everyBlockRunsExactlyOnceUnderDisturbedSchedules() {
        for (int workers : WORKERS) {
            for (long seed = 0; seed < 20; seed++) {
                try (Jobs jobs = Jobs.perturbed(workers, seed)) {
                    assertExactlyOnce(jobs, "workers " + workers + ", seed " + seed);
                }
            }
        }
    }

    private static void assertExactlyOnce(Jobs jobs, String where) {
        jobs.beginTick();
        try {
            for (int blocks : BLOCKS) {
                AtomicIntegerArray runs = new AtomicIntegerArray(blocks);
                jobs.run(
                        (block, worker) -> {
                            assertTrue(worker >= 0 && worker < jobs.workers(), "worker " + worker);
                            runs.incrementAndGet(block);
                        },
                        blocks);
                for (int block = 0; block < blocks; block++) {
                    assertEquals(1, runs.get(block), where + ", block " + block + " of " + blocks);
                }
            }
        } finally {
            jobs.endTick();
        }
    }

    /** A helper that is late for one stage must not run a block of the next one. */
    @Test
    void stagesOfChangingSizeNeverMix() {
        for (int workers = 2; workers <= 4; workers++) {
            try (Jobs jobs = Jobs.of(workers);
                    Jobs perturbed = Jobs.perturbed(workers, workers)) {
                assertStagesNeverMix(jobs, 20_000);
                assertStagesNeverMix(perturbed, 1_000);
            }
        }
    }

    private static void assertStagesNeverMix(Jobs jobs, int stages) {
        long[] sums = new long[100];
        long[] expected = new long[100];
        int[] current = new int[1];
        BlockJob job = (block, worker) -> sums[block] += current[0];
        jobs.beginTick();
        for (int stage = 1; stage <= stages; stage++) {
            int blocks = 2 + (int) (stage * 2654435761L >>> 16 & 63);
            current[0] = stage;
            jobs.run(job, blocks);
            for (int block = 0; block < blocks; block++) {
                expected[block] += stage;
            }
        }
        jobs.endTick();
        assertArrayEquals(expected, sums, "workers " + jobs.workers());
    }

    /** Each stage reads, in plain arrays, what other blocks wrote in the stage before. */
    @Test
    void plainWritesAreSeenInBothDirections() {
        int blocks = 16;
        for (int workers : WORKERS) {
            try (Jobs jobs = Jobs.perturbed(workers, 7)) {
                long[] from = new long[blocks];
                long[] to = new long[blocks];
                long[][] sides = {from, to};
                jobs.beginTick();
                for (int stage = 0; stage < 500; stage++) {
                    Arrays.fill(sides[(stage + 1) & 1], -1); // by the caller, plainly
                    long[] read = sides[stage & 1];
                    long[] write = sides[(stage + 1) & 1];
                    jobs.run(
                            (block, worker) -> write[block] = read[(block + 5) % blocks] + 1,
                            blocks);
                    for (int block = 0; block < blocks; block++) {
                        assertEquals(stage + 1, write[block], "workers " + workers);
                    }
                }
                jobs.endTick();
            }
        }
    }

    @Test
    void oneWorkerIsAPlainLoopOnTheCaller() {
        try (Jobs jobs = Jobs.of(1)) {
            StringBuilder order = new StringBuilder();
            Thread caller = Thread.currentThread();
            jobs.run(
                    (block, worker) -> {
                        assertSame(caller, Thread.currentThread());
                        order.append(block);
                    },
                    5);
            assertEquals("01234", order.toString());
        }
    }

    @Test
    void oneBlockRunsOnTheCaller() {
        try (Jobs jobs = Jobs.of(4)) {
            AtomicReference<Thread> thread = new AtomicReference<>();
            jobs.run((block, worker) -> thread.set(Thread.currentThread()), 1);
            assertSame(Thread.currentThread(), thread.get());
        }
    }

    /** Both blocks wait for each other, so two threads must be inside at once. */
    @Test
    void helpersReallyHelpInsideATickAndOutside() {
        try (Jobs jobs = Jobs.of(2)) {
            for (int round = 0; round < 50; round++) {
                boolean inTick = round % 2 == 0;
                if (inTick) {
                    jobs.beginTick();
                }
                CountDownLatch both = new CountDownLatch(2);
                jobs.run(
                        (block, worker) -> {
                            both.countDown();
                            assertDoesNotThrow(() -> both.await());
                        },
                        2);
                if (inTick) {
                    jobs.endTick();
                }
            }
        }
    }

    /** A helper that wakes to a tick that is over already must still hear of the next one. */
    @Test
    void helpersWakeAfterTicksThatWereOverBeforeTheyWoke() {
        try (Jobs jobs = Jobs.of(2)) {
            AtomicReference<Thread> helper = new AtomicReference<>();
            for (int round = 0; round < 200; round++) {
                CountDownLatch both = new CountDownLatch(2);
                jobs.run(
                        (block, worker) -> {
                            both.countDown();
                            assertDoesNotThrow(() -> both.await());
                            if (worker == 1) {
                                helper.set(Thread.currentThread());
                            }
                        },
                        2);
                if (round % 2 == 0) {
                    while (helper.get().getState() != Thread.State.WAITING) {
                        Thread.onSpinWait();
                    }
                }
                for (int empty = 0; empty < round % 3; empty++) {
                    jobs.beginTick();
                    jobs.endTick();
                }
                for (int i = 0; i < round % 7 * 3000; i++) {
                    Thread.onSpinWait(); // the helper is anywhere between asleep and asleep again
                }
            }
        }
    }

    @Test
    void ticksMayNestAndAnEndWithoutABeginDoesNothing() {
        try (Jobs jobs = Jobs.of(2)) {
            jobs.endTick();
            jobs.beginTick();
            jobs.beginTick();
            jobs.endTick();
            assertExactlyOnce(jobs, "nested");
            jobs.endTick();
            jobs.endTick();
            assertExactlyOnce(jobs, "after");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4})
    void allBlocksRunAndTheLowestFailureIsThrownWithTheOthersInOrder(int workers) {
        for (long seed = -1; seed < 20; seed++) {
            try (Jobs jobs = seed < 0 ? Jobs.of(workers) : Jobs.perturbed(workers, seed)) {
                AtomicIntegerArray runs = new AtomicIntegerArray(100);
                IllegalArgumentException thrown =
                        assertThrows(
                                IllegalArgumentException.class,
                                () ->
                                        jobs.run(
                                                (block, worker) -> {
                                                    runs.incrementAndGet(block);
                                                    if (block % 10 == 7) {
                                                        throw new IllegalArgumentException(
                                                                "block " + block);
                                                    }
                                                },
                                                100));
                String where = "workers " + workers + ", seed " + seed;
                assertEquals("block 7", thrown.getMessage(), where);
                assertEquals(
                        IntStream.range(1, 10).mapToObj(i -> "block " + (10 * i + 7)).toList(),
                        Arrays.stream(thrown.getSuppressed()).map(Throwable::getMessage).toList(),
                        where);
                for (int block = 0; block < 100; block++) {
                    assertEquals(1, runs.get(block), where);
                }
                assertExactlyOnce(jobs, where + ", after the failure");
            }
        }
    }

    @Test
    void theVeryThrowableIsThrownAlsoAnErrorAndAlsoASharedOne() {
        try (Jobs jobs = Jobs.of(2)) {
            AssertionError shared = new AssertionError("from each block");
            AssertionError thrown =
                    assertThrows(
                            AssertionError.class,
                            () ->
                                    jobs.run(
                                            (block, worker) -> {
                                                throw shared;
                                            },
                                            64));
            assertSame(shared, thrown);
            assertEquals(0, thrown.getSuppressed().length);
        }
    }

    @Test
    void helpersLiveOnAfterAFailureInAHelper() {
        try (Jobs jobs = Jobs.of(2)) {
            for (int round = 0; round < 20; round++) {
                CountDownLatch both = new CountDownLatch(2);
                BlockJob failing =
                        (block, worker) -> {
                            both.countDown();
                            assertDoesNotThrow(() -> both.await());
                            if (worker == 1) {
                                throw new StackOverflowError("in the helper");
                            }
                        };
                assertThrows(StackOverflowError.class, () -> jobs.run(failing, 2));
            }
        }
    }

    /** An interrupt that a block leaves on a helper neither ends it nor lets it miss a tick. */
    @Test
    void anInterruptedHelperLivesOn() {
        try (Jobs jobs = Jobs.of(2)) {
            for (int round = 0; round < 20; round++) {
                AtomicInteger inside = new AtomicInteger();
                jobs.run(
                        (block, worker) -> {
                            inside.incrementAndGet();
                            while (inside.get() < 2) {
                                Thread.onSpinWait();
                            }
                            if (worker == 1) {
                                Thread.currentThread().interrupt();
                            }
                        },
                        2);
                assertFalse(Thread.currentThread().isInterrupted());
                for (int i = 0; i < 2000; i++) {
                    Thread.onSpinWait();
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void runInsideABlockIsRefusedWithARemedy(int workers) {
        try (Jobs jobs = Jobs.of(workers)) {
            BlockJob inner = (block, worker) -> {};
            CountDownLatch all = new CountDownLatch(workers); // so that each worker has a block
            IllegalStateException thrown =
                    assertThrows(
                            IllegalStateException.class,
                            () ->
                                    jobs.run(
                                            (block, worker) -> {
                                                all.countDown();
                                                assertDoesNotThrow(() -> all.await());
                                                jobs.run(inner, 4);
                                            },
                                            workers));
            List<Throwable> refused = new ArrayList<>(List.of(thrown.getSuppressed()));
            refused.add(thrown);
            assertEquals(workers, refused.size());
            for (Throwable refusal : refused) {
                assertTrue(refusal.getMessage().contains("inside a block"), refusal::getMessage);
                assertTrue(refusal.getMessage().contains("after this one"), refusal::getMessage);
            }
            assertExactlyOnce(jobs, "after the refusal");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void runFromASecondThreadWhileOneRunsIsRefused(int workers) {
        try (Jobs jobs = Jobs.of(workers)) {
            AtomicReference<Throwable> refused = new AtomicReference<>();
            jobs.run(
                    (block, worker) -> {
                        Thread other =
                                Thread.ofPlatform()
                                        .name("other")
                                        .unstarted(() -> {
                                            try {
                                                jobs.run((b, w) -> {}, 3);
                                            } catch (Throwable thrown) {
                                                refused.set(thrown);
                                            }
                                        });
                        other.start();
                        assertDoesNotThrow(() -> other.join());
                    },
                    1);
            assertTrue(refused.get() instanceof IllegalStateException, () -> "" + refused.get());
            assertTrue(refused.get().getMessage().contains("'other'"), refused.get().getMessage());
            assertExactlyOnce(jobs, "after the refusal");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 0, 257, 1000})
    void aWorkerCountOutOfRangeIsRefusedWithValueAndBounds(int workers) {
        for (Supplier<Jobs> maker :
                Arrays.<Supplier<Jobs>>asList(
                        () -> Jobs.of(workers), () -> Jobs.perturbed(workers, 1))) {
            IllegalArgumentException thrown =
                    assertThrows(IllegalArgumentException.class, maker::get);
            assertTrue(thrown.getMessage().contains("workers is " + workers), thrown.getMessage());
            assertTrue(thrown.getMessage().contains("[1, 256]"), thrown.getMessage());
        }
    }

    @Test
    void theLargestWorkerCountWorks() {
        try (Jobs jobs = Jobs.of(Jobs.MAX_WORKERS)) {
            assertExactlyOnce(jobs, "256 workers");
        }
    }

    @Test
    void badArgumentsOfRunAreRefusedAndHarmless() {
        try (Jobs jobs = Jobs.of(2)) {
            assertThrows(NullPointerException.class, () -> jobs.run(null, 3));
            IllegalArgumentException thrown =
                    assertThrows(IllegalArgumentException.class, () -> jobs.run((b, w) -> {}, -3));
            assertTrue(thrown.getMessage().contains("-3"), thrown.getMessage());
            assertExactlyOnce(jobs, "after the refusal");
        }
    }

    @Test
    void defaultWorkersFitTheBounds() {
        assertTrue(Jobs.defaultWorkers() >= 1 && Jobs.defaultWorkers() <= Jobs.MAX_WORKERS);
        try (Jobs jobs = Jobs.of(Jobs.defaultWorkers())) {
            assertEquals(Jobs.defaultWorkers(), jobs.workers());
        }
    }

    /** The perturber and the plain system give the same result, and the same wrong one is seen. */
    @Test
    void aStageThatDependsOnTheOrderIsFoundByThePerturber() {
        StringBuilder plain = new StringBuilder();
        StringBuilder reversed = new StringBuilder();
        try (Jobs jobs = Jobs.of(1);
                Jobs perturbed = Jobs.perturbed(1, 1)) {
            jobs.run((block, worker) -> plain.append(block), 4);
            perturbed.run((block, worker) -> reversed.append(block), 4);
        }
        assertEquals("0123", plain.toString());
        assertEquals("3210", reversed.toString());
    }

    @Test
    void onlyWorkersBelowTheLimitTakePart() {
        try (Jobs jobs = Jobs.of(4)) {
            for (int limit : new int[] {1, 3, 2, 4, 1}) {
                jobs.limit(limit);
                int[] ran = new int[400];
                int[] most = new int[ran.length];
                for (int stage = 0; stage < 50; stage++) {
                    jobs.beginTick();
                    jobs.run(
                            (block, worker) -> {
                                ran[block]++;
                                most[block] = Math.max(most[block], worker);
                            },
                            ran.length);
                    jobs.endTick();
                }
                for (int block = 0; block < ran.length; block++) {
                    assertEquals(50, ran[block]);
                    assertTrue(most[block] < limit, "worker " + most[block] + " of " + limit);
                }
            }
        }
    }
}
