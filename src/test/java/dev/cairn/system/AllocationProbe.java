package dev.cairn.system;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.AllocationMeter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;

/**
 * Prints, for every scene, the bytes that the second half of its ticks allocated; one line each.
 */
final class AllocationProbe {
    private AllocationProbe() {}

    /** Arguments: ticks, workers. */
    public static void main(String[] arguments) {
        int ticks = Integer.parseInt(arguments[0]);
        int workers = Integer.parseInt(arguments[1]);
        for (SampleScene scene : SceneRegistry.all()) {
            System.out.println(scene.id() + " " + bytes(scene, ticks, workers));
        }
    }

    private static long bytes(SampleScene scene, int ticks, int workers) {
        AllocationMeter meter = new AllocationMeter();
        SceneOptions options = SceneOptions.defaults(scene);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(workers)
                        .sleeping(false)
                        .systems(scene.systems(options))
                        .build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            meter.attach();
            long sum = 0;
            for (int tick = 1; tick <= ticks; tick++) {
                built.beforeTick();
                long before = meter.bytes();
                world.step(SampleScene.STEP_SECONDS);
                sum += 2 * tick > ticks ? meter.bytes() - before : 0;
                built.afterTick();
            }
            return sum;
        }
    }
}
