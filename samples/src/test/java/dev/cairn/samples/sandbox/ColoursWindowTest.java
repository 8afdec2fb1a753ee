package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

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
