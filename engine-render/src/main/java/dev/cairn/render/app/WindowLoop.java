package dev.cairn.render.app;

import static org.lwjgl.glfw.GLFW.glfwGetClipboardString;
import static org.lwjgl.glfw.GLFW.glfwSetClipboardString;
import static org.lwjgl.glfw.GLFW.glfwSetFramebufferSizeCallback;
import static org.lwjgl.glfw.GLFW.glfwSetWindowCloseCallback;
import static org.lwjgl.glfw.GLFW.glfwSetWindowContentScaleCallback;
import static org.lwjgl.glfw.GLFW.glfwSetWindowIconifyCallback;
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
import dev.cairn.render.camera.Effects;
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
import org.lwjgl.system.MemoryUtil;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Objects;

/** The main thread of an application with a window: events, camera, frames, panels. */
final class WindowLoop {
    private static final double TITLE_SECONDS = 0.5;

    /** How long a minimised window sleeps before it looks whether the application has ended, s. */
    private static final double HIDDEN_SECONDS = 0.1;

    private final Application application;
    private final Simulation simulation;
    private final GlContext context;
    private final Camera camera;
    private final WindowInput input;
    private final FullScreen fullScreen;
    private final View view;
    private final HelpPanel help = new HelpPanel();
    private final Notice notice = new Notice();

    /** Where GLFW writes sizes; arrays on the heap would be wrapped, and so be garbage. */
    private final long sizes = MemoryUtil.nmemCallocChecked(5, 4);

    private boolean sizesKnown;
    private boolean closed;
    private boolean iconified;
    private final Vector3d eye = new Vector3d();
    private @Nullable FrameTarget target;
    private @Nullable NuklearUi panels;
    private boolean panelsFailed;
    private boolean vsync = true;
    private long frames;
    private long framesAtTitle;
    private long panelNanos;
    private double titleAge;
    private long stepsInTitle = -1;
    private final TextBuffer title = new TextBuffer();
    private final NativeText titleLetters = new NativeText();

    WindowLoop(Application application, Simulation simulation, GlContext context) {
        this.application = application;
        this.simulation = simulation;
        this.context = context;
        this.camera = application.camera();
        this.fullScreen = new FullScreen(context.handle());
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
        try (SceneRenderer renderer = new SceneRenderer(context.isSoftware(), chosenEffects());
                DebugLines lines = new DebugLines()) {
            renderer.overlay(lines);
            view.lines(lines);
            long before = System.nanoTime();
            while (!closed && !application.wishes().quitting && !simulation.isOver()) {
                FrameCalls.pollEvents();
                long now = System.nanoTime();
                double elapsed = Math.min((now - before) * 1e-9, 0.1);
                before = now;
                applyWishes();
                readSizes(window);
                if (iconified || size(0) == 0 || size(1) == 0) {
                    glfwWaitEventsTimeout(HIDDEN_SECONDS);
                    continue;
                }
                double pixelsPerPoint = (double) size(0) / Math.max(1, size(2));
                preparePanels(pixelsPerPoint);
                input.handOut(panels, size(2), size(3), pixelsPerPoint);
                input.moveCamera(elapsed);
                frame(renderer, lines, window, elapsed);
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

    private void frame(SceneRenderer renderer, DebugLines lines, long window, double elapsed) {
        renderer.effects(chosenEffects());
        renderer.tint(DebugDrawing.tint(application.debugMask()));
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
        view.dropped(input.takeDropped());
        arrangePanels(into, elapsed);
        renderer.draw(snapshot, alpha, camera, light, into);
        if (application.wishes().takeScreenshot()) {
            saveScreenshot(into, snapshot.tick());
        }
        if (panels != null) {
            into.bindResolved();
            long start = System.nanoTime();
            panels.paint();
            panelNanos += System.nanoTime() - start;
        }
        into.show();
        GlContext.checkErrors("a frame of the window");
        FrameCalls.swapBuffers(window);
    }

    /** What the application wants; the first frame says what that is where it wants nothing. */
    private Effects chosenEffects() {
        WindowWishes wishes = application.wishes();
        Effects chosen = wishes.effects;
        if (chosen == null) {
            chosen = context.isSoftware() ? Effects.PLAIN : Effects.ALL;
            wishes.effects = chosen;
        }
        return chosen;
    }

    // GLFW owns the callbacks; GlContext.close frees them.
    @SuppressWarnings("resource")
    private void listen(long window) {
        glfwSetWindowCloseCallback(window, w -> application.wishes().askToClose());
        glfwSetWindowIconifyCallback(window, (w, gone) -> iconified = gone);
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
    private void arrangePanels(FrameTarget into, double elapsed) {
        NuklearUi ui = panels;
        if (ui != null) {
            long start = System.nanoTime();
            ui.begin(into.width(), into.height(), start);
            application.panels(ui, view);
            if (application.isHelpShown()) {
                help.draw(ui, application.bindings());
            }
            notice.draw(ui, elapsed);
            panelNanos += System.nanoTime() - start;
        }
    }

    private void saveScreenshot(FrameTarget from, long tick) {
        Path file = Path.of(application.getClass().getSimpleName() + "-" + tick + ".png");
        try {
            new Picture(from.width(), from.height(), from.read()).savePng(file);
            System.out.println("Saved " + file.toAbsolutePath());
            notice.show("Saved " + file.toAbsolutePath());
        } catch (UncheckedIOException unwritable) {
            // A full disk is no reason to close the window.
            System.err.println(unwritable.getMessage());
            notice.show(String.valueOf(unwritable.getMessage()));
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
        try {
            NuklearUi made = new NuklearUi(scale);
            made.clipboard(
                    () -> Objects.requireNonNullElse(glfwGetClipboardString(context.handle()), ""),
                    text -> glfwSetClipboardString(context.handle(), text));
            if (known != null) {
                made.openAs(known);
            }
            panels = made;
        } catch (LinkageError missing) {
            panelsFailed = true;
            System.err.println(
                    "There are no panels: the native library of lwjgl-nuklear cannot be loaded ("
                            + missing.getMessage()
                            + "); add that artifact with the classifier natives-<your system>");
        } finally {
            if (known != null) {
                known.close();
            }
        }
    }

    private void applyWishes() {
        WindowWishes wishes = application.wishes();
        String text = wishes.takeNotice();
        if (text != null) {
            notice.show(text);
        }
        if (wishes.takeEscape()) {
            if (wishes.helpShown) {
                wishes.helpShown = false;
            } else if (!application.dismiss()) {
                wishes.askToClose();
            }
        }
        if (wishes.takeClose() && application.closing()) {
            closed = true;
        }
        if (application.isVsync() != vsync) {
            vsync = !vsync;
            glfwSwapInterval(vsync ? 1 : 0);
        }
        fullScreen.set(application.isFullscreen());
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
        boolean smooth = chosenEffects().antialiasing();
        if (known == null || !known.is(width, height, smooth)) {
            if (known != null) {
                known.close();
            }
            known = new FrameTarget(width, height, smooth);
            target = known;
        }
        return known;
    }

    /** The tick stands in the title only while it stands still: else it would lag the panels. */
    private void showTitle(long window, double elapsed) {
        titleAge += elapsed;
        Scene scene = application.sceneOrNull();
        boolean paused = simulation.isPaused();
        long steps = paused ? simulation.steps() : -1;
        if (scene == null || (titleAge < TITLE_SECONDS && steps == stepsInTitle)) {
            return;
        }
        if (titleAge >= TITLE_SECONDS) {
            long shown = Math.max(1, frames - framesAtTitle);
            view.rate((frames - framesAtTitle) / titleAge, 1e-6 * panelNanos / shown);
            panelNanos = 0;
            titleAge = 0;
            framesAtTitle = frames;
        }
        stepsInTitle = steps;
        title.clear().put(scene.title()).put(" - ");
        if (paused) {
            title.put("paused at tick ").put(steps);
        } else {
            title.put(Speeds.text(simulation.timeScale())).put(", ");
            title.put(view.framesPerSecond(), 0).put(" fps");
        }
        FrameCalls.title(window, titleLetters.of(title));
    }
}
