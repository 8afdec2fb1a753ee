package dev.cairn.samples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

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
        SceneOptions options = SceneOptions.defaults(scene);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .sleeping(false)
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(1)
                        .systems(scene.systems(options))
                        .build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
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

    /** Archimedes' depth, the period of heaving and the speed of what drifts, as in WeatherTest. */
    @Test
    void floatingCubesFollowTheClosedForms() {
        Map<String, Double> errors = run("buoyancy", 600, 2).errors();
        assertTrue(errors.get("depthMetres") < 1e-9, errors.toString());
        assertTrue(errors.get("driftMetresPerSecond") < 1e-9, errors.toString());
        assertTrue(Math.abs(errors.get("periodRelative")) < 1e-3, errors.toString());
    }

    /** A world without water would let the cubes fall, so it is refused. */
    @Test
    void aSceneWithSystemsRefusesAWorldWithoutThem() {
        SampleScene scene = SceneRegistry.get("buoyancy");
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            SceneBuilder builder = new SceneBuilder(world, SceneOptions.defaults(scene));
            String told =
                    assertThrows(IllegalArgumentException.class, () -> scene.build(builder))
                            .getMessage();
            assertTrue(told.contains("needs the system \"buoyancy\""), told);
        }
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

    /** Two balls 2 mm in each other, one 1 mm in the floor, one past the floor's edge: 5 mm². */
    @Test
    void overlapsOfSphereGridsAreThoseOfBallsAndFloor() {
        SampleScene scene = SceneRegistry.get("spheres-666");
        Map<String, String> four = Map.of("side", "2", "layers", "1");
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            SceneBuilder built =
                    scene.build(new SceneBuilder(world, SceneOptions.of(scene, four, 1, null)));
            double[][] places = {{0, 1, 0}, {0.198, 1, 0}, {3, 0.099, 0}, {150, -5, 0}};
            int next = 0;
            for (BodyRef body : built.bodies()) {
                if (!body.isFixed()) {
                    double[] at = places[next++];
                    body.teleport(at[0], at[1], at[2], new Quaterniond());
                }
            }
            assertEquals(places.length, next);
            built.afterTick();
            assertEquals(5e-6, built.errors().get("overlapSquaredMetres2"), 1e-15);
        }
    }

    /** SimBenchmark's ground is a plane without an end, so no ball may fall past ours. */
    @ParameterizedTest
    @ValueSource(strings = {"spheres-666", "elastic-666"})
    void noBallOfASphereGridLeavesTheFloor(String id) {
        SampleScene scene = SceneRegistry.get(id);
        try (PhysicsWorld world =
                PhysicsWorld.builder().gravity(0, -SampleScene.GRAVITY, 0).build()) {
            SceneBuilder built =
                    scene.build(new SceneBuilder(world, SceneOptions.of(scene, Map.of(), 1, null)));
            for (int tick = 0; tick < 600; tick++) {
                world.step(1.0 / 60);
            }
            Vector3d centre = new Vector3d();
            for (BodyRef body : built.bodies()) {
                assertTrue(
                        body.isFixed() || body.centreOfMass(centre).y > 0.05,
                        () -> body + " at " + centre);
            }
        }
    }
}
