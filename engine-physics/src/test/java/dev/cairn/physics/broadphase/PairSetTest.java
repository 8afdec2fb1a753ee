package dev.cairn.physics.broadphase;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;

class PairSetTest {

    @ParameterizedTest
    @ValueSource(longs = {11, 12, 13})
    void behavesAsASet(long seed) {
        Random random = new Random(seed);
        PairSet pairs = new PairSet();
        Set<Long> expected = new HashSet<>();
        for (int i = 0; i < 40_000; i++) {
            int a = random.nextInt(60);
            int b = a + 1 + random.nextInt(60);
            long key = random.nextBoolean() ? PairSet.key(a, b) : PairSet.key(b, a);
            String where = "seed " + seed + ", change " + i;
            if (random.nextBoolean()) {
                assertEquals(expected.add(key), pairs.add(key), where);
            } else {
                assertEquals(expected.remove(key), pairs.remove(key), where);
            }
            assertEquals(expected.contains(key), pairs.contains(key), where);
            assertEquals(expected.size(), pairs.size(), where);
        }
        for (int a = 0; a < 60; a++) {
            for (int b = a + 1; b < 120; b++) {
                long key = PairSet.key(a, b);
                assertEquals(expected.contains(key), pairs.contains(key), "seed " + seed);
            }
        }
    }
}
