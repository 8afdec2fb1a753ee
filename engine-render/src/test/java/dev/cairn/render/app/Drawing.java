package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.app.Blocks.Block;
import dev.cairn.render.app.Blocks.Hit;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Effects;
import dev.cairn.render.camera.Light;

import org.joml.Vector3d;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/**
 * What the drawing tests share: a small offscreen view, two lights, and the comparison of a picture
 * with the rays of {@link Blocks}, pixel by pixel.
 */
abstract class Drawing {
    static final int WIDTH = 320;
    static final int HEIGHT = 180;
    static final int SKY = 0x102030;

    /** No sun: a surface shows its own colour. */
    static final Light FLAT =
            Light.DAYLIGHT.strengths(0, 1).background(SKY, SKY).haze(0).shadows(false);

    static final Light SUNNY = Light.DAYLIGHT.background(SKY, SKY).haze(0);

    static Offscreen view;

    @BeforeAll
    static void open() {
        GlTests.require();
        view = Offscreen.open(WIDTH, HEIGHT);
        view.effects(Effects.PLAIN);
    }

    @AfterAll
    static void close() {
        if (view != null) {
            view.close();
        }
    }

    static Picture draw(PoseSnapshot snapshot, double alpha, Camera camera, Light light) {
        view.draw(snapshot, alpha, camera, light);
        return view.picture();
    }

    /**
     * What a place in the picture shows: -1 if the oracle is not sure, else a colour; and what kind
     * of place it is.
     */
    record Seen(int kind, int rgb) {
        static final int SKY_KIND = 0;
        static final int AWAY = 1;
        static final int SHADED = 2;
        static final int SUNNY_KIND = 3;
        static final int UNSURE = 4;
    }

    static Seen trace(
            Camera camera, double px, double py, List<Block> blocks, Light light, double softness) {
        Vector3d eye = camera.position(new Vector3d());
        Vector3d sun = new Vector3d(light.sunX(), light.sunY(), light.sunZ()).normalize();
        Vector3d ray = Blocks.ray(camera, px, py, WIDTH, HEIGHT);
        Hit hit = Blocks.nearest(blocks, eye, ray, 0);
        if (hit == null) {
            return new Seen(Seen.SKY_KIND, SKY);
        }
        int rgb = hit.block().rgb();
        double facing = hit.normal().dot(sun);
        if (facing <= 0 || !light.shadows()) {
            return new Seen(
                    facing <= 0 ? Seen.AWAY : Seen.SUNNY_KIND,
                    Blocks.lit(rgb, hit.normal(), light, facing > 0));
        }
        // A shadow's edge is as wide as some texels of the map.
        Vector3d point = new Vector3d(eye).fma(hit.distance(), ray);
        boolean surely = Blocks.shaded(blocks, hit.block(), point, sun, -softness);
        boolean maybe = Blocks.shaded(blocks, hit.block(), point, sun, softness);
        if (surely != maybe || facing < 0.05) {
            return new Seen(Seen.UNSURE, 0);
        }
        return new Seen(
                surely ? Seen.SHADED : Seen.SUNNY_KIND,
                Blocks.lit(rgb, hit.normal(), light, !surely));
    }

    /** Compares each pixel that the oracle is sure of; returns how many there are of each kind. */
    static int[] compare(Picture picture, Camera camera, List<Block> blocks, Light light) {
        // One sample per half pixel; a pixel is compared if all samples up to a pixel away agree.
        int columns = 2 * WIDTH + 3;
        Seen[] samples = new Seen[columns * (2 * HEIGHT + 3)];
        for (int i = 0; i < samples.length; i++) {
            double px = (i % columns - 1) * 0.5;
            double py = (i / columns - 1) * 0.5;
            samples[i] = trace(camera, px, py, blocks, light, 0.12);
        }
        int[] counts = new int[4];
        int wrong = 0;
        String first = "";
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                Seen seen = samples[(2 * y + 2) * columns + 2 * x + 2];
                boolean sure = seen.kind() != Seen.UNSURE;
                for (int k = 0; k < 25 && sure; k++) {
                    sure = seen.equals(samples[(2 * y + k / 5) * columns + 2 * x + k % 5]);
                }
                if (!sure) {
                    continue;
                }
                counts[seen.kind()]++;
                if (Blocks.difference(seen.rgb(), picture.at(x, y)) > 3) {
                    wrong++;
                    if (first.isEmpty()) {
                        first =
                                "pixel %d,%d shows %06x, expected %s %06x"
                                        .formatted(
                                                x,
                                                y,
                                                picture.at(x, y) & 0xFFFFFF,
                                                seen.kind(),
                                                seen.rgb());
                    }
                }
            }
        }
        assertEquals(0, wrong, "wrong pixels of " + Arrays.toString(counts) + ", first: " + first);
        return counts;
    }

    static int blockPixels(int[] counts) {
        return counts[Seen.AWAY] + counts[Seen.SHADED] + counts[Seen.SUNNY_KIND];
    }

    static Block random(SplittableRandom random, double x, double y, double z, int rgb) {
        return new Block(
                x,
                y,
                z,
                Blocks.randomTurn(random),
                random.nextDouble(0.3, 1),
                random.nextDouble(0.3, 1),
                random.nextDouble(0.3, 1),
                rgb);
    }
}
