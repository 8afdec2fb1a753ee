package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;

import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A top whose tip slips, leaning so far that its rim is near the ground, too: most of its contact
 * carries nothing. Friction and ground are passive, so its energy can only fall.
 */
class SlippingTopTest {
    private static final double TICK = 1 / 60.0;
    private static final double G = 9.81;
    private static final double TILT = 0.5236;
    private static final int SIDES = 16;

    /** Share of the energy that errors of the integrator may put back in three seconds. */
    private static final double RISE = 1e-3;

    private static ConvexHull hull() {
        double[] corners = new double[3 * SIDES + 3];
        for (int i = 0; i < SIDES; i++) {
            double angle = 2 * Math.PI * i / SIDES;
            corners[3 * i] = 0.05 * StrictMath.cos(angle);
            corners[3 * i + 1] = 0.1 / 0.75;
            corners[3 * i + 2] = 0.05 * StrictMath.sin(angle);
        }
        return ConvexHull.of(corners);
    }

    @ParameterizedTest
    @CsvSource({
        "4, 20, 0.1",
        "4, 20, 0.3",
        "4, 40, 0.1",
        "4, 40, 0.3",
        "4, 40, 0.5",
        "4, 80, 0.2",
        "16, 40, 0.1",
        "16, 40, 0.3",
        "16, 80, 0.3"
    })
    void neverGainsEnergy(int substeps, double spin, double friction) {
        PhysicsSettings settings =
                PhysicsSettings.DEFAULT.withSubsteps(substeps).withSleeping(false);
        try (PhysicsWorld world =
                PhysicsWorld.builder().gravity(0, -G, 0).workers(1).settings(settings).build()) {
            Material surface = new Material(friction, 0, 1000);
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(50, 1, 50))
                            .at(0, -1, 0)
                            .material(surface));
            double x = spin * StrictMath.sin(TILT);
            double y = spin * StrictMath.cos(TILT);
            BodyRef top =
                    world.add(
                            Body.dynamic()
                                    .shape(hull())
                                    .mass(1)
                                    .inertia(0.0025, 0.0025, 0.0025)
                                    .rotationAbout(0, 0, 1, -TILT)
                                    .angularVelocity(x, y, 0)
                                    .material(surface));
            double begin = energy(world, top);
            double least = begin;
            for (int tick = 0; tick < 180; tick++) {
                world.step(TICK);
                double now = energy(world, top);
                least = Math.min(least, now);
                double rise = now - least;
                assertTrue(
                        rise <= RISE * begin,
                        "tick %d: %.4f J above the least so far, of %.3f J"
                                .formatted(tick, rise, begin));
            }
            assertTrue(least < 0.95 * begin, "did not slip: " + least + " of " + begin + " J");
        }
    }

    private static double energy(PhysicsWorld world, BodyRef top) {
        return world.kineticEnergy() + G * top.centreOfMass(new Vector3d()).y;
    }
}
