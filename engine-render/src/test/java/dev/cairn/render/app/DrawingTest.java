package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.app.Blocks.Block;
import dev.cairn.render.app.Blocks.Hit;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Light;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.Texture;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/**
 * What is drawn is where geometry says, in the order, orientation and brightness that geometry
 * says.
 */
class DrawingTest {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 180;
    private static final int SKY = 0x102030;

    /** No sun: a surface shows its own colour. */
    private static final Light FLAT =
            Light.DAYLIGHT.strengths(0, 1).background(SKY, SKY).haze(0).shadows(false);

    private static final Light SUNNY = Light.DAYLIGHT.background(SKY, SKY).haze(0);

    private static Offscreen view;

    @BeforeAll
    static void open() {
        GlTests.require();
        view = Offscreen.open(WIDTH, HEIGHT);
    }

    @AfterAll
    static void close() {
        if (view != null) {
            view.close();
        }
    }

    private static Picture draw(PoseSnapshot snapshot, double alpha, Camera camera, Light light) {
        view.draw(snapshot, alpha, camera, light);
        return view.picture();
    }

    /**
     * What a place in the picture shows: -1 if the oracle is not sure, else a colour; and what kind
     * of place it is.
     */
    private record Seen(int kind, int rgb) {
        private static final int SKY_KIND = 0;
        private static final int AWAY = 1;
        private static final int SHADED = 2;
        private static final int SUNNY_KIND = 3;
        private static final int UNSURE = 4;
    }

    private static Seen trace(
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
    private static int[] compare(Picture picture, Camera camera, List<Block> blocks, Light light) {
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

    private static int blockPixels(int[] counts) {
        return counts[Seen.AWAY] + counts[Seen.SHADED] + counts[Seen.SUNNY_KIND];
    }

    private static Block random(SplittableRandom random, double x, double y, double z, int rgb) {
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
    void textureStandsUprightOnEachFace() {
        int red = 0xFFFF0000;
        int green = 0xFF00FF00;
        int blue = 0xFF0000FF;
        int white = 0xFFFFFFFF;
        int[] pixels = new int[64 * 64];
        for (int i = 0; i < pixels.length; i++) {
            boolean left = i % 64 < 32;
            boolean top = i / 64 < 32;
            pixels[i] = top ? (left ? red : green) : (left ? blue : white);
        }
        Model model =
                Model.of(Meshes.CUBE)
                        .texture(Texture.of("corners", 64, 64, pixels))
                        .color(0xFFFFFF);
        double[][] sides = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}};
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, 0, 0), model);
            PoseSnapshot snapshot = stage.publish();
            for (double[] side : sides) {
                Camera camera = new Camera().lookAt(5 * side[0], 5 * side[1], 5 * side[2], 0, 0, 0);
                Picture picture = draw(snapshot, 1, camera, FLAT);
                String where = "seen from " + Arrays.toString(side);
                assertTrue(
                        Blocks.difference(picture.at(WIDTH / 2 - 20, HEIGHT / 2 - 20), red) < 4,
                        where);
                assertTrue(
                        Blocks.difference(picture.at(WIDTH / 2 + 20, HEIGHT / 2 - 20), green) < 4,
                        where);
                assertTrue(
                        Blocks.difference(picture.at(WIDTH / 2 - 20, HEIGHT / 2 + 20), blue) < 4,
                        where);
                assertTrue(
                        Blocks.difference(picture.at(WIDTH / 2 + 20, HEIGHT / 2 + 20), white) < 4,
                        where);
            }
        }
    }

    @Test
    void tiledTextureRepeatsByMetresWhateverTheScale() {
        int[] pixels = new int[64 * 64];
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] = i % 64 < 32 ? 0xFF000000 : 0xFFFFFFFF;
        }
        Texture stripes = Texture.of("stripes", 64, 64, pixels).tiledEvery(1);
        Camera camera = new Camera().lookAt(0, 0, 8, 0, 0, 0);
        try (Stage stage = new Stage()) {
            stage.add(
                    Pose.at(0, 0, -0.5),
                    Model.of(Meshes.CUBE).scale(10, 10, 0.5).texture(stripes).color(0xFFFFFF));
            Picture picture = draw(stage.publish(), 1, camera, FLAT);
            double metresPerPixel = 2 * 8 * Math.tan(camera.fieldOfView() / 2) / HEIGHT;
            int checked = 0;
            for (int x = 0; x < WIDTH; x++) {
                double metres = (x + 0.5 - WIDTH / 2.0) * metresPerPixel;
                double phase = metres - Math.floor(metres);
                if (Math.abs(phase - 0.25) < 0.12 || Math.abs(phase - 0.75) < 0.12) {
                    int expected = phase < 0.5 ? 0 : 0xFFFFFF;
                    assertTrue(
                            Blocks.difference(expected, picture.at(x, HEIGHT / 2)) < 60,
                            "metre " + metres);
                    checked++;
                }
            }
            assertTrue(checked > 100, "checked " + checked);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void posesBetweenTicksAreInterpolatedTheShortWayRound(boolean flipSign) {
        Quaterniond from = new Quaterniond().rotateXYZ(0.3, 0.2, 0.1);
        Quaterniond to = new Quaterniond().rotateXYZ(0.9, -0.3, 0.5);
        Block start = new Block(-1.2, 0.2, 0, from, 0.9, 0.6, 0.4, 0x40C0F0);
        Block end = new Block(1.0, -0.4, 0.6, to, 0.9, 0.6, 0.4, 0x40C0F0);
        Quaterniond middle =
                new Quaterniond(from.x + to.x, from.y + to.y, from.z + to.z, from.w + to.w)
                        .normalize();
        Block between = new Block(-0.1, -0.1, 0.3, middle, 0.9, 0.6, 0.4, 0x40C0F0);
        double sign = flipSign ? -1 : 1;
        Camera camera = new Camera().lookAt(0.5, 1, 5, 0, 0, 0);
        try (Stage stage = new Stage()) {
            long entity = stage.add(start, start.rgb());
            stage.publish();
            stage.set(
                    entity,
                    new Pose(
                            end.x(),
                            end.y(),
                            end.z(),
                            sign * to.x,
                            sign * to.y,
                            sign * to.z,
                            sign * to.w,
                            0));
            PoseSnapshot snapshot = stage.step();
            assertTrue(
                    blockPixels(
                                    compare(
                                            draw(snapshot, 0, camera, FLAT),
                                            camera,
                                            List.of(start),
                                            FLAT))
                            > 500);
            assertTrue(
                    blockPixels(
                                    compare(
                                            draw(snapshot, 0.5, camera, FLAT),
                                            camera,
                                            List.of(between),
                                            FLAT))
                            > 500);
            Picture last = draw(snapshot, 1, camera, SUNNY);
            assertTrue(
                    blockPixels(
                                    compare(
                                            draw(snapshot, 1, camera, FLAT),
                                            camera,
                                            List.of(end),
                                            FLAT))
                            > 500);
            // The end of one tick is the beginning of the next, bit for bit.
            PoseSnapshot next = stage.step();
            assertArrayEquals(last.argb(), draw(next, 0, camera, SUNNY).argb());
        }
    }

    @Test
    void teleportDoesNotSmear() {
        Block there = new Block(1, 0, 0, new Quaterniond(), 0.5, 0.5, 0.5, 0x40C0F0);
        Camera camera = new Camera().lookAt(0, 1, 5, 0, 0, 0);
        try (Stage stage = new Stage()) {
            long entity =
                    stage.add(Pose.at(-2, 0, 0), Model.of(Meshes.CUBE).scale(0.5).color(0x40C0F0));
            stage.publish();
            stage.set(entity, new Pose(1, 0, 0, 0, 0, 0, 1, 1));
            assertTrue(
                    blockPixels(
                                    compare(
                                            draw(stage.step(), 0.5, camera, FLAT),
                                            camera,
                                            List.of(there),
                                            FLAT))
                            > 500);
        }
    }

    @Test
    void sameSnapshotIsUploadedOnceAndDrawnTheSame() {
        Camera camera = new Camera().lookAt(2, 2, 5, 0, 0, 0);
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, 0, 0), Model.of(Meshes.CUBE));
            PoseSnapshot snapshot = stage.publish();
            Picture first = draw(snapshot, 1, camera, SUNNY);
            int uploads = view.uploads();
            assertArrayEquals(first.argb(), draw(snapshot, 1, camera, SUNNY).argb());
            assertEquals(uploads, view.uploads());
            draw(stage.step(), 1, camera, SUNNY);
            assertEquals(uploads + 1, view.uploads());
        }
    }

    @Test
    void modelThatCannotBeDrawnIsAVisiblePlaceholder() {
        Camera camera = new Camera().lookAt(0, 0, 5, 0, 0, 0);
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, 0, 0), "no model");
            assertEquals(
                    0xFFFF00FF, draw(stage.publish(), 1, camera, FLAT).at(WIDTH / 2, HEIGHT / 2));
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

    @Test
    void cameraRidesOnAnEntity() {
        Block other = new Block(5, 2, -4, new Quaterniond(), 0.5, 0.5, 0.5, 0x40C0F0);
        Camera camera = new Camera();
        try (Stage stage = new Stage()) {
            stage.add(other, other.rgb());
            long carrier = stage.add(Pose.at(0, 2, 0), Model.of(Meshes.BALL).scale(0.1));
            camera.lookAt(0, 0, 4, 0, 0, 0).follow(carrier, 0, 0, 2, false);
            stage.publish();
            stage.set(carrier, Pose.at(10, 2, 0));
            PoseSnapshot snapshot = stage.step();
            draw(snapshot, 0.5, camera, FLAT);
            assertEquals(new Vector3d(5, 2, 2), camera.position(new Vector3d()));
            assertFalse(camera.followed() == Camera.NOTHING);
        }
    }
}
