package dev.cairn.benchmarks;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;

import java.util.Map;

/**
 * Scenes of the samples after two seconds of settling or more, sleep off; for the suites of whole
 * steps. They go on until the vector kernels are warm, see {@link WarmUp}.
 */
final class SettledScenes {
    private static final int SETTLING_STEPS = 120;

    private SettledScenes() {}

    /**
     * Builds a scene and lets it settle.
     *
     * @param scene its id
     * @param bodies about so many of them; 0 for as many as it has by itself
     * @param substeps per tick
     * @param workers threads
     * @param lanes contacts that the solver takes at once; 0 for what fits the machine
     */
    static PhysicsWorld build(String scene, int bodies, int substeps, int workers, int lanes) {
        PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(workers)
                        .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                        .substeps(substeps)
                        .sleeping(false)
                        .build();
        SampleScene chosen = SceneRegistry.get(scene);
        chosen.build(
                new SceneBuilder(
                        world,
                        SceneOptions.of(
                                chosen, sized(scene, bodies), SceneOptions.DEFAULT_SEED, null)));
        WarmUp.untilQuiet(() -> {
            for (int step = 0; step < SETTLING_STEPS; step++) {
                world.step(SampleScene.STEP_SECONDS);
            }
        });
        return world;
    }

    private static Map<String, String> sized(String scene, int bodies) {
        if (bodies == 0) {
            return Map.of();
        }
        // base (base + 1) / 2 boxes in a pyramid, side^2 layers bodies in a pile
        long base = Math.max(1, Math.round((Math.sqrt(8.0 * bodies + 1) - 1) / 2));
        long side = Math.max(1, Math.round(Math.cbrt(bodies)));
        long layers = Math.max(1, Math.round((double) bodies / (side * side)));
        long pyramids = Math.max(1, Math.round(Math.sqrt(bodies / 55.0)));
        return switch (scene) {
            case "pyramid" -> Map.of("base", Long.toString(base));
            case "many-pyramids" -> Map.of("side", Long.toString(pyramids), "base", "10");
            case "stack-4" -> Map.of("boxes", "4");
            default -> Map.of("side", Long.toString(side), "layers", Long.toString(layers));
        };
    }
}
