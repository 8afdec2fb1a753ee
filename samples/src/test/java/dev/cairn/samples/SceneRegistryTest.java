package dev.cairn.samples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/** Every scene builds, runs, stays finite, and does the same with any number of workers. */
class SceneRegistryTest {
    private static final int TICKS = 30;

    static List<String> ids() {
        return SceneRegistry.ids();
    }

    private static SceneReport run(String id, int ticks, int workers, String... settings) {
        SampleScene scene = SceneRegistry.get(id);
        Map<String, String> values = new TreeMap<>();
        for (String setting : settings) {
            values.put(setting.split("=")[0], setting.split("=")[1]);
        }
        return new SceneRun(scene, SceneOptions.of(scene, values, 1, null), ticks, workers, 4)
                .run(() -> {});
    }

    @Test
    void idsAreUniqueAndTheScenesOfTheReportAreThere() {
        Set<String> unique = new HashSet<>(SceneRegistry.ids());
        assertEquals(SceneRegistry.all().size(), unique.size());
        assertTrue(
                unique.containsAll(
                        List.of(
                                "slope-box",
                                "stack-4",
                                "slope-ball",
                                "room",
                                "static-100",
                                "cubes-18",
                                "pairs-3",
                                "obj-drop",
                                "pyramid",
                                "free-fall")));
    }

    @ParameterizedTest
    @MethodSource("ids")
    void sceneHasTheSameDigestForEveryNumberOfWorkers(String id) {
        SceneReport one = run(id, TICKS, 1);
        for (int workers = 1; workers <= 3; workers++) {
            SceneReport again = run(id, TICKS, workers);
            assertEquals(one.digest(), again.digest(), id + " with " + workers + " workers");
            assertEquals(one.errors(), again.errors());
            assertEquals(one.maxPenetrationMetres(), again.maxPenetrationMetres());
        }
        assertTrue(Double.isFinite(one.kineticEnergy()), "energy " + one.kineticEnergy());
    }

    @ParameterizedTest
    @MethodSource("ids")
    void sceneStaysFiniteAndHasALook(String id) {
        SampleScene scene = SceneRegistry.get(id);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .sleeping(false)
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(1)
                        .build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, SceneOptions.defaults(scene)));
            assertEquals(built.bodies().size(), world.bodyCount());
            for (int tick = 0; tick < TICKS; tick++) {
                built.beforeTick();
                world.step(SampleScene.STEP_SECONDS);
                built.afterTick();
            }
            for (BodyRef body : built.bodies()) {
                assertTrue(body.position().isFinite(), body + " at " + body.position());
                assertTrue(body.velocity().isFinite(), body + " moves with " + body.velocity());
            }
            built.errors()
                    .forEach((name, value) ->
                            assertTrue(Double.isFinite(value), name + " is " + value));
        }
    }

    @Test
    void theSeedMatters() {
        SampleScene scene = SceneRegistry.get("obj-drop");
        String first =
                new SceneRun(scene, SceneOptions.of(scene, Map.of(), 1, null), 5, 1, 4)
                        .run(() -> {})
                        .digest();
        String other =
                new SceneRun(scene, SceneOptions.of(scene, Map.of(), 2, null), 5, 1, 4)
                        .run(() -> {})
                        .digest();
        assertNotEquals(first, other);
    }

    @Test
    void parametersReachTheScene() {
        assertEquals(1 + 6, run("pyramid", 1, 1, "base=3").bodies());
        assertEquals(1 + 210, run("pyramid", 1, 1).bodies());
        assertEquals(100, run("static-100", 1, 1).bodies());
        assertEquals(1 + 18, run("cubes-18", 1, 1).bodies());
    }

    @Test
    void slidingBoxFollowsTheClosedForm() {
        SceneReport report = run("slope-box", 120, 1, "friction=0.2", "drop=0", "speed=0");
        assertTrue(report.errors().get("distanceRelative") < 0.005, report.errors().toString());
    }

    @Test
    void boxWithEnoughFrictionDoesNotMove() {
        SceneReport report = run("slope-box", 240, 1, "friction=0.5", "drop=0", "speed=0");
        assertTrue(report.errors().get("distanceMetres") < 1e-4, report.errors().toString());
        assertTrue(!report.errors().containsKey("distanceRelative"), report.errors().toString());
    }

    @Test
    void freeFallIsTheParabola() {
        SceneReport report = run("free-fall", 60, 1);
        assertTrue(report.errors().get("positionMetres") < 1e-9, report.errors().toString());
    }

    @Test
    void pairsCollideExactlyTwice() {
        SceneReport report = run("pairs-3", 60, 2);
        assertEquals(0, report.errors().get("collisionsOff"));
        assertEquals(2, report.remarks().size(), report.remarks().toString());
    }

    @Test
    void staticCubesDoNotMove() {
        SceneReport report = run("static-100", 30, 1);
        assertEquals(0, report.errors().get("movedMetres"));
        assertEquals(0, report.contacts());
        assertEquals(0, report.kineticEnergy());
    }

    @Test
    void stacksStand() {
        for (String id : List.of("stack-4", "cubes-18")) {
            SceneReport report = run(id, 300, 1);
            assertTrue(
                    report.maxPenetrationMetres() < 0.005,
                    id + " overlaps " + report.maxPenetrationMetres());
            assertTrue(report.errors().get("sagMetres") < 0.005, id + report.errors());
            assertTrue(report.errors().get("creepMetres") < 0.001, id + report.errors());
        }
    }

    @Test
    void unknownSceneIsRefused() {
        assertThrows(UsageException.class, () -> SceneRegistry.get("pyramids-of-giza"));
    }
}
