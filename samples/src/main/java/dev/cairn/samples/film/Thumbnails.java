package dev.cairn.samples.film;

import dev.cairn.render.app.Offscreen;
import dev.cairn.render.camera.Effects;
import dev.cairn.render.mesh.Texture;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneRegistry;

import org.jspecify.annotations.Nullable;

import java.awt.image.BufferedImage;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import javax.imageio.ImageIO;

/** The sheet of small pictures beside the names in the list of scenes, and which is whose. */
public final class Thumbnails {
    static final String OPTION = "--of-list";
    static final Path FOLDER = Path.of("samples/src/main/resources/dev/cairn/samples/film");

    /** Of one picture, pixels: enough for panels at twice the usual size. */
    static final int WIDTH = 128;

    static final int HEIGHT = 72;

    /** Pictures in a row. */
    static final int COLUMNS = 8;

    private static final String SHEET = "thumbnails.jpg";
    private static final String IDS = "thumbnails.txt";

    /** Drawn so many times as wide and high, since a thin thing must not vanish. */
    private static final int FINER = 2;

    private Thumbnails() {}

    /**
     * The pictures of scenes.
     *
     * @param scenes which
     * @return one for each, null where there is none
     */
    public static List<Ui.@Nullable Part> of(List<SampleScene> scenes) {
        Texture sheet;
        List<String> ids;
        try (InputStream picture = resource(SHEET);
                InputStream names = resource(IDS)) {
            BufferedImage image = ImageIO.read(picture);
            int width = image.getWidth();
            int height = image.getHeight();
            int[] argb = image.getRGB(0, 0, width, height, null, 0, width);
            sheet = Texture.of(SHEET, width, height, argb);
            ids = new String(names.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(
                    "the samples jar's " + SHEET + " cannot be read", unreadable);
        }
        List<Ui.@Nullable Part> parts = new ArrayList<>();
        for (SampleScene scene : scenes) {
            int i = ids.indexOf(scene.id());
            parts.add(
                    i < 0
                            ? null
                            : new Ui.Part(
                                    sheet,
                                    i % COLUMNS * WIDTH,
                                    i / COLUMNS * HEIGHT,
                                    WIDTH,
                                    HEIGHT));
        }
        return parts;
    }

    private static InputStream resource(String name) throws IOException {
        InputStream found = Thumbnails.class.getResourceAsStream(name);
        if (found == null) {
            throw new FileNotFoundException(name + " is missing from the samples jar");
        }
        return found;
    }

    /** Draws all scenes of the list. */
    static void make(Path folder) throws IOException {
        List<SampleScene> scenes = SceneRegistry.all();
        int rows = (scenes.size() + COLUMNS - 1) / COLUMNS;
        BufferedImage all = PicturesCommand.sheet(COLUMNS * WIDTH, rows * HEIGHT);
        try (Offscreen screen = Offscreen.open(FINER * WIDTH, FINER * HEIGHT)) {
            for (int i = 0; i < scenes.size(); i++) {
                int[] fine = PicturesCommand.draw(screen, scenes.get(i), Effects.ALL)[0];
                int[] small = new int[WIDTH * HEIGHT];
                for (int p = 0; p < small.length; p++) {
                    int at = FINER * (p / WIDTH * FINER * WIDTH + p % WIDTH);
                    small[p] = mean(fine, at);
                }
                int left = i % COLUMNS * WIDTH;
                all.setRGB(left, i / COLUMNS * HEIGHT, WIDTH, HEIGHT, small, 0, WIDTH);
            }
        }
        ImageIO.write(all, "jpg", folder.resolve(SHEET).toFile());
        Files.write(folder.resolve(IDS), SceneRegistry.ids());
    }

    /** Of the four pixels of a square, each channel rounded down. */
    private static int mean(int[] fine, int at) {
        int rgb = 0;
        for (int shift = 0; shift < 24; shift += 8) {
            int sum = 0;
            for (int i : new int[] {at, at + 1, at + FINER * WIDTH, at + FINER * WIDTH + 1}) {
                sum += fine[i] >> shift & 255;
            }
            rgb |= (sum / 4) << shift;
        }
        return rgb;
    }
}
