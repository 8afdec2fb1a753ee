package dev.cairn.core.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

import org.junit.jupiter.api.Test;

class BlocksTest {

    @Property
    void blocksAreACutOfTheItems(
            @ForAll @IntRange(max = 100_000) int items,
            @ForAll @IntRange(min = 1, max = 5_000) int itemsPerBlock) {
        int expectedBegin = 0;
        int count = Blocks.count(items, itemsPerBlock);
        for (int block = 0; block < count; block++) {
            assertEquals(expectedBegin, Blocks.begin(block, itemsPerBlock));
            int end = Blocks.end(block, itemsPerBlock, items);
            assertTrue(end > expectedBegin && end - expectedBegin <= itemsPerBlock);
            expectedBegin = end;
        }
        assertEquals(items, expectedBegin);
    }

    @Test
    void theLargestCountsDoNotOverflow() {
        int most = Integer.MAX_VALUE;
        assertEquals(1, Blocks.count(most, most));
        assertEquals(2, Blocks.count(most, most - 1));
        assertEquals(most, Blocks.end(0, most, most));
        assertEquals(most, Blocks.end(1, most - 1, most));
        assertEquals(most, Blocks.end(Blocks.count(most, 1000) - 1, 1000, most));
        assertEquals(0, Blocks.count(0, 1));
    }

    @Test
    void badCountsAreRefusedWithValueAndBound() {
        assertTrue(
                assertThrows(IllegalArgumentException.class, () -> Blocks.count(-1, 8))
                        .getMessage()
                        .contains("items is -1"));
        assertTrue(
                assertThrows(IllegalArgumentException.class, () -> Blocks.count(8, 0))
                        .getMessage()
                        .contains("itemsPerBlock is 0"));
    }
}
