package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.window.WindowFixture;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.io.IOException;

/** Handles, several things at once, the clipboard and the floor, in the real window. */
class EditorToolsWindowTest extends WindowFixture {
    @Override
    public boolean pixels() {
        return false;
    }

    @Override
    public Class<?> program() {
        return EditorProbe.class;
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= 1;
    }

    /** One window for all of it: to open one takes longer than what is done in it. */
    @Test
    void handlesGroupsClipboardAndFloor() throws IOException, InterruptedException {
        type("key", "F2");
        await("the editor", seen -> seen.is("mode", "REST") && seen.number("entities") == 1);
        aMessagePushesNoButtonAway();
        click("box");
        await("a box", seen -> seen.number("entities") == 2 && seen.number("seenY") == 0.5);
        settle();
        look("editor-move");
        aFunctionKeyActsFromWithinAField();
        theMiddleButtonTakesTheCameraAroundTheSelection();
        anArrowMovesAlongItsAxisAlone();
        aCircleTurnsInSteps();
        aBarScalesOneAxis();
        severalThingsAreCopiedMovedAndPutDown();
        assertEquals(0, now().number("shortened"), last);
    }

    /** Who has typed a name plays the scene without a click beside the field; the name is kept. */
    private void aFunctionKeyActsFromWithinAField() throws IOException, InterruptedException {
        click("name");
        settle();
        type("type", "x");
        settle();
        double length = now().number("nameLength");
        assertEquals("box".length() + 1, length, last);
        type("key", "F5");
        await("the scene to run", seen -> seen.is("mode", "PLAYING"));
        settle();
        type("key", "F5");
        await("the scene to rest", seen -> seen.is("mode", "REST"));
        settle();
        assertEquals(length, now().number("nameLength"), last);
    }

    private void aMessagePushesNoButtonAway() throws IOException, InterruptedException {
        settle();
        Seen before = now();
        type("key", "Delete");
        await("that nothing is selected", seen -> seen.flag("wrong"));
        settle();
        look("editor-message");
        assertEquals(before.number("boxX"), now().number("boxX"), last);
        assertEquals(before.number("boxY"), now().number("boxY"), last);
        assertEquals(0, now().number("overlapping"), "the message lies over nothing: " + last);
    }

    /** The way a quarter of the picture's height wide is an eighth of a turn; then all way back. */
    private void theMiddleButtonTakesTheCameraAroundTheSelection()
            throws IOException, InterruptedException {
        Seen before = now();
        moveTo(500, 300);
        settle();
        type("mousedown", "2");
        settle();
        moveTo(660, 300);
        settle();
        type("mouseup", "2");
        settle();
        Seen after = now();
        look("editor-orbit");
        Vector3d was = new Vector3d();
        Vector3d is = new Vector3d();
        assertEquals(fromSelected(before, was), fromSelected(after, is), 1e-4, last);
        assertEquals(was.y, is.y, 1e-4, "as high as before: " + last);
        Vector3d level = new Vector3d(was.x, 0, was.z);
        assertEquals(Math.PI / 4, level.angle(new Vector3d(is.x, 0, is.z)), 1e-4, last);
        assertEquals(along(before, was), along(after, is), 1e-4, "at its place: " + last);
        assertEquals(before.number("steps"), after.number("steps"), "no edit: " + last);
        moveTo(660, 300);
        settle();
        type("mousedown", "2");
        settle();
        moveTo(500, 300);
        settle();
        type("mouseup", "2");
        settle();
        assertEquals(before.number("eyeX"), now().number("eyeX"), 1e-4, last);
    }

    /** From the camera to the middle of the box, m. */
    private static double fromSelected(Seen seen, Vector3d dest) {
        return dest.set(
                        seen.number("selectedX") - seen.number("eyeX"),
                        seen.number("selectedY") - seen.number("eyeY"),
                        seen.number("selectedZ") - seen.number("eyeZ"))
                .length();
    }

    private static double along(Seen seen, Vector3d direction) {
        return direction.x * seen.number("aheadX")
                + direction.y * seen.number("aheadY")
                + direction.z * seen.number("aheadZ");
    }

    private void dragHandle(int axis, double right, double down)
            throws IOException, InterruptedException {
        settle();
        Seen seen = now();
        double x = seen.number("handle" + axis + "X");
        double y = seen.number("handle" + axis + "Y");
        moveTo(x, y);
        settle();
        type("mousedown", "1");
        settle();
        moveTo(x + right / 2, y + down / 2);
        settle();
        moveTo(x + right, y + down);
        settle();
        type("mouseup", "1");
        settle();
    }

    private void anArrowMovesAlongItsAxisAlone() throws IOException, InterruptedException {
        Seen before = now();
        dragHandle(1, 0, -80);
        Seen after = now();
        double rise = after.number("selectedY") - before.number("selectedY");
        assertTrue(rise > 0.5, "80 pixels up: " + last);
        assertEquals(0, after.number("selectedY") % 0.25, 1e-9, "on the grid: " + last);
        assertEquals(before.number("selectedX"), after.number("selectedX"), last);
        assertEquals(before.number("selectedZ"), after.number("selectedZ"), last);
        assertEquals(before.number("steps") + 1, after.number("steps"), "one step: " + last);
        type("key", "ctrl+z");
        await("it to be back", seen -> seen.number("selectedY") == before.number("selectedY"));
    }

    private void aCircleTurnsInSteps() throws IOException, InterruptedException {
        type("key", "t");
        await("circles", seen -> seen.is("tool", "TURN"));
        dragHandle(1, -70, 0);
        look("editor-turn");
        double degrees = Math.toDegrees(now().number("turnY"));
        assertTrue(Math.abs(degrees) > 10, last);
        double steps = degrees / 15;
        assertEquals(Math.rint(steps), steps, 1e-3, "in steps of 15 degrees: " + last);
        type("key", "ctrl+z");
        await("it to be back", seen -> Math.abs(seen.number("turnY")) < 1e-9);
    }

    private void aBarScalesOneAxis() throws IOException, InterruptedException {
        click("Scale");
        await("bars", seen -> seen.is("tool", "SCALE"));
        dragHandle(1, 0, -60);
        look("editor-scale");
        Seen after = now();
        assertTrue(after.number("scaleY") > 1.2, last);
        assertEquals(1, after.number("scaleX"), last);
        type("key", "ctrl+z");
        await("it to be back", seen -> seen.number("scaleY") == 1);
        type("key", "t");
        await("arrows", seen -> seen.is("tool", "MOVE"));
    }

    private void severalThingsAreCopiedMovedAndPutDown() throws IOException, InterruptedException {
        type("key", "ctrl+c", "ctrl+v");
        Seen pasted = await("a copy", seen -> seen.number("entities") == 3);
        assertEquals(1.1, pasted.number("selectedX"), 1e-9, last);
        settle();
        moveTo(512, 320); // the first box
        type("keydown", "shift", "click", "1", "keyup", "shift");
        await("both", seen -> seen.number("count") == 2);
        settle();
        look("editor-both");
        for (int i = 0; i < 20; i++) {
            type("click", "4");
        }
        await("both 2 m up", seen -> Math.abs(seen.number("lowestY") - 2.5) < 1e-9);
        type("key", "g");
        await("both on the floor", seen -> seen.number("lowestY") == 0.5);
        type("key", "ctrl+d");
        Seen four = await("two more, selected", seen -> seen.number("entities") == 5);
        assertEquals(2, four.number("count"), last);
        type("key", "Delete");
        await("these to be gone", seen -> seen.number("entities") == 3);
        type("key", "ctrl+z");
        await("them to be back", seen -> seen.number("entities") == 5);
        type("key", "ctrl+a");
        await("all but the floor", seen -> seen.number("count") == 4);
        type("key", "Escape");
        await("nothing", seen -> seen.number("count") == 0 && seen.is("mode", "REST"));
    }
}
