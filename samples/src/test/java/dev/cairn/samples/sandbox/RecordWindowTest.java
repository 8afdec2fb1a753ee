package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A whole run in the real window, as {@code samples --window --record} writes it. */
class RecordWindowTest extends WindowFixture {
    @Override
    public boolean pixels() {
        return false;
    }

    @Override
    public Class<?> program() {
        return SandboxProbe.class;
    }

    /** The probe records where it finds the file. */
    @Override
    public void prepare() throws IOException {
        Files.createFile(folder.resolve(SandboxProbe.RUN));
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= 5;
    }

    /** Balls, a pull of the mouse, a past that was changed: what comes again is what was seen. */
    @Test
    void theRunIsWrittenWhenTheWindowCloses() throws IOException, InterruptedException {
        type("key", "b");
        await("a ball", seen -> seen.number("bodies") == 6);
        await("60 ticks", seen -> seen.number("tick") >= 60);
        pullTheMiddle();
        type("key", "comma");
        await("the pause", seen -> seen.flag("paused"));
        type("key", "comma", "comma", "comma");
        Seen back = await("the past", seen -> seen.number("tick") <= seen.number("newest") - 3);
        type("key", "b"); // another future begins here
        type("key", "space");
        await(
                "a future with two balls",
                seen -> seen.number("bodies") == 7 && seen.number("tick") > back.number("newest"));
        type("key", "p");
        await("the pause", seen -> seen.flag("paused"));
        settle();
        Seen end = now();
        assertTrue(end.number("tick") > back.number("newest"), last);
        type("key", "Escape");
        assertEquals(0, ended());
        Path run = folder.resolve(SandboxProbe.RUN);
        assertTrue(Files.size(run) > 1000, "nothing is in " + run);
        String told = plays(run, end);
        assertTrue(told.contains("%.0f ticks from tick 0".formatted(end.number("tick"))), told);
    }

    @Test
    void anExplosionBlowsTheStackApartAndIsWrittenToo() throws IOException, InterruptedException {
        await("the stack", seen -> seen.number("tick") >= 60);
        moveTo(512, 340);
        type("click", "1");
        Seen before = await("a box to be told about", seen -> seen.is("held", "box_1"));
        settle();
        type("key", "x");
        await("it to fly", seen -> Math.abs(seen.number("heldX") - before.number("heldX")) > 0.5);
        look("exploded");
        type("key", "p");
        await("the pause", seen -> seen.flag("paused"));
        settle();
        Seen end = now();
        type("key", "Escape");
        assertEquals(0, ended());
        plays(folder.resolve(SandboxProbe.RUN), end);
    }
}
