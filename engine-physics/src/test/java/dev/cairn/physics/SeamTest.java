package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.util.Arrays;

/** What crosses the seams of a floor does as on a slab. */
class SeamTest {
    private static double[] compare(TileRuns.Start start, double tile) {
        TileRuns.Floor slab = new TileRuns.Floor(0, 0, 0, 0);
        TileRuns.Floor tiles = new TileRuns.Floor(tile, 0, 0, 0);
        double[] truth = TileRuns.run(start, slab, 90, Scenes.awake().workers(1));
        double[] run = TileRuns.run(start, tiles, 90, Scenes.awake().workers(1));
        return TileRuns.differences(run, truth);
    }

    @Test
    void everyShapeAtEverySpeed() {
        for (String kind : TileRuns.KINDS) {
            for (double speed : new double[] {2, 5, 9, 20}) {
                double[] d =
                        compare(
                                new TileRuns.Start(kind, .35, speed, .37, .2, 0, .1, .11, .23),
                                .9);
                System.out.printf("%-9s %4.0f m/s %s%n", kind, speed, Arrays.toString(d));
            }
        }
        assertTrue(true);
    }
}
