package dev.cairn.render.input;

import java.util.Objects;

/**
 * A key that is pressed while Ctrl is held.
 *
 * @param key which key
 */
public record Chord(Key key) implements Trigger {
    static final String PREFIX = "CTRL+";

    /** Checks the key. */
    public Chord {
        Objects.requireNonNull(key, "key");
    }

    @Override
    public String label() {
        return "Ctrl+" + key.label();
    }

    @Override
    public String id() {
        return PREFIX + key.id();
    }
}
