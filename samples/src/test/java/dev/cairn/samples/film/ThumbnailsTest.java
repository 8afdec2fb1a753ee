package dev.cairn.samples.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.cairn.render.app.Offscreen;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneRegistry;

import org.junit.jupiter.api.Test;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The small pictures of the list, and the large ones of the docs. */
class ThumbnailsTest {
    /** Who adds a scene runs {@code samples pictures --of-list}. */
    @Test
    void eachSceneHasAPictureOfItsOwn() {
        List<SampleScene> scenes = SceneRegistry.all();
        List<Ui.Part> parts = Thumbnails.of(scenes);
        Map<Integer, String> seen = new HashMap<>();
        for (int i = 0; i < scenes.size(); i++) {
            String id = scenes.get(i).id();
            Ui.Part part = parts.get(i);
            assertNotNull(part, id + " has none; run samples pictures --of-list");
            int[] pixels = new int[part.width() * part.height()];
            int[] sheet = part.sheet().argb();
            for (int y = 0; y < part.height(); y++) {
                int from = (part.top() + y) * part.sheet().width() + part.left();
                System.arraycopy(sheet, from, pixels, y * part.width(), part.width());
            }
            assertTrue(Arrays.stream(pixels).distinct().count() > 100, id + " shows nothing");
            String other = seen.put(Arrays.hashCode(pixels), id);
            assertEquals(null, other, id + " has the picture of " + other);
        }
    }

    @Test
    void picturesSideBySideHaveTheSameBytesEachTimeAndDiffer() {
        assumeTrue(Offscreen.unavailableReason() == null, "no OpenGL here");
        BufferedImage first = PicturesCommand.sideBySide(List.of("arch", "cradle"), 160, 90, 1);
        BufferedImage second = PicturesCommand.sideBySide(List.of("arch", "cradle"), 160, 90, 1);
        int width = first.getWidth();
        int height = first.getHeight();
        int[] pixels = first.getRGB(0, 0, width, height, null, 0, width);
        assertArrayEquals(pixels, second.getRGB(0, 0, width, height, null, 0, width));
        assertEquals(2 * 160 + 4, width);
        assertEquals(2 * 90 + 4, height);
        int same = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < 160; x++) {
                same += first.getRGB(x, y) == first.getRGB(x + 164, y) ? 1 : 0;
            }
        }
        assertTrue(same < 0.5 * 160 * height, same + " pixels are the same with all effects");
    }
}
