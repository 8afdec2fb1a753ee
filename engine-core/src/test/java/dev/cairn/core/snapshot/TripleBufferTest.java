package dev.cairn.core.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import org.junit.jupiter.api.Test;

/** Any interleaving of whole calls; the hand-over itself is for jcstress. */
class TripleBufferTest {
    @Property(tries = 300)
    void theReaderSeesTheNewestAndKeepsItsSlot(@ForAll boolean[] calls) {
        TripleBuffer<long[]> buffer = new TripleBuffer<>(() -> new long[1]);
        long published = 0;
        for (boolean write : calls) {
            if (write) {
                buffer.writing()[0] = ++published;
                buffer.publish();
            } else {
                long[] own = buffer.latest();
                assertEquals(published, own[0]);
                assertNotSame(own, buffer.writing());
            }
        }
    }

    @Test
    void noSlotIsNoBuffer() {
        assertThrows(NullPointerException.class, () -> new TripleBuffer<>(null));
        assertThrows(NullPointerException.class, () -> new TripleBuffer<Object>(() -> null));
    }
}
