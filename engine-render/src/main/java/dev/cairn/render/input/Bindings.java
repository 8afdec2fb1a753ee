package dev.cairn.render.input;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.DoubleConsumer;

/**
 * Which function runs for which key or mouse button. A function has a name, the <em>action</em>;
 * triggers are bound to actions and can be rebound while the program runs. One trigger fires one
 * action (a later binding takes the trigger away from an earlier one); one action may have several
 * triggers.
 *
 * <p>Functions run on the simulation thread, before the tick that follows the press, also while the
 * physics is paused; so they may touch the world freely. Bind and rebind there too (in {@code
 * initScene}, {@code update}, or a bound function), or before the application starts. The look-ups
 * {@link #keys} and {@link #actions} may be called from any thread.
 */
public final class Bindings {
    private final Map<String, Runnable> functions = new LinkedHashMap<>();
    private final Map<String, DoubleConsumer> scrolls = new LinkedHashMap<>();
    private final Map<Key, String> actionOfKey = new EnumMap<>(Key.class);
    private final Map<MouseButton, String> actionOfButton = new EnumMap<>(MouseButton.class);
    private final EnumSet<Key> downKeys = EnumSet.noneOf(Key.class);
    private final EnumSet<MouseButton> downButtons = EnumSet.noneOf(MouseButton.class);
    private final EnumSet<Key> pressedKeys = EnumSet.noneOf(Key.class);
    private final EnumSet<MouseButton> pressedButtons = EnumSet.noneOf(MouseButton.class);
    private EnumSet<Key> reserved = EnumSet.noneOf(Key.class);
    private volatile Map<String, Key[]> keysOfAction = Map.of();
    private volatile List<Binding> listed = List.of();

    /**
     * One action and what triggers it, for a help text.
     *
     * @param action its name
     * @param triggers the names of its keys and buttons, joined by ", "; empty if it has none
     */
    public record Binding(String action, String triggers) {}

    /** No bindings. */
    public Bindings() {}

    /**
     * Binds a key: the function runs once for each press (not for repeats while it is held).
     *
     * @param key which key
     * @param action name of the action; if it exists, it gets this function and the key is added to
     *     its triggers
     * @param function what to run, on the simulation thread
     * @return this
     */
    public Bindings onKey(Key key, String action, Runnable function) {
        Objects.requireNonNull(key, "key");
        functions.put(checkAction(action), Objects.requireNonNull(function, "function"));
        actionOfKey.put(key, action);
        refresh();
        return this;
    }

    /**
     * Binds a mouse button: the function runs once for each press.
     *
     * @param button which button
     * @param action name of the action; if it exists, it gets this function and the button is added
     *     to its triggers
     * @param function what to run, on the simulation thread
     * @return this
     */
    public Bindings onButton(MouseButton button, String action, Runnable function) {
        Objects.requireNonNull(button, "button");
        functions.put(checkAction(action), Objects.requireNonNull(function, "function"));
        actionOfButton.put(button, action);
        refresh();
        return this;
    }

    /**
     * Names an action that is held rather than pressed, such as a movement: nothing runs, {@link
     * #isHeld} tells.
     *
     * @param key which key
     * @param action name of the action
     * @return this
     */
    public Bindings onHold(Key key, String action) {
        return onKey(key, action, () -> {});
    }

    /**
     * Binds the mouse wheel.
     *
     * @param action name of the action
     * @param function receives the steps, positive away from the user, on the simulation thread
     * @return this
     */
    public Bindings onScroll(String action, DoubleConsumer function) {
        scrolls.put(checkAction(action), Objects.requireNonNull(function, "function"));
        return this;
    }

    /**
     * Gives an action other triggers in place of all that it has.
     *
     * @param action an action that was bound before
     * @param keys the keys that trigger it from now on; none = it has no trigger
     * @return this
     * @throws IllegalArgumentException if there is no such action
     */
    public Bindings rebind(String action, Key... keys) {
        clearTriggers(action);
        for (Key key : keys) {
            actionOfKey.put(Objects.requireNonNull(key, "key"), action);
        }
        refresh();
        return this;
    }

    /**
     * Gives an action mouse buttons in place of all triggers that it has.
     *
     * @param action an action that was bound before
     * @param buttons the buttons that trigger it from now on
     * @return this
     * @throws IllegalArgumentException if there is no such action
     */
    public Bindings rebind(String action, MouseButton... buttons) {
        clearTriggers(action);
        for (MouseButton button : buttons) {
            actionOfButton.put(Objects.requireNonNull(button, "button"), action);
        }
        refresh();
        return this;
    }

    /**
     * Forgets an action and frees its triggers; nothing happens if there is none.
     *
     * @param action its name
     * @return this
     */
    public Bindings unbind(String action) {
        functions.remove(action);
        scrolls.remove(action);
        actionOfKey.values().removeIf(action::equals);
        actionOfButton.values().removeIf(action::equals);
        refresh();
        return this;
    }

    /**
     * All actions with their triggers, in the order in which they were first bound.
     *
     * @return an immutable list; any thread
     */
    public List<Binding> actions() {
        return listed;
    }

    /**
     * The keys of an action.
     *
     * @param action its name
     * @return the keys, empty if it has none; do not change the array; any thread, no allocation
     */
    public Key[] keys(String action) {
        Key[] keys = keysOfAction.get(action);
        return keys == null ? NO_KEYS : keys;
    }

    private static final Key[] NO_KEYS = {};

    /**
     * Whether a key is down, as of the tick's input.
     *
     * @param key which key
     * @return true while it is held; simulation thread
     */
    public boolean isDown(Key key) {
        return downKeys.contains(key);
    }

    /**
     * Whether a mouse button is down, as of the tick's input.
     *
     * @param button which button
     * @return true while it is held; simulation thread
     */
    public boolean isDown(MouseButton button) {
        return downButtons.contains(button);
    }

    /**
     * Whether a key went down since the last tick that was not paused.
     *
     * @param key which key
     * @return true if so, even if it is up again; simulation thread
     */
    public boolean wasPressed(Key key) {
        return pressedKeys.contains(key);
    }

    /**
     * Whether a mouse button went down since the last tick that was not paused.
     *
     * @param button which button
     * @return true if so, even if it is up again; simulation thread
     */
    public boolean wasPressed(MouseButton button) {
        return pressedButtons.contains(button);
    }

    /** What the application does once a tick has seen the presses: they are forgotten. */
    public void endTick() {
        pressedKeys.clear();
        pressedButtons.clear();
    }

    /**
     * Takes keys away from their actions, as a {@link Controllable} does that is in the scene. The
     * actions keep them for the time when they are free again.
     *
     * @param keys all keys that are taken from now on; copied
     */
    public void reserve(Set<Key> keys) {
        if (!reserved.equals(keys)) {
            reserved = EnumSet.noneOf(Key.class);
            reserved.addAll(keys);
            refresh();
        }
    }

    /**
     * Whether any trigger of an action is down, as of the tick's input.
     *
     * @param action its name
     * @return true while one is held; simulation thread
     */
    public boolean isHeld(String action) {
        for (Key key : downKeys) {
            if (!reserved.contains(key) && action.equals(actionOfKey.get(key))) {
                return true;
            }
        }
        for (MouseButton button : downButtons) {
            if (action.equals(actionOfButton.get(button))) {
                return true;
            }
        }
        return false;
    }

    /**
     * What the window does when a key goes down; scripts and tests may call it in its place. Runs
     * the bound function.
     *
     * @param key which key
     */
    public void press(Key key) {
        downKeys.add(key);
        pressedKeys.add(key);
        if (!reserved.contains(key)) {
            run(actionOfKey.get(key));
        }
    }

    /**
     * What the window does when a key goes up.
     *
     * @param key which key
     */
    public void release(Key key) {
        downKeys.remove(key);
    }

    /**
     * What the window does when a mouse button goes down; scripts and tests may call it in its
     * place. Runs the bound function.
     *
     * @param button which button
     */
    public void press(MouseButton button) {
        downButtons.add(button);
        pressedButtons.add(button);
        run(actionOfButton.get(button));
    }

    /**
     * What the window does when a mouse button goes up.
     *
     * @param button which button
     */
    public void release(MouseButton button) {
        downButtons.remove(button);
    }

    /** What the window does when it loses the focus: nothing is held any more. */
    public void releaseAll() {
        downKeys.clear();
        downButtons.clear();
        endTick();
    }

    /**
     * What the window does when the wheel turns.
     *
     * @param steps positive away from the user
     */
    public void scroll(double steps) {
        for (DoubleConsumer function : scrolls.values()) {
            function.accept(steps);
        }
    }

    private void run(@Nullable String action) {
        Runnable function = action == null ? null : functions.get(action);
        if (function != null) {
            function.run();
        }
    }

    private void clearTriggers(String action) {
        if (!functions.containsKey(action)) {
            throw new IllegalArgumentException(
                    "there is no action '"
                            + action
                            + "' to rebind; the actions are "
                            + functions.keySet());
        }
        actionOfKey.values().removeIf(action::equals);
        actionOfButton.values().removeIf(action::equals);
    }

    private static String checkAction(String action) {
        if (action.isBlank()) {
            throw new IllegalArgumentException("action is '" + action + "', expected a name");
        }
        return action;
    }

    private void refresh() {
        Map<String, Key[]> keys = new LinkedHashMap<>();
        List<Binding> list = new ArrayList<>();
        for (String action : functions.keySet()) {
            List<Key> own = new ArrayList<>();
            List<String> names = new ArrayList<>();
            actionOfKey.forEach((key, bound) -> {
                if (bound.equals(action) && !reserved.contains(key)) {
                    own.add(key);
                    names.add(key.name());
                }
            });
            actionOfButton.forEach((button, bound) -> {
                if (bound.equals(action)) {
                    names.add("mouse " + button.name());
                }
            });
            keys.put(action, own.toArray(Key[]::new));
            list.add(new Binding(action, String.join(", ", names)));
        }
        keysOfAction = keys;
        listed = List.copyOf(list);
    }

    @Override
    public String toString() {
        return "Bindings" + Arrays.toString(listed.toArray());
    }
}
