package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;

import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.stream.Stream;

/**
 * What lies tilted in the ground, one side deeper than the other, comes to lie flat: being pushed
 * out of an overlap is a turn too.
 */
class LevellingTest {
    /** Half the size, m, and how much of that the plates are thick. */
    private static final double HALF = 0.5, THICK = 1e-3;

    private static final double TILT = 1e-3;

    record Case(Shape shape, double degrees, int substeps, int lanes, int workers) {}

    static Stream<Case> cases() {
        Shape plate = Box.ofHalfExtents(HALF, THICK * HALF, 0.8 * HALF);
        return Stream.of(plate, Cylinder.of(HALF, THICK * HALF))
                .flatMap(shape ->
                        Stream.of(4, 8)
                                .flatMap(substeps ->
                                        Stream.of(0.0, 37.0, 90.0)
                                                .map(d -> new Case(shape, d, substeps, 1, 1))));
    }

    @ParameterizedTest
    @MethodSource("cases")
    void whatLiesTiltedInTheGroundComesToLieFlat(Case one) {
        double[] flat = new double[1];
        long digest = run(one, flat);
        assertTrue(
                flat[0] * HALF < 0.05 * THICK * HALF,
                () -> "tilted by " + flat[0] + " rad after two seconds");
        Case other = new Case(one.shape, one.degrees, one.substeps, 4, 2);
        assertEquals(digest, run(other, flat), "bits of another number of lanes and workers");
    }

    /**
     * The angle between a body's axis and the vertical after two seconds, and the world's digest.
     */
    private static long run(Case one, double[] tilt) {
        double azimuth = Math.toRadians(one.degrees);
        PhysicsSettings settings =
                PhysicsSettings.DEFAULT.withSubsteps(one.substeps).withLanes(one.lanes);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .settings(settings)
                        .workers(one.workers)
                        .sleeping(false)
                        .build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .shape(one.shape)
                                    .at(0, THICK * HALF, 0)
                                    .rotationAbout(Math.cos(azimuth), 0, Math.sin(azimuth), TILT));
            for (int tick = 0; tick < 120; tick++) {
                world.step(1.0 / 60);
            }
            Vector3d axis = body.orientation().transform(new Vector3d(0, 1, 0));
            tilt[0] = Math.hypot(axis.x, axis.z);
            return world.digest();
        }
    }
}
