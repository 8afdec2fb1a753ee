package dev.cairn.samples.sandbox.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.sandbox.SandboxProbe;
import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

import java.awt.image.BufferedImage;
import java.io.IOException;

/** What the engine knows of bodies, told by their colours and by arrows, in the real window. */
class ColoursWindowTest extends WindowFixture {
    /** Fronts of the lowest and of the highest of the four boxes. */
    private static final int[] LOWEST = {495, 400};

    private static final int[] HIGHEST = {495, 195};

    @Override
    public Class<?> program() {
        return SandboxProbe.class;
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= 60;
    }

    private void toggle(String layer, int layers) throws IOException, InterruptedException {
        click(layer);
        await(layer, seen -> seen.number("layers") == layers);
        settle();
    }

    /** How much more red than blue there is. */
    private int redness(int[] at) throws IOException {
        int rgb = screen().getRGB(at[0], at[1]);
        return (rgb >> 16 & 255) - (rgb & 255);
    }

    @Test
    void bodiesTakeTheColourOfWhatTheyDo() throws IOException, InterruptedException {
        await("rest", seen -> seen.number("tick") >= 240);
        assertTrue(redness(LOWEST) > 60, "its own red");
        click("Draw");
        settle();
        assertEquals(0, now().number("shortened"), last);
        toggle("colour: speed", 1);
        look("colour-speed");
        assertTrue(redness(LOWEST) < -40, "blue at rest: " + redness(LOWEST));
        toggle("colour: speed", 0);
        assertTrue(redness(LOWEST) > 60, "its own red again");

        toggle("colour: load", 1);
        look("colour-load");
        assertTrue(redness(LOWEST) > 60, "the lowest bears most: " + redness(LOWEST));
        assertTrue(redness(HIGHEST) < -20, "the highest least: " + redness(HIGHEST));
        toggle("colour: load", 0);

        int before = orange();
        toggle("contact forces", 1);
        look("forces");
        assertTrue(orange() > before + 200, "arrows: " + before + " to " + orange());
        toggle("contact forces", 0);
        toggle("colour: island", 1);
        settle();
        look("colour-island");
    }

    /** The switch changes pixels at edges and no others, and back again all of them. */
    @Test
    void edgesAreSmoothByASwitchOnTheRasteriserToo() throws IOException, InterruptedException {
        await("rest", seen -> seen.number("tick") >= 240);
        type("key", "p");
        await("the pause", seen -> seen.flag("paused"));
        click("Window");
        while (seeing("smooth edges").number("smooth_edgesY") > now().number("uiHeight") - 30) {
            moveTo(880, 500);
            type("click", "5"); // it is below the panel's edge
            settle();
        }
        BufferedImage rough = screen();
        look("rough-edges");
        click("smooth edges");
        settle();
        BufferedImage smooth = screen();
        look("smooth-edges");
        int[] changed = changed(rough, smooth);
        assertTrue(changed[0] > 300, changed[0] + " pixels changed");
        assertTrue(changed[0] < 0.1 * changed[1], changed[0] + " pixels changed");
        click("smooth edges");
        settle();
        assertEquals(0, changed(rough, screen())[0], "as before");
    }

    /** Pixels between the panels that are another colour, and all of them. */
    private static int[] changed(BufferedImage before, BufferedImage after) {
        int[] counts = new int[2];
        for (int y = 100; y < 500; y++) {
            for (int x = 330; x < 690; x++) {
                counts[0] += before.getRGB(x, y) == after.getRGB(x, y) ? 0 : 1;
                counts[1]++;
            }
        }
        return counts;
    }

    /** Pixels in the picture's middle that have the colour of an arrow. */
    private int orange() throws IOException {
        var screen = screen();
        int count = 0;
        for (int y = 100; y < 500; y++) {
            for (int x = 400; x < 640; x++) {
                int rgb = screen.getRGB(x, y);
                boolean is =
                        Math.abs((rgb >> 16 & 255) - 0xFF) < 40
                                && Math.abs((rgb >> 8 & 255) - 0x8A) < 30
                                && Math.abs((rgb & 255) - 0x3D) < 40;
                count += is ? 1 : 0;
            }
        }
        return count;
    }
}
