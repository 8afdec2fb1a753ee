package dev.cairn.samples;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.shape.Box;
import dev.cairn.samples.weather.Buoyancy;
import dev.cairn.samples.weather.Hull;
import dev.cairn.samples.weather.Wind;

import org.junit.jupiter.api.Test;

/**
 * Water and wind as systems: Archimedes' depth, the period of heaving, the speed of what drifts.
 */
class WeatherTest {
    private static final double STEP = 1.0 / 60;
    private static final double GRAVITY = 9.81;
    private static final double WATER = 1000;

    private static PhysicsWorld sea(double windX, int workers) {
        return PhysicsWorld.builder()
                .workers(workers)
                .systems(new Buoyancy(WATER, GRAVITY), new Wind(windX, 0))
                .build();
    }

    /** A cube of 1 m, upright. */
    private static BodyRef crate(PhysicsWorld world, double density, double y, double drag) {
        return world.add(
                Body.dynamic()
                        .shape(Box.cubeOfHalfExtent(0.5))
                        .mass(density)
                        .at(0, y, 0)
                        .with(new Hull(1, 0.5, drag), Force.ZERO));
    }

    /** In balance {@code rho_w d = rho H}: a crate put there stays. */
    @Test
    void aFloatingBoxIsAsDeepAsItsWeight() {
        for (double density : new double[] {100, 400, 900}) {
            try (PhysicsWorld world = sea(0, 1)) {
                double y = 0.5 - density / WATER;
                BodyRef crate = crate(world, density, y, 0);
                for (int tick = 0; tick < 300; tick++) {
                    world.step(STEP);
                }
                assertEquals(y, crate.position().y, 1e-9);
            }
        }
    }

    /**
     * {@code T = 2 pi sqrt(rho H / (rho_w g))}; the step's map of (y, v) turns by a little more.
     */
    @Test
    void itHeavesWithThePeriodOfItsDepth() {
        double density = 500;
        double omega = Math.sqrt(GRAVITY / (density / WATER));
        double a = 0.1;
        try (PhysicsWorld world = sea(0, 2)) {
            BodyRef crate = crate(world, density, a, 0);
            int crossings = 0;
            double first = 0;
            double last = 0;
            double before = a;
            double largest = 0;
            for (int tick = 1; tick <= 1800; tick++) {
                world.step(STEP);
                double y = crate.position().y;
                largest = Math.max(largest, Math.abs(y));
                if (before > 0 && y <= 0) {
                    last = (tick - 1 + before / (before - y)) * STEP;
                    first = crossings == 0 ? last : first;
                    crossings++;
                }
                before = y;
            }
            double period = (last - first) / (crossings - 1);
            // cos(phi) = 1 - (omega h)²/2 is the map's angle in a tick
            double angle = Math.acos(1 - omega * omega * STEP * STEP / 2);
            assertEquals(2 * Math.PI * STEP / angle, period, 1e-4 * period);
            assertEquals(2 * Math.PI / omega, period, 1e-3 * period);
            assertEquals(a, largest, 1e-3 * a, "no energy from nothing in 30 s");
        }
    }

    /** {@code v = u (1 - exp(-c t/m))}, of first order in the tick. */
    @Test
    void itDriftsWithTheWind() {
        try (PhysicsWorld world = sea(3, 1)) {
            BodyRef crate = crate(world, 500, 0, 1000);
            for (int tick = 0; tick < 60; tick++) {
                world.step(STEP);
            }
            assertEquals(3 * (1 - StrictMath.exp(-2)), crate.velocity().x, 0.03);
        }
    }
}
