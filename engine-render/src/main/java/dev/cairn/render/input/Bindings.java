package dev.cairn.render.input;

import org.jspecify.annotations.Nullable;

import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.DoubleConsumer;

/**
 * Which function runs for which key, mouse button, step of the wheel or move of the mouse. A
 * function has a name, the <em>action</em>; triggers are bound to actions and can be rebound while
 * the program runs. One trigger fires one action (a later binding takes the trigger away from an
 * earlier one); one action may have several triggers.
 *
 * <p>Functions run on the simulation thread, before the tick that follows the press, also while the
 * physics is paused; so they may touch the world freely. Bind and rebind there too (in {@code
 * initScene}, {@code update}, or a bound function), or before the application starts. The look-ups
 * {@link #keys}, {@link #triggers} and {@link #actions} may be called from any thread.
 */
public final class Bindings {
    private final Map<String, Runnable> functions = new LinkedHashMap<>();
    private final Map<String, DoubleConsumer> scrolls = new LinkedHashMap<>();
    private final Mouse mouse = new Mouse();
    private final TriggerTable table = new TriggerTable();
    private final Steps wheel = new Steps();
    private final Steps across = new Steps();
    private final Steps down = new Steps();

    /** The ways that wheel and mouse have gone since the last tick. */
    private final EnumSet<Wheel> turned = EnumSet.noneOf(Wheel.class);

    private final EnumSet<MouseMove> moved = EnumSet.noneOf(MouseMove.class);

    private final EnumSet<Key> downKeys = EnumSet.noneOf(Key.class);
    private final EnumSet<MouseButton> downButtons = EnumSet.noneOf(MouseButton.class);
    private final EnumSet<Key> pressedKeys = EnumSet.noneOf(Key.class);
    private final EnumSet<MouseButton> pressedButtons = EnumSet.noneOf(MouseButton.class);
    private EnumSet<Key> reserved = EnumSet.noneOf(Key.class);

    /**
     * One action and what triggers it, for a help text.
     *
     * @param action its name
     * @param triggers what starts it; empty if nothing does
     * @param label the names of the triggers, joined by ", "
     */
    public record Binding(String action, List<Trigger> triggers, String label) {
        /** Copies the list. */
        public Binding {
            triggers = List.copyOf(triggers);
        }
    }

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
        return on(Objects.requireNonNull(key, "key"), action, function);
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
        return on(Objects.requireNonNull(button, "button"), action, function);
    }

    /**
     * Binds a key together with Ctrl: the function runs once for each press of the key while a Ctrl
     * key is held. A key whose chord is bound does, with Ctrl, nothing else.
     *
     * @param key which key
     * @param action name of the action; if it exists, it gets this function and the chord is added
     *     to its triggers
     * @param function what to run, on the simulation thread
     * @return this
     */
    public Bindings onChord(Key key, String action, Runnable function) {
        return on(new Chord(key), action, function);
    }

    private Bindings on(Trigger trigger, String action, Runnable function) {
        functions.put(checkAction(action), Objects.requireNonNull(function, "function"));
        table.bind(trigger, action);
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
     * Where the mouse is and how it moves, for {@code update} and for functions of its own.
     *
     * @return the same object each time; simulation thread
     */
    public Mouse mouse() {
        return mouse;
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
        return rebind(action, List.of(keys));
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
        return rebind(action, List.of(buttons));
    }

    /**
     * Gives an action other triggers in place of all that it has. A trigger of another action is
     * taken from that one; {@link #actions} tells beforehand whose it is.
     *
     * @param action an action that was bound before
     * @param triggers what starts it from now on; none = nothing does
     * @return this
     * @throws IllegalArgumentException if there is no such action
     */
    public Bindings rebind(String action, List<? extends Trigger> triggers) {
        List<Trigger> wanted = List.copyOf(triggers);
        clearTriggers(action);
        for (Trigger trigger : wanted) {
            table.bind(trigger, action);
        }
        refresh();
        return this;
    }

    /**
     * Keeps the present triggers as those that {@link #reset} goes back to. The application does
     * this once its first scene is made.
     *
     * @return this
     */
    public Bindings keepAsDefaults() {
        table.keepAsDefaults();
        return this;
    }

    /**
     * Gives every action the triggers that were kept by {@link #keepAsDefaults}, or none.
     *
     * @return this
     */
    public Bindings reset() {
        table.reset(functions.keySet());
        refresh();
        return this;
    }

    /** The triggers that were kept for an action. */
    List<Trigger> defaultsOf(String action) {
        return table.defaultsOf(action);
    }

    /** The triggers of an action, reserved ones too. */
    List<Trigger> triggersOf(String action) {
        return table.allOf(action);
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
        table.clear(action);
        refresh();
        return this;
    }

    /**
     * All actions with their triggers, in the order in which they were first bound.
     *
     * @return an immutable list; any thread
     */
    public List<Binding> actions() {
        return table.listed();
    }

    /**
     * The keys of an action.
     *
     * @param action its name
     * @return the keys, empty if it has none; do not change the array; any thread, no allocation
     */
    public Key[] keys(String action) {
        return table.keys(action);
    }

    /**
     * All triggers of an action.
     *
     * @param action its name
     * @return an immutable list, empty if it has none; any thread, no allocation
     */
    public List<Trigger> triggers(String action) {
        return table.triggers(action);
    }

    /**
     * Whether a key starts or holds an action.
     *
     * @param key which key
     * @return true if so; any thread
     */
    public boolean isBound(Key key) {
        for (Binding binding : actions()) {
            if (binding.triggers().contains(key)) {
                return true;
            }
        }
        return false;
    }

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
        turned.clear();
        moved.clear();
        mouse.endTick();
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
     * Whether any trigger of an action is down, as of the tick's input. A way of the wheel or of
     * the mouse is so for the tick that follows.
     *
     * @param action its name
     * @return true while one is held; simulation thread
     */
    public boolean isHeld(String action) {
        List<Trigger> triggers = triggers(action);
        for (int i = 0; i < triggers.size(); i++) {
            Trigger trigger = triggers.get(i);
            if (downKeys.contains(trigger)
                    || downButtons.contains(trigger)
                    || turned.contains(trigger)
                    || moved.contains(trigger)) {
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
            boolean control =
                    downKeys.contains(Key.LEFT_CONTROL) || downKeys.contains(Key.RIGHT_CONTROL);
            String chord = control ? table.actionOf(new Chord(key)) : null;
            run(chord == null ? table.actionOf(key) : chord);
        }
    }

    /**
     * What the window does when a key goes down together with Ctrl while a text is edited. Runs the
     * bound function.
     *
     * @param chord which
     */
    public void press(Chord chord) {
        run(table.actionOf(chord));
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
        run(table.actionOf(button));
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
     * What the window does when the wheel turns. A way that an action is bound to is that action's,
     * once for each whole step, and of {@link #onScroll} no longer.
     *
     * @param steps positive away from the user
     */
    public void scroll(double steps) {
        Wheel way = Wheel.of(steps);
        if (table.actionOf(way) != null) {
            turned.add(way);
            run(way, wheel.add(steps));
            return;
        }
        for (DoubleConsumer function : scrolls.values()) {
            function.accept(steps);
        }
    }

    /**
     * What the window does when the mouse moves and does not turn the view. A way that an action is
     * bound to starts it once for each {@link MouseMove#POINTS_PER_STEP}; {@link Mouse#onMove} is
     * told by {@link Mouse#move}, whatever is bound.
     *
     * @param right how far, points of the screen
     * @param downwards how far, points of the screen
     */
    public void move(double right, double downwards) {
        go(right > 0 ? MouseMove.RIGHT : MouseMove.LEFT, across, right);
        go(downwards > 0 ? MouseMove.DOWN : MouseMove.UP, down, downwards);
    }

    private void go(MouseMove way, Steps counted, double points) {
        if (points != 0) {
            moved.add(way);
            run(way, counted.add(points / MouseMove.POINTS_PER_STEP));
        }
    }

    private void run(Trigger way, int steps) {
        for (int i = 0; i < steps; i++) {
            run(table.actionOf(way));
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
        table.clear(action);
    }

    private static String checkAction(String action) {
        if (action.isBlank()) {
            throw new IllegalArgumentException("action is '" + action + "', expected a name");
        }
        return action;
    }

    private void refresh() {
        table.list(functions.keySet(), reserved);
    }

    @Override
    public String toString() {
        return "Bindings" + actions();
    }
}
