package dev.cairn.render.app;

import static org.lwjgl.glfw.GLFW.GLFW_CURSOR;
import static org.lwjgl.glfw.GLFW.GLFW_CURSOR_DISABLED;
import static org.lwjgl.glfw.GLFW.GLFW_CURSOR_NORMAL;
import static org.lwjgl.glfw.GLFW.GLFW_PRESS;
import static org.lwjgl.glfw.GLFW.GLFW_RAW_MOUSE_MOTION;
import static org.lwjgl.glfw.GLFW.GLFW_RELEASE;
import static org.lwjgl.glfw.GLFW.GLFW_TRUE;
import static org.lwjgl.glfw.GLFW.glfwGetCursorPos;
import static org.lwjgl.glfw.GLFW.glfwRawMouseMotionSupported;
import static org.lwjgl.glfw.GLFW.glfwSetCharCallback;
import static org.lwjgl.glfw.GLFW.glfwSetCursorPosCallback;
import static org.lwjgl.glfw.GLFW.glfwSetDropCallback;
import static org.lwjgl.glfw.GLFW.glfwSetInputMode;
import static org.lwjgl.glfw.GLFW.glfwSetKeyCallback;
import static org.lwjgl.glfw.GLFW.glfwSetMouseButtonCallback;
import static org.lwjgl.glfw.GLFW.glfwSetScrollCallback;
import static org.lwjgl.glfw.GLFW.glfwSetWindowFocusCallback;

import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Chord;
import dev.cairn.render.input.Held;
import dev.cairn.render.input.Key;
import dev.cairn.render.input.MouseButton;
import dev.cairn.render.input.MouseMove;
import dev.cairn.render.input.Pointer;
import dev.cairn.render.input.Trigger;
import dev.cairn.render.input.Wheel;
import dev.cairn.render.ui.nuklear.NuklearUi;

import org.jspecify.annotations.Nullable;
import org.lwjgl.glfw.GLFWDropCallback;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.function.Consumer;

/**
 * What keys and mouse do in a window. GLFW's callbacks only note events; each frame hands them out
 * in order: to the panels first, and what these do not want to the camera and the bindings. A
 * button belongs, from press to release, to whoever was under the cursor at the press.
 *
 * <p>A release that follows its own press in one frame waits for the next, so that a click is seen
 * however slow the frames are. A move that follows a press or a release waits too, so that both
 * happen where the cursor was then, and the way up to a release belongs to its drag.
 */
final class WindowInput {
    static final String FORWARD = "fly forward";
    static final String BACK = "fly back";
    static final String LEFT = "fly left";
    static final String RIGHT = "fly right";
    static final String UP = "rise";
    static final String DOWN = "sink";
    static final String FAST = "fly faster";
    static final String TURN_LEFT = "turn left";
    static final String TURN_RIGHT = "turn right";
    static final String TURN_UP = "turn up";
    static final String TURN_DOWN = "turn down";

    private static final double FAST_FACTOR = 5;
    private static final double TURN_RADIANS_PER_SECOND = 1.2;

    /** As fast as by the functions that turn, bound to the ways of the mouse. */
    private static final double LOOK_RADIANS_PER_PIXEL =
            TURN_RADIANS_PER_SECOND * Held.SECONDS_PER_STEP / MouseMove.POINTS_PER_STEP;

    private static final int SHIFT = 1;
    private static final int CONTROL = 2;
    private static final int REPEAT = 2;

    /** What Ctrl and these mean to a text that is edited; undo is the application's. */
    private static final EnumSet<Key> OF_FIELDS =
            EnumSet.of(Key.A, Key.C, Key.V, Key.X, Key.LEFT, Key.RIGHT);

    private static final byte KEY = 0;
    private static final byte BUTTON = 1;
    private static final byte CURSOR = 2;
    private static final byte WHEEL = 3;
    private static final byte LETTER = 4;
    private static final byte FOCUS = 5;

    private final Application application;
    private final Simulation simulation;
    private final long window;
    private final Camera camera;
    private final Bindings bindings;
    private final Pointer pointer = new Pointer();
    private final Held held = new Held();
    private final EnumSet<MouseButton> ofPanels = EnumSet.noneOf(MouseButton.class);
    private final EnumSet<MouseButton> pressedNow = EnumSet.noneOf(MouseButton.class);
    private byte[] kind = new byte[64];
    private int[] code = new int[64];
    private int[] detail = new int[64];
    private double[] eventX = new double[64];
    private double[] eventY = new double[64];
    private int events;

    /** Whether a button went down or up in this frame. */
    private boolean clicked;

    private List<Path> dropped = List.of();
    private boolean lookButton;
    private boolean captured;
    private final double[] startX = new double[1];
    private final double[] startY = new double[1];
    private double cursorX;
    private double cursorY;

    /** How far the mouse has moved since the simulation was told, points. */
    private double movedX;

    private double movedY;

    /** Of the window, screen coordinates. */
    private double width = 1;

    private double height = 1;

    WindowInput(Application application, Simulation simulation, long window) {
        this.application = application;
        this.simulation = simulation;
        this.window = window;
        this.camera = application.camera();
        this.bindings = application.bindings();
    }

    Pointer pointer() {
        return pointer;
    }

    // GLFW owns the callbacks; GlContext.close frees them.
    @SuppressWarnings("resource")
    void listen() {
        glfwSetKeyCallback(
                window, (w, key, scan, action, mods) -> note(KEY, key, action | mods << 2, 0, 0));
        glfwSetMouseButtonCallback(
                window,
                (w, button, action, mods) -> note(BUTTON, button, action | mods << 2, 0, 0));
        glfwSetScrollCallback(window, (w, x, y) -> note(WHEEL, 0, 0, x, y));
        glfwSetCursorPosCallback(window, (w, x, y) -> note(CURSOR, 0, 0, x, y));
        glfwSetCharCallback(window, (w, letter) -> note(LETTER, letter, 0, 0, 0));
        glfwSetWindowFocusCallback(window, (w, focused) -> note(FOCUS, focused ? 1 : 0, 0, 0, 0));
        glfwSetDropCallback(window, (w, count, names) -> note(count, names));
        glfwGetCursorPos(window, startX, startY);
        cursorX = startX[0];
        cursorY = startY[0];
    }

    /** What is thrown in a callback is told nowhere, and the other files would be lost with it. */
    private void note(int count, long names) {
        List<Path> paths = new ArrayList<>(dropped);
        for (int i = 0; i < count; i++) {
            try {
                paths.add(Path.of(GLFWDropCallback.getName(names, i)));
            } catch (InvalidPathException unnamed) {
                // Java names files in the encoding of the locale, and the C locale has few letters.
                application.notice("A file cannot be named in this locale: " + unnamed.getInput());
            }
        }
        dropped = List.copyOf(paths);
    }

    /** The files that were dropped into the window since the last call. */
    List<Path> takeDropped() {
        List<Path> taken = dropped;
        dropped = List.of();
        return taken;
    }

    private void note(byte what, int which, int how, double x, double y) {
        if (events == kind.length) {
            kind = Arrays.copyOf(kind, 2 * events);
            code = Arrays.copyOf(code, 2 * events);
            detail = Arrays.copyOf(detail, 2 * events);
            eventX = Arrays.copyOf(eventX, 2 * events);
            eventY = Arrays.copyOf(eventY, 2 * events);
        }
        kind[events] = what;
        code[events] = which;
        detail[events] = how;
        eventX[events] = x;
        eventY[events] = y;
        events++;
    }

    /**
     * Hands out the events of a frame.
     *
     * @param panels who gets them first, or null
     * @param widthPoints of the window, screen coordinates
     * @param heightPoints same
     * @param pixelsPerPoint of the picture
     */
    void handOut(
            @Nullable NuklearUi panels,
            double widthPoints,
            double heightPoints,
            double pixelsPerPoint) {
        width = widthPoints;
        height = heightPoints;
        pointer.nextFrame();
        pressedNow.clear();
        captureCursor();
        if (panels != null) {
            panels.input().begin();
        }
        clicked = false;
        int done = 0;
        while (done < events && handle(done, panels, pixelsPerPoint)) {
            done++;
        }
        tellMove(panels);
        keep(done);
        if (panels != null) {
            panels.input().end();
        }
        boolean over = panels != null && panels.wantsMouse();
        pointer.place(cursorX / widthPoints, cursorY / heightPoints, captured, over);
    }

    private void keep(int from) {
        int left = events - from;
        System.arraycopy(kind, from, kind, 0, left);
        System.arraycopy(code, from, code, 0, left);
        System.arraycopy(detail, from, detail, 0, left);
        System.arraycopy(eventX, from, eventX, 0, left);
        System.arraycopy(eventY, from, eventY, 0, left);
        events = left;
    }

    /** False if the event has to wait for the next frame. */
    private boolean handle(int i, @Nullable NuklearUi panels, double pixelsPerPoint) {
        if (panels != null && kind[i] != CURSOR && (kind[i] != KEY || (detail[i] & 3) != REPEAT)) {
            panels.input().stir(); // what it does may show in panels
        }
        switch (kind[i]) {
            case KEY -> key(code[i], detail[i] & 3, detail[i] >> 2, panels);
            case BUTTON -> {
                tellMove(panels); // whoever acts on the press finds the mouse where it was then
                MouseButton button = MouseButton.ofCode(code[i]);
                boolean down = (detail[i] & 3) == GLFW_PRESS;
                if (!down && pressedNow.contains(button)) {
                    return false;
                }
                if (down) {
                    int mods = detail[i] >> 2;
                    pointer.modifiers((mods & SHIFT) != 0, (mods & CONTROL) != 0);
                }
                button(button, down, panels, pixelsPerPoint);
                clicked = true;
            }
            case CURSOR -> {
                if (clicked) {
                    return false;
                }
                look(eventX[i], eventY[i]);
                if (panels != null && !captured) {
                    panels.input().moved(cursorX * pixelsPerPoint, cursorY * pixelsPerPoint);
                }
            }
            case WHEEL -> {
                double steps = eventY[i];
                if (panels != null && !captured && panels.wantsMouse()) {
                    panels.input().scrolled(steps);
                } else if (steps != 0 && !capture(Wheel.of(steps))) {
                    held.scroll(steps);
                    post(() -> bindings.scroll(steps));
                }
            }
            case LETTER -> {
                if (panels != null && panels.wantsKeys()) {
                    panels.input().typed(code[i]);
                }
            }
            default -> {
                if (code[i] == 0) {
                    held.releaseAll();
                    lookButton = false;
                    pointer.releaseAll();
                    post(bindings::releaseAll);
                }
            }
        }
        return true;
    }

    private void key(int keyCode, int action, int mods, @Nullable NuklearUi panels) {
        Key key = Key.ofCode(keyCode);
        if (key == null) {
            if (action == GLFW_PRESS && application.wishes().isCapturing()) {
                application.notice("This key has no name; press another, or Esc");
            }
            return;
        }
        if (captureKey(key, action, mods)) {
            return;
        }
        if (panels != null && (panels.wantsKeys() || action == GLFW_RELEASE)) {
            panels.input().key(key, action != GLFW_RELEASE, (mods & CONTROL) != 0);
        }
        boolean edits = panels != null && panels.wantsKeys();
        if (edits && panels != null && action == GLFW_PRESS) {
            whileEditing(key, (mods & CONTROL) != 0, panels);
        }
        if (action == GLFW_RELEASE) {
            held.press(key, false);
            post(() -> bindings.release(key));
        } else if (action != REPEAT && !edits) {
            if ((mods & CONTROL) == 0 || controlIsBound()) {
                held.press(key, true); // Ctrl+S saves; it does not fly as well.
            }
            post(() -> bindings.press(key));
        }
    }

    /**
     * Keys that are no text: Escape and Enter end it, chords that a field does not know act, and
     * F1, F2, .. do both.
     */
    private void whileEditing(Key key, boolean control, NuklearUi panels) {
        if (key == Key.ESCAPE || key == Key.ENTER || key == Key.KEYPAD_ENTER) {
            panels.endEditing();
        } else if (isFunction(key)) {
            panels.endEditing();
            held.press(key, true);
            post(() -> bindings.press(key));
        } else if (control && !OF_FIELDS.contains(key)) {
            Chord chord = new Chord(key);
            post(() -> bindings.press(chord));
        }
    }

    private static boolean isFunction(Key key) {
        return key.compareTo(Key.F1) >= 0 && key.compareTo(Key.F25) <= 0;
    }

    /** Whether somebody waits for this key, and has it now. Ctrl counts when it goes up alone. */
    private boolean captureKey(Key key, int action, int mods) {
        if (!application.wishes().isCapturing() || action == REPEAT) {
            return false;
        }
        boolean control = key == Key.LEFT_CONTROL || key == Key.RIGHT_CONTROL;
        if (control || action == GLFW_RELEASE) {
            return control && action == GLFW_RELEASE && capture(key);
        }
        Trigger taken = (mods & CONTROL) != 0 ? new Chord(key) : key;
        return capture(key == Key.ESCAPE ? null : taken);
    }

    private boolean capture(@Nullable Trigger taken) {
        Consumer<@Nullable Trigger> taker = application.wishes().takeCapture();
        if (taker == null) {
            return false;
        }
        taker.accept(taken);
        return true;
    }

    /** Whether a Ctrl key is one to fly or to act with, rather than the beginning of a chord. */
    private boolean controlIsBound() {
        return bindings.isBound(Key.LEFT_CONTROL) || bindings.isBound(Key.RIGHT_CONTROL);
    }

    private void button(
            MouseButton button, boolean down, @Nullable NuklearUi panels, double pixelsPerPoint) {
        if (panels != null && !captured) {
            panels.input().button(button, cursorX * pixelsPerPoint, cursorY * pixelsPerPoint, down);
        }
        if (down && button != MouseButton.LEFT && capture(button)) {
            return;
        }
        if (down) {
            pressedNow.add(button);
            if (panels != null && !captured && panels.wantsMouse()) {
                ofPanels.add(button);
                return;
            }
        } else if (ofPanels.remove(button)) {
            return;
        }
        held.press(button, down);
        if (button == MouseButton.RIGHT) {
            lookButton = down;
        }
        pointer.button(button, down);
        post(down ? () -> bindings.press(button) : () -> bindings.release(button));
    }

    private void post(Runnable action) {
        try {
            simulation.post(action);
        } catch (IllegalStateException full) {
            // 65 536 events wait: the scene hangs in update. The window must stay usable, so the
            // event is let go.
            return;
        }
    }

    private void captureCursor() {
        boolean wanted = lookButton || application.wishes().mouseLook;
        if (wanted != captured) {
            captured = wanted;
            glfwSetInputMode(
                    window, GLFW_CURSOR, wanted ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
            if (glfwRawMouseMotionSupported()) {
                glfwSetInputMode(window, GLFW_RAW_MOUSE_MOTION, wanted ? GLFW_TRUE : 0);
            }
            // From here on, moves count from where the cursor is now.
            glfwGetCursorPos(window, startX, startY);
            cursorX = startX[0];
            cursorY = startY[0];
        }
    }

    /** Hands the moves since the last call to the simulation, but for those over a panel. */
    private void tellMove(@Nullable NuklearUi panels) {
        double right = movedX;
        double down = movedY;
        movedX = 0;
        movedY = 0;
        if ((right == 0 && down == 0) || (panels != null && !captured && panels.wantsMouse())) {
            return;
        }
        double toX = captured ? 0.5 : cursorX / width;
        double toY = captured ? 0.5 : cursorY / height;
        post(() -> bindings.mouse().move(toX, toY, right, down));
        if (!captured) {
            held.move(right, down);
            post(() -> bindings.move(right, down));
        }
    }

    private void look(double x, double y) {
        movedX += x - cursorX;
        movedY += y - cursorY;
        if (captured) {
            camera.turn(
                    (x - cursorX) * LOOK_RADIANS_PER_PIXEL, (cursorY - y) * LOOK_RADIANS_PER_PIXEL);
        }
        cursorX = x;
        cursorY = y;
    }

    /** Moves the camera by what is held, and by how far wheel and mouse have gone. */
    void moveCamera(double seconds) {
        double metresPerSecond =
                camera.speed() * (held.seconds(bindings, FAST, seconds) > 0 ? FAST_FACTOR : 1);
        double forward = axis(FORWARD, BACK, seconds);
        double right = axis(RIGHT, LEFT, seconds);
        double up = axis(UP, DOWN, seconds);
        if (forward != 0 || right != 0 || up != 0) {
            camera.fly(forward * metresPerSecond, right * metresPerSecond, up * metresPerSecond);
        }
        double yaw = axis(TURN_RIGHT, TURN_LEFT, seconds);
        double pitch = axis(TURN_UP, TURN_DOWN, seconds);
        if (yaw != 0 || pitch != 0) {
            camera.turn(yaw * TURN_RADIANS_PER_SECOND, pitch * TURN_RADIANS_PER_SECOND);
        }
        held.endFrame();
    }

    private double axis(String positive, String negative, double frame) {
        return held.seconds(bindings, positive, frame) - held.seconds(bindings, negative, frame);
    }
}
