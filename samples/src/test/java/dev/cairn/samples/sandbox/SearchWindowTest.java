package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.stream.IntStream;

/** The list of scenes, and the words that make it shorter. */
class SearchWindowTest extends WindowFixture {
    @Override
    public Class<?> program() {
        return SearchProbe.class;
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= 2 && seen.values().containsKey("searchX");
    }

    @Test
    void wordsMakeTheListShorterAndAClickChooses() throws IOException, InterruptedException {
        assertTrue(now().number("listed") >= 4, last);
        click("search");
        settle();
        type("type", "dominoes");
        // the whole word: letters that come in one frame with the next keys would follow those
        await("an empty list", seen -> seen.is("sought", "dominoes"));
        assertEquals(0, now().number("listed"), last);
        type("key", "ctrl+a");
        settle();
        type("key", "BackSpace");
        await("all scenes", seen -> seen.is("sought", ""));
        assertTrue(now().number("listed") >= 4, last);
        // far more than a frame takes, and then through the clipboard of the server
        String many = "m3 ".repeat(30) + "end";
        type("type", "--delay", "1", many);
        await("all of it", seen -> seen.is("sought", many.replace(' ', '_')));
        type("key", "ctrl+a", "ctrl+x");
        await("nothing", seen -> seen.is("sought", ""));
        type("key", "ctrl+v", "ctrl+v");
        await("twice as much", seen -> seen.is("sought", (many + many).replace(' ', '_')));
        look("search-long");
        type("key", "ctrl+a", "BackSpace");
        await("nothing again", seen -> seen.is("sought", ""));
        type("type", "FRICTION slope");
        await("one scene", seen -> seen.is("sought", "FRICTION_slope"));
        assertEquals(1, now().number("listed"), last);
        settle();
        look("search");
        assertFalse(now().flag("paused"), "letters of the field are no keys: " + last);
        // The picture stands left of the name, and is no even patch.
        double x = now().number("hitX") - 70;
        double y = now().number("hitY");
        assertTrue(colours((int) x, (int) y) > 20, "no picture beside the name");
        moveTo(x, y);
        type("click", "1");
        await("the scene to be shown", seen -> seen.is("scene", "1"));
        type("key", "Page_Up");
        await("the scene before", seen -> seen.is("scene", "0"));
        click("hit");
        await("the scene by its name", seen -> seen.is("scene", "1"));
    }

    /** How many colours there are around a place. */
    private int colours(int x, int y) throws IOException {
        BufferedImage screen = screen();
        return (int)
                IntStream.range(0, 24 * 16)
                        .map(i -> screen.getRGB(x - 12 + i % 24, y - 8 + i / 24))
                        .distinct()
                        .count();
    }
}
