package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** Warming up at a loading screen: progress is told, and no bit depends on it. */
@Tag("compiled")
class WarmUpTest {
    private static long stack() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            Scenes.stack(world, 10);
            Scenes.run(world, 60);
            return world.digest();
        }
    }

    @Test
    void progressAscendsToOneAndNoBitChanges() {
        final long before = stack();
        List<Double> told = new ArrayList<>();
        PhysicsWorld.builder().warmUp(told::add);
        assertEquals(0, told.get(0));
        assertEquals(1, told.get(told.size() - 1));
        for (int i = 1; i < told.size(); i++) {
            assertTrue(told.get(i) >= told.get(i - 1), "ascending at " + i);
        }
        assertEquals(before, stack());
    }

    @Test
    void nobodyToTellIsRefused() {
        IllegalArgumentException refused =
                assertThrows(
                        IllegalArgumentException.class, () -> PhysicsWorld.builder().warmUp(null));
        assertTrue(String.valueOf(refused.getMessage()).contains("progress"));
    }

    /** Who is told may throw: nothing is left open. */
    @Test
    void whoIsToldMayStopIt() {
        assertThrows(
                IllegalStateException.class,
                () ->
                        PhysicsWorld.builder()
                                .warmUp(share -> {
                                    if (share > 0.01) {
                                        throw new IllegalStateException("enough");
                                    }
                                }));
        assertTrue(stack() != 0);
    }
}
