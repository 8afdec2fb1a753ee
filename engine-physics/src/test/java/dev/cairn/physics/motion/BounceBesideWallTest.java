package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A wall without friction is not felt by what bounces beside it, also while it leans on the wall:
 * energy is kept, up to the fall of a body under load, which a sub-step makes {@code g h / 2} too
 * fast. That error is of first order: its bound falls with the sub-step.
 */
class BounceBesideWallTest {
    private static final Material ELASTIC = new Material(0, 1, 1000);

    /** Energy that is lost in ten seconds with 4 sub-steps, over that of the fall. */
    private static final double LOSS = 0.004;

    @ParameterizedTest
    @CsvSource({
        "ball, 0",
        "ball, 1e-9",
        "ball, 0.5",
        "cube, 1e-9",
        "cube, 0.5",
        "capsule, 1e-9",
        "capsule, 0.5"
    })
    void theWallIsNotFelt(String kind, double pull) {
        for (int substeps = 2; substeps <= 16; substeps *= 2) {
            long digest = run(kind, pull, substeps, 1, 1);
            if (substeps == 4) {
                assertEquals(digest, run(kind, pull, substeps, 2, 4), "2 workers, 4 lanes");
                assertEquals(digest, run(kind, pull, substeps, 2, 8), "2 workers, 8 lanes");
            }
        }
    }

    private static long run(String kind, double pull, int substeps, int workers, int lanes) {
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withSubsteps(substeps).withLanes(lanes);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(-pull, -9.81, 0)
                        .workers(workers)
                        .sleeping(false)
                        .settings(settings)
                        .build()) {
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(20, 1, 20))
                            .at(0, -1, 0)
                            .material(ELASTIC));
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(1, 20, 20))
                            .at(-1, 0, 0)
                            .material(ELASTIC));
            Shape shape =
                    switch (kind) {
                        case "ball" -> Sphere.of(0.5);
                        case "cube" -> Box.cubeOfHalfExtent(0.5);
                        default -> Capsule.of(0.1, 0.4);
                    };
            double beside = kind.equals("capsule") ? 0.1 : 0.5;
            BodyRef body =
                    world.add(Body.dynamic().shape(shape).at(beside, 2.5, 0).material(ELASTIC));
            double start = world.kineticEnergy() + world.potentialEnergy();
            double scale = body.mass() * 9.81 * 2;
            double bound = pull == 0 ? 1e-12 : LOSS * 4 / substeps;
            for (int tick = 0; tick < 600; tick++) {
                world.step(1 / 60.0);
                double gain = (world.kineticEnergy() + world.potentialEnergy() - start) / scale;
                String where = kind + ", " + substeps + " sub-steps, tick " + tick;
                assertTrue(gain < 1e-12, () -> where + ": energy gained " + gain);
                assertTrue(gain > -bound, () -> where + ": energy lost " + -gain);
            }
            return world.digest();
        }
    }
}
