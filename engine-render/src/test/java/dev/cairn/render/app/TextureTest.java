package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.Texture;

import org.junit.jupiter.api.Test;

import java.util.Arrays;

/** Textures stand upright, and repeat by metres. */
class TextureTest extends Drawing {
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
}
