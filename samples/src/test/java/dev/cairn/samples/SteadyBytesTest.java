package dev.cairn.samples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.function.IntToLongFunction;

/** What counts as steady allocation, and what as paid once. */
class SteadyBytesTest {
    private static double perTick(int ticks, IntToLongFunction bytesOfTick) {
        SteadyBytes bytes = new SteadyBytes(ticks);
        for (int tick = 0; tick < ticks; tick++) {
            bytes.add(bytesOfTick.applyAsLong(tick));
        }
        return bytes.perTick();
    }

    @Test
    void anObjectInEachTickShows() {
        assertEquals(16, perTick(300, tick -> 16));
        assertEquals(16, perTick(1, tick -> 16));
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 7, 10})
    void anObjectInEveryNthTickShows(int n) {
        assertTrue(perTick(90, tick -> tick % n == 0 ? 16 : 0) > 0);
    }

    @Test
    void startAndSingleEventsDoNot() {
        assertEquals(0, perTick(90, tick -> tick < 40 || tick == 67 || tick == 69 ? 98168 : 0));
        assertEquals(0, perTick(0, tick -> 1));
    }
}
