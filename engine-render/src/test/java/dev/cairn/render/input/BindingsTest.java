package dev.cairn.render.input;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

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
        assertEquals(List.of(new Bindings.Binding("pause", "")), bindings.actions());
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
}
