package dev.cairn.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

class BroadPhaseTest {

    /** The tree's shape hangs on rounding; a scene shifted or turned is to keep its rows. */
    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void pairsComeInTheOrderOfSlots(int workers) {
        Random random = new Random(7);
        BroadPhase broadPhase = new BroadPhase();
        broadPhase.ensureSlots(300);
        double[] box = new double[6];
        for (int slot = 0; slot < 300; slot++) {
            AabbTreeTest.randomBox(random, box, 0);
            broadPhase.place(slot, false, box, 0);
        }
        try (Jobs jobs = Jobs.of(workers)) {
            broadPhase.findPairs(jobs);
        }
        long[] pairs = Arrays.copyOf(broadPhase.newPairs(), broadPhase.newPairCount());
        assertTrue(pairs.length > 60, "seed 7: " + pairs.length + " pairs");
        long[] sorted = pairs.clone();
        Arrays.sort(sorted);
        assertArrayEquals(sorted, pairs, "seed 7");
    }

    /** Drives a broad phase with random boxes, and keeps the list of pairs as an owner would. */
    private static final class Driver {
        final BroadPhase broadPhase = new BroadPhase();
        final Random random;
        final int n;
        final double[] box = new double[6];
        final List<Long> rows = new ArrayList<>();

        Driver(long seed, int n) {
            this.random = new Random(seed);
            this.n = n;
            broadPhase.ensureSlots(n);
        }

        void place(int slot) {
            AabbTreeTest.randomBox(random, box, 0);
            broadPhase.place(slot, slot % 5 == 0, box, 0);
        }

        void tick(Jobs jobs) {
            broadPhase.findPairs(jobs);
            rows.removeIf(key -> {
                int a = (int) (key >>> 32);
                int b = key.intValue();
                boolean apart = !broadPhase.overlap(a, b);
                if (apart) {
                    broadPhase.forget(a, b);
                }
                return apart;
            });
            for (int i = 0; i < broadPhase.newPairCount(); i++) {
                rows.add(broadPhase.newPairs()[i]);
            }
            broadPhase.endTick();
        }

        long[] bruteForce() {
            long[] pairs = new long[n * n / 2];
            int count = 0;
            double[] fat = broadPhase.fatBoxes();
            for (int a = 0; a < n; a++) {
                for (int b = a + 1; b < n; b++) {
                    if (!broadPhase.contains(a)
                            || !broadPhase.contains(b)
                            || (a % 5 == 0 && b % 5 == 0)) {
                        continue;
                    }
                    boolean overlap = true;
                    for (int axis = 0; axis < 3; axis++) {
                        overlap &= fat[6 * a + axis] <= fat[6 * b + axis + 3];
                        overlap &= fat[6 * b + axis] <= fat[6 * a + axis + 3];
                    }
                    if (overlap) {
                        pairs[count++] = PairSet.key(a, b);
                    }
                }
            }
            return Arrays.copyOf(pairs, count);
        }

        long[] sortedRows() {
            return rows.stream().mapToLong(Long::longValue).sorted().toArray();
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {21, 22, 23, 24})
    void pairsAreThoseOfBruteForceThroughRandomChanges(long seed) {
        try (Jobs jobs = Jobs.perturbed(3, seed)) {
            Driver driver = new Driver(seed, 300);
            for (int tick = 0; tick < 60; tick++) {
                int changes = driver.random.nextInt(80);
                for (int i = 0; i < changes; i++) {
                    int slot = driver.random.nextInt(driver.n);
                    if (driver.random.nextInt(6) == 0) {
                        driver.broadPhase.remove(slot);
                    } else {
                        driver.place(slot);
                    }
                }
                driver.tick(jobs);
                String where = "seed " + seed + ", tick " + tick;
                assertArrayEquals(driver.bruteForce(), driver.sortedRows(), where);
                assertEquals(driver.rows.size(), driver.broadPhase.pairCount(), where);
            }
            driver.broadPhase.staticTree().validate();
            driver.broadPhase.dynamicTree().validate();
        }
    }

    @Test
    void orderOfPairsDoesNotDependOnWorkers() {
        List<Long> reference = null;
        for (int workers = 1; workers <= 4; workers++) {
            try (Jobs jobs = workers == 4 ? Jobs.perturbed(4, 99) : Jobs.of(workers)) {
                Driver driver = new Driver(31, 400);
                for (int tick = 0; tick < 20; tick++) {
                    for (int i = 0; i < 300; i++) {
                        driver.place(driver.random.nextInt(driver.n));
                    }
                    driver.tick(jobs);
                }
                if (reference == null) {
                    reference = driver.rows;
                }
                assertEquals(reference, driver.rows, workers + " workers");
            }
        }
    }

    @Test
    void losesNothingWhenAllAreInOneSpot() {
        int n = 2000;
        try (Jobs jobs = Jobs.of(2)) {
            BroadPhase broadPhase = new BroadPhase();
            broadPhase.ensureSlots(n);
            double[] box = {0, 0, 0, 1, 1, 1};
            for (int slot = 0; slot < n; slot++) {
                broadPhase.place(slot, false, box, 0);
            }
            broadPhase.findPairs(jobs);
            assertEquals(n * (n - 1) / 2, broadPhase.newPairCount());
            assertEquals(n * (n - 1) / 2, broadPhase.pairCount());
            broadPhase.endTick();
            for (int slot = 0; slot < n; slot++) {
                broadPhase.place(slot, false, box, 0);
            }
            broadPhase.findPairs(jobs);
            assertEquals(0, broadPhase.newPairCount(), "known pairs are not found again");
        }
    }

    @Test
    void idleStaticsAreNeverTouched() {
        try (Jobs jobs = Jobs.of(1)) {
            Driver driver = new Driver(41, 100);
            for (int slot = 0; slot < driver.n; slot++) {
                driver.place(slot);
            }
            driver.tick(jobs);
            long before = driver.broadPhase.staticTree().changes();
            for (int tick = 0; tick < 20; tick++) {
                for (int slot = 0; slot < driver.n; slot++) {
                    if (slot % 5 != 0) {
                        driver.place(slot);
                    }
                }
                driver.tick(jobs);
            }
            assertEquals(before, driver.broadPhase.staticTree().changes());
        }
    }

    @Test
    void aPairPersistsWhileItsBoxesOverlap() {
        try (Jobs jobs = Jobs.of(1)) {
            BroadPhase broadPhase = new BroadPhase();
            broadPhase.ensureSlots(2);
            broadPhase.place(0, false, new double[] {0, 0, 0, 1, 1, 1}, 0);
            broadPhase.place(1, false, new double[] {0.5, 0, 0, 1.5, 1, 1}, 0);
            broadPhase.findPairs(jobs);
            assertEquals(1, broadPhase.newPairCount());
            broadPhase.endTick();
            broadPhase.place(1, false, new double[] {0.9, 0, 0, 1.9, 1, 1}, 0);
            broadPhase.findPairs(jobs);
            assertEquals(0, broadPhase.newPairCount());
            assertTrue(broadPhase.overlap(0, 1));
            broadPhase.endTick();
            broadPhase.place(1, false, new double[] {1.1, 0, 0, 2.1, 1, 1}, 0);
            assertFalse(broadPhase.overlap(0, 1));
        }
    }
}
