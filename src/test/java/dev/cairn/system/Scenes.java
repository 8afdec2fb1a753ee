package dev.cairn.system;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.SceneReport;
import dev.cairn.samples.SceneRun;

import java.util.Map;

/** Runs the registry's scenes for the tests, which state what must come out. */
final class Scenes {
    private Scenes() {}

    static int ticks(double seconds) {
        return (int) StrictMath.round(seconds / SampleScene.STEP_SECONDS);
    }

    static SceneReport run(String id, double seconds, int workers, Map<String, String> parameters) {
        SampleScene scene = SceneRegistry.get(id);
        SceneOptions options = SceneOptions.of(scene, parameters, SceneOptions.DEFAULT_SEED, null);
        int substeps = PhysicsSettings.DEFAULT.substeps();
        return new SceneRun(scene, options, ticks(seconds), workers, substeps).run(() -> {});
    }

    static SceneReport run(String id, double seconds, Map<String, String> parameters) {
        return run(id, seconds, 1, parameters);
    }
}
