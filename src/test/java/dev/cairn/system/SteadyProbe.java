package dev.cairn.system;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.SceneReport;
import dev.cairn.samples.SceneRun;

/**
 * Prints, for each scene that is asked for, the bytes per tick that its runner reports; a line
 * each.
 *
 * <p>While HotSpot still compiles, each window of ticks that the runner looks at may hold a
 * compilation, which costs bytes on the thread that asks for it. What ticks themselves allocate
 * comes back in every run; so a run that reports bytes is repeated, and the least counts.
 */
final class SteadyProbe {
    private static final int RUNS = 4;

    private SteadyProbe() {}

    /** Arguments: workers, and the scenes. */
    public static void main(String[] arguments) {
        int workers = Integer.parseInt(arguments[0]);
        int substeps = PhysicsSettings.DEFAULT.substeps();
        for (int i = 1; i < arguments.length; i++) {
            SampleScene scene = SceneRegistry.get(arguments[i]);
            SceneOptions options = SceneOptions.defaults(scene);
            // long scenes end early, short ones run on: a window of few ticks may each time hold a
            // compilation
            int ticks = Math.clamp(scene.ticks(), 240, 300);
            double least = Double.POSITIVE_INFINITY;
            for (int run = 0; run < RUNS && least > 0; run++) {
                SceneReport report =
                        new SceneRun(scene, options, ticks, workers, substeps).run(() -> {});
                least = Math.min(least, report.allocatedBytesPerTick());
            }
            System.out.println(scene.id() + " " + least);
        }
    }
}
