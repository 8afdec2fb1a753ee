package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Random;

/**
 * Slender boxes that are dropped in random poses never have more energy than they were dropped
 * with: the floor does no work. They turn by a good part of a radian within a tick, and by much
 * more than their own thickness.
 */
final class SlenderTest {
    private static final int WORLDS = 400;
    private static final int TICKS = 150;
    private static final long SEED = 1;

    /** Rounding, and what pushing out an overlap of less than a thickness lifts. */
    private static final double ROOM = 1e-4;

    @ParameterizedTest(name = "{0} x {1} from {2} m, seed 1")
    @CsvSource({
        "0.0025, 0.125, 0.5",
        "0.0025, 0.125, 1",
        "0.0025, 0.125, 2",
        "0.0025, 0.125, 5",
        "0.004, 0.1, 1",
        "0.02, 0.5, 20"
    })
    void landingGivesNoEnergy(double half, double halfLength, double height) {
        Random random = new Random(SEED);
        for (int n = 0; n < WORLDS; n++) {
            Quaterniond pose =
                    new Quaterniond().rotateXYZ(turn(random), turn(random), turn(random));
            double gain = gain(half, halfLength, height, pose);
            assertTrue(
                    gain <= ROOM,
                    "world " + n + " of seed " + SEED + " gains " + gain + " of its energy");
        }
    }

    private static double turn(Random random) {
        return random.nextDouble() * 2 * Math.PI;
    }

    /** Most energy after a tick over the first, less one. */
    private static double gain(double half, double halfLength, double height, Quaterniond pose) {
        double most = 0;
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -9.81, 0)
                        .workers(1)
                        .settings(PhysicsSettings.DEFAULT.withSleeping(false).withLanes(1))
                        .build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            BodyRef rod =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(half, halfLength, half))
                                    .at(0, height, 0)
                                    .rotation(pose));
            double first = energy(rod, half, halfLength);
            for (int t = 0; t < TICKS; t++) {
                world.step(1.0 / 60);
                most = Math.max(most, energy(rod, half, halfLength) / first - 1);
            }
        }
        return most;
    }

    /** Energy over mass, J/kg. */
    private static double energy(BodyRef rod, double half, double halfLength) {
        Vector3d v = new Vector3d(rod.velocity());
        Vector3d w =
                new Vector3d(rod.angularVelocity())
                        .rotate(new Quaterniond(rod.orientation()).conjugate());
        double across = (half * half + halfLength * halfLength) / 3;
        double along = 2 * half * half / 3;
        double spin = across * (w.x * w.x + w.z * w.z) + along * w.y * w.y;
        return 0.5 * (v.lengthSquared() + spin) + 9.81 * rod.position().y;
    }
}
