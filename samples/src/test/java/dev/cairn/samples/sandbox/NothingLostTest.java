package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

import javax.imageio.ImageIO;

/** Small things that a user of the sandbox trips over, in the real window. */
class NothingLostTest extends WindowFixture {
    /** The panels' dark glass; pictures must not hold it. */
    private static final int GLASS = 0x232A35;

    @Override
    public Class<?> program() {
        return SandboxProbe.class;
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= 30;
    }

    /** What the user has rebound the last time. */
    @Override
    public void prepare() throws IOException {
        Files.writeString(
                keys(),
                "throw a ball = F7, WHEEL_UP\nkeep moment = MOUSE_MOVE_LEFT\nno such action = A\n");
    }

    @Test
    void keysPanelsPicturesAndTitleDoAsTheySay() throws IOException, InterruptedException {
        keysAreKeptAndRebound();

        // While it stands still, title and panel tell one tick.
        type("key", "p");
        await("the pause", seen -> seen.flag("paused"));
        String tick = "paused at tick " + Math.round(now().number("tick"));
        long end = System.nanoTime() + 5_000_000_000L;
        while (!title().endsWith(tick) && System.nanoTime() < end) {
            now();
        }
        assertTrue(title().endsWith(tick), title() + " against " + tick);

        // A picture shows the scene alone, and the window says where it is.
        type("key", "F12");
        await("the notice", seen -> seen.values().containsKey("NoticeX"));
        settle();
        look("picture-saved");
        Path found;
        try (Stream<Path> files = Files.list(folder)) {
            found = files.filter(file -> file.toString().endsWith(".png")).findAny().orElseThrow();
        }
        keep(found, "picture");
        int corner = ImageIO.read(found.toFile()).getRGB(60, 24) & 0xFFFFFF;
        assertTrue(corner != GLASS && (corner & 255) > 100, "%06x".formatted(corner));
        type("key", "p");

        // A tower that grows stays in the picture.
        Seen before = await("to go on", seen -> !seen.flag("paused"));
        moveTo(before.number("boxesX"), before.number("boxesY"));
        type("click", "1");
        await(
                "the camera to go back from a tower of some hundred boxes",
                seen -> seen.number("eyeZ") > 5 * before.number("eyeZ"));

        // Escape closes what lies on top, then the window.
        type("key", "F1");
        await("the list of keys", seen -> seen.flag("help"));
        type("key", "Escape");
        await("the scene", seen -> !seen.flag("help"));
        type("key", "Escape");
        assertEquals(0, ended());
    }

    private String kept() {
        try {
            return Files.readString(keys());
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private void keysAreKeptAndRebound() throws IOException, InterruptedException {
        Seen start = now();
        type("key", "F7");
        await("a ball by the kept key", seen -> seen.number("bodies") > start.number("bodies"));
        Seen thrown = now();
        moveTo(512, 340);
        type("click", "4");
        await("a ball by the wheel", seen -> seen.number("bodies") > thrown.number("bodies"));
        assertEquals(-1, now().number("kept"), "no moment is kept yet: " + last);
        moveTo(400, 340);
        await("a moment by the way to the left", seen -> seen.number("kept") >= 0);
        click("Keys");
        await("the keys", seen -> seen.values().containsKey("sinkX"));
        click("sink");
        settle(); // a key that comes before the click is drawn is not for it
        type("key", "F1");
        await("the conflict to be told", seen -> seen.values().containsKey("Leave_itX"));
        assertEquals("F1", now().values().get("listKeys"), "nothing is taken yet");
        click(KeyRows.LEAVE);
        await("all to be as before", seen -> seen.is("sinkKeys", "Q") && seen.is("listKeys", "F1"));
        settle();
        click("sink");
        settle(); // a key that comes before the click is drawn is not for it
        type("key", "F6");
        await("the new key", seen -> seen.is("sinkKeys", "F6"));
        await("the new key to be kept", seen -> kept().contains("sink = F6"));
    }

    /** Ten ticks in a row, panels open, a body in the hand. */
    @Test
    void noTextIsCutAtAnyScaleAndTheSimulationThreadMakesNoGarbage()
            throws IOException, InterruptedException {
        await("ten ticks without a byte", seen -> seen.number("quiet") >= 10);
        moveTo(512, 340);
        type("mousedown", "1");
        await("a body in the hand", seen -> seen.flag("pulling"));
        type("mouseup", "1");
        await("it to be let go", seen -> !seen.flag("pulling"));
        await("ten ticks again", seen -> seen.number("quiet") >= 10);
        assertEquals(0, now().number("shortened"), last);
        // So that the buttons stay in the window when all grows by a half.
        type("key", "F11");
        await("the whole screen", seen -> seen.number("uiWidth") == 1100);
        settle();
        click("Window");
        await("the buttons of the scales", seen -> seen.values().containsKey("1.5X"));
        aBoxIsSelectedInTheEditor();
        for (String scale : new String[] {"1.5", "2"}) {
            while (now().number(scale + "Y") > now().number("uiHeight") - 20) {
                moveTo(150 * now().number("uiScale"), 300 * now().number("uiScale"));
                type("click", "5"); // where there is one column, the buttons are below the edge
                settle();
            }
            click(scale);
            await(scale, seen -> seen.number("uiScale") == Double.parseDouble(scale));
            settle();
            assertEquals(0, now().number("shortened"), last);
            assertEquals(0, now().number("overlapping"), last);
            look("sandbox-" + scale);
            type("key", "F1");
            await("the list of keys", seen -> seen.flag("help"));
            settle();
            assertEquals(0, now().number("shortened"), last);
            type("key", "Escape");
            await("the list to close", seen -> !seen.flag("help"));
            type("key", "F2");
            await("the fields", seen -> seen.flag("paused") && seen.values().containsKey("nameX"));
            settle();
            look("editor-" + scale);
            assertEquals(0, now().number("overlapping"), "the editor: " + last);
            assertEquals(0, now().number("shortened"), "the editor: " + last);
            type("key", "F2");
            await("the scene", seen -> !seen.flag("paused"));
            settle();
        }
    }

    private void aBoxIsSelectedInTheEditor() throws IOException, InterruptedException {
        type("key", "F2");
        await("the editor", seen -> seen.flag("paused") && seen.values().containsKey("boxX"));
        click("box");
        await("its fields", seen -> seen.values().containsKey("nameX"));
        settle();
        look("editor-1");
        assertEquals(0, now().number("overlapping"), "the editor: " + last);
        assertEquals(0, now().number("shortened"), "the editor: " + last);
        type("key", "F2");
        await("the scene", seen -> !seen.flag("paused"));
        settle();
    }
}
