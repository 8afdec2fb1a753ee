package dev.cairn.physics.solver.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.util.PriorityQueue;
import java.util.SplittableRandom;

class KeyQueueTest {
    /** Whatever comes and goes, equal numbers too: what leaves is what leaves the library's. */
    @Test
    void theLeastLeavesFirst() {
        long seed = 7;
        SplittableRandom random = new SplittableRandom(seed);
        KeyQueue queue = new KeyQueue();
        PriorityQueue<Long> other = new PriorityQueue<>();
        for (int step = 0; step < 20_000; step++) {
            boolean grows = step / 3000 % 2 == 0;
            if (other.isEmpty() || random.nextInt(10) < (grows ? 7 : 3)) {
                long key = random.nextLong(-50, 1L << random.nextInt(1, 60));
                queue.add(key);
                other.add(key);
            } else {
                assertEquals(other.remove(), queue.remove(), "seed " + seed + ", step " + step);
            }
            assertEquals(other.isEmpty(), queue.isEmpty());
        }
        queue.clear();
        assertTrue(queue.isEmpty());
    }
}
