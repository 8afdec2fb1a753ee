package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.SceneReport;

import org.junit.jupiter.api.Test;

import java.util.Map;

/**
 * The scenes of the report against their closed forms. Overlaps are measured outside the engine,
 * from poses and shapes; there is no sleeping.
 */
final class SceneTruthTest {
    private static void assertBelow(double bound, String metric, SceneReport report) {
        Double value = report.errors().get(metric);
        assertTrue(
                value != null && Math.abs(value) < bound,
                () -> "%s of %s is %s, bound %s".formatted(metric, report.scene(), value, bound));
    }

    @Test
    void fourBoxesStandForAMinute() {
        SceneReport stack = Scenes.run("stack-4", 60, Map.of("restitution", "0"));

        assertTrue(stack.maxPenetrationMetres() < 5e-3, () -> "overlap " + stack);
        assertBelow(1e-3, "creepMetres", stack);
        // Level k carries the weight above it: N = (n - k) m g.
        assertBelow(1e-3, "forceRelative", stack);
    }

    @Test
    void eighteenCubesStandForAMinute() {
        SceneReport cubes = Scenes.run("cubes-18", 60, Map.of());

        assertTrue(cubes.maxPenetrationMetres() < 5e-3, () -> "overlap " + cubes);
        assertBelow(1e-3, "creepMetres", cubes);
    }

    @Test
    void aBoxSlidesDownTwentyDegreesAsCoulombSays() {
        // s = g (sin - mu cos) t² / 2
        SceneReport slide =
                Scenes.run("slope-box", 2, Map.of("friction", "0.2", "drop", "0", "speed", "0"));

        assertBelow(5e-3, "distanceRelative", slide);
    }

    @Test
    void aBoxBelowTheFrictionAngleDoesNotMove() {
        SceneReport stick =
                Scenes.run("slope-box", 60, Map.of("friction", "0.5", "drop", "0", "speed", "0"));

        assertBelow(1e-5, "distanceMetres", stick);
    }

    @Test
    void rollersStopWhereRollingFrictionSays() {
        SceneReport rolled = Scenes.run("rolling-resistance", 8, Map.of());

        assertBelow(1e-11, "speedRelative", rolled);
        assertBelow(1e-11, "distanceRelative", rolled);
    }

    @Test
    void freeFallIsTheParabola() {
        SceneReport fall = Scenes.run("free-fall", 5, Map.of());

        fall.errors().keySet().forEach(metric -> assertBelow(1e-9, metric, fall));
    }

    @Test
    void elasticBoxesKeepBouncing() {
        SceneReport bounce =
                Scenes.run("stack-4", 10, Map.of("restitution", "1", "boxes", "1", "gap", "1"));

        assertBelow(1e-2, "energyRelative", bounce);
    }

    @Test
    void elasticBoxesWithoutFrictionKeepTheirEnergyThroughTiltsAndTumbles() {
        // impacts slower than the threshold do not bounce, and some of these are: one in 30 s
        PhysicsSettings settings =
                PhysicsSettings.DEFAULT.withRestitutionThreshold(0).withSleeping(false);
        SampleScene scene = SceneRegistry.get("stack-4");
        SceneOptions options =
                SceneOptions.of(
                        scene,
                        Map.of("restitution", "1", "friction", "0"),
                        SceneOptions.DEFAULT_SEED,
                        null);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(1)
                        .settings(settings)
                        .build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            for (int tick = 0; tick < 1800; tick++) {
                built.beforeTick();
                world.step(SampleScene.STEP_SECONDS);
                built.afterTick();
                double off = Math.abs(built.errors().get("energyRelative"));
                assertTrue(off < 1e-11, "energy off by " + off + " in tick " + tick);
            }
        }
    }

    @Test
    void twoPairsOfThreeCollide() {
        SceneReport pairs = Scenes.run("pairs-3", 1, Map.of());

        assertEquals(2, pairs.remarks().size(), () -> "collisions: " + pairs.remarks());
    }
}
