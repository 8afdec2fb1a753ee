package dev.cairn.render.input;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

class BindingsTest {
    private final Bindings bindings = new Bindings();
    private final List<String> ran = new ArrayList<>();

    @Test
    void everyKeyAndButtonCanBeBound() {
        for (Key key : Key.values()) {
            bindings.onKey(key, "key " + key, () -> ran.add(key.name()));
            assertSame(key, Key.ofCode(key.code()));
        }
        for (MouseButton button : MouseButton.values()) {
            bindings.onButton(button, "button " + button, () -> ran.add(button.name()));
        }
        for (Key key : Key.values()) {
            bindings.press(key);
        }
        for (MouseButton button : MouseButton.values()) {
            bindings.press(button);
        }
        assertEquals(Key.values().length + MouseButton.values().length, ran.size());
        assertEquals(Key.values().length + MouseButton.values().length, bindings.actions().size());
        assertNull(Key.ofCode(-1));
        assertNull(Key.ofCode(33));
    }

    @Test
    void rebindingMovesTheActionToItsNewKey() {
        bindings.onKey(Key.P, "pause", () -> ran.add("pause"))
                .onKey(Key.SPACE, "pause", () -> ran.add("pause"));
        bindings.press(Key.P);
        bindings.press(Key.SPACE);
        assertEquals(List.of("pause", "pause"), ran);
        bindings.rebind("pause", Key.F5);
        bindings.press(Key.P);
        bindings.press(Key.SPACE);
        assertEquals(2, ran.size());
        bindings.press(Key.F5);
        assertEquals(3, ran.size());
        assertArrayEquals(new Key[] {Key.F5}, bindings.keys("pause"));
        bindings.rebind("pause", MouseButton.MIDDLE);
        bindings.press(Key.F5);
        bindings.press(MouseButton.MIDDLE);
        assertEquals(4, ran.size());
    }

    @Test
    void laterBindingTakesTheKey() {
        bindings.onKey(Key.P, "pause", () -> ran.add("pause"))
                .onKey(Key.P, "punch", () -> ran.add("punch"));
        bindings.press(Key.P);
        assertEquals(List.of("punch"), ran);
        bindings.onKey(Key.P, "punch", () -> ran.add("kick"));
        bindings.press(Key.P);
        assertEquals(List.of("punch", "kick"), ran);
        bindings.unbind("punch");
        bindings.press(Key.P);
        assertEquals(2, ran.size());
        assertEquals(List.of(new Bindings.Binding("pause", List.of(), "")), bindings.actions());
    }

    @Test
    void actionsMayBindWhileTheyRun() {
        bindings.onKey(
                Key.A, "first", () -> bindings.onKey(Key.A, "second", () -> ran.add("second")));
        bindings.press(Key.A);
        bindings.press(Key.A);
        assertEquals(List.of("second"), ran);
    }

    @Test
    void heldKeysAreKnownUntilTheyGoUp() {
        bindings.onHold(Key.W, "forward").onButton(MouseButton.LEFT, "fire", () -> {});
        bindings.press(Key.W);
        bindings.press(MouseButton.LEFT);
        assertTrue(bindings.isDown(Key.W) && bindings.isHeld("forward") && bindings.isHeld("fire"));
        bindings.release(Key.W);
        assertFalse(bindings.isDown(Key.W) || bindings.isHeld("forward"));
        bindings.releaseAll();
        assertFalse(bindings.isDown(MouseButton.LEFT) || bindings.isHeld("fire"));
    }

    @Test
    void wheelTurns() {
        bindings.onScroll("zoom", steps -> ran.add("zoom " + steps));
        bindings.scroll(-2);
        assertEquals(List.of("zoom -2.0"), ran);
    }

    /** Once for each whole step, also where a fine wheel tells parts of one. */
    @Test
    void aWayOfTheWheelIsBoundLikeAKey() {
        bindings.onScroll("zoom", steps -> ran.add("zoom " + steps))
                .onKey(Key.E, "rise", () -> ran.add("rise"))
                .rebind("rise", List.of(Wheel.UP));
        assertEquals("Wheel up", bindings.actions().getFirst().label());
        bindings.scroll(2);
        assertEquals(List.of("rise", "rise"), ran);
        for (double part : new double[] {0.5, 0.25, 0.25, 0.5, -1, 0.75}) {
            bindings.scroll(part);
        }
        assertEquals(List.of("rise", "rise", "rise", "zoom -1.0", "rise"), ran);
        bindings.press(Key.E);
        assertEquals(5, ran.size(), "the key is bound no longer");
    }

    /** Once for each whole step of the way; back and forth is none. */
    @Test
    void aWayOfTheMouseIsBoundLikeAKey() {
        double step = MouseMove.POINTS_PER_STEP;
        bindings.mouse().onMove("aim", (right, down) -> ran.add("aim"));
        bindings.onKey(Key.B, "throw", () -> ran.add("throw"))
                .onKey(Key.E, "rise", () -> ran.add("rise"))
                .rebind("throw", List.of(MouseMove.RIGHT))
                .rebind("rise", List.of(MouseMove.UP, Key.E));
        assertEquals("Mouse up, E", bindings.actions().get(1).label());
        assertEquals(List.of(MouseMove.UP, Key.E), bindings.triggers("rise"));
        bindings.move(2 * step, 0);
        assertEquals(List.of("throw", "throw"), ran);
        bindings.move(0.75 * step, -step);
        assertEquals(List.of("throw", "throw", "rise"), ran);
        for (int shake = 0; shake < 10; shake++) {
            bindings.move(-0.5 * step, 0.5 * step);
            bindings.move(0.5 * step, -0.5 * step);
        }
        assertEquals(3, ran.size(), "it went nowhere");
        bindings.move(-3 * step, 3 * step);
        assertEquals(3, ran.size(), "the other ways are nobody's");
        bindings.mouse().move(0.5, 0.5, step, step);
        assertEquals("aim", ran.getLast(), "who asked for each move is told, whatever is bound");
        bindings.press(Key.E);
        assertEquals(List.of("aim", "rise"), ran.subList(3, 5));
    }

    @Test
    void whatIsHeldIsHeldByWheelAndMouseForOneTick() {
        bindings.onHold(Key.W, "forward").onHold(Key.S, "back");
        bindings.rebind("forward", List.of(MouseMove.LEFT, Wheel.UP));
        bindings.move(-1, 0);
        assertTrue(bindings.isHeld("forward") && !bindings.isHeld("back"));
        bindings.endTick();
        assertFalse(bindings.isHeld("forward"));
        bindings.scroll(0.1);
        assertTrue(bindings.isHeld("forward"));
        bindings.endTick();
        bindings.move(1, 5);
        bindings.scroll(-1);
        assertFalse(bindings.isHeld("forward"), "those are other ways");
    }

    /** A frame of 20 ms: keys and buttons hold for all of it, steps for a tenth of a second. */
    @Test
    void aFrameKnowsForHowLongAnActionIsHeld() {
        bindings.onHold(Key.W, "forward").onHold(Key.E, "rise").onHold(Key.LEFT, "turn left");
        bindings.rebind("forward", List.of(Key.W, MouseButton.MIDDLE))
                .rebind("rise", List.of(Wheel.UP))
                .rebind("turn left", List.of(MouseMove.LEFT, Key.LEFT));
        Held held = new Held();
        held.press(Key.W, true);
        held.press(MouseButton.MIDDLE, true);
        held.press(Key.LEFT, true);
        held.move(-MouseMove.POINTS_PER_STEP, 7);
        held.move(-MouseMove.POINTS_PER_STEP / 2, 7);
        held.scroll(2);
        assertEquals(0.02, held.seconds(bindings, "forward", 0.02), 1e-15, "once, not twice");
        assertEquals(0.02 + 0.15, held.seconds(bindings, "turn left", 0.02), 1e-15);
        assertEquals(0.2, held.seconds(bindings, "rise", 0.02), 1e-15);
        assertEquals(0, held.seconds(bindings, "no such action", 0.02));
        held.endFrame();
        held.press(Key.W, false);
        assertEquals(0.02, held.seconds(bindings, "forward", 0.02), "by the button still");
        assertEquals(0.02, held.seconds(bindings, "turn left", 0.02));
        assertEquals(0, held.seconds(bindings, "rise", 0.02));
        held.move(5, 0);
        held.releaseAll();
        assertEquals(0, held.seconds(bindings, "turn left", 0.02), "the other way");
        assertEquals(0, held.seconds(bindings, "forward", 0.02));
    }

    @Test
    void unknownActionIsNamed() {
        bindings.onKey(Key.P, "pause", () -> {});
        IllegalArgumentException e =
                assertThrows(IllegalArgumentException.class, () -> bindings.rebind("paus", Key.A));
        assertTrue(
                e.getMessage().contains("'paus'") && e.getMessage().contains("[pause]"),
                e.getMessage());
        assertThrows(IllegalArgumentException.class, () -> bindings.onKey(Key.A, " ", () -> {}));
    }

    @Test
    void aChordTakesItsKeyWhileControlIsHeld() {
        bindings.onKey(Key.S, "back", () -> ran.add("back"))
                .onChord(Key.S, "save", () -> ran.add("save"));
        bindings.press(Key.S);
        bindings.release(Key.S);
        bindings.press(Key.LEFT_CONTROL);
        bindings.press(Key.S);
        bindings.release(Key.LEFT_CONTROL);
        bindings.press(Key.S);
        assertEquals(List.of("back", "save", "back"), ran);
    }

    @Test
    void whatIsReboundIsKeptInAFileAndCanBeResetAgain(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("new/keys.txt");
        List<Bindings.Binding> defaults = standard(bindings).actions();
        BindingsFile.save(bindings, file);
        assertFalse(Files.exists(file), "nothing differs");
        bindings.rebind("pause", List.of(Key.F1, new Chord(Key.P), MouseMove.DOWN));
        BindingsFile.save(bindings, file);
        Bindings later = standard(new Bindings());
        assertEquals(List.of(), BindingsFile.load(later, file));
        assertEquals(bindings.actions(), later.actions());
        assertEquals("F1, Ctrl+P, Mouse down", later.actions().get(0).label());
        assertEquals("", later.actions().get(1).label(), "F1 was taken from it");
        assertEquals(defaults, later.reset().actions());

        Files.writeString(file, "# a remark\npause = F99\nnone = A\nhelp = F2\n");
        List<String> remarks = BindingsFile.load(later, file);
        assertEquals(2, remarks.size());
        assertTrue(
                remarks.get(0).contains(":2: \"F99\"") && remarks.get(1).contains(":3: "),
                remarks.toString());
        assertEquals("F2", later.actions().get(1).label(), "what can be used is used");
    }

    private static Bindings standard(Bindings bindings) {
        return bindings.onKey(Key.P, "pause", () -> {})
                .onKey(Key.SPACE, "pause", () -> {})
                .onKey(Key.F1, "help", () -> {})
                .keepAsDefaults();
    }

    @Test
    void everyTriggerIsReadBackByItsId() {
        for (Key key : Key.values()) {
            assertSame(key, Trigger.parse(key.id()));
            assertEquals(
                    new Chord(key), Trigger.parse(new Chord(key).id().toLowerCase(Locale.ROOT)));
        }
        for (MouseButton button : MouseButton.values()) {
            assertSame(button, Trigger.parse(button.id()));
        }
        for (Wheel way : Wheel.values()) {
            assertSame(way, Trigger.parse(way.id()));
        }
        for (MouseMove way : MouseMove.values()) {
            assertSame(way, Trigger.parse(way.id()));
        }
        assertNull(Trigger.parse("F99"));
        assertNull(Trigger.parse("MOUSE_MOVE_SIDEWAYS"));
        assertNull(Trigger.parse("CTRL+"));
    }
}
