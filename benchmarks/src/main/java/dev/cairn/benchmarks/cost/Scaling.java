package dev.cairn.benchmarks.cost;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.IntStream;

/**
 * Wall time of a tick of large scenes with more and more workers, once all is compiled; the world
 * after it has the same bits for all.
 */
@Command(
        name = "scaling",
        mixinStandardHelpOptions = true,
        description = "Wall time of a tick of large scenes by the number of workers.")
public final class Scaling implements Callable<Integer> {
    @Parameters(
            paramLabel = "WORKERS",
            description =
                    "numbers of workers, the first of them what the others are compared with; 1, 2"
                            + " and so on, doubled up to the processors that there are, by default")
    private List<Integer> workers = List.of();

    @Option(
            names = "--scenes",
            split = ",",
            paramLabel = "ID",
            description = "which of the scenes; all by default")
    private List<String> scenes = List.of();

    @Option(
            names = "--ticks",
            paramLabel = "N",
            defaultValue = "100",
            description = "ticks that are timed, after as many before, default: ${DEFAULT-VALUE}")
    private int ticks = 100;

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
     * Runs the command and ends the JVM with its status.
     *
     * @param args its options; {@code --help} lists them
     */
    public static void main(String[] args) {
        System.exit(new CommandLine(new Scaling()).execute(args));
    }

    @Override
    public Integer call() {
        List<String> known = ROWS.stream().map(Row::scene).toList();
        if (ticks < 1 || !known.containsAll(scenes) || workers.stream().anyMatch(w -> w < 1)) {
            System.err.printf(
                    "--ticks %d, --scenes %s, workers %s: want at least 1 tick, 1 worker, and"
                            + " scenes of %s%n",
                    ticks, scenes, workers, known);
            return CommandLine.ExitCode.USAGE;
        }
        List<Row> rows =
                ROWS.stream().filter(r -> scenes.isEmpty() || scenes.contains(r.scene)).toList();
        List<Integer> counts = workers.isEmpty() ? doubled() : workers;
        System.out.printf(
                Locale.ROOT,
                "%d processors; quartiles of %d ticks after %d, sleeping off%n",
                Runtime.getRuntime().availableProcessors(),
                ticks,
                ticks);
        PhysicsWorld.builder().warmUp(share -> {});
        System.out.println("scene           contacts  workers   lower  median   upper ms   times");
        for (Row row : rows) {
            measure(row, counts.get(0), ticks);
            Times first = null;
            for (int w : counts) {
                Times t = measure(row, w, ticks);
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
        return CommandLine.ExitCode.OK;
    }

    private static List<Integer> doubled() {
        int most = Runtime.getRuntime().availableProcessors();
        return IntStream.iterate(1, w -> w <= most, w -> 2 * w).boxed().toList();
    }

    private static Times measure(Row row, int workers, int ticks) {
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
            double[] millis = new double[ticks];
            for (int tick = -ticks; tick < ticks; tick++) {
                long start = System.nanoTime();
                built.beforeTick();
                world.step(SampleScene.STEP_SECONDS);
                built.afterTick();
                millis[Math.max(tick, 0)] = (System.nanoTime() - start) * 1e-6;
            }
            Arrays.sort(millis);
            return new Times(
                    millis[ticks / 4],
                    millis[ticks / 2],
                    millis[3 * ticks / 4],
                    world.contacts().count(),
                    world.digest());
        }
    }
}
