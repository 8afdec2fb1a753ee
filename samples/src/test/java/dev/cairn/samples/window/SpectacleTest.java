package dev.cairn.samples.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneRegistry;

import org.junit.jupiter.api.Test;

import java.awt.image.BufferedImage;
import java.io.IOException;

/** What somebody sees who starts the samples and says nothing: a heap that falls, not one box. */
class SpectacleTest extends MainFixture {
    /** Colour levels by which a pixel differs that shows something else. */
    private static final int OTHER = 24;

    @Test
    void theWindowOpensOnTheJunkYardInMotion() throws IOException, InterruptedException {
        String junkyard = title("junkyard");
        await(() -> title().startsWith("Cairn: " + junkyard), "the junk yard in the title");
        // A share of the picture's middle that no single box could fill.
        BufferedImage first = screen();
        await(() -> changed(first, screen()) > 0.05, "a heap in motion");
        look("opens");
        type("key", "Escape");
        assertEquals(0, ended());
    }

    private static String title(String id) {
        return SceneRegistry.all().stream()
                .filter(scene -> scene.id().equals(id))
                .map(SampleScene::title)
                .findFirst()
                .orElseThrow();
    }

    private interface Condition {
        boolean holds() throws IOException, InterruptedException;
    }

    private static void await(Condition condition, String what)
            throws IOException, InterruptedException {
        long end = System.nanoTime() + 60_000_000_000L;
        boolean holds = condition.holds();
        while (!holds && System.nanoTime() < end) {
            holds = condition.holds();
        }
        assertTrue(holds, () -> "waited in vain for " + what);
    }

    /** Share of the pixels between the panels that are another colour. */
    private static double changed(BufferedImage from, BufferedImage to) {
        int changed = 0;
        int all = 0;
        for (int y = 60; y < 500; y += 3) {
            for (int x = 320; x < 780; x += 3) {
                int difference = 0;
                for (int shift = 0; shift <= 16; shift += 8) {
                    int was = (from.getRGB(x, y) >> shift) & 0xFF;
                    int is = (to.getRGB(x, y) >> shift) & 0xFF;
                    difference = Math.max(difference, Math.abs(was - is));
                }
                changed += difference > OTHER ? 1 : 0;
                all++;
            }
        }
        return changed / (double) all;
    }
}
