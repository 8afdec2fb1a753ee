package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** What stands or falls on a floor of tiles does as on one slab. */
class StructuresOnTilesTest {
    /** Half the side of a box, m. */
    private static final double HALF = 0.25;

    /** No multiple of a box's side: seams are anywhere below the boxes. */
    private static final double TILE = 0.83;

    private static final double REACH = 12;

    private static void floor(PhysicsWorld world, boolean isTiled, double bond) {
        if (!isTiled) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(REACH, 0.5, REACH)).at(0, -0.5, 0));
            return;
        }
        int most = (int) (REACH / TILE);
        for (int j = -most; j <= most; j++) {
            double shift = bond * j - Math.floor(bond * j);
            for (int i = -most; i <= most; i++) {
                world.add(
                        Body.fixed()
                                .shape(Box.ofHalfExtents(TILE / 2, 0.5, TILE / 2))
                                .at((i + shift) * TILE, -0.5, j * TILE));
            }
        }
    }

    private static List<BodyRef> pyramid(PhysicsWorld world, int rows) {
        List<BodyRef> boxes = new ArrayList<>();
        for (int row = 0; row < rows; row++) {
            for (int i = 0; i < rows - row; i++) {
                boxes.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(HALF))
                                        .at(
                                                2.2 * HALF * (i + 0.5 * row),
                                                HALF * (2 * row + 1),
                                                0.1)));
            }
        }
        return boxes;
    }

    /** Ten rows for five seconds: nowhere a picometre from where they are on the slab. */
    @Test
    void aPyramidStandsAsOnASlab() {
        for (double bond : new double[] {0, 0.37}) {
            try (PhysicsWorld tiled = Scenes.awake().workers(1).build();
                    PhysicsWorld whole = Scenes.awake().workers(1).build()) {
                floor(tiled, true, bond);
                floor(whole, false, 0);
                List<BodyRef> boxes = pyramid(tiled, 10);
                List<BodyRef> same = pyramid(whole, 10);
                double worst = 0;
                for (int tick = 0; tick < 300; tick++) {
                    tiled.step(Scenes.STEP);
                    whole.step(Scenes.STEP);
                    for (int i = 0; i < boxes.size(); i++) {
                        double off = boxes.get(i).position().distance(same.get(i).position());
                        worst = Math.max(worst, off);
                    }
                }
                System.out.println("bond " + bond + ": " + worst + " m from the slab's");
                assertTrue(worst < 1e-12, "bond " + bond + ": " + worst + " m");
            }
        }
    }

    /**
     * A hundred boxes fall in a heap: rounding decides where each ends, but not that none sinks,
     * and that all sleep, as on the slab.
     */
    @Test
    void aHeapSleepsAsOnASlab() {
        int tiles = heap(true);
        int slab = heap(false);
        System.out.println("asleep after " + tiles + " ticks on tiles, " + slab + " on the slab");
        assertEquals(slab, tiles, 180, "ticks until all sleep");
    }

    /** After how many ticks all sleep. */
    private static int heap(boolean isTiled) {
        long seed = 3;
        Random random = new Random(seed);
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            floor(world, isTiled, 0.37);
            List<BodyRef> boxes = new ArrayList<>();
            for (int i = 0; i < 100; i++) {
                boxes.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(HALF))
                                        .at(
                                                random.nextDouble(-1, 1),
                                                1 + 0.3 * i,
                                                random.nextDouble(-1, 1))
                                        .rotation(Scenes.turn(random))));
            }
            int ticks = 0;
            while (!Scenes.allAsleep(boxes)) {
                world.step(Scenes.STEP);
                assertTrue(++ticks < 1200, "seed " + seed + ": not asleep after 20 s");
            }
            for (BodyRef box : boxes) {
                Vector3d at = box.position();
                // half a box lies above, however it lies
                assertTrue(at.y > HALF - 1e-3, "seed " + seed + ": one sank to " + at);
            }
            return ticks;
        }
    }
}
