package dev.cairn.render.app;

import static org.lwjgl.glfw.GLFW.GLFW_DONT_CARE;
import static org.lwjgl.glfw.GLFW.glfwGetPrimaryMonitor;
import static org.lwjgl.glfw.GLFW.glfwGetVideoMode;
import static org.lwjgl.glfw.GLFW.glfwGetWindowPos;
import static org.lwjgl.glfw.GLFW.glfwGetWindowSize;
import static org.lwjgl.glfw.GLFW.glfwSetFramebufferSizeCallback;
import static org.lwjgl.glfw.GLFW.glfwSetWindowCloseCallback;
import static org.lwjgl.glfw.GLFW.glfwSetWindowContentScaleCallback;
import static org.lwjgl.glfw.GLFW.glfwSetWindowMonitor;
import static org.lwjgl.glfw.GLFW.glfwSetWindowSizeCallback;
import static org.lwjgl.glfw.GLFW.glfwShowWindow;
import static org.lwjgl.glfw.GLFW.glfwSwapInterval;
import static org.lwjgl.glfw.GLFW.glfwWaitEventsTimeout;
import static org.lwjgl.glfw.GLFW.nglfwGetFramebufferSize;
import static org.lwjgl.glfw.GLFW.nglfwGetWindowContentScale;
import static org.lwjgl.glfw.GLFW.nglfwGetWindowSize;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.physics.DebugData;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Light;
import dev.cairn.render.gl.DebugLines;
import dev.cairn.render.gl.FrameTarget;
import dev.cairn.render.gl.GlContext;
import dev.cairn.render.gl.SceneRenderer;
import dev.cairn.render.ui.TextBuffer;
import dev.cairn.render.ui.nuklear.NativeText;
import dev.cairn.render.ui.nuklear.NuklearUi;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.lwjgl.glfw.GLFWVidMode;
import org.lwjgl.system.MemoryUtil;

import java.io.UncheckedIOException;
import java.nio.file.Path;

/** The main thread of an application with a window: events, camera, frames, panels. */
final class WindowLoop {
    private static final int SAMPLES = 4;
    private static final double TITLE_SECONDS = 0.5;

    private final Application application;
    private final Simulation simulation;
    private final GlContext context;
    private final Camera camera;
    private final WindowInput input;
    private final View view;
    private final HelpPanel help = new HelpPanel();

    /** Where GLFW writes sizes; arrays on the heap would be wrapped, and so be garbage. */
    private final long sizes = MemoryUtil.nmemCallocChecked(5, 4);

    private boolean sizesKnown;
    private boolean closed;
    private final int[] windowX = new int[1];
    private final int[] windowY = new int[1];
    private final int[] oneWidth = new int[1];
    private final int[] oneHeight = new int[1];
    private final Vector3d eye = new Vector3d();
    private @Nullable FrameTarget target;
    private @Nullable NuklearUi panels;
    private boolean panelsFailed;
    private boolean fullscreen;
    private boolean vsync = true;
    private final int[] placeBefore = new int[4];
    private long frames;
    private long framesAtTitle;
    private double titleAge;
    private final TextBuffer title = new TextBuffer();
    private final NativeText titleLetters = new NativeText();

    WindowLoop(Application application, Simulation simulation, GlContext context) {
        this.application = application;
        this.simulation = simulation;
        this.context = context;
        this.camera = application.camera();
        this.input = new WindowInput(application, simulation, context.handle());
        this.view = new View(camera, input.pointer(), simulation.exchange().latest());
    }

    /** Runs until the window is closed, the application quits, or the simulation ends. */
    void run() {
        long window = context.handle();
        input.listen();
        listen(window);
        glfwSwapInterval(1);
        glfwShowWindow(window);
        try (SceneRenderer renderer = new SceneRenderer(context.isSoftware());
                DebugLines lines = new DebugLines()) {
            renderer.overlay(lines);
            view.lines(lines);
            long before = System.nanoTime();
            while (!closed && !application.isQuitting() && !simulation.isOver()) {
                FrameCalls.pollEvents();
                long now = System.nanoTime();
                double elapsed = Math.min((now - before) * 1e-9, 0.1);
                before = now;
                applyWishes(window);
                readSizes(window);
                if (size(0) == 0 || size(1) == 0) {
                    glfwWaitEventsTimeout(0.05);
                    continue;
                }
                double pixelsPerPoint = (double) size(0) / Math.max(1, size(2));
                preparePanels(pixelsPerPoint);
                input.handOut(panels, size(2), size(3), pixelsPerPoint);
                input.moveCamera(elapsed);
                frame(renderer, lines, window);
                frames++;
                showTitle(window, elapsed);
            }
        } finally {
            if (target != null) {
                target.close();
            }
            if (panels != null) {
                panels.close();
            }
            titleLetters.close();
            MemoryUtil.nmemFree(sizes);
        }
    }

    private void frame(SceneRenderer renderer, DebugLines lines, long window) {
        FrameTarget into = target(size(0), size(1));
        PoseSnapshot snapshot = simulation.exchange().latest();
        Scene scene = application.sceneOrNull();
        Light light = scene == null ? Light.DAYLIGHT : scene.light();
        double alpha = alpha(snapshot);
        camera.position(eye);
        lines.begin(DebugDrawing.anchor(eye), panels == null ? 1 : panels.scale());
        if (snapshot.extra() instanceof DebugData data) {
            DebugDrawing.draw(data, application.debugMask(), lines);
        }
        view.next(snapshot, alpha, (double) into.width() / into.height(), frames);
        arrangePanels(into);
        renderer.draw(snapshot, alpha, camera, light, into);
        if (panels != null) {
            into.bindResolved();
            panels.paint();
        }
        into.show();
        GlContext.checkErrors("a frame of the window");
        if (application.takeScreenshotRequest()) {
            saveScreenshot(into, snapshot.tick());
        }
        FrameCalls.swapBuffers(window);
    }

    // GLFW owns the callbacks; GlContext.close frees them.
    @SuppressWarnings("resource")
    private void listen(long window) {
        glfwSetWindowCloseCallback(window, w -> closed = true);
        glfwSetFramebufferSizeCallback(window, (w, x, y) -> sizesKnown = false);
        glfwSetWindowSizeCallback(window, (w, x, y) -> sizesKnown = false);
        glfwSetWindowContentScaleCallback(window, (w, x, y) -> sizesKnown = false);
    }

    /** Only after they have changed: each question to GLFW makes garbage of its own. */
    private void readSizes(long window) {
        if (!sizesKnown) {
            sizesKnown = true;
            nglfwGetFramebufferSize(window, sizes, sizes + 4);
            nglfwGetWindowSize(window, sizes + 8, sizes + 12);
            nglfwGetWindowContentScale(window, sizes + 16, MemoryUtil.NULL);
        }
    }

    /** Framebuffer's width and height, pixels; window's width and height, screen coordinates. */
    private int size(int index) {
        return MemoryUtil.memGetInt(sizes + 4L * index);
    }

    /** Before the scene is drawn, since panels may add lines to it. */
    private void arrangePanels(FrameTarget into) {
        NuklearUi ui = panels;
        if (ui != null) {
            ui.begin(into.width(), into.height());
            application.panels(ui, view);
            if (application.isHelpShown()) {
                help.draw(ui, application.bindings());
            }
        }
    }

    private void saveScreenshot(FrameTarget from, long tick) {
        Path file = Path.of(application.getClass().getSimpleName() + "-" + tick + ".png");
        try {
            new Picture(from.width(), from.height(), from.read()).savePng(file);
            System.out.println("Saved " + file.toAbsolutePath());
        } catch (UncheckedIOException unwritable) {
            // A full disk is no reason to close the window.
            System.err.println(unwritable.getMessage());
        }
    }

    /** Panels are made anew when the density of the screen, or the wish, changes. */
    private void preparePanels(double pixelsPerPoint) {
        if (panelsFailed) {
            return;
        }
        double scale =
                Math.clamp(
                        Math.max(MemoryUtil.memGetFloat(sizes + 16), pixelsPerPoint)
                                * application.panelScale(),
                        0.5,
                        4.0);
        NuklearUi known = panels;
        if (known != null && known.scale() == scale) {
            return;
        }
        panels = null;
        if (known != null) {
            known.close();
        }
        try {
            panels = new NuklearUi(scale);
        } catch (LinkageError missing) {
            panelsFailed = true;
            System.err.println(
                    "There are no panels: the native library of lwjgl-nuklear cannot be loaded ("
                            + missing.getMessage()
                            + "); add that artifact with the classifier natives-<your system>");
        }
    }

    private void applyWishes(long window) {
        if (application.isVsync() != vsync) {
            vsync = !vsync;
            glfwSwapInterval(vsync ? 1 : 0);
        }
        if (application.isFullscreen() != fullscreen) {
            fullscreen = !fullscreen;
            long monitor = fullscreen ? glfwGetPrimaryMonitor() : 0;
            GLFWVidMode mode = monitor == 0 ? null : glfwGetVideoMode(monitor);
            if (mode != null) {
                glfwGetWindowPos(window, windowX, windowY);
                glfwGetWindowSize(window, oneWidth, oneHeight);
                placeBefore[0] = windowX[0];
                placeBefore[1] = windowY[0];
                placeBefore[2] = oneWidth[0];
                placeBefore[3] = oneHeight[0];
                glfwSetWindowMonitor(
                        window, monitor, 0, 0, mode.width(), mode.height(), mode.refreshRate());
            } else if (!fullscreen && placeBefore[2] > 0) {
                glfwSetWindowMonitor(
                        window,
                        0,
                        placeBefore[0],
                        placeBefore[1],
                        placeBefore[2],
                        placeBefore[3],
                        GLFW_DONT_CARE);
            }
        }
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

    private void showTitle(long window, double elapsed) {
        titleAge += elapsed;
        Scene scene = application.sceneOrNull();
        if (titleAge < TITLE_SECONDS || scene == null) {
            return;
        }
        double rate = (frames - framesAtTitle) / titleAge;
        view.rate(rate);
        title.clear().put(scene.title()).put(" - tick ").put(simulation.ticks());
        if (simulation.isPaused()) {
            title.put(", paused, ");
        } else {
            title.put(", x").putDigits(simulation.timeScale(), 3).put(", ");
        }
        FrameCalls.title(window, titleLetters.of(title.put(rate, 0).put(" fps")));
        titleAge = 0;
        framesAtTitle = frames;
    }
}
