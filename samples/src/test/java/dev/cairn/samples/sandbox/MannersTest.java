package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.render.input.MouseMove;
import dev.cairn.samples.window.WindowFixture;
import dev.cairn.samples.window.WindowManager;

import org.junit.jupiter.api.Test;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;

/** How the window behaves beside other windows, and what it does to keys, in the real window. */
class MannersTest extends WindowFixture {
    @Override
    public Class<?> program() {
        return SandboxProbe.class;
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= 5;
    }

    /** One window for all of it: to open one takes longer than what is done in it. */
    @Test
    void itSleepsLooksRebindsAndClosesWhenAsked() throws IOException, InterruptedException {
        aMinimisedWindowDrawsNothingWhileTheSceneGoesOn();
        theCrossOfMouseLookHasBothArms();
        aDoubleClickHasTheCameraFollow();
        theSpeedReadsAsPeopleSayIt();
        aKeyWithoutANameIsToldAndTakesNothing();
        aMoveOfTheMouseIsTakenOnlyWhereItIsAskedFor();
        aTakenKeyComesBackByReset();
        try (WindowManager manager = manager()) {
            manager.askToClose();
        }
        assertEquals(0, ended());
    }

    private void aMinimisedWindowDrawsNothingWhileTheSceneGoesOn()
            throws IOException, InterruptedException {
        try (WindowManager manager = manager()) {
            Seen before = now();
            manager.minimise();
            Seen asleep = awaitSleep("120 ticks without a frame");
            manager.restore();
            Seen again = await("to be drawn again", seen -> seen.values().containsKey("tick"));
            assertEquals(asleep.number("frame") + 1, again.number("frame"), last);
            assertTrue(again.number("tick") >= before.number("tick") + 120, last);
        }
    }

    private void aDoubleClickHasTheCameraFollow() throws IOException, InterruptedException {
        moveTo(512, 340);
        doubleClick();
        await("the camera to follow", seen -> seen.flag("followed"));
        settle();
        look("followed");
        Seen beside = now();
        type("key", "u");
        Seen passed = await("30 ticks", seen -> seen.number("tick") > beside.number("tick") + 30);
        assertEquals(0, aroundBy(beside, passed), 0.05, "it only follows: " + last);
        Seen mounted = now();
        boolean turns = false;
        // a second click that comes late is a single one: then it only follows, or stands
        for (int tries = 0; tries < 8 && !turns; tries++) {
            if (!now().flag("followed")) {
                type("key", "Home");
                settle();
            }
            moveTo(512, 340); // wherever the box is now, it is in the middle
            doubleClick();
            mounted = now();
            type("key", "u");
            // by ticks: how many frames they are depends on the driver
            double end = mounted.number("tick") + 120;
            for (Seen seen = mounted; seen.flag("followed") && !turns; seen = now()) {
                turns = Math.abs(aroundBy(mounted, seen)) > 0.2;
                if (seen.number("tick") > end) {
                    break;
                }
            }
        }
        assertTrue(turns, "it turns with it: " + last);
        settle();
        look("riding");
        doubleClick();
        await("the camera to stand still", seen -> !seen.flag("followed"));
        type("key", "r", "Home");
        double ridden = mounted.number("tick");
        await("the stack as at first", seen -> seen.number("tick") < ridden);
    }

    /** By how much the camera's heading about the stack, which stands at the middle, differs. */
    private static double aroundBy(Seen before, Seen after) {
        double was = Math.atan2(before.number("eyeX"), before.number("eyeZ"));
        double is = Math.atan2(after.number("eyeX"), after.number("eyeZ"));
        return Math.IEEEremainder(is - was, 2 * Math.PI);
    }

    private void doubleClick() throws IOException, InterruptedException {
        type("click", "--repeat", "2", "--delay", "60", "1");
        settle();
    }

    private void theSpeedReadsAsPeopleSayIt() throws IOException, InterruptedException {
        type("key", "bracketleft", "bracketleft");
        long end = System.nanoTime() + 20_000_000_000L;
        while (!title().contains(" - 1/4x, ") && System.nanoTime() < end) {
            now();
        }
        assertTrue(title().contains(" - 1/4x, "), title());
        settle();
        look("slow-motion");
        type("key", "backslash");
    }

    /** White over what is behind it: the pixels of both arms differ from those between them. */
    private void theCrossOfMouseLookHasBothArms() throws IOException, InterruptedException {
        type("key", "p");
        await("the pause", seen -> seen.flag("paused"));
        settle();
        BufferedImage without = screen();
        type("key", "Tab");
        settle();
        settle();
        look("mouse-look");
        BufferedImage with = screen();
        int x = 512;
        int y = 320;
        for (int[] arm : new int[][] {{8, 0}, {-8, 0}, {0, 8}, {0, -8}}) {
            assertTrue(
                    brighter(without, with, x + arm[0], y + arm[1]),
                    "no arm at " + arm[0] + ", " + arm[1]);
        }
        assertFalse(brighter(without, with, x + 8, y + 8), "a box, no cross");
        type("key", "Tab");
        type("key", "p");
        await("to go on", seen -> !seen.flag("paused"));
    }

    /** Whether one of the pixels around a place has become brighter. */
    private static boolean brighter(BufferedImage before, BufferedImage after, int x, int y) {
        for (int dx = -1; dx <= 1; dx++) {
            for (int dy = -1; dy <= 1; dy++) {
                int green = after.getRGB(x + dx, y + dy) >> 8 & 255;
                if (green > (before.getRGB(x + dx, y + dy) >> 8 & 255) + 20) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Keys that a keyboard of another language or of a laptop has. */
    private void aKeyWithoutANameIsToldAndTakesNothing() throws IOException, InterruptedException {
        click("Keys");
        await("the keys", seen -> seen.values().containsKey("sinkX"));
        for (String key : new String[] {"hebrew_shin", "U1F642", "XF86AudioPlay"}) {
            click("sink");
            settle(); // a key that comes before the click is drawn is not for it
            type("key", key);
            await(key + " to be told", seen -> seen.values().containsKey("NoticeX"));
            settle();
            look("key-" + key);
            type("key", "Escape");
            settle();
            assertEquals("Q", now().values().get("sinkKeys"), key + ": " + last);
        }
        assertEquals(0, now().number("shortened"), last);
        click("sink");
        settle();
        moveTo(512, 340);
        type("click", "5");
        await("the wheel", seen -> seen.is("sinkKeys", "Wheel_down"));
    }

    private void aMoveOfTheMouseIsTakenOnlyWhereItIsAskedFor()
            throws IOException, InterruptedException {
        click("fly right");
        await("the ways of the mouse", seen -> seen.values().containsKey("Mouse_downX"));
        moveTo(600, 440);
        moveTo(600, 200);
        settle();
        assertEquals("D", now().values().get("rightKeys"), "moved by accident: " + last);
        look("key-moves");
        assertEquals(0, now().number("shortened"), last);
        click(MouseMove.DOWN.label());
        await("a move for it", seen -> seen.is("rightKeys", "Mouse_down"));
        await("that to be kept", seen -> kept("fly right = MOUSE_MOVE_DOWN"));
        type("key", "p");
        await("the pause: no key is waited for", seen -> seen.flag("paused"));
        type("key", "p");
        await("to go on", seen -> !seen.flag("paused"));

        moveTo(600, 200);
        settle();
        Seen left = now();
        moveTo(600, 440); // five steps of 48 points, a tenth of a second each
        await("the camera to fly", seen -> seen.number("eyeX") > left.number("eyeX") + 0.1);
        settle();
        Seen right = now();
        moveTo(600, 200);
        settle();
        assertEquals(right.number("eyeX"), now().number("eyeX"), 1e-6, "up is nobody's: " + last);
        type("key", "Tab");
        settle();
        type("mousemove_relative", "0", "100");
        settle();
        assertEquals(right.number("eyeX"), now().number("eyeX"), 1e-6, "the view's: " + last);
        type("key", "Tab", "Home");
        settle();

        click("fly left");
        settle();
        click(MouseMove.DOWN.label());
        await("the conflict", seen -> seen.values().containsKey("Leave_itX"));
        settle();
        look("key-move-conflict");
        assertEquals("Mouse_down", now().values().get("rightKeys"), last);
        click(KeyRows.LEAVE);
        settle();
    }

    private void aTakenKeyComesBackByReset() throws IOException, InterruptedException {
        click("sink");
        settle(); // a key that comes before the click is drawn is not for it
        type("key", "F1");
        await("the conflict", seen -> seen.values().containsKey("Take_itX"));
        settle();
        look("key-conflict");
        assertEquals(0, now().number("shortened"), last);
        click(KeyRows.TAKE);
        await("F1 to sink", seen -> seen.is("sinkKeys", "F1") && seen.is("listKeys", ""));
        type("key", "F1");
        settle();
        assertFalse(now().flag("help"), "F1 lists no keys any more: " + last);
        await("it to be kept", seen -> kept("sink = F1"));
        // The list is longer than its panel: the last row is below the edge.
        moveTo(880, 500);
        for (int i = 0; i < 40; i++) {
            type("click", "5");
        }
        settle();
        look("keys-reset");
        assertEquals(0, now().number("shortened"), last);
        click(KeyRows.RESET);
        await("all as at first", seen -> seen.is("sinkKeys", "Q") && seen.is("listKeys", "F1"));
        await("that to be kept, too", seen -> !kept("sink = F1") && !kept("MOUSE_MOVE"));
    }

    private boolean kept(String line) {
        try {
            return Files.exists(keys()) && Files.readString(keys()).contains(line);
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }
}
