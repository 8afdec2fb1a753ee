package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.physics.shape.Box;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Light;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.Texture;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.Arrays;

/** Surfaces that are seen through. */
class GlassTest extends Drawing {
    private static final int RED = 0xC02010;
    private static final int BLUE = 0x2040F0;
    private static final double SHARE = 0.25;

    private static Model box(double x, double y, double z, Texture texture, int rgb) {
        return Model.of(Box.ofHalfExtents(x, y, z)).texture(texture).color(rgb);
    }

    @Test
    void aPixelIsTheMixOfGlassAndWhatIsBehindIt() {
        Camera camera = new Camera().lookAt(0, 0, 6, 0, 0, 0);
        try (Stage stage = new Stage()) {
            // The glass first: it is drawn last all the same.
            Texture glass = Texture.WHITE.opacity(SHARE);
            stage.add(Pose.at(0, 0, 1), box(1, 1, 0.1, glass, BLUE));
            long red = stage.add(Pose.at(0, 0, -1), box(0.5, 0.5, 0.1, Texture.WHITE, RED));
            PoseSnapshot snapshot = stage.publish();
            Picture picture = draw(snapshot, 1, camera, FLAT);
            expect(picture.at(WIDTH / 2, HEIGHT / 2), RED);
            expect(picture.at(WIDTH / 2 + 32, HEIGHT / 2), SKY);
            Vector3d eye = camera.position(new Vector3d());
            Pick pick = new Picker().pick(snapshot, 1, eye, camera.forward(new Vector3d()));
            assertEquals(red, pick.entity(), "the mouse goes through");
        }
        assertThrows(IllegalArgumentException.class, () -> Texture.WHITE.opacity(1.5));
    }

    private static void expect(int seen, int behind) {
        for (int shift = 0; shift < 24; shift += 8) {
            double mixed = SHARE * (BLUE >> shift & 255) + (1 - SHARE) * (behind >> shift & 255);
            assertEquals(mixed, seen >> shift & 255, 2, Integer.toHexString(seen));
        }
    }

    @Test
    void glassCastsNoShadow() {
        Light noon = SUNNY.from(0, 1, 0);
        Camera camera = new Camera().lookAt(0, 3, 0, 0, 0, -1e-3);
        Texture[] plates = {null, Texture.glass(), Texture.WHITE};
        int[][] pictures = new int[3][];
        for (int i = 0; i < 3; i++) {
            try (Stage stage = new Stage()) {
                stage.add(Pose.at(0, -0.5, 0), box(3, 0.5, 3, Texture.WHITE, 0x808080));
                if (plates[i] != null) {
                    stage.add(Pose.at(0, 5, 0), box(3, 0.1, 3, plates[i], 0xFFFFFF));
                } else {
                    // The same region for the map of shadows.
                    stage.add(Pose.at(0, 5, 0), box(3, 0.1, 3, Texture.WHITE.opacity(0), 0));
                }
                Picture picture = draw(stage.publish(), 1, camera, noon);
                int[] all = new int[WIDTH * HEIGHT];
                Arrays.setAll(all, p -> picture.at(p % WIDTH, p / WIDTH));
                pictures[i] = all;
            }
        }
        assertArrayEquals(pictures[0], pictures[1]);
        assertFalse(Arrays.equals(pictures[0], pictures[2]), "a solid plate does");
        assertTrue((pictures[2][0] & 255) < (pictures[0][0] & 255));
    }
}
