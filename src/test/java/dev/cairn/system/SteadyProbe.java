package dev.cairn.system;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.narrowphase.wide.BoxWarmUp;
import dev.cairn.physics.narrowphase.wide.RoundWarmUp;
import dev.cairn.physics.solver.wide.Lanes;
import dev.cairn.physics.solver.wide.WideSweeps;
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
        compileKernels();
        int substeps = PhysicsSettings.DEFAULT.substeps();
        for (SampleScene scene : SceneRegistry.all()) {
            SceneOptions options = SceneOptions.defaults(scene);
            SceneReport report =
                    new SceneRun(scene, options, scene.ticks(), workers, substeps).run(() -> {});
            System.out.println(scene.id() + " " + report.allocatedBytesPerTick());
        }
    }

    /** In a scene they come when they are ready; in between they may be compiled once more. */
    private static void compileKernels() {
        BoxWarmUp.await();
        RoundWarmUp.await();
        for (boolean isSingle : new boolean[] {true, false}) {
            if (Lanes.sweeps(0, isSingle, false) instanceof WideSweeps wide) {
                wide.finish();
            }
        }
    }
}
