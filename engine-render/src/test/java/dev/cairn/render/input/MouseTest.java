package dev.cairn.render.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** The mouse as the simulation sees it. */
class MouseTest {
    private final Bindings bindings = new Bindings();
    private final Mouse mouse = bindings.mouse();
    private final List<String> told = new ArrayList<>();

    @Test
    void movesAddUpUntilATickHasSeenThem() {
        mouse.move(0.25, 0.5, 3, -1);
        mouse.move(0.5, 0.75, 4, 2);
        assertEquals(0.5, mouse.x());
        assertEquals(0.75, mouse.y());
        assertEquals(7, mouse.movedRight());
        assertEquals(1, mouse.movedDown());
        bindings.endTick();
        assertEquals(0, mouse.movedRight());
        assertEquals(0, mouse.movedDown());
        assertEquals(0.5, mouse.x());
    }

    @Test
    void functionsAreToldByName() {
        mouse.onMove("aim", (right, down) -> told.add("old"))
                .onMove("steer", (right, down) -> told.add("steer " + right))
                .onMove("aim", (right, down) -> told.add("aim " + down));
        mouse.move(0, 0, 1, 2);
        assertEquals(List.of("aim 2.0", "steer 1.0"), told);
        assertTrue(mouse.forget("aim"));
        assertFalse(mouse.forget("aim"));
        mouse.move(0, 0, 5, 6);
        assertEquals(List.of("aim 2.0", "steer 1.0", "steer 5.0"), told);
        assertThrows(NullPointerException.class, () -> mouse.onMove(null, (right, down) -> {}));
    }

    /** A slow frame holds a whole double click. */
    @Test
    void aFrameKnowsHowOftenAButtonWentDown() {
        Pointer pointer = new Pointer();
        pointer.nextFrame();
        for (int click = 0; click < 2; click++) {
            pointer.button(MouseButton.LEFT, true);
            pointer.button(MouseButton.LEFT, false);
        }
        assertEquals(2, pointer.presses(MouseButton.LEFT));
        assertEquals(0, pointer.presses(MouseButton.RIGHT));
        assertTrue(pointer.wasPressed(MouseButton.LEFT));
        assertFalse(pointer.isDown(MouseButton.LEFT));
        pointer.nextFrame();
        assertEquals(0, pointer.presses(MouseButton.LEFT));
        assertFalse(pointer.wasPressed(MouseButton.LEFT));
    }
}
