package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.render.app.Blocks.Block;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Light;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;

import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/** What is drawn is where geometry says, in the order and brightness that geometry says. */
class DrawingTest extends Drawing {
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void turnedBlockCoversThePixelsThatItsProjectionCovers(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        // From the origin to a quarter of the way to the Moon.
        double far = seed <= 2 ? 0 : Math.pow(10, seed + 3) * random.nextDouble(0.5, 1);
        Block block = random(random, far, -far, 0.5 * far, 0xE08040);
        Camera camera =
                new Camera().lookAt(far + 2, -far + 1.5, 0.5 * far + 4, far + 0.2, -far, 0.5 * far);
        try (Stage stage = new Stage()) {
            stage.add(block, block.rgb());
            Picture picture = draw(stage.publish(), 1, camera, FLAT);
            int[] counts = compare(picture, camera, List.of(block), FLAT);
            assertTrue(
                    blockPixels(counts) > 500 && counts[0] > 20_000,
                    "seed " + seed + ": " + Arrays.toString(counts));
        }
    }

    @Test
    void ballCoversACircle() {
        Camera camera = new Camera().lookAt(0, 0, 6, 0, 0, 0);
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, 0, 0), Model.of(Meshes.BALL).scale(1.5).color(0xFFFFFF));
            Picture picture = draw(stage.publish(), 1, camera, FLAT);
            // The tangent cone: sin = r / d, tan gives the radius at distance 1.
            double sine = 1.5 / 6;
            double radius =
                    sine
                            / Math.sqrt(1 - sine * sine)
                            / Math.tan(camera.fieldOfView() / 2)
                            * HEIGHT
                            / 2;
            int inside = 0;
            for (int y = 0; y < HEIGHT; y++) {
                for (int x = 0; x < WIDTH; x++) {
                    double r = Math.hypot(x + 0.5 - WIDTH / 2.0, y + 0.5 - HEIGHT / 2.0);
                    if (r < radius - 1.2) {
                        inside++;
                        assertTrue(
                                Blocks.difference(picture.at(x, y), 0xFFFFFF) <= 1,
                                "hole at " + x + "," + y);
                    } else if (r > radius + 1.2) {
                        assertTrue(
                                Blocks.difference(picture.at(x, y), SKY) <= 1,
                                "spill at " + x + "," + y);
                    }
                }
            }
            assertTrue(inside > 2000, "inside " + inside);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {11, 12, 13})
    void nearerBlockHidesTheFartherOneWhateverTheOrder(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Block> blocks = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            blocks.add(
                    random(
                            random,
                            random.nextDouble(-3, 3),
                            random.nextDouble(-2, 2),
                            random.nextDouble(-4, 2),
                            random.nextInt(0x1000000) | 0x202020));
        }
        Camera camera = new Camera().lookAt(0.5, 1, 9, 0, 0, 0);
        Picture[] pictures = new Picture[2];
        for (int order = 0; order < 2; order++) {
            List<Block> added = order == 0 ? blocks : blocks.reversed();
            try (Stage stage = new Stage()) {
                added.forEach(block -> stage.add(block, block.rgb()));
                pictures[order] = draw(stage.publish(), 1, camera, FLAT);
            }
            int[] counts = compare(pictures[order], camera, blocks, FLAT);
            assertTrue(blockPixels(counts) > 2000, "seed " + seed + ": " + Arrays.toString(counts));
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {21, 22, 23})
    void facesAreAsBrightAsLambertSays(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Block block = random(random, 0, 0, 0, 0xC0A080);
        Light light =
                SUNNY.shadows(false)
                        .from(
                                random.nextDouble(-1, 1),
                                random.nextDouble(0.2, 1),
                                random.nextDouble(0, 1));
        Camera camera = new Camera().lookAt(1.5, 1.5, 3, 0, 0, 0);
        try (Stage stage = new Stage()) {
            stage.add(block, block.rgb());
            int[] counts =
                    compare(draw(stage.publish(), 1, camera, light), camera, List.of(block), light);
            assertTrue(
                    counts[3] > 300, "seed " + seed + ", sunny pixels " + Arrays.toString(counts));
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {31, 32, 33})
    void shadowsLieWhereTheSunIsHidden(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Block> blocks = new ArrayList<>();
        blocks.add(new Block(0, -1, 0, new Quaterniond(), 30, 1, 30, 0xC0C0C0));
        for (int i = 0; i < 6; i++) {
            blocks.add(
                    random(
                            random,
                            2.2 * (i % 3) - 2.2,
                            random.nextDouble(1, 2.5),
                            2.5 * (i / 3) - 1.2,
                            random.nextInt(0x1000000) | 0x606060));
        }
        Light light = SUNNY.from(random.nextDouble(-1, 1), 1, random.nextDouble(-1, 1));
        Camera camera = new Camera().lookAt(2, 6, 9, 0, 0.5, 0);
        try (Stage stage = new Stage()) {
            blocks.forEach(block -> stage.add(block, block.rgb()));
            int[] counts = compare(draw(stage.publish(), 1, camera, light), camera, blocks, light);
            assertTrue(
                    counts[2] > 400 && counts[3] > 5000,
                    "seed " + seed + ": shaded and sunny pixels " + Arrays.toString(counts));
        }
    }

    @Test
    void modelThatCannotBeDrawnIsAVisiblePlaceholder() {
        Camera camera = new Camera().lookAt(0, 0, 5, 0, 0, 0);
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, 0, 0), "no model");
            Picture picture = draw(stage.publish(), 1, camera, FLAT);
            // Four squares a side: the middle is a corner of four of them.
            assertEquals(0xFFFF00FF, picture.at(WIDTH / 2 - 3, HEIGHT / 2 - 3));
            assertEquals(0xFF000000, picture.at(WIDTH / 2 + 3, HEIGHT / 2 - 3));
        }
    }

    @Test
    void entitiesComeAndGo() {
        Camera camera = new Camera().lookAt(0, 0, 5, 0, 0, 0);
        try (Stage empty = new Stage();
                Stage stage = new Stage()) {
            assertEquals(
                    0xFF000000 | SKY,
                    draw(empty.publish(), 1, camera, FLAT).at(WIDTH / 2, HEIGHT / 2));
            stage.add(Pose.at(0, 0, 0), Model.of(Meshes.CUBE).color(0x00FF00));
            assertEquals(
                    0xFF00FF00, draw(stage.publish(), 1, camera, FLAT).at(WIDTH / 2, HEIGHT / 2));
            stage.add(Pose.at(0, 0, 2), Model.of(Meshes.BALL).scale(0.5).color(0xFF0000));
            assertEquals(
                    0xFFFF0000, draw(stage.publish(), 1, camera, FLAT).at(WIDTH / 2, HEIGHT / 2));
            assertEquals(
                    0xFF000000 | SKY,
                    draw(empty.publish(), 1, camera, FLAT).at(WIDTH / 2, HEIGHT / 2));
        }
    }
}
