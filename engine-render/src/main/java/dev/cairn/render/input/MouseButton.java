package dev.cairn.render.input;

import org.jspecify.annotations.Nullable;

/** A mouse button that a function can be bound to. */
public enum MouseButton implements Trigger {
    /** The primary button. */
    LEFT,
    /** The secondary button. */
    RIGHT,
    /** The wheel as a button. */
    MIDDLE,
    /** The fourth button, often "back". */
    BUTTON_4,
    /** The fifth button, often "forward". */
    BUTTON_5,
    /** The sixth button. */
    BUTTON_6,
    /** The seventh button. */
    BUTTON_7,
    /** The eighth button. */
    BUTTON_8;

    static final String PREFIX = "MOUSE_";

    private static final MouseButton[] ALL = values();

    /** The button of that constant name, or null. */
    static @Nullable MouseButton named(String name) {
        for (MouseButton button : ALL) {
            if (button.name().equals(name)) {
                return button;
            }
        }
        return null;
    }

    @Override
    public String label() {
        return switch (this) {
            case LEFT -> "Left button";
            case RIGHT -> "Right button";
            case MIDDLE -> "Middle button";
            default -> "Button " + name().substring(name().length() - 1);
        };
    }

    @Override
    public String id() {
        return PREFIX + name();
    }

    /**
     * The button of GLFW's number.
     *
     * @param code 0 = left, 1 = right, 2 = middle, up to 7
     * @return the button
     */
    public static MouseButton ofCode(int code) {
        if (code < 0 || code >= ALL.length) {
            throw new IllegalArgumentException(
                    "mouse button code is " + code + ", expected 0.." + (ALL.length - 1));
        }
        return ALL[code];
    }
}
