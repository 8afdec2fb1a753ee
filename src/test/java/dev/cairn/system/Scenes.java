package dev.cairn.system;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.SceneReport;
import dev.cairn.samples.SceneRun;

import java.util.Locale;
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

    /** The last digest of a run that is not measured: to look for overlaps takes longer than it. */
    static String digest(SampleScene scene, SceneOptions options, SceneRun run, int ticks) {
        try (PhysicsWorld world = run.world()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            for (int tick = 0; tick < ticks; tick++) {
                built.beforeTick();
                world.step(built.stepSeconds());
                built.afterTick();
            }
            return String.format(Locale.ROOT, "%016x", world.digest());
        }
    }

    static SceneReport run(String id, double seconds, Map<String, String> parameters) {
        return run(id, seconds, 1, parameters);
    }
}
