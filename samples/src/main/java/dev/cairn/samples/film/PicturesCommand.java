package dev.cairn.samples.film;

import dev.cairn.core.job.Jobs;
import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.core.snapshot.SnapshotExchange;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.render.app.Offscreen;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.CameraMount;
import dev.cairn.render.camera.Effects;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.SceneRun;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import javax.imageio.ImageIO;

/**
 * Makes the pictures of the docs that show scenes without and with effects, and the small pictures
 * of the list of scenes. Stateless.
 */
public final class PicturesCommand {
    /** Where the pictures of the docs go if nothing else is said. */
    public static final Path FOLDER = Path.of("docs", "images");

    /** One scene without and with effects, side by side. */
    public static final String EFFECTS = "effects.png";

    /** The same of ten scenes. */
    public static final String TEN = "ten-scenes.png";

    /** The ten. */
    public static final List<String> SCENES =
            List.of(
                    "shapes",
                    "ragdolls",
                    "arch",
                    "bridge",
                    "cradle",
                    "car",
                    "funnel",
                    "junkyard",
                    "pyramid",
                    "terrain");

    private static final String USAGE =
            "samples pictures [FOLDER] makes the pictures of docs/rendering.md; samples pictures"
                    + " --of-list FOLDER those of the list of scenes";
    private static final int DONE = 0;
    private static final int MISUSED = 2;
    private static final int SUBSTEPS = 4;
    private static final int GAP = 4;
    private static final int WHITE = 0xFFFFFF;

    private PicturesCommand() {}

    /**
     * Makes them.
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
        boolean ofList = arguments.length > 0 && arguments[0].equals(Thumbnails.OPTION);
        for (int i = ofList ? 1 : 0; i < arguments.length; i++) {
            if (arguments[i].startsWith("-")) {
                err.println("Unknown option: '%s'; %s".formatted(arguments[i], USAGE));
                return MISUSED;
            }
        }
        if (arguments.length > (ofList ? 2 : 1)) {
            err.println("pictures: one folder; " + USAGE);
            return MISUSED;
        }
        String missing = Offscreen.unavailableReason();
        if (missing != null) {
            err.println("pictures: " + missing);
            return MISUSED;
        }
        Path folder =
                arguments.length > (ofList ? 1 : 0)
                        ? Path.of(arguments[arguments.length - 1])
                        : ofList ? Thumbnails.FOLDER : FOLDER;
        try {
            Files.createDirectories(folder);
            if (ofList) {
                Thumbnails.make(folder);
            } else {
                save(sideBySide(List.of("shapes"), 640, 360, 1), folder.resolve(EFFECTS), out);
                save(sideBySide(SCENES, 320, 180, 2), folder.resolve(TEN), out);
            }
        } catch (IOException unwritable) {
            throw new UncheckedIOException(
                    "pictures: %s cannot be written: %s".formatted(folder, unwritable.getMessage()),
                    unwritable);
        }
        return DONE;
    }

    private static void save(BufferedImage image, Path file, PrintStream out) throws IOException {
        ImageIO.write(image, "png", file.toFile());
        out.printf("%s %d kB%n", file, Files.size(file) / 1000);
    }

    /**
     * Scenes at the tick that is worth a picture, each plain on the left and with all effects on
     * the right of it.
     *
     * @param scenes ids
     * @param width of one picture, pixels
     * @param height same
     * @param columns scenes in a row
     * @return all of them
     */
    public static BufferedImage sideBySide(
            List<String> scenes, int width, int height, int columns) {
        int rows = (scenes.size() + columns - 1) / columns;
        BufferedImage all = sheet(2 * columns * (width + GAP) - GAP, rows * (height + GAP) - GAP);
        try (Offscreen screen = Offscreen.open(width, height)) {
            for (int i = 0; i < scenes.size(); i++) {
                int left = i % columns * 2 * (width + GAP);
                int top = i / columns * (height + GAP);
                int[][] both =
                        draw(screen, SceneRegistry.get(scenes.get(i)), Effects.PLAIN, Effects.ALL);
                all.setRGB(left, top, width, height, both[0], 0, width);
                all.setRGB(left + width + GAP, top, width, height, both[1], 0, width);
            }
        }
        return all;
    }

    static BufferedImage sheet(int width, int height) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                image.setRGB(x, y, WHITE);
            }
        }
        return image;
    }

    /**
     * Runs a scene to the tick that is worth a picture and draws it with each choice of effects.
     */
    static int[][] draw(Offscreen screen, SampleScene scene, Effects... effects) {
        SceneOptions options = SceneOptions.defaults(scene);
        SceneRun run =
                new SceneRun(scene, options, scene.pictureTick(), Jobs.defaultWorkers(), SUBSTEPS);
        try (PhysicsWorld world = run.world()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            Camera camera = built.view().place(new Camera());
            CameraMount.attach(world.ecs(), camera);
            for (int tick = 0; tick < scene.pictureTick(); tick++) {
                built.beforeTick();
                world.step(built.stepSeconds());
                built.afterTick();
            }
            SnapshotExchange exchange = new SnapshotExchange();
            exchange.publish(world.ecs());
            PoseSnapshot snapshot = exchange.latest();
            int[][] pictures = new int[effects.length][];
            for (int i = 0; i < effects.length; i++) {
                screen.effects(effects[i]);
                screen.draw(snapshot, 1, camera, built.light());
                pictures[i] = screen.picture().argb();
            }
            return pictures;
        }
    }
}
