package dev.cairn.core.tick;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;

@Timeout(60)
class InboxTest {

    /** Four threads post; the drain sees each thread's actions whole and in its order. */
    @Test
    void noActionOfAnyThreadIsLostOrOvertaken() throws InterruptedException {
        int threads = 4;
        int each = 20_000;
        Inbox inbox = new Inbox(1 << 17);
        int[] next = new int[threads]; // plain: only the draining thread touches it
        List<Thread> posters = new ArrayList<>();
        for (int poster = 0; poster < threads; poster++) {
            int from = poster;
            posters.add(
                    Thread.ofPlatform()
                            .start(() -> {
                                for (int i = 0; i < each; i++) {
                                    int number = i;
                                    inbox.post(() -> assertEquals(number, next[from]++));
                                }
                            }));
        }
        int drained = 0;
        while (drained < threads * each) {
            drained += inbox.drain();
        }
        for (Thread poster : posters) {
            poster.join();
        }
        assertTrue(inbox.isEmpty());
        for (int count : next) {
            assertEquals(each, count);
        }
    }

    @Test
    void aFullInboxRefusesLoudlyAndKeepsWhatItHas() {
        Inbox inbox = new Inbox(1);
        List<Integer> ran = new ArrayList<>();
        for (int i = 0; i < inbox.capacity(); i++) {
            int number = i;
            inbox.post(() -> ran.add(number));
        }
        IllegalStateException full =
                assertThrows(IllegalStateException.class, () -> inbox.post(() -> ran.add(-1)));
        assertTrue(full.getMessage().contains(inbox.capacity() + " actions"), full.getMessage());
        assertEquals(inbox.capacity(), inbox.drain());
        assertEquals(inbox.capacity(), ran.size());
        for (int i = 0; i < ran.size(); i++) {
            assertEquals(i, ran.get(i));
        }
        inbox.post(() -> ran.add(-1));
        assertEquals(1, inbox.drain());
    }

    @Test
    void anActionThatPostsWaitsForTheNextDrain() {
        Inbox inbox = new Inbox();
        int[] ran = new int[1];
        Runnable[] again = new Runnable[1];
        again[0] =
                () -> {
                    ran[0]++;
                    inbox.post(again[0]);
                };
        inbox.post(again[0]);
        for (int drain = 1; drain <= 5; drain++) {
            assertEquals(1, inbox.drain());
            assertEquals(drain, ran[0]);
        }
    }

    @Test
    void anActionThatThrowsLeavesTheOthersInOrder() {
        Inbox inbox = new Inbox();
        StringBuilder order = new StringBuilder();
        IllegalStateException broken = new IllegalStateException("broken");
        inbox.post(() -> order.append('a'));
        inbox.post(() -> {
            throw broken;
        });
        inbox.post(() -> order.append('b'));
        inbox.post(() -> order.append('c'));
        assertSame(broken, assertThrows(IllegalStateException.class, inbox::drain));
        assertEquals("a", order.toString());
        assertEquals(2, inbox.drain());
        assertEquals("abc", order.toString());
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 0, (1 << 24) + 1})
    void aCapacityOutOfRangeIsRefused(int capacity) {
        IllegalArgumentException thrown =
                assertThrows(IllegalArgumentException.class, () -> new Inbox(capacity));
        assertTrue(thrown.getMessage().contains("capacity is " + capacity), thrown.getMessage());
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 100, 128, 129, 1000, 1 << 20})
    void theCapacityIsAtLeastWhatWasAskedFor(int capacity) {
        Inbox inbox = new Inbox(capacity);
        assertTrue(inbox.capacity() >= capacity);
        for (int i = 0; i < Math.min(inbox.capacity(), 5000); i++) {
            inbox.post(() -> {});
        }
        assertEquals(Math.min(inbox.capacity(), 5000), inbox.drain());
    }
}
