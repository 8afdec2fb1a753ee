package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.shape.Box;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Effects;
import dev.cairn.render.camera.Light;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.Texture;

import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Each effect by what it must do to a picture, and that it does nothing else. */
class EffectsTest extends Drawing {
    private static final Light NOON = SUNNY.from(0, 1, 0);

    private Stage stage = new Stage();

    @AfterEach
    void plainAgain() {
        view.effects(Effects.PLAIN);
        stage.close();
    }

    private void place(Model model, double x, double y, double z) {
        stage.add(Pose.at(x, y, z), model);
    }

    private void clear() {
        stage.close();
        stage = new Stage();
    }

    private Picture draw(String effects, Camera camera, Light light) {
        view.effects(Effects.named(effects));
        return draw(stage.publish(), 1, camera, light);
    }

    /** A floor of 3 x 3 m, seen from above, with a roof over its left half. */
    private Camera underARoof(double height) {
        place(floor(1.5, 1.5), 0, -0.5, 0);
        place(Model.of(Box.ofHalfExtents(1, 0.05, 1.5)), -1, height, 0);
        return new Camera().lookAt(0, 1, 0, 0, 0, -1e-3);
    }

    private static Model floor(double halfX, double halfZ) {
        return Model.of(Box.ofHalfExtents(halfX, 0.5, halfZ))
                .texture(Texture.WHITE)
                .color(0x808080);
    }

    private static int grey(int rgb) {
        return (rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255);
    }

    /** Columns of the middle row that are neither in the light nor in the shadow. */
    private static int penumbra(Picture picture) {
        int dark = grey(picture.at(10, HEIGHT / 2));
        int bright = grey(picture.at(WIDTH - 10, HEIGHT / 2));
        assertTrue(bright > dark + 60, dark + " and " + bright);
        int count = 0;
        for (int x = 0; x < WIDTH; x++) {
            double share = (grey(picture.at(x, HEIGHT / 2)) - dark) / (double) (bright - dark);
            count += share > 0.1 && share < 0.9 ? 1 : 0;
        }
        return count;
    }

    /** The edge of a disc's image is 2 h tan(half the disc) wide. */
    @Test
    void theEdgeOfAShadowIsAsWideAsItsCasterIsHigh() {
        Camera camera = underARoof(2);
        int low = penumbra(draw("soft-shadows", camera, NOON));
        int hard = penumbra(draw("plain", camera, NOON));
        assertTrue(low > hard, "at 2 m " + low + ", without the effect " + hard);
        clear();
        underARoof(4);
        int high = penumbra(draw("soft-shadows", camera, NOON));
        assertTrue(
                high > 1.5 * low && high < 2.6 * low, low + " pixels at 2 m, " + high + " at 4 m");
    }

    @Test
    void cornersGetLessOfTheSkyAndTheOpenPlainGetsAllOfIt() {
        place(floor(10, 10), 0, -0.5, 0);
        place(Model.of(Meshes.CUBE), 0, 1, 0);
        Camera camera = new Camera().lookAt(0, 4, 8, 0, 0.5, 0);
        Picture without = draw("plain", camera, FLAT);
        Picture with = draw("occlusion", camera, FLAT);
        int darker = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                int change = grey(with.at(x, y)) - grey(without.at(x, y));
                assertTrue(change <= 3, "brighter at " + x + ", " + y);
                darker += change < -15 ? 1 : 0;
            }
        }
        assertTrue(darker > 300, darker + " pixels are darker");
        int open = grey(with.at(WIDTH / 2, HEIGHT - 4)) - grey(without.at(WIDTH / 2, HEIGHT - 4));
        assertTrue(Math.abs(open) <= 3, "far from all corners by " + open);
    }

    /**
     * Light changes over a face away from the sun, in the corner that it makes with a floor and a
     * wall, but from pixel to pixel only by little: no speckle. Counts the inner pixels that differ
     * from the mean of the pixels on both sides.
     */
    @Test
    void aFaceAwayFromTheSunHasNoSpeckle() {
        place(floor(10, 10), 0, -0.5, 0);
        place(Model.of(Box.ofHalfExtents(2, 2, 0.5)).texture(Texture.WHITE), 0, 2, 0);
        place(Model.of(Box.ofHalfExtents(0.5, 2, 2)).texture(Texture.WHITE), -2.5, 2, 2);
        Camera camera = new Camera().lookAt(0, 2.5, 5, 0, 0.8, 0);
        Light behind = SUNNY.from(0.3, 0.5, -1);
        for (String effects : new String[] {"occlusion", "all"}) {
            Picture picture = draw(effects, camera, behind);
            int darkest = 3 * 255;
            int brightest = 0;
            for (int y = 30; y < 130; y++) {
                for (int x = 120; x < 210; x++) {
                    int here = grey(picture.at(x, y));
                    // 2 of 255 in each of three colours, and of the mean of two.
                    int across = grey(picture.at(x - 1, y)) + grey(picture.at(x + 1, y));
                    int bend = Math.abs(2 * here - across);
                    assertTrue(bend <= 9, effects + ": " + bend + " at " + x + ", " + y);
                    darkest = Math.min(darkest, here);
                    brightest = Math.max(brightest, here);
                }
            }
            assertTrue(brightest > darkest + 40, effects + " is even: " + darkest);
        }
    }

    /** A mirror that faces the eye at 45 degrees shows the zenith, and paint does not. */
    @Test
    void metalMirrorsTheSkyInItsOwnColour() {
        Light light = FLAT.background(0x2040C0, 0x2040C0);
        Model plate = Model.of(Meshes.CUBE).texture(Texture.WHITE.finish(0.05, 1)).color(0xFFFFFF);
        place(plate.scale(5, 0.5, 5), 0, -0.5, 0);
        Camera camera = new Camera().lookAt(0, 5, 5, 0, 0, 0);
        int mirror = draw("reflections", camera, light).at(WIDTH / 2, HEIGHT / 2);
        assertTrue(Blocks.difference(0x2040C0, mirror) < 12, "%06x".formatted(mirror));
        clear();
        place(plate.color(0xFF0000).scale(5, 0.5, 5), 0, -0.5, 0);
        int red = draw("reflections", camera, light).at(WIDTH / 2, HEIGHT / 2);
        assertTrue((red & 255) < 40 && (red >> 16 & 255) > 15, "%06x".formatted(red));
        assertThrows(IllegalArgumentException.class, () -> Texture.WHITE.finish(0, 0));
        assertThrows(IllegalArgumentException.class, () -> Texture.WHITE.finish(0.5, 1.1));
    }

    /** Brighter stays brighter, and twice what white sends out can still be told from it. */
    @Test
    void filmKeepsTheOrderOfBrightnessAndHasRoomAboveWhite() {
        place(floor(10, 10), 0, -0.5, 0);
        Camera camera = new Camera().lookAt(0, 4, 4, 0, 0, 0);
        int before = -1;
        for (double strength : new double[] {0.02, 0.1, 0.5, 1, 4, 16, 32}) {
            Light light = FLAT.strengths(0, strength);
            int now = grey(draw("filmic", camera, light).at(WIDTH / 2, HEIGHT / 2));
            assertTrue(now > before, "strength " + strength + ": " + now + " after " + before);
            before = now;
        }
    }

    @Test
    void aWideFloorEndsInTheHorizon() {
        Model ground = Model.ground(Box.ofHalfExtents(40, 0.5, 40)).color(0x303030);
        place(ground, 0, -0.5, 0);
        Camera camera = new Camera().lookAt(0, 6, 0, 0, 6, -10);
        Light light = Light.DAYLIGHT.haze(0);
        assertTrue(step(draw("plain", camera, light)) > 60, "without the effect an edge is seen");
        int edge = step(draw("horizon", camera, light));
        assertTrue(edge < 30, "the greatest step is " + edge);
        clear();
        place(Model.ground(Box.ofHalfExtents(3, 0.5, 3)), 0, -0.5, 0);
        Camera above = new Camera().lookAt(0, 6, 6, 0, 0, 0);
        assertEquals(
                draw("plain", above, light).at(WIDTH / 2, HEIGHT / 2),
                draw("horizon", above, light).at(WIDTH / 2, HEIGHT / 2),
                "a small floor is a thing like others");
    }

    /** The greatest change from one row to the next in the middle of the picture. */
    private static int step(Picture picture) {
        int most = 0;
        for (int y = 1; y < HEIGHT * 2 / 3; y++) {
            int above = grey(picture.at(WIDTH / 2, y - 1));
            most = Math.max(most, Math.abs(grey(picture.at(WIDTH / 2, y)) - above));
        }
        return most;
    }

    @Test
    void theSamePictureHasTheSameBytes() {
        Camera camera = underARoof(2);
        int[] first = draw("all", camera, SUNNY).argb();
        draw("plain", camera, SUNNY);
        assertArrayEquals(first, draw("all", camera, SUNNY).argb());
    }

    /**
     * A white square, turned by 20 degrees, before the dark: a pixel at its edge is as bright as
     * the share of it that is covered says, by 16 x 16 rays, up to what four samples can tell;
     * without the effect there is nothing between the two.
     */
    @Test
    void edgesAreAsBrightAsTheShareThatTheyCover() {
        double turn = Math.toRadians(20);
        stage.add(
                new Pose(0, 0, 0, 0, 0, Math.sin(turn / 2), Math.cos(turn / 2), 0),
                Model.of(Box.ofHalfExtents(1, 1, 0.01)).texture(Texture.WHITE));
        Camera camera = new Camera().lookAt(0, 0, 4, 0, 0, 0);
        Picture smooth = draw("antialiasing", camera, FLAT);
        Picture plain = draw("plain", camera, FLAT);
        int inside = plain.at(WIDTH / 2, HEIGHT / 2);
        int outside = plain.at(2, 2);
        assertTrue(Blocks.difference(inside, outside) > 60, "a bright square in the dark");
        int edges = 0;
        double sum = 0;
        double sumOfCovered = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                int covered = covered(camera, x, y, turn);
                if (covered == 0 || covered == 256) {
                    continue;
                }
                edges++;
                int rgb = plain.at(x, y);
                assertTrue(
                        Math.min(Blocks.difference(rgb, inside), Blocks.difference(rgb, outside))
                                <= 2,
                        "plain: between the two at " + x + ", " + y);
                double share =
                        (double) (grey(smooth.at(x, y)) - grey(outside))
                                / (grey(inside) - grey(outside));
                assertEquals(covered / 256.0, share, 0.4, "at " + x + ", " + y);
                sum += Math.abs(share - covered / 256.0);
                sumOfCovered += share - covered / 256.0;
            }
        }
        assertTrue(edges > 100, edges + " pixels of edge");
        assertTrue(sum / edges < 0.12, "mean difference " + sum / edges);
        assertEquals(0, sumOfCovered / edges, 0.04, "as much too bright as too dark");
    }

    /** Of 16 x 16 rays through a pixel, those that meet the square. */
    private static int covered(Camera camera, int x, int y, double turn) {
        int count = 0;
        for (int i = 0; i < 256; i++) {
            Vector3d ray =
                    Blocks.ray(
                            camera,
                            x + (i % 16 + 0.5) / 16,
                            y + (i / 16 + 0.5) / 16,
                            WIDTH,
                            HEIGHT);
            double t = -(4 - 0.01) / ray.z; // to the square's front
            double u = t * (ray.x * Math.cos(turn) + ray.y * Math.sin(turn));
            double v = t * (ray.y * Math.cos(turn) - ray.x * Math.sin(turn));
            count += Math.abs(u) < 1 && Math.abs(v) < 1 ? 1 : 0;
        }
        return count;
    }

    @Test
    void namesAreThoseOfTheEffects() {
        assertEquals(
                Effects.ALL,
                Effects.named(
                        "soft-shadows,occlusion,reflections,filmic,horizon,sky-light,cascades,"
                                + "antialiasing"));
        assertEquals(Effects.PLAIN, Effects.named("plain"));
        assertEquals(
                new Effects(false, true, false, true, false, false, false, false),
                Effects.named("filmic, occlusion"));
        IllegalArgumentException unknown =
                assertThrows(IllegalArgumentException.class, () -> Effects.named("bloom"));
        assertTrue(String.valueOf(unknown.getMessage()).contains("soft-shadows"));
    }
}
