package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.SplittableRandom;

/** What stands, stands with ticks of any lengths. */
final class UnevenTickTest {
    private static final long SEED = 20261124;
    private static final double MINUTE = 60;

    @ParameterizedTest(name = "{1} boxes, {0}, lanes {2}")
    @CsvSource({
        "EVERY_TENTH_SHORT, 5, 1",
        "EVERY_TENTH_SHORT, 10, 8",
        "IN_TURNS, 5, 8",
        "IN_TURNS, 10, 1",
        "ONE_MILLISECOND_A_SECOND, 10, 1",
        "ONE_MILLISECOND_A_SECOND, 25, 1",
        "RANDOM, 10, 1",
        "RANDOM, 10, 8"
    })
    void aStackStandsForAMinute(Lengths lengths, int boxes, int lanes) {
        // from 24 on, stacks are solved directly and creep with uneven ticks
        assertEquals(0, drift(lengths, boxes, lanes, 0), boxes < 24 ? 1e-9 : 1e-2, "m");
    }

    /** Friction that holds a load holds it with ticks of any lengths, too. */
    @ParameterizedTest
    @EnumSource
    void whatIsHeldOnASlopeDoesNotCreep(Lengths lengths) {
        SplittableRandom random = new SplittableRandom(SEED);
        double slope = 0.3;
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(9.81 * StrictMath.sin(slope), -9.81 * StrictMath.cos(slope), 0)
                        .workers(1)
                        .settings(PhysicsSettings.DEFAULT.withSleeping(false))
                        .build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            Box shape = Box.ofHalfExtents(0.5, 0.25, 0.5);
            BodyRef lower = world.add(Body.dynamic().shape(shape).at(0, 0.25, 0));
            BodyRef upper = world.add(Body.dynamic().shape(shape).at(0, 0.75, 0));
            double time = 0;
            for (int tick = 0; time < MINUTE; tick++) {
                double seconds = lengths.next(tick, random);
                world.step(seconds);
                time += seconds;
            }
            assertEquals(0, lower.position().x, 1e-9, "m");
            assertEquals(0, upper.position().x, 1e-9, "m");
        }
    }

    /** Dropped, so that loads are not known from the start. */
    @Test
    void aStackThatLandsStandsForAMinute() {
        for (Lengths lengths : Lengths.values()) {
            assertTrue(drift(lengths, 5, 1, 0.01) < 0.06, lengths + ", m");
        }
    }

    private static double drift(Lengths lengths, int boxes, int lanes, double apart) {
        SplittableRandom random = new SplittableRandom(SEED);
        double most = 0;
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -9.81, 0)
                        .workers(1)
                        .settings(PhysicsSettings.DEFAULT.withSleeping(false).withLanes(lanes))
                        .build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            BodyRef[] box = new BodyRef[boxes];
            for (int i = 0; i < boxes; i++) {
                double height = 0.5 + i + apart * (i + 1);
                box[i] =
                        world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, height, 0));
            }
            double time = 0;
            for (int tick = 0; time < MINUTE; tick++) {
                double seconds = lengths.next(tick, random);
                world.step(seconds);
                time += seconds;
                for (int i = 0; i < boxes; i++) {
                    most = Math.max(most, box[i].position().distance(0, 0.5 + i, 0));
                }
            }
        }
        return most;
    }

    /** How long ticks are. */
    enum Lengths {
        EVERY_TENTH_SHORT,
        IN_TURNS,
        ONE_MILLISECOND_A_SECOND,
        RANDOM;

        double next(int tick, SplittableRandom random) {
            return switch (this) {
                case EVERY_TENTH_SHORT -> tick % 10 == 9 ? 1.0 / 600 : 1.0 / 60;
                case IN_TURNS -> tick % 2 == 0 ? 1.0 / 120 : 1.0 / 30;
                case ONE_MILLISECOND_A_SECOND -> tick % 60 == 59 ? 0.001 : 1.0 / 60;
                case RANDOM -> 0.001 + (1.0 / 30 - 0.001) * random.nextDouble();
            };
        }
    }
}
