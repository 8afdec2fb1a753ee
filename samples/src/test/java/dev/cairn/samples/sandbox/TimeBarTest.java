package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.Main;
import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Back and forth through the last minutes, in the real window. */
class TimeBarTest extends WindowFixture {
    @Override
    public Class<?> program() {
        return SandboxProbe.class;
    }

    /** In the beginning, while the boxes fall: what differs then shows for long. */
    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= 5;
    }

    /** One window for all of it: to open one takes longer than what is done in it. */
    @Test
    void timeGoesBackAndForthIsComparedAndWrittenDown() throws IOException, InterruptedException {
        theBarGoesBackAndOnToTheSameFuture();
        twoFuturesOfAMomentAreComparedTickByTick();
        type("key", "r");
        await("the beginning", seen -> seen.number("bodies") == 5 && !seen.flag("paused"));
        aBugReportPlaysTheLastSecondsAgain();
        type("key", "r", "p");
        await("the beginning", seen -> seen.number("bodies") == 5 && !seen.flag("paused"));
        aMomentThatIsSavedGoesOnWithoutAWindow();
    }

    private void theBarGoesBackAndOnToTheSameFuture() throws IOException, InterruptedException {
        await("60 ticks", seen -> seen.number("tick") >= 60);
        type("key", "comma");
        // A frame may know of the pause while the tick that was running is not in the bar yet.
        Seen paused =
                await(
                        "the pause, a tick back",
                        seen ->
                                seen.flag("paused")
                                        && seen.number("tick") == seen.number("newest") - 1);
        type("key", "comma");
        Seen back =
                await(
                        "another tick back",
                        seen -> seen.number("tick") == paused.number("tick") - 1);
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
                seen -> seen.number("tick") > runs.number("newest") + 20);
        Seen later = now();
        assertTrue(!later.flag("paused"), last);
        assertEquals(0, later.number("oldest"), "the beginning is remembered");
        assertEquals(0, later.number("otherAgain"), last);
        double again = runs.number("newest") - past.number("tick") - 1;
        assertTrue(later.number("sameAgain") >= again, again + " ticks came again: " + last);
    }

    private void twoFuturesOfAMomentAreComparedTickByTick()
            throws IOException, InterruptedException {
        type("key", "k");
        Seen kept = await("a kept moment", seen -> seen.number("kept") >= 0);
        await("a future", seen -> seen.number("tick") > kept.number("kept") + 45);
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
                "a third of a second",
                seen -> {
                    assertTrue(!(seen.number("apart") > 0), last);
                    return seen.number("tick") > kept.number("kept") + 20;
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

    /** What is read from the file is the moment that was seen, and goes on as it went on. */
    private void aMomentThatIsSavedGoesOnWithoutAWindow() throws IOException, InterruptedException {
        type("key", "b");
        await("a ball", seen -> seen.number("bodies") == 6);
        type("key", "p");
        Seen saved = await("the pause", seen -> seen.flag("paused"));
        type("key", "m");
        String tick = "%.0f".formatted(now().number("tick"));
        Path file = folder.resolve("moment-stack-4-" + tick + ".cairn");
        await("the file, " + saved, seen -> Files.exists(file));
        await("the notice", seen -> seen.values().containsKey("NoticeX"));
        look("moment-saved");
        type("key", "p");
        double last = Double.parseDouble(tick) + 40;
        Seen later = await("40 ticks", seen -> seen.number("digestTick") >= last);
        int ticks = (int) (later.number("digestTick") - Double.parseDouble(tick));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PrintStream both = new PrintStream(out, true, StandardCharsets.UTF_8);
        String[] arguments = {
            "--from", file.toString(), "--ticks", Integer.toString(ticks), "--json", "-"
        };
        assertEquals(0, Main.run(arguments, both, both, false), out::toString);
        String json = out.toString(StandardCharsets.UTF_8);
        assertTrue(json.contains(later.values().get("digest")), later + " against " + json);
    }

    /** Balls, pulls and a change of mind: what the report plays ends in the world that was seen. */
    private void aBugReportPlaysTheLastSecondsAgain() throws IOException, InterruptedException {
        type("key", "b");
        Seen ball = await("a ball", seen -> seen.number("bodies") == 6);
        await("ticks", seen -> seen.number("tick") > ball.number("tick") + 20);
        pullTheMiddle();
        // Some ticks back, and another future.
        type("key", "comma", "comma", "comma");
        Seen back = await("ticks back", seen -> seen.number("newest") == seen.number("tick") + 3);
        type("key", "p");
        await("to go on", seen -> seen.number("tick") > back.number("newest"));
        type("key", "b");
        Seen second = await("another ball", seen -> seen.number("bodies") == 7);
        await("ticks", seen -> seen.number("tick") > second.number("tick") + 40);
        type("key", "p");
        await("the pause", seen -> seen.flag("paused"));
        Seen end = now();
        String tick = "%.0f".formatted(end.number("tick"));
        type("key", "F9");
        Path file = folder.resolve("report-stack-4-" + tick + ".cairn");
        await("the notice", seen -> seen.values().containsKey("NoticeX"));
        look("report");
        assertTrue(Files.exists(file), file.toString());
        plays(file, end);
    }
}
