package dev.cairn.render.input;

import org.jspecify.annotations.Nullable;

import java.util.Locale;

/**
 * What an action can be bound to: a key, a mouse button, a step of the wheel, a way that the mouse
 * goes, or a key together with Ctrl. Immutable; any thread.
 */
public sealed interface Trigger permits Key, MouseButton, Wheel, MouseMove, Chord {
    /**
     * What a person calls it.
     *
     * @return such as "F1", "Shift", "Ctrl+S", "Right button", "Wheel up", "Mouse up"
     */
    String label();

    /**
     * What a file calls it; {@link #parse} reads it back.
     *
     * @return such as "F1", "LEFT_SHIFT", "CTRL+S", "MOUSE_RIGHT", "WHEEL_UP", "MOUSE_MOVE_UP"
     */
    String id();

    /**
     * Reads what {@link #id} wrote.
     *
     * @param id the text; case and spaces around it do not count
     * @return the trigger, or null if there is none of this name
     */
    static @Nullable Trigger parse(String id) {
        String text = id.strip().toUpperCase(Locale.ROOT);
        if (text.startsWith(Chord.PREFIX)) {
            Key key = Key.named(text.substring(Chord.PREFIX.length()).strip());
            return key == null ? null : new Chord(key);
        }
        for (MouseMove way : MouseMove.values()) {
            if (way.id().equals(text)) {
                return way;
            }
        }
        if (text.startsWith(MouseButton.PREFIX)) {
            return MouseButton.named(text.substring(MouseButton.PREFIX.length()));
        }
        for (Wheel way : Wheel.values()) {
            if (way.id().equals(text)) {
                return way;
            }
        }
        return Key.named(text);
    }
}
