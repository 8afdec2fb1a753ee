package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;
import java.util.Random;

/**
 * Needles of a millimetre that fall, bounce and rock on a floor, in ticks in which gravity alone
 * moves them by several times their thickness.
 */
class NeedleTest {
    private static final long SEED = 20261127;

    /** Radius and half height, m. */
    private static final double THIN = 5e-4, LONG = 0.0107;

    private static final int TICKS = 60;

    @ParameterizedTest
    @CsvSource({"1, 0.2", "1, 0.8", "4, 0.2"})
    void noNeedlePassesTheFloorInTicksOfUnevenLength(int substeps, double restitution) {
        for (int n = 0; n < 20; n++) {
            double[] low = new double[1];
            long digest = run(n, substeps, restitution, 1, 1, low);
            int needle = n;
            assertTrue(
                    low[0] > 0,
                    () -> "seed " + SEED + ", needle " + needle + ": centre at " + low[0] + " m");
            assertEquals(digest, run(n, substeps, restitution, 4, 2, low), "other lanes, workers");
        }
    }

    /** Returns the digest after the last tick; the lowest place of the centre of mass. */
    private static long run(
            int n, int substeps, double restitution, int lanes, int workers, double[] low) {
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withSubsteps(substeps).withLanes(lanes);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .settings(settings)
                        .workers(workers)
                        .sleeping(false)
                        .build()) {
            BodyRef needle = drop(world, n, restitution);
            Vector3d at = new Vector3d();
            low[0] = Double.MAX_VALUE;
            for (int tick = 0; tick < TICKS; tick++) {
                world.step(tick % 2 == 0 ? 1.0 / 120 : 1.0 / 30);
                low[0] = Math.min(low[0], needle.centreOfMass(at).y);
            }
            return world.digest();
        }
    }

    /** A wall that does not move gives no energy, however fast the blow makes a needle spin. */
    @Test
    void aBlowOnATipGivesNoEnergy() {
        for (int n = 0; n < 40; n++) {
            Random random = new Random(SEED + n);
            Vector3d[] corners = new Vector3d[8];
            for (int c = 0; c < 8; c++) {
                corners[c] =
                        new Vector3d(
                                ((c & 1) - 0.5) * 2e-5 * (1 + random.nextDouble()),
                                ((c >> 1 & 1) - 0.5) * 2e-5 * (1 + random.nextDouble()),
                                ((c >> 2) - 0.5) * 0.1 * (0.7 + 0.3 * random.nextDouble()));
            }
            try (PhysicsWorld world =
                    PhysicsWorld.builder().substeps(16).gravity(0, 0, 0).sleeping(false).build()) {
                Material material = new Material(0, 0, 1000);
                world.add(Body.fixed().shape(HalfSpace.of()).material(material));
                world.add(
                        Body.dynamic()
                                .shape(ConvexHull.of(List.of(corners)))
                                .at(0, 0.06, 0)
                                .rotation(turn(random))
                                .velocity(0, -1.4, 0)
                                .mass(90)
                                .material(material));
                double start = world.kineticEnergy();
                for (int tick = 0; tick < 40; tick++) {
                    world.step(0.0027);
                    double gain = world.kineticEnergy() / start - 1;
                    int needle = n;
                    assertTrue(gain < 1e-9, () -> "needle " + needle + " gains " + gain);
                }
            }
        }
    }

    /**
     * Nor is one put up that gravity alone moves by a hundred times its thickness in a tick: by no
     * more than that way, {@code g t²}, which is as near as its landing can be told.
     */
    @Test
    void noNeedleIsPutUp() {
        for (int n = 0; n < 60; n++) {
            Random random = new Random(SEED + n);
            try (PhysicsWorld world = PhysicsWorld.builder().substeps(2).sleeping(false).build()) {
                Material material = new Material(1.5, 0, 1000);
                world.add(Body.fixed().shape(HalfSpace.of()).material(material));
                world.add(
                        Body.dynamic()
                                .shape(Box.ofHalfExtents(1e-5, 1.1e-5, 0.0025))
                                .at(0, 0.004, 0)
                                .rotation(turn(random))
                                .mass(500)
                                .material(material));
                double start = world.kineticEnergy() + world.potentialEnergy();
                for (int tick = 0; tick < 120; tick++) {
                    world.step(1.0 / 60);
                    double now = world.kineticEnergy() + world.potentialEnergy();
                    double height = (now - start) / (500 * 9.81);
                    int needle = n;
                    assertTrue(
                            height < 9.81 / (60 * 60),
                            () -> "needle " + needle + " is put up by " + height + " m");
                }
            }
        }
    }

    @Test
    void whatOthersTouchChangesNoBit() {
        for (int n = 0; n < 10; n++) {
            try (PhysicsWorld alone = world();
                    PhysicsWorld beside = world()) {
                BodyRef one = drop(alone, n, 0.2);
                BodyRef other = drop(beside, n, 0.2);
                for (int k = 0; k < 5; k++) {
                    // touches and leaves the floor again and again, far away
                    beside.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.1))
                                    .at(10 + k, 0.2 + 0.05 * k, 0)
                                    .material(new Material(0.6, 0.9, 1000)));
                }
                for (int tick = 0; tick < 2 * TICKS; tick++) {
                    double seconds = tick % 2 == 0 ? 1.0 / 120 : 1.0 / 30;
                    alone.step(seconds);
                    beside.step(seconds);
                    assertEquals(one.position(), other.position(), "needle " + n + ", " + tick);
                }
            }
        }
    }

    private static PhysicsWorld world() {
        return PhysicsWorld.builder().substeps(1).sleeping(false).build();
    }

    private static BodyRef drop(PhysicsWorld world, int n, double restitution) {
        Random random = new Random(SEED + n);
        Quaterniond turn = turn(random);
        Material material = new Material(0.6, restitution, 1000);
        world.add(Body.fixed().shape(HalfSpace.of()).material(material));
        return world.add(
                Body.dynamic()
                        .shape(Cone.of(THIN, LONG))
                        .at(0, 0.05, 0)
                        .rotation(turn)
                        .material(material));
    }

    private static Quaterniond turn(Random random) {
        return new Quaterniond(
                        random.nextGaussian(),
                        random.nextGaussian(),
                        random.nextGaussian(),
                        random.nextGaussian())
                .normalize();
    }
}
