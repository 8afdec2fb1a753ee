package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.support.MixedHeap;
import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Test;

import java.util.List;

/**
 * A heap of dry bodies that nothing disturbs stays as it is. It did not: offsets that held all of
 * the load of inclined contacts wound forces up until it gave way, every ten seconds, and 200
 * bodies sank by centimetres within a minute.
 */
class HeapAtRestTest {
    private static final int SIDE = 7;
    private static final int LAYERS = 10;

    /** A hundredth of a small body's size, m; within ten seconds this heap sank by 10 mm. */
    private static final double HUNDREDTH = 2e-3;

    private static double height(List<BodyRef> bodies) {
        return bodies.stream().mapToDouble(body -> body.position().y).average().orElseThrow();
    }

    @Test
    void keepsItsHeight() {
        try (PhysicsWorld world = Scenes.awake().build()) {
            List<BodyRef> bodies = MixedHeap.drop(world, 1, SIDE, LAYERS);
            Scenes.run(world, 600);
            double before = height(bodies);
            Scenes.run(world, 600);
            assertEquals(before, height(bodies), HUNDREDTH, "seed 1");
        }
    }

    @Test
    void sameBits() {
        Scenes.assertSameBits(world -> {
            MixedHeap.drop(world, 4, SIDE, LAYERS);
            Scenes.run(world, 120);
        });
    }
}
