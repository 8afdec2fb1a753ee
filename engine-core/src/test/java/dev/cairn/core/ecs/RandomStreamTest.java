package dev.cairn.core.ecs;

import static dev.cairn.core.ecs.WorldTest.assertTeaches;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

import org.junit.jupiter.api.Test;

import java.util.HashSet;
import java.util.Set;

/** Random streams: fixed numbers, independence of the four words, uniformity. */
class RandomStreamTest {
    @Test
    void theNumbersAreFixedForEver() {
        RandomStream stream = new RandomStream().reset(1, 2, 3, 4);
        assertEquals(0x68055585A968B899L, stream.nextLong());
        assertEquals(0x9A72E9C958BD6B24L, stream.nextLong());
        assertEquals(0.4282678762387596, stream.nextDouble());
        assertEquals(0.7713940143585205f, stream.nextFloat());
        assertEquals(866, stream.nextInt(1000));
        assertEquals(2.257035380062481, stream.nextDouble(-2, 3));
    }

    @Test
    void theMixingIsThatOfSplitMix64() {
        // First outputs of SplitMix64 from state 0, as in its authors' reference.
        long state = 0;
        state += 0x9E3779B97F4A7C15L;
        assertEquals(0xE220A8397B1DCDAFL, RandomStream.mix(state));
        state += 0x9E3779B97F4A7C15L;
        assertEquals(0x6E789E6AA1B965F4L, RandomStream.mix(state));
        state += 0x9E3779B97F4A7C15L;
        assertEquals(0x06C45D188009454FL, RandomStream.mix(state));
    }

    @Test
    void neighbouringWordsGiveDifferentStreams() {
        RandomStream stream = new RandomStream();
        Set<Long> seen = new HashSet<>();
        int drawn = 0;
        for (long seed = 0; seed < 8; seed++) {
            for (long tick = 0; tick < 8; tick++) {
                for (long entity = 0; entity < 8; entity++) {
                    for (int use = 0; use < 8; use++) {
                        stream.reset(seed, tick, entity, use);
                        seen.add(stream.nextLong());
                        seen.add(stream.nextLong());
                        drawn += 2;
                    }
                }
            }
        }
        assertEquals(drawn, seen.size());
    }

    @Property(tries = 200)
    void boundsHold(@ForAll long seed, @ForAll @IntRange(min = 1) int bound) {
        RandomStream stream = new RandomStream().reset(seed, 0, 0, 0);
        for (int i = 0; i < 50; i++) {
            int value = stream.nextInt(bound);
            assertTrue(value >= 0 && value < bound);
            double unit = stream.nextDouble();
            assertTrue(unit >= 0 && unit < 1);
            float small = stream.nextFloat();
            assertTrue(small >= 0 && small < 1);
            double between = stream.nextDouble(1, Math.nextUp(1.0));
            assertEquals(1.0, between);
        }
    }

    @Test
    void numbersOfOneDrawPerEntityAreUniform() {
        RandomStream stream = new RandomStream();
        int[] counts = new int[16];
        int draws = 160_000;
        for (int entity = 0; entity < draws; entity++) {
            counts[stream.reset(0, 1, entity, 0).nextInt(16)]++;
        }
        double chi2 = 0;
        for (int count : counts) {
            double expected = draws / 16.0;
            chi2 += (count - expected) * (count - expected) / expected;
        }
        assertTrue(chi2 < 37.7, "chi-squared with 15 degrees of freedom, 0.1 %: " + chi2);
    }

    @Test
    void badBoundsTeach() {
        RandomStream stream = new RandomStream();
        assertTeaches(IllegalArgumentException.class, () -> stream.nextInt(0), "0", "at least 1");
        assertTeaches(IllegalArgumentException.class, () -> stream.nextDouble(1, 1), "[1.0, 1.0)");
        assertTeaches(
                IllegalArgumentException.class, () -> stream.nextDouble(0, Double.NaN), "NaN");
    }
}
