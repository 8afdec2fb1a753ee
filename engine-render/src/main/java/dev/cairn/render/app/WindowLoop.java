package dev.cairn.render.app;

import static org.lwjgl.glfw.GLFW.GLFW_CURSOR;
import static org.lwjgl.glfw.GLFW.GLFW_CURSOR_DISABLED;
import static org.lwjgl.glfw.GLFW.GLFW_CURSOR_NORMAL;
import static org.lwjgl.glfw.GLFW.GLFW_PRESS;
import static org.lwjgl.glfw.GLFW.GLFW_RAW_MOUSE_MOTION;
import static org.lwjgl.glfw.GLFW.GLFW_RELEASE;
import static org.lwjgl.glfw.GLFW.GLFW_TRUE;
import static org.lwjgl.glfw.GLFW.glfwGetCursorPos;
import static org.lwjgl.glfw.GLFW.glfwGetFramebufferSize;
import static org.lwjgl.glfw.GLFW.glfwPollEvents;
import static org.lwjgl.glfw.GLFW.glfwRawMouseMotionSupported;
import static org.lwjgl.glfw.GLFW.glfwSetCursorPosCallback;
import static org.lwjgl.glfw.GLFW.glfwSetInputMode;
import static org.lwjgl.glfw.GLFW.glfwSetKeyCallback;
import static org.lwjgl.glfw.GLFW.glfwSetMouseButtonCallback;
import static org.lwjgl.glfw.GLFW.glfwSetScrollCallback;
import static org.lwjgl.glfw.GLFW.glfwSetWindowFocusCallback;
import static org.lwjgl.glfw.GLFW.glfwSetWindowTitle;
import static org.lwjgl.glfw.GLFW.glfwShowWindow;
import static org.lwjgl.glfw.GLFW.glfwSwapBuffers;
import static org.lwjgl.glfw.GLFW.glfwSwapInterval;
import static org.lwjgl.glfw.GLFW.glfwWaitEventsTimeout;
import static org.lwjgl.glfw.GLFW.glfwWindowShouldClose;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Light;
import dev.cairn.render.gl.FrameTarget;
import dev.cairn.render.gl.GlContext;
import dev.cairn.render.gl.SceneRenderer;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Key;
import dev.cairn.render.input.MouseButton;

import org.jspecify.annotations.Nullable;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Locale;

/** The main thread of an application with a window: events, camera, frames. */
final class WindowLoop {
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

    private static final int SAMPLES = 4;
    private static final double FAST_FACTOR = 5;
    private static final double TURN_RADIANS_PER_SECOND = 1.2;
    private static final double LOOK_RADIANS_PER_PIXEL = 0.0025;
    private static final double TITLE_SECONDS = 0.5;

    private final Application application;
    private final Simulation simulation;
    private final GlContext context;
    private final Camera camera;
    private final Bindings bindings;
    private final EnumSet<Key> held = EnumSet.noneOf(Key.class);
    private final int[] framebufferWidth = new int[1];
    private final int[] framebufferHeight = new int[1];
    private boolean lookButton;
    private boolean captured;
    private final double[] startX = new double[1];
    private final double[] startY = new double[1];
    private double cursorX;
    private double cursorY;
    private @Nullable FrameTarget target;
    private long frames;
    private long framesAtTitle;
    private double titleAge;

    WindowLoop(Application application, Simulation simulation, GlContext context) {
        this.application = application;
        this.simulation = simulation;
        this.context = context;
        this.camera = application.camera();
        this.bindings = application.bindings();
    }

    /** Runs until the window is closed, the application quits, or the simulation ends. */
    void run() {
        long window = context.handle();
        listen(window);
        glfwSwapInterval(1);
        glfwShowWindow(window);
        try (SceneRenderer renderer = new SceneRenderer(context.isSoftware())) {
            long before = System.nanoTime();
            while (!glfwWindowShouldClose(window)
                    && !application.isQuitting()
                    && !simulation.isOver()) {
                glfwPollEvents();
                long now = System.nanoTime();
                double elapsed = Math.min((now - before) * 1e-9, 0.1);
                before = now;
                captureCursor(window);
                moveCamera(elapsed);
                glfwGetFramebufferSize(window, framebufferWidth, framebufferHeight);
                if (framebufferWidth[0] == 0 || framebufferHeight[0] == 0) {
                    glfwWaitEventsTimeout(0.05);
                    continue;
                }
                frame(renderer, window);
                frames++;
                showTitle(window, elapsed);
            }
        } finally {
            if (target != null) {
                target.close();
            }
        }
    }

    private void frame(SceneRenderer renderer, long window) {
        FrameTarget into = target(framebufferWidth[0], framebufferHeight[0]);
        PoseSnapshot snapshot = simulation.exchange().latest();
        Scene scene = application.sceneOrNull();
        Light light = scene == null ? Light.DAYLIGHT : scene.light();
        renderer.draw(snapshot, alpha(snapshot), camera, light, into);
        into.show();
        GlContext.checkErrors("a frame of the window");
        if (application.takeScreenshotRequest()) {
            Path file =
                    Path.of(
                            application.getClass().getSimpleName()
                                    + "-"
                                    + snapshot.tick()
                                    + ".png");
            try {
                new Picture(into.width(), into.height(), into.read()).savePng(file);
                System.out.println("Saved " + file.toAbsolutePath());
            } catch (UncheckedIOException unwritable) {
                // A full disk is no reason to close the window.
                System.err.println(unwritable.getMessage());
            }
        }
        glfwSwapBuffers(window);
    }

    /** How far real time is from the previous tick to the current one. */
    private double alpha(PoseSnapshot snapshot) {
        double step = snapshot.stepSeconds();
        if (!(step > 0)) {
            return 1;
        }
        double age =
                (System.nanoTime() - snapshot.publishedNanos()) * 1e-9 * simulation.timeScale();
        return Math.clamp(age / step, 0.0, 1.0);
    }

    private FrameTarget target(int width, int height) {
        FrameTarget known = target;
        if (known == null || known.width() != width || known.height() != height) {
            if (known != null) {
                known.close();
            }
            known = new FrameTarget(width, height, context.isSoftware() ? 1 : SAMPLES);
            target = known;
        }
        return known;
    }

    // GLFW owns the callbacks; GlContext.close frees them.
    @SuppressWarnings("resource")
    private void listen(long window) {
        glfwSetKeyCallback(
                window,
                (w, code, scancode, action, mods) -> {
                    Key key = Key.ofCode(code);
                    if (key != null && action == GLFW_PRESS) {
                        held.add(key);
                        post(() -> bindings.press(key));
                    } else if (key != null && action == GLFW_RELEASE) {
                        held.remove(key);
                        post(() -> bindings.release(key));
                    }
                });
        glfwSetMouseButtonCallback(
                window,
                (w, code, action, mods) -> {
                    MouseButton button = MouseButton.ofCode(code);
                    boolean down = action == GLFW_PRESS;
                    if (button == MouseButton.RIGHT) {
                        lookButton = down;
                    }
                    post(down ? () -> bindings.press(button) : () -> bindings.release(button));
                });
        glfwSetScrollCallback(window, (w, x, y) -> post(() -> bindings.scroll(y)));
        glfwSetCursorPosCallback(window, (w, x, y) -> look(x, y));
        glfwSetWindowFocusCallback(
                window,
                (w, focused) -> {
                    if (!focused) {
                        held.clear();
                        lookButton = false;
                        post(bindings::releaseAll);
                    }
                });
    }

    private void post(Runnable action) {
        try {
            simulation.post(action);
        } catch (IllegalStateException full) {
            // 65 536 events wait: the scene hangs in update. An exception would leave through
            // GLFW's C code, so the event is let go.
            return;
        }
    }

    private void captureCursor(long window) {
        boolean wanted = lookButton || application.isMouseLook();
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

    private void look(double x, double y) {
        if (captured) {
            camera.turn(
                    (x - cursorX) * LOOK_RADIANS_PER_PIXEL, (cursorY - y) * LOOK_RADIANS_PER_PIXEL);
        }
        cursorX = x;
        cursorY = y;
    }

    private void moveCamera(double seconds) {
        double metres = seconds * camera.speed() * (isHeld(FAST) ? FAST_FACTOR : 1);
        double forward = axis(FORWARD, BACK);
        double right = axis(RIGHT, LEFT);
        double up = axis(UP, DOWN);
        if (forward != 0 || right != 0 || up != 0) {
            camera.fly(forward * metres, right * metres, up * metres);
        }
        double yaw = axis(TURN_RIGHT, TURN_LEFT);
        double pitch = axis(TURN_UP, TURN_DOWN);
        if (yaw != 0 || pitch != 0) {
            double radians = seconds * TURN_RADIANS_PER_SECOND;
            camera.turn(yaw * radians, pitch * radians);
        }
    }

    private double axis(String positive, String negative) {
        return (isHeld(positive) ? 1 : 0) - (isHeld(negative) ? 1 : 0);
    }

    private boolean isHeld(String action) {
        for (Key key : bindings.keys(action)) {
            if (held.contains(key)) {
                return true;
            }
        }
        return false;
    }

    private void showTitle(long window, double elapsed) {
        titleAge += elapsed;
        Scene scene = application.sceneOrNull();
        if (titleAge < TITLE_SECONDS || scene == null) {
            return;
        }
        String state = simulation.isPaused() ? "paused" : "x" + trimmed(simulation.timeScale());
        glfwSetWindowTitle(
                window,
                String.format(
                        Locale.ROOT,
                        "%s - tick %d, %s, %.0f fps",
                        scene.title(),
                        simulation.ticks(),
                        state,
                        (frames - framesAtTitle) / titleAge));
        titleAge = 0;
        framesAtTitle = frames;
    }

    private static String trimmed(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }
}
