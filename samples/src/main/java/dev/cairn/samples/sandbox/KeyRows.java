package dev.cairn.samples.sandbox;

import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.BindingsFile;
import dev.cairn.render.input.MouseMove;
import dev.cairn.render.input.Trigger;
import dev.cairn.render.ui.Ui;

import org.jspecify.annotations.Nullable;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Every action with its keys as a button: press it, then the new key. A mouse is always moved, so
 * its ways are buttons below the action that waits. A key that does something else already is taken
 * from it only after a second click. Window thread; changes are posted.
 */
final class KeyRows {
    static final String RESET = "All keys as at first";
    static final String TAKE = "Take it";
    static final String LEAVE = "Leave it";

    private static final MouseMove[] WAYS = MouseMove.values();
    private static final String FILE_NAME = "sandbox-keys.txt";
    private static final int PROBLEM = 0xFF7A7A;

    private final Sandbox sandbox;

    /** The action that waits for a key, or empty. */
    private String waiting = "";

    private @Nullable Conflict conflict;

    /** A key that was pressed for an action and belongs to another. */
    private record Conflict(String action, Trigger wanted, String line) {}

    KeyRows(Sandbox sandbox) {
        this.sandbox = sandbox;
    }

    /** Where keys are kept between two starts: the property cairn.keys, or the user's folder. */
    static Path file(@Nullable String property, Map<String, String> environment, String home) {
        if (property != null) {
            return Path.of(property);
        }
        String roaming = environment.get("APPDATA");
        String config = environment.get("XDG_CONFIG_HOME");
        Path folder =
                roaming != null
                        ? Path.of(roaming)
                        : config != null && !config.isEmpty()
                                ? Path.of(config)
                                : Path.of(home, ".config");
        return folder.resolve("cairn").resolve(FILE_NAME);
    }

    private static Path file() {
        return file(
                System.getProperty("cairn.keys"), System.getenv(), System.getProperty("user.home"));
    }

    /** Takes what was kept, once all actions are bound; simulation thread. */
    static void load(Bindings bindings) {
        bindings.keepAsDefaults();
        BindingsFile.load(bindings, file()).forEach(System.err::println);
    }

    private void keep() {
        try {
            BindingsFile.save(sandbox.keyBindings(), file());
        } catch (UncheckedIOException refused) {
            sandbox.notice(String.valueOf(refused.getMessage()));
        }
    }

    void draw(Ui ui) {
        ui.text(
                "Press a button, then a key, Ctrl with a key, a mouse button, the wheel over the"
                        + " scene, or a move below it.");
        Conflict now = conflict;
        if (now != null) {
            ui.label("Already in use:", PROBLEM);
            ui.text(now.line());
            ui.columns(2);
            if (ui.button(TAKE)) {
                rebind(now.action(), now.wanted());
            }
            if (ui.button(LEAVE)) {
                conflict = null;
            }
        }
        List<Bindings.Binding> all = sandbox.keyBindings().actions();
        for (int i = 0; i < all.size(); i++) {
            Bindings.Binding binding = all.get(i);
            boolean waits = binding.action().equals(waiting);
            String label = waits ? "press ... (Esc)" : binding.label();
            if (ui.valueButton(binding.action(), label.isEmpty() ? "none" : label)) {
                conflict = null;
                waiting = binding.action();
                sandbox.captureTrigger(trigger -> pressed(binding.action(), trigger));
            }
            if (waits) {
                offerMoves(ui, binding.action());
            }
        }
        ui.columns(1);
        if (ui.button(RESET)) {
            conflict = null;
            sandbox.post(() -> {
                sandbox.keyBindings().reset();
                keep();
            });
        }
    }

    private void offerMoves(Ui ui, String action) {
        ui.columns(2);
        for (MouseMove way : WAYS) {
            if (ui.button(way.label())) {
                sandbox.captureTrigger(null);
                pressed(action, way);
            }
        }
    }

    private void pressed(String action, @Nullable Trigger trigger) {
        waiting = "";
        if (trigger == null) {
            return;
        }
        for (Bindings.Binding other : sandbox.keyBindings().actions()) {
            if (!other.action().equals(action) && other.triggers().contains(trigger)) {
                conflict =
                        new Conflict(
                                action,
                                trigger,
                                "%s is \"%s\". Shall it be \"%s\" instead?"
                                        .formatted(trigger.label(), other.action(), action));
                return;
            }
        }
        rebind(action, trigger);
    }

    private void rebind(String action, Trigger trigger) {
        conflict = null;
        sandbox.post(() -> {
            sandbox.keyBindings().rebind(action, List.of(trigger));
            keep();
        });
    }
}
