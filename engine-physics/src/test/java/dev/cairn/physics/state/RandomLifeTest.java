package dev.cairn.physics.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsWorld;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Worlds whose user does something at random before most ticks: whatever is done, three worlds of
 * other workers and lanes stay alike to the bit, what was saved goes on as it did, nothing fails,
 * and what {@link PhysicsWorld#validate} looks at is in order.
 */
@Tag("compiled")
class RandomLifeTest {
    private static PhysicsWorld world(int workers, int lanes) {
        PhysicsWorld built = PhysicsWorld.builder().workers(workers).build();
        var settings = built.settings().withLanes(lanes);
        built.close();
        return PhysicsWorld.builder().workers(workers).settings(settings).build();
    }

    static void live(long seed, int ticks) {
        try (PhysicsWorld one = world(1, 1);
                PhysicsWorld three = world(3, 4);
                PhysicsWorld later = world(2, 4)) {
            RandomUser first = new RandomUser(one);
            RandomUser second = new RandomUser(three);
            first.begin(seed);
            second.begin(seed);
            int saved = 20 + (int) (seed % 50);
            WorldState state = null;
            long[] digests = new long[ticks];
            for (int t = 0; t < ticks; t++) {
                String where = "seed " + seed + ", tick " + t;
                if (t == saved) {
                    state = one.save();
                }
                try {
                    first.act(seed, t);
                    second.act(seed, t);
                    assertEquals(first.done.toString(), second.done.toString(), where);
                    where += ":" + first.done;
                    one.step(RandomUser.step(seed, t));
                    three.step(RandomUser.step(seed, t));
                    digests[t] = one.digest();
                    assertEquals(digests[t], three.digest(), where);
                    one.validate();
                    assertTrue(one.quarantined().isEmpty(), where);
                } catch (RuntimeException failed) {
                    throw new AssertionError(where + ":" + first.done, failed);
                }
            }
            later.restore(state);
            RandomUser again = new RandomUser(later);
            for (int t = saved; t < ticks; t++) {
                again.act(seed, t);
                later.step(RandomUser.step(seed, t));
                assertEquals(digests[t], later.digest(), "seed " + seed + " again, tick " + t);
            }
        }
    }

    @Test
    void whateverIsDone() {
        for (long seed = 1; seed <= 40; seed++) {
            live(seed, 200);
        }
    }
}
