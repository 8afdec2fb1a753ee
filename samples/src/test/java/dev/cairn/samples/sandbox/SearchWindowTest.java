package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

import java.io.IOException;

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
        await("an empty list", seen -> seen.number("listed") == 0);
        type("key", "ctrl+a");
        settle();
        type("key", "BackSpace");
        await("all scenes", seen -> seen.number("listed") >= 4);
        type("type", "FRICTION slope");
        await("one scene", seen -> seen.number("listed") == 1);
        settle();
        look("search");
        assertFalse(now().flag("paused"), "letters of the field are no keys: " + last);
        click("hit");
        await("the scene to be shown", seen -> seen.is("scene", "1"));
    }
}
