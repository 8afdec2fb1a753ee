package dev.cairn.system;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.SceneReport;
import dev.cairn.samples.SceneRun;

/** Prints, for every scene, the bytes per tick that its runner reports; one line each. */
final class SteadyProbe {
    private SteadyProbe() {}

    /** Argument: workers. */
    public static void main(String[] arguments) {
        int workers = Integer.parseInt(arguments[0]);
        int substeps = PhysicsSettings.DEFAULT.substeps();
        for (SampleScene scene : SceneRegistry.all()) {
            SceneOptions options = SceneOptions.defaults(scene);
            // short scenes run on: a window of few ticks may each time hold a compilation
            int ticks = Math.max(scene.ticks(), 240);
            SceneReport report =
                    new SceneRun(scene, options, ticks, workers, substeps).run(() -> {});
            System.out.println(scene.id() + " " + report.allocatedBytesPerTick());
        }
    }
}
