package dev.cairn.samples;

import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Key;
import dev.cairn.render.ui.Ui;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Locale;

/** Every action with its keys as a field that can be typed into: the keys are rebound at once. */
final class KeyFields {
    private static final int PROBLEM = 0xFF7A7A;

    private final Sandbox sandbox;
    private String problem = "";

    /** The action whose field holds what is no key yet, and what it holds. */
    private String typedAction = "";

    private String typed = "";

    KeyFields(Sandbox sandbox) {
        this.sandbox = sandbox;
    }

    void draw(Ui ui) {
        ui.text("Type the names of keys, such as F6 or LEFT_ALT, with commas between them.");
        if (!problem.isEmpty()) {
            ui.label(problem, PROBLEM);
        }
        List<Bindings.Binding> all = sandbox.keyBindings().actions();
        for (int i = 0; i < all.size(); i++) {
            Bindings.Binding binding = all.get(i);
            boolean unfinished = binding.action().equals(typedAction);
            String shown = unfinished ? typed : binding.triggers();
            String now = ui.textField(binding.action(), shown);
            if (!now.equals(shown)) {
                change(binding.action(), now);
            }
        }
    }

    private void change(String action, String text) {
        Key[] keys = parse(text);
        if (keys == null) {
            typedAction = action;
            typed = text;
            problem = "\"" + text + "\" is no list of keys";
            return;
        }
        typedAction = "";
        problem = "";
        sandbox.post(() -> sandbox.keyBindings().rebind(action, keys));
    }

    /**
     * Reads names of keys.
     *
     * @return the keys, none for an empty text, or null if one is unknown
     */
    static Key @Nullable [] parse(String text) {
        if (text.isBlank()) {
            return new Key[0];
        }
        String[] names = text.split(",", -1);
        Key[] keys = new Key[names.length];
        for (int i = 0; i < names.length; i++) {
            try {
                keys[i] = Key.valueOf(names[i].strip().toUpperCase(Locale.ROOT).replace(' ', '_'));
            } catch (IllegalArgumentException unknown) {
                return null;
            }
        }
        return keys;
    }
}
