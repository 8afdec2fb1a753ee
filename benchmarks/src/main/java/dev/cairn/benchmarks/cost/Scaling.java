package dev.cairn.benchmarks.cost;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Wall time of a tick of large scenes with more and more workers, once all is compiled; the world
 * after it has the same bits for all.
 */
public final class Scaling {
    private static final int TICKS = 100;

    private record Row(String scene, Map<String, String> settings) {}

    private static final List<Row> ROWS =
            List.of(
                    new Row("pyramid", Map.of("base", "100")),
                    new Row("many-pyramids", Map.of("side", "20", "base", "10")),
                    new Row("pile-mixed", Map.of("side", "12", "layers", "16")),
                    new Row("convex-pile", Map.of("side", "12", "layers", "16")),
                    new Row("junkyard", Map.of("side", "16", "layers", "12")),
                    new Row("washer", Map.of("side", "12")),
                    new Row("terrain", Map.of("bodies", "3000")));

    /** Quartiles of a tick's time, ms, and what the world was in the end. */
    private record Times(double lower, double median, double upper, int contacts, long digest) {}

    private Scaling() {}

    /**
     * Measures and prints a line for each scene and number of workers.
     *
     * @param args numbers of workers, the first of them what the others are compared with; 1, 2 and
     *     so on, doubled up to the processors that there are, if there is none
     */
    public static void main(String[] args) {
        int[] workers = args.length == 0 ? doubled() : workers(args);
        System.out.printf(
                Locale.ROOT,
                "%d processors; quartiles of %d ticks after %d, sleeping off%n",
                Runtime.getRuntime().availableProcessors(),
                TICKS,
                TICKS);
        PhysicsWorld.builder().warmUp(share -> {});
        System.out.println("scene           contacts  workers   lower  median   upper ms   times");
        for (Row row : ROWS) {
            measure(row, workers[0]);
            Times first = null;
            for (int w : workers) {
                Times t = measure(row, w);
                first = first == null ? t : first;
                System.out.printf(
                        Locale.ROOT,
                        "%-15s %8d %8d %7.2f %7.2f %7.2f %10.2f%s%n",
                        row.scene,
                        t.contacts,
                        w,
                        t.lower,
                        t.median,
                        t.upper,
                        first.median / t.median,
                        t.digest == first.digest ? "" : "  OTHER BITS");
            }
        }
    }

    private static int[] workers(String[] args) {
        int[] workers = new int[args.length];
        for (int i = 0; i < args.length; i++) {
            try {
                workers[i] = Integer.parseInt(args[i]);
            } catch (NumberFormatException e) {
                throw new IllegalArgumentException(
                        "number of workers is '" + args[i] + "'; give whole numbers, such as 1 2 4",
                        e);
            }
        }
        return workers;
    }

    private static int[] doubled() {
        int most = Runtime.getRuntime().availableProcessors();
        int[] workers = new int[32 - Integer.numberOfLeadingZeros(most)];
        Arrays.setAll(workers, i -> 1 << i);
        return workers;
    }

    private static Times measure(Row row, int workers) {
        SampleScene scene = SceneRegistry.get(row.scene);
        SceneOptions options =
                SceneOptions.of(scene, row.settings, SceneOptions.DEFAULT_SEED, null);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(workers)
                        .settings(PhysicsSettings.DEFAULT.withSleeping(false))
                        .systems(scene.systems(options))
                        .build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            double[] millis = new double[TICKS];
            for (int tick = -TICKS; tick < TICKS; tick++) {
                long start = System.nanoTime();
                built.beforeTick();
                world.step(SampleScene.STEP_SECONDS);
                built.afterTick();
                millis[Math.max(tick, 0)] = (System.nanoTime() - start) * 1e-6;
            }
            Arrays.sort(millis);
            return new Times(
                    millis[TICKS / 4],
                    millis[TICKS / 2],
                    millis[3 * TICKS / 4],
                    world.contacts().count(),
                    world.digest());
        }
    }
}
