package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.io.IOException;

/** Back and forth through the last minutes, in the real window. */
class TimeBarTest extends WindowFixture {
    @Override
    Class<?> program() {
        return SandboxProbe.class;
    }

    /** In the beginning, while the boxes fall: what differs then shows for long. */
    @Override
    boolean ready(Seen seen) {
        return seen.number("tick") >= 5;
    }

    @Test
    void theBarGoesBackAndOnToTheSameFuture() throws IOException, InterruptedException {
        await("150 ticks", seen -> seen.number("tick") >= 150);
        type("key", "comma");
        Seen paused = await("the pause", seen -> seen.flag("paused"));
        type("key", "comma");
        Seen back = await("a tick back", seen -> seen.number("tick") < paused.number("newest") - 1);
        type("key", "comma");
        await("another", seen -> seen.number("tick") == back.number("tick") - 1);
        type("key", "period");
        await("forth", seen -> seen.number("tick") == back.number("tick"));
        assertEquals(paused.number("newest"), now().number("newest"), "nothing is forgotten");

        // Drag to a fifth of the bar: paused while the button is down, then it goes on from there.
        type("key", "space");
        Seen runs = await("to go on", seen -> !seen.flag("paused"));
        moveTo(runs.number("barX") + 0.9 * runs.number("barWidth"), runs.number("barY"));
        type("mousedown", "1");
        await("the bar to be held", seen -> seen.flag("paused"));
        moveTo(runs.number("barX") + 0.2 * runs.number("barWidth"), runs.number("barY"));
        Seen past = await("the past", seen -> seen.number("tick") < 0.4 * seen.number("newest"));
        assertTrue(past.flag("paused"), last);
        type("mouseup", "1");
        // Each tick from there on comes again as it was.
        await(
                "ticks that were not there yet",
                seen -> seen.number("tick") > runs.number("newest") + 60);
        Seen later = now();
        assertTrue(!later.flag("paused"), last);
        assertEquals(0, later.number("oldest"), "the beginning is remembered");
        assertEquals(0, later.number("otherAgain"), last);
        double again = runs.number("newest") - past.number("tick") - 1;
        assertTrue(later.number("sameAgain") >= again, again + " ticks came again: " + last);
    }

    @Test
    void twoFuturesOfAMomentAreComparedTickByTick() throws IOException, InterruptedException {
        type("key", "k");
        Seen kept = await("a kept moment", seen -> seen.number("kept") >= 0);
        await("a future", seen -> seen.number("tick") > kept.number("kept") + 90);
        type("key", "l");
        await(
                "the kept moment again",
                seen ->
                        seen.flag("paused")
                                && seen.flag("future")
                                && seen.number("tick") == seen.number("kept"));
        type("key", "space");
        // Nothing was changed: the other future is this one, to the last bit.
        await(
                "half a second",
                seen -> {
                    assertTrue(!(seen.number("apart") > 0), last);
                    return seen.number("tick") > kept.number("kept") + 40;
                });
        type("key", "l");
        Seen again = await("once more", seen -> seen.number("tick") == seen.number("kept"));
        type("key", "b");
        await("a ball", seen -> seen.number("bodies") == again.number("bodies") + 1);
        type("key", "space");
        await("boxes that it has hit", seen -> seen.number("apart") > 0.02);
        settle();
        assertEquals(0, now().number("shortened"), last);
        look("two-futures");
        click(TimePanel.FORGET);
        await("no other future", seen -> !seen.flag("future"));
    }
}
