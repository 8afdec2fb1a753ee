package dev.cairn.samples.film;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.render.app.Offscreen;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.SceneRun;
import dev.cairn.samples.SceneView;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Makes the animations of {@code docs/gallery.md}. Stateless. */
public final class GalleryCommand {
    /** Where they go if nothing else is said. */
    public static final Path FOLDER = Path.of("docs", "images", "gallery");

    /** The largest file, bytes. */
    public static final long MOST_BYTES = 300_000;

    private static final String USAGE =
            "samples gallery [FOLDER] makes the animations of docs/gallery.md";
    private static final int DONE = 0;
    private static final int MISUSED = 2;
    private static final int WIDTH = 320;
    private static final int HEIGHT = 180;
    private static final int TICKS_PER_FRAME = 5;
    private static final int SUBSTEPS = 4;

    private GalleryCommand() {}

    /**
     * One animation.
     *
     * @param scene id in the list of scenes
     * @param from first tick that is shown
     * @param to last tick that is shown
     * @param values parameters that differ from the scene's own
     * @param view from where, or null for the scene's own
     */
    public record Take(
            String scene, int from, int to, Map<String, Double> values, @Nullable SceneView view) {
        Take(String scene, int from, int to) {
            this(scene, from, to, Map.of(), null);
        }

        /** Copies the map. */
        public Take {
            values = Map.copyOf(values);
        }

        /**
         * Its file.
         *
         * @return a name without folders
         */
        public String file() {
            return scene + ".png";
        }
    }

    /** All of them, in the order of the page. */
    public static final List<Take> TAKES =
            List.of(
                    new Take("junkyard", 0, 120, Map.of("layers", 3.0), null),
                    new Take(
                            "ragdolls",
                            10,
                            150,
                            Map.of("figures", 8.0),
                            new SceneView(2.8, 3.9, 5.8, -1, 1.9, -0.4)),
                    new Take("car", 40, 240, Map.of(), new SceneView(8.5, 2.6, 6.5, 5.5, 0.3, 0)),
                    new Take("bridge", 0, 200),
                    new Take(
                            "funnel",
                            0,
                            240,
                            Map.of("friction", 0.05),
                            new SceneView(0, 9.5, 8.5, 0, 3.4, 0)),
                    new Take(
                            "terrain",
                            0,
                            120,
                            Map.of("bodies", 240.0),
                            new SceneView(6, 4.2, 8, -1, -0.4, -1)),
                    new Take("cradle", 0, 160, Map.of(), new SceneView(0.5, 0.9, 2.7, 0.1, 0.2, 0)),
                    new Take(
                            "buoyancy", 0, 240, Map.of(), new SceneView(3.5, 2.6, 7, 1.2, 0, -0.4)),
                    new Take(
                            "dzhanibekov", 0, 300, Map.of(), new SceneView(1, 2.5, 5.4, 0, 1.4, 0)),
                    new Take("gears", 0, 200),
                    new Take("door", 0, 200),
                    new Take("washer", 60, 240));

    /**
     * Runs the scenes and writes the files.
     *
     * @param arguments a folder, or nothing
     * @param out standard output
     * @param err standard error
     * @return the exit code
     */
    public static int run(String[] arguments, PrintStream out, PrintStream err) {
        if (arguments.length > 0 && arguments[0].equals("--help")) {
            out.println(USAGE);
            return DONE;
        }
        for (String word : arguments) {
            if (word.startsWith("-")) {
                err.println("Unknown option: '%s'; %s".formatted(word, USAGE));
                return MISUSED;
            }
        }
        if (arguments.length > 1) {
            err.println("gallery: one folder, not %d; %s".formatted(arguments.length, USAGE));
            return MISUSED;
        }
        String missing = Offscreen.unavailableReason();
        if (missing != null) {
            err.println("gallery: " + missing);
            return MISUSED;
        }
        Path folder = arguments.length == 1 ? Path.of(arguments[0]) : FOLDER;
        long sum = 0;
        try {
            Files.createDirectories(folder);
            for (Take take : TAKES) {
                Path file = folder.resolve(take.file());
                shoot(take, file);
                long bytes = Files.size(file);
                sum += bytes;
                out.printf("%-20s %4d kB%n", take.file(), bytes / 1000);
            }
        } catch (IOException unwritable) {
            throw new UncheckedIOException(
                    "gallery: %s cannot be written: %s".formatted(folder, unwritable.getMessage()),
                    unwritable);
        }
        out.printf("%d animations, %d kB, in %s%n", TAKES.size(), sum / 1000, folder);
        return DONE;
    }

    /**
     * Runs a scene and films it.
     *
     * @param take what to film
     * @param file where the animated .png goes
     */
    public static void shoot(Take take, Path file) {
        SampleScene scene = SceneRegistry.get(take.scene());
        SceneOptions own = SceneOptions.defaults(scene);
        Map<String, Double> values = new LinkedHashMap<>(own.values());
        values.putAll(take.values());
        SceneOptions options = new SceneOptions(values, own.seed(), own.obj());
        SceneRun run = new SceneRun(scene, options, take.to(), Jobs.defaultWorkers(), SUBSTEPS);
        try (PhysicsWorld world = run.world()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            if (take.view() != null) {
                built.view(take.view());
            }
            try (Film film = new Film(built, WIDTH, HEIGHT, TICKS_PER_FRAME)) {
                for (int tick = 1; tick <= take.to(); tick++) {
                    built.beforeTick();
                    world.step(built.stepSeconds());
                    built.afterTick();
                    if (tick > take.from()) {
                        film.shoot(world, tick);
                    }
                }
                film.save(file);
            }
        }
    }
}
