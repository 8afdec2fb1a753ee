package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.editor.files.LeaveQuestion;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.Xyz;
import dev.cairn.samples.window.WindowFixture;
import dev.cairn.samples.window.WindowManager;

import org.junit.jupiter.api.Test;

import java.io.IOException;

/** The editor from end to end, by {@link EditorProbe}. */
class EditorWindowTest extends WindowFixture {
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

    /** Until the floor is built: the camera is the sandbox's until then. */
    private void awaitEditor() throws IOException, InterruptedException {
        await(
                "the editor with a floor at rest",
                seen ->
                        seen.is("mode", "REST")
                                && seen.number("entities") == 1
                                && seen.number("seenY") == -0.5);
    }

    @Test
    void aBoxIsPlacedDraggedRaisedSavedLoadedAndFalls() throws IOException, InterruptedException {
        type("key", "F2");
        awaitEditor();
        click("box");
        Seen placed =
                await(
                        "a box on the floor",
                        seen -> seen.number("entities") == 2 && seen.number("seenY") == 0.5);
        assertEquals(1, placed.number("selected"), last);
        assertEquals(0, placed.number("selectedX"), last);

        moveTo(512, 40);
        type("click", "1");
        await("nothing to be selected by a click on the sky", seen -> seen.number("selected") < 0);
        // The camera's axis meets the floor under the box, so the middle of the picture shows it.
        moveTo(512, 320);
        type("mousedown", "1");
        await("the box to be taken", seen -> seen.number("selected") == 1);
        moveTo(600, 320);
        Seen dragged = await("the box to follow", seen -> seen.number("selectedX") > 1);
        type("mouseup", "1");
        assertEquals(0.5, dragged.number("selectedY"), "over the ground: " + last);
        assertEquals(2, dragged.number("steps"), "a drag is one step: " + last);
        type("key", "ctrl+z");
        await("the drag to be taken back", seen -> seen.number("selectedX") == 0);
        type("key", "ctrl+y");
        await(
                "the drag to be done again",
                seen -> seen.number("selectedX") == dragged.number("selectedX"));
        for (int i = 0; i < 10; i++) {
            type("click", "4");
        }
        Seen raised =
                await(
                        "the box to hang 1 m above the floor",
                        seen -> seen.number("selectedY") == 1.5 && seen.number("seenY") == 1.5);
        assertEquals(0, raised.number("tick"), "at rest: " + last);

        click("Save");
        await("the file to be saved", seen -> !seen.flag("changed") && !seen.flag("wrong"));
        SceneFile saved = SceneReader.read(folder.resolve("scene.json"));
        EntitySpec box = saved.entities().get(1);
        assertEquals(new Xyz(dragged.number("selectedX"), 1.5, box.position().z()), box.position());
        type("key", "Delete");
        await("the box to be gone", seen -> seen.number("entities") == 1);
        click("Load");
        await("the warning of unsaved changes", seen -> seen.flag("wrong"));
        type("click", "1");
        await(
                "the box to be back",
                seen -> seen.number("entities") == 2 && seen.number("seenY") == 1.5);

        type("key", "F5");
        Seen landed =
                await(
                        "the box to lie on the floor",
                        seen -> seen.number("tick") > 90 && seen.is("mode", "PLAYING"));
        // It fell 1 m and rests on y = 0 with half its height of 0.5 m.
        assertEquals(0.5, landed.number("seenY"), 0.01);
        type("key", "F5");
        await(
                "the scene as it was edited",
                seen -> seen.is("mode", "REST") && seen.number("seenY") == 1.5);
        // The pause key lets time pass, too.
        type("key", "space");
        await("the scene to run", seen -> seen.is("mode", "PLAYING") && seen.number("seenY") < 1.4);
        type("key", "F2");
        Seen closed = await("the sandbox's own scene", seen -> seen.is("mode", "CLOSED"));
        assertTrue(closed.number("entities") == 2, "the editor keeps its scene: " + last);
    }

    /** The floor stays, the way up to a release counts, undo keeps what is selected. */
    @Test
    void nothingIsLostByAStrayClickOrByClosingTheWindow() throws IOException, InterruptedException {
        type("key", "F2");
        awaitEditor();
        moveTo(700, 500);
        dragTo(600, 560);
        settle();
        Seen start = now();
        type("key", "c");
        await("the duplicate to be refused", seen -> seen.flag("wrong"));
        assertEquals(0, now().number("steps"), "the floor was moved: " + last);
        assertEquals(-1, now().number("selected"), last);

        click("box");
        await("a box", seen -> seen.number("entities") == 2 && seen.number("seenY") == 0.5);
        moveTo(512, 320);
        dragTo(600, 320);
        Seen dragged = await("the box to follow", seen -> seen.number("selectedX") > 1);
        assertEquals(2, dragged.number("steps"), last);
        type("key", "ctrl+z");
        await(
                "the drag to be taken back, the box still selected",
                seen -> seen.number("selectedX") == 0 && seen.number("selected") == 1);
        type("key", "Delete");
        await("the box to be gone", seen -> seen.number("entities") == 1);
        type("key", "ctrl+z");
        await("the box to be back, selected", seen -> seen.number("selected") == 1);
        hostileTexts();

        type("key", "f");
        await("the camera to go to the box", seen -> seen.number("eyeZ") < 6);
        settle();
        look("editor-framed");
        type("key", "Home");
        await("the camera to be back", seen -> seen.number("eyeZ") == start.number("eyeZ"));
        type("key", "ctrl+s");
        Seen saved = await("the file", seen -> !seen.flag("changed"));
        assertEquals(2, SceneReader.read(folder.resolve("scene.json")).entities().size());
        assertEquals(start.number("eyeZ"), saved.number("eyeZ"), "the camera flew: " + last);
        assertEquals(0, saved.number("shortened"), last);

        type("key", "Delete");
        await("a change", seen -> seen.flag("changed") && seen.number("entities") == 1);
        type("key", "Escape");
        await("the editor to close", seen -> seen.is("mode", "CLOSED"));
        type("key", "Escape");
        await("the question", seen -> seen.flag("asked"));
        type("key", "Escape");
        await("to stay", seen -> !seen.flag("asked"));
        try (WindowManager manager = manager()) {
            manager.askToClose();
        }
        await("the question again", seen -> seen.values().containsKey("Quit_without_savingX"));
        settle();
        look("leave-question");
        click(LeaveQuestion.GIVE_UP);
        assertEquals(0, ended());
    }

    /** Into the fields of the selected box, whose place is x = 0; all is undone at the end. */
    private void hostileTexts() throws IOException, InterruptedException {
        int steps = (int) now().number("steps");
        click("name");
        settle();
        type("key", "ctrl+a");
        type("type", "--delay", "1", "x".repeat(300));
        await("a long name", seen -> seen.number("nameLength") == 300);
        type("key", "Return");
        click("position x");
        settle();
        for (String none : new String[] {"1e999", "NaN", "1-1"}) {
            type("key", "ctrl+a");
            // a number on the way, as the 1 of 1-1, counts if a frame sees it: so each begins at 0
            type("key", "0");
            await("the field at 0", seen -> seen.number("selectedX") == 0);
            type("key", "BackSpace");
            settle();
            for (char c : none.toCharArray()) {
                type("type", String.valueOf(c));
            }
            settle();
            double x = now().number("selectedX");
            assertTrue(x == 0 || x == 1 || x == 1e9 || x == 1e99, none + ": " + last);
        }
        type("key", "ctrl+a");
        type("key", "0");
        await("the field at 0", seen -> seen.number("selectedX") == 0);
        type("type", "--delay", "1", "x10");
        settle();
        look("editor-hostile");
        assertEquals(0, now().number("selectedX"), last);
        type("key", "ctrl+a");
        type("type", "--delay", "1", "2,5");
        await("a comma to be a point", seen -> seen.number("selectedX") == 2.5);
        // Undo reaches the scene from within the field.
        for (int i = 0; i < 20 && now().number("steps") > steps; i++) {
            type("key", "ctrl+z");
            settle();
        }
        assertEquals(3, now().number("nameLength"), last);
        assertEquals(0, now().number("selectedX"), last);
        type("key", "Return");
    }

    /** A pendulum by mouse alone; its length stays what it was when it was placed. */
    @Test
    void aBoxIsHungOnTheWorldAndSwings() throws IOException, InterruptedException {
        type("key", "F2");
        awaitEditor();
        click("box");
        await("a box", seen -> seen.number("entities") == 2 && seen.number("bodyY") == 0.5);
        moveTo(512, 320); // the wheel over a panel is the panel's
        for (int i = 0; i < 30; i++) {
            type("click", "4");
        }
        await("the box 3 m up", seen -> seen.number("bodyY") == 3.5);
        click("New joint");
        await("the section", seen -> seen.values().containsKey("To_the_world...X"));
        settle();
        click("To the world...");
        await("a click to be awaited", seen -> seen.is("awaited", "WORLD"));
        type("key", "Escape");
        await("to have given it up", seen -> seen.is("awaited", "NONE"));
        assertEquals(1, now().number("selected"), last);
        click("To the world...");
        await("a click to be awaited", seen -> seen.is("awaited", "WORLD"));
        moveTo(640, 60); // the sky, right above
        type("click", "1");
        Seen placed =
                await(
                        "the joint and its anchor",
                        seen -> seen.number("joints") == 1 && seen.number("entities") == 3);
        assertEquals(0, placed.number("joint"), "it is selected: " + last);
        settle();
        look("editor-joint-placed");
        click("twist about x");
        await("its fields", seen -> seen.values().containsKey("twist:_a_motorX"));
        awaitNoGarbage("a joint is selected");

        click("Save");
        await("the file", seen -> !seen.flag("changed") && !seen.flag("wrong"));
        SceneFile saved = SceneReader.read(folder.resolve("scene.json"));
        Xyz anchor = saved.joints().get(0).place().anchorA();
        double length = Math.hypot(anchor.x(), anchor.y() - 3.5);
        assertTrue(length > 0.5, "from " + anchor);
        type("key", "F5");
        Seen swung =
                await(
                        "it to swing",
                        seen -> seen.is("mode", "PLAYING") && seen.number("tick") > 60);
        double now =
                Math.hypot(swung.number("bodyX") - anchor.x(), swung.number("bodyY") - anchor.y());
        assertEquals(length, now, 1e-5, last);
        assertTrue(Math.abs(swung.number("bodyX")) > 0.01, "it moves: " + last);
        type("key", "F5");
        await("the scene at rest", seen -> seen.is("mode", "REST") && seen.number("bodyY") == 3.5);
        type("key", "Delete");
        await("the joint to be gone", seen -> seen.number("joints") == 0);
        type("key", "ctrl+z");
        await("it to be back, selected", seen -> seen.number("joint") == 0);
    }

    /** With what is selected, its fields and its outline, and while the scene runs. */
    @Test
    void aSteadyEditorMakesNoGarbage() throws IOException, InterruptedException {
        type("key", "F2");
        awaitEditor();
        awaitNoGarbage("nothing is selected");
        int entities = 1;
        for (String shape : new String[] {"box", "capsule", "hull", "half-space"}) {
            click(shape);
            int wanted = ++entities;
            await(shape, seen -> seen.number("entities") == wanted);
            awaitNoGarbage(shape);
        }
        type("key", "F5");
        Seen started = await("the scene to run", seen -> seen.is("mode", "PLAYING"));
        // Its world is built on the other thread; frames go on meanwhile.
        await("ticks", seen -> seen.number("tick") > started.number("tick"));
        awaitNoGarbage("the scene runs");
    }
}
