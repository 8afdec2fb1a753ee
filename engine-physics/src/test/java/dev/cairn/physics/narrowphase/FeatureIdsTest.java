package dev.cairn.physics.narrowphase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.pair.FeatureIds;

import org.junit.jupiter.api.Test;

import java.util.HashSet;
import java.util.Set;

/** The bytes that stand for names in a word. */
class FeatureIdsTest {
    @Test
    void namesOfBoxesHaveAByteEach() {
        Set<Integer> bytes = new HashSet<>();
        int names = 0;
        for (int v = 0; v < 8; v++) {
            bytes.add(FeatureIds.hash(FeatureIds.VERTEX_A | v));
            bytes.add(FeatureIds.hash(FeatureIds.VERTEX_B | v));
            names += 2;
        }
        for (int a = 0; a < 12; a++) {
            for (int b = 0; b < 12; b++) {
                bytes.add(FeatureIds.hash(FeatureIds.CROSSING | a << 15 | b));
                names++;
            }
        }
        bytes.add(FeatureIds.hash(FeatureIds.CLOSEST));
        assertEquals(names + 1, bytes.size());
        assertTrue(bytes.stream().allMatch(b -> b > 0 && b < 256));
    }
}
