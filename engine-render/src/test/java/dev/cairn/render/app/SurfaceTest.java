package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.render.app.Blocks.Block;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Light;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.Texture;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/** Surfaces and sky, point by point, against the formulas that they are defined by. */
class SurfaceTest extends Drawing {
    private static final int SIZE = 64;

    /** Red where the picture is left and up, green right and up, blue left and down, else white. */
    private static Texture corners() {
        int[] pixels = new int[SIZE * SIZE];
        for (int i = 0; i < pixels.length; i++) {
            boolean left = i % SIZE < SIZE / 2;
            boolean top = i / SIZE < SIZE / 2;
            pixels[i] = top ? (left ? 0xFFFF0000 : 0xFF00FF00) : (left ? 0xFF0000FF : 0xFFFFFFFF);
        }
        return Texture.of("corners", SIZE, SIZE, pixels);
    }

    private static int corner(double u, double v) {
        boolean left = u - Math.floor(u) < 0.5;
        boolean up = v - Math.floor(v) >= 0.5;
        return up ? (left ? 0xFF0000 : 0x00FF00) : (left ? 0x0000FF : 0xFFFFFF);
    }

    private static double fromEdge(double u) {
        double half = 2 * u - Math.floor(2 * u);
        return Math.min(half, 1 - half) / 2;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 2.5, 0.8})
    void aTiledTextureRepeatsAfterItsMetresOnEachFace(double tile) {
        double hx = 2;
        double hy = 1.5;
        double hz = 1.2;
        Model model =
                Model.of(Meshes.CUBE)
                        .scale(hx, hy, hz)
                        .texture(corners().tiledEvery(tile))
                        .color(0xFFFFFF);
        // From the front, the right and above: the face, and the axes that it takes.
        double[][] eyes = {{0.5, 0.4, 6}, {6, 0.4, 0.5}, {0.5, 6, 0.4}};
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, 0, 0), model);
            for (int face = 0; face < 3; face++) {
                Camera camera =
                        new Camera().lookAt(eyes[face][0], eyes[face][1], eyes[face][2], 0, 0, 0);
                Picture picture = draw(stage.publish(), 1, camera, FLAT);
                int checked = 0;
                for (int y = 0; y < HEIGHT; y += 3) {
                    for (int x = 0; x < WIDTH; x += 3) {
                        Vector3d ray = Blocks.ray(camera, x + 0.5, y + 0.5, WIDTH, HEIGHT);
                        Block block = new Block(0, 0, 0, new Quaterniond(), hx, hy, hz, 0);
                        Blocks.Hit hit =
                                Blocks.hit(block, camera.position(new Vector3d()), ray, -0.1);
                        if (hit == null) {
                            continue;
                        }
                        Vector3d n = hit.normal();
                        // Again, on the block's true surface.
                        hit = Blocks.hit(block, camera.position(new Vector3d()), ray, 0);
                        if (hit == null || hit.normal().dot(n) < 0.9) {
                            continue;
                        }
                        Vector3d at = camera.position(new Vector3d()).fma(hit.distance(), ray);
                        double u = n.y > 0.5 || n.z > 0.5 ? at.x : at.z;
                        double v = n.y > 0.5 ? -at.z : at.y;
                        if (fromEdge(u / tile) * tile > 0.11 && fromEdge(v / tile) * tile > 0.11) {
                            checked++;
                            int shown = picture.at(x, y);
                            assertTrue(
                                    Blocks.difference(corner(u / tile, v / tile), shown) < 50,
                                    "tile %s, normal %s, pixel %d,%d shows %06x"
                                            .formatted(tile, n, x, y, shown & 0xFFFFFF));
                        }
                    }
                }
                assertTrue(checked > 150, "face " + face + ": checked " + checked);
            }
        }
    }

    /**
     * A pixel of a floor near the horizon covers metres along the view and centimetres across it:
     * stripes along the view stay apart, where a mean over a square would be grey.
     */
    @Test
    void stripesOfAFloorStayApartInTheDistance() {
        double tile = 4;
        int light = 0xFFFFFF;
        int dark = 0x808080;
        int[] pixels = new int[SIZE * SIZE];
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] = 0xFF000000 | (i % SIZE < SIZE / 2 ? light : dark);
        }
        Model floor =
                Model.of(Meshes.CUBE)
                        .scale(100, 1, 100)
                        .texture(Texture.of("stripes", SIZE, SIZE, pixels).tiledEvery(tile))
                        .color(0xFFFFFF);
        Camera camera = new Camera().lookAt(0.3, 1.2, 0, 0.3, 0.6, -20);
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, -1, 0), floor);
            Picture picture = draw(stage.publish(), 1, camera, FLAT);
            int checked = 0;
            for (int y = 0; y < HEIGHT; y++) {
                for (int x = 0; x < WIDTH; x++) {
                    Vector3d ray = Blocks.ray(camera, x + 0.5, y + 0.5, WIDTH, HEIGHT);
                    double t = 1.2 / -ray.y;
                    double across = 0.3 + t * ray.x;
                    boolean sure = fromEdge(across / tile) * tile > 0.6;
                    if (t > 22 && t < 35 && Math.abs(across) < 8 && sure) {
                        checked++;
                        double u = across / tile;
                        int expected = u - Math.floor(u) < 0.5 ? light : dark;
                        assertTrue(
                                Blocks.difference(expected, picture.at(x, y)) < 25,
                                "pixel %d,%d, %.1f m away, shows %06x, expected %06x"
                                        .formatted(x, y, t, picture.at(x, y) & 0xFFFFFF, expected));
                    }
                }
            }
            assertTrue(checked > 40, "checked " + checked);
        }
    }

    /** IEC 61966-2-1, its linear part too. */
    @Test
    void lightIsEncodedForTheScreen() {
        double[] values = {0.0004, 0.0012, 0.0025, 0.0031, 0.0045, 0.01, 0.05, 0.2, 0.5, 0.9, 1, 3};
        Camera camera = new Camera().lookAt(0, 0, 5, 0, 0, 0);
        try (Stage stage = new Stage()) {
            stage.add(Pose.at(0, 0, 0), Model.of(Meshes.CUBE).color(0xFFFFFF));
            for (double value : values) {
                Light light =
                        new Light(
                                0, 1, 0, 0, 0, 0, value, value / 2, value / 4, value, value / 2,
                                value / 4, SKY, SKY, 0, false);
                int shown =
                        draw(stage.publish(), 1, camera, light).at(WIDTH / 2, HEIGHT / 2)
                                & 0xFFFFFF;
                int expected =
                        Blocks.encoded(value) << 16
                                | Blocks.encoded(value / 2) << 8
                                | Blocks.encoded(value / 4);
                assertTrue(
                        Blocks.difference(expected, shown) <= 1,
                        "light %s shows %06x, expected %06x".formatted(value, shown, expected));
            }
        }
    }

    @Test
    void skyGoesFromTheHorizonToTheZenith() {
        Light light = SUNNY.background(0x2050C0, 0xE0D0B0);
        try (Stage stage = new Stage()) {
            for (double pitch : new double[] {-0.3, 0.1, 0.7, 1.3}) {
                Camera camera = new Camera().lookAt(0, 0, 0, Math.cos(pitch), Math.sin(pitch), 0.4);
                Picture picture = draw(stage.publish(), 1, camera, light);
                for (int i = 0; i < 60; i++) {
                    int x = (37 * i) % WIDTH;
                    int y = (53 * i) % HEIGHT;
                    Vector3d ray = Blocks.ray(camera, x + 0.5, y + 0.5, WIDTH, HEIGHT);
                    double share = 1 - Math.exp(-3 * Math.max(0, ray.y));
                    int expected = mixed(0xE0D0B0, 0x2050C0, share);
                    assertTrue(
                            Blocks.difference(expected, picture.at(x, y)) <= 1,
                            "pitch %s, pixel %d,%d shows %06x, expected %06x"
                                    .formatted(pitch, x, y, picture.at(x, y) & 0xFFFFFF, expected));
                }
            }
        }
    }

    private static int mixed(int from, int to, double share) {
        int rgb = 0;
        for (int shift = 16; shift >= 0; shift -= 8) {
            double light =
                    (1 - share) * Blocks.linear(from >> shift) + share * Blocks.linear(to >> shift);
            rgb |= Blocks.encoded(light) << shift;
        }
        return rgb;
    }

    @Test
    void hazeHidesBySixtyThreeHundredthsAtItsDistance() {
        double far = 40;
        Light light = FLAT.haze(far).background(0x2050C0, 0xE0D0B0);
        Camera camera = new Camera().lookAt(7.3, 5.4, -6.2, 7.3, 5.4, -9);
        for (double distance : new double[] {5, 20, 40, 80}) {
            try (Stage stage = new Stage()) {
                stage.add(
                        Pose.at(7, 5, -6.2 - distance - 1),
                        Model.of(Meshes.CUBE).scale(30, 30, 1).color(0x306010));
                int shown = draw(stage.publish(), 1, camera, light).at(WIDTH / 2, HEIGHT / 2);
                double square = distance / far * (distance / far);
                int expected = mixed(0x306010, 0xE0D0B0, 1 - Math.exp(-square));
                assertTrue(
                        Blocks.difference(expected, shown) <= 2,
                        "at %s m %06x, expected %06x"
                                .formatted(distance, shown & 0xFFFFFF, expected));
            }
        }
    }

    /** An ellipsoid: a ball that is scaled unevenly and turned must be lit by its own normals. */
    @Test
    void anEllipsoidIsShadedByItsOwnNormals() {
        double[] axis = {1.8, 1.2, 0.6};
        Quaterniond turn = new Quaterniond().rotateXYZ(0.4, 0.7, -0.3);
        Light light = SUNNY.shadows(false).from(0.4, 0.7, 0.6);
        Camera camera = new Camera().lookAt(1, 1.5, 5, 0, 0, 0);
        try (Stage stage = new Stage()) {
            stage.add(
                    new Pose(0, 0, 0, turn.x, turn.y, turn.z, turn.w, 0),
                    Model.of(Meshes.BALL)
                            .texture(Texture.WHITE)
                            .scale(axis[0], axis[1], axis[2])
                            .color(0xC0A080));
            Picture picture = draw(stage.publish(), 1, camera, light);
            Quaterniond back = new Quaterniond(turn).conjugate();
            Vector3d eye = back.transform(camera.position(new Vector3d()));
            int checked = 0;
            for (int y = 0; y < HEIGHT; y += 2) {
                for (int x = 0; x < WIDTH; x += 2) {
                    Vector3d ray =
                            back.transform(Blocks.ray(camera, x + 0.5, y + 0.5, WIDTH, HEIGHT));
                    Vector3d o = new Vector3d(eye).div(axis[0], axis[1], axis[2]);
                    Vector3d d = new Vector3d(ray).div(axis[0], axis[1], axis[2]);
                    double a = d.lengthSquared();
                    double half = o.dot(d);
                    double root = half * half - a * (o.lengthSquared() - 1);
                    if (root < 0.05 * a) {
                        continue; // beside it, or at its edge
                    }
                    Vector3d at = new Vector3d(eye).fma((-half - Math.sqrt(root)) / a, ray);
                    Vector3d normal =
                            turn.transform(
                                    at.div(axis[0] * axis[0], axis[1] * axis[1], axis[2] * axis[2])
                                            .normalize());
                    checked++;
                    int expected = Blocks.lit(0xC0A080, normal, light, true);
                    assertTrue(
                            Blocks.difference(expected, picture.at(x, y)) <= 9,
                            "pixel %d,%d shows %06x, expected %06x"
                                    .formatted(x, y, picture.at(x, y) & 0xFFFFFF, expected));
                }
            }
            assertTrue(checked > 1000, "checked " + checked);
        }
    }

    @Test
    void anotherOriginShiftsTheModelInItsOwnFrame() {
        Quaterniond turn = new Quaterniond().rotateZ(0.5).rotateX(0.3);
        Vector3d shift = turn.transform(new Vector3d(0.8, -0.3, 0.2));
        Block seen = new Block(-shift.x, -shift.y, -shift.z, turn, 0.6, 0.4, 0.5, 0x40C0F0);
        Camera camera = new Camera().lookAt(0.5, 1, 5, 0, 0, 0);
        try (Stage stage = new Stage()) {
            stage.add(
                    new Pose(0, 0, 0, turn.x, turn.y, turn.z, turn.w, 0),
                    Model.of(Meshes.CUBE)
                            .scale(0.6, 0.4, 0.5)
                            .origin(0.8, -0.3, 0.2)
                            .color(0x40C0F0));
            int[] counts =
                    compare(draw(stage.publish(), 1, camera, FLAT), camera, List.of(seen), FLAT);
            assertTrue(blockPixels(counts) > 500, "pixels " + blockPixels(counts));
            assertEquals(1, view.drawn());
        }
    }
}
