package dev.cairn.benchmarks;

import com.sun.management.ThreadMXBean;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;

import java.lang.management.ManagementFactory;
import java.util.Map;

/**
 * Scenes of the samples after two seconds of settling or more, sleep off; for the suites of whole
 * steps.
 *
 * <p>Vector kernels are warmed up by threads of their own, which put their vectors on the heap
 * until the compiler is through, some seconds on a quiet machine and many on a busy one. JMH's
 * {@code -prof gc} counts all threads. So a scene goes on until no thread allocates any more.
 */
final class SettledScenes {
    private static final int SETTLING_STEPS = 120;

    /** Fewer bytes in so many steps are the JVM's own doing. */
    private static final long QUIET_BYTES = 64 * 1024;

    private static final long MOST_NANOS = 60_000_000_000L;
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

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
        long start = System.nanoTime();
        long bytes = Long.MAX_VALUE;
        while (bytes > QUIET_BYTES && System.nanoTime() - start < MOST_NANOS) {
            long before = THREADS.getTotalThreadAllocatedBytes();
            for (int step = 0; step < SETTLING_STEPS; step++) {
                world.step(SampleScene.STEP_SECONDS);
            }
            bytes = THREADS.getTotalThreadAllocatedBytes() - before;
        }
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
