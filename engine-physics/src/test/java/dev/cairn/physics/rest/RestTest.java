package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Inside;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Arrays;
import java.util.Random;

/** What rests keeps its contact points and comes to rest. */
@Tag("compiled")
class RestTest {
    private static int[] names(PhysicsWorld world) {
        ContactStore c = Inside.contacts(world);
        int[] names = new int[5 * c.count];
        for (int row = 0; row < c.count; row++) {
            names[5 * row] = c.pointCount[row];
            System.arraycopy(
                    c.feature, ContactStore.POINTS * row, names, 5 * row + 1, c.pointCount[row]);
        }
        return names;
    }

    @Test
    void anAlignedStackKeepsTheNamesOfItsPoints() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            Scenes.stack(world, 10);
            world.step(Scenes.STEP);
            int[] first = names(world);
            assertEquals(50, first.length);
            for (int tick = 1; tick < 600; tick++) {
                world.step(Scenes.STEP);
                assertArrayEquals(first, names(world), "tick " + tick);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void aStackThatWasPutDownCarelesslyKeepsThemOnceItStands(long seed) {
        Random random = new Random(seed);
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            Scenes.ground(world);
            for (int i = 0; i < 10; i++) {
                world.add(
                        Body.dynamic()
                                .shape(Box.cubeOfHalfExtent(0.5))
                                .at(
                                        0.01 * random.nextGaussian(),
                                        0.5 + 1.001 * i,
                                        0.01 * random.nextGaussian())
                                .rotationAbout(0, 1, 0, 0.5 * random.nextGaussian()));
            }
            int[] last = {};
            for (int tick = 0; tick < 600; tick++) {
                world.step(Scenes.STEP);
                int[] now = names(world);
                if (tick > 180) {
                    assertArrayEquals(last, now, "seed " + seed + " tick " + tick);
                }
                last = now;
            }
        }
    }

    /**
     * 200 boxes in a pit of 5 m; the median of the last two seconds. Of 90 piles every seventh
     * still has a stone that slips (6e-4 to 4e-2 m/s in the mean), which ones is chance; half are
     * slower than 1e-4. So the median of nine is held, to three times that.
     */
    @Test
    void pilesOfTwoHundredBoxesComeToRest() {
        double[] speeds = new double[9];
        for (int i = 0; i < speeds.length; i++) {
            speeds[i] = restlessness(i + 1);
        }
        String measured = "seeds 1 to 9: mean speeds " + Arrays.toString(speeds) + " m/s";
        Arrays.sort(speeds);
        assertTrue(speeds[4] < 3e-4, measured);
    }

    private static double restlessness(long seed) {
        double mass = 0;
        double[] energy = new double[120];
        try (PhysicsWorld world = Scenes.awake().workers(1).substeps(8).build()) {
            Scenes.ground(world);
            for (int side = -1; side <= 1; side += 2) {
                world.add(Body.fixed().shape(Box.ofHalfExtents(0.5, 5, 3)).at(3 * side, 5, 0));
                world.add(Body.fixed().shape(Box.ofHalfExtents(3, 5, 0.5)).at(0, 5, 3 * side));
            }
            Random random = new Random(seed);
            for (int i = 0; i < 200; i++) {
                BodyRef box = world.add(stone(random, i));
                mass += box.mass();
            }
            for (int tick = 0; tick < 600; tick++) {
                world.step(Scenes.STEP);
                if (tick >= 480) {
                    energy[tick - 480] = world.kineticEnergy();
                }
            }
        }
        Arrays.sort(energy);
        return Math.sqrt(2 * energy[60] / mass);
    }

    private static Body stone(Random random, int i) {
        return Body.dynamic()
                .shape(
                        Box.ofHalfExtents(
                                0.15 + 0.2 * random.nextDouble(),
                                0.15 + 0.2 * random.nextDouble(),
                                0.15 + 0.2 * random.nextDouble()))
                .at(
                        -1.8 + 1.2 * (i % 4) + 0.2 * random.nextDouble(),
                        0.6 + 0.75 * (i / 16),
                        -1.8 + 1.2 * (i / 4 % 4) + 0.2 * random.nextDouble())
                .rotationAbout(
                        random.nextDouble(),
                        random.nextDouble(),
                        random.nextDouble() + 0.1,
                        6 * random.nextDouble());
    }
}
