package dev.cairn.render.app;

import static org.lwjgl.opengl.GL11.glFinish;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Effects;
import dev.cairn.render.camera.Light;
import dev.cairn.render.gl.FrameTarget;
import dev.cairn.render.gl.GlContext;
import dev.cairn.render.gl.GlUnavailableException;
import dev.cairn.render.gl.SceneOverlay;
import dev.cairn.render.gl.SceneRenderer;
import dev.cairn.render.ui.nuklear.NuklearUi;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.Objects;

/**
 * Draws snapshots into pictures without a display, by the same code that draws into a window. It
 * needs EGL: on Debian the packages {@code libegl1} and {@code libgl1-mesa-dri}; a graphics
 * processor is used where there is one, unless the environment says {@code
 * LIBGL_ALWAYS_SOFTWARE=1}.
 *
 * <p>One at a time, and not while a window is open. Open, use and close it on one thread (on macOS
 * the main thread).
 *
 * <pre>{@code
 * try (Offscreen view = Offscreen.open(1280, 720)) {
 *     view.draw(exchange.latest(), 1, camera, Light.DAYLIGHT);
 *     view.savePng(Path.of("picture.png"));
 * }
 * }</pre>
 */
public final class Offscreen implements AutoCloseable {
    /** Largest width and height, pixels. */
    public static final int MAX_SIZE = 8192;

    private static volatile boolean known;

    private final GlContext context;
    private final SceneRenderer renderer;
    private FrameTarget target;
    private boolean drawn;
    private boolean closed;

    private Offscreen(GlContext context, int width, int height) {
        this.context = context;
        Effects effects = Objects.requireNonNullElse(Effects.ofProperty(), Effects.ALL);
        this.target = new FrameTarget(width, height, effects.antialiasing());
        this.renderer = new SceneRenderer(false, effects);
    }

    /**
     * Whether pictures can be drawn on this machine. The first call opens and closes a context,
     * which takes some tenths of a second; a success is remembered.
     *
     * @return null if they can, otherwise one sentence that says why not and what to install
     */
    public static @Nullable String unavailableReason() {
        if (known) {
            return null;
        }
        try (GlContext tried = GlContext.offscreen()) {
            tried.check();
            known = true;
            return null;
        } catch (GlUnavailableException e) {
            return e.getMessage();
        }
    }

    /**
     * Opens a place to draw to.
     *
     * @param width pixels, 1..{@value #MAX_SIZE}
     * @param height pixels, 1..{@value #MAX_SIZE}
     * @return the place
     * @throws IllegalArgumentException if a size is out of range
     * @throws IllegalStateException if there is no OpenGL (the message is the {@link
     *     #unavailableReason}), or a view is open already
     */
    public static Offscreen open(int width, int height) {
        if (width < 1 || height < 1 || width > MAX_SIZE || height > MAX_SIZE) {
            throw new IllegalArgumentException(
                    "picture is "
                            + width
                            + " x "
                            + height
                            + " pixels, expected 1.."
                            + MAX_SIZE
                            + " each");
        }
        GlContext context;
        try {
            context = GlContext.offscreen();
        } catch (GlUnavailableException e) {
            throw new IllegalStateException("no picture can be drawn here: " + e.getMessage(), e);
        }
        known = true;
        Offscreen view = null;
        try {
            view = new Offscreen(context, width, height);
            return view;
        } finally {
            if (view == null) {
                context.close();
            }
        }
    }

    /**
     * Draws a snapshot.
     *
     * @param snapshot what
     * @param alpha 0 = the poses of the previous tick, 1 = those of the current one, between them
     *     the way from one to the other
     * @param camera from where; one that follows an entity is moved to it
     * @param light in which light
     * @throws IllegalArgumentException if alpha is not within 0..1
     * @throws IllegalStateException if the view is closed, belongs to another thread, or OpenGL
     *     reports an error
     */
    public void draw(PoseSnapshot snapshot, double alpha, Camera camera, Light light) {
        context.check();
        if (!(alpha >= 0 && alpha <= 1)) {
            throw new IllegalArgumentException("alpha is " + alpha + ", expected 0..1");
        }
        renderer.draw(snapshot, alpha, camera, light, target);
        GlContext.checkErrors("Offscreen.draw");
        drawn = true;
    }

    /** Waits until all that was asked for is drawn; for measurements. */
    public void finish() {
        glFinish();
    }

    /**
     * Chooses what is drawn beyond the plain picture; at first what the property {@code
     * cairn.effects} says, or else {@link Effects#ALL}.
     *
     * @param value the effects
     */
    public void effects(Effects value) {
        context.check();
        renderer.effects(value);
        int width = target.width();
        int height = target.height();
        if (!target.is(width, height, value.antialiasing())) {
            target.close();
            target = new FrameTarget(width, height, value.antialiasing());
            drawn = false;
        }
    }

    /** Has something drawn over the scenes to come, or nothing. */
    void overlay(@Nullable SceneOverlay value) {
        renderer.overlay(value);
    }

    /** Draws panels over what was drawn last. */
    void paint(NuklearUi panels) {
        context.check();
        target.bindResolved();
        panels.paint();
        GlContext.checkErrors("Offscreen.paint");
    }

    /**
     * What was drawn last.
     *
     * @return a new picture
     * @throws IllegalStateException if nothing was drawn yet
     */
    public Picture picture() {
        context.check();
        if (!drawn) {
            throw new IllegalStateException("nothing was drawn yet; call draw first");
        }
        return new Picture(target.width(), target.height(), target.read());
    }

    /**
     * Writes what was drawn last.
     *
     * @param file where; parent folders are made
     * @throws java.io.UncheckedIOException if it cannot be written
     * @throws IllegalStateException if nothing was drawn yet
     */
    public void savePng(Path file) {
        picture().savePng(file);
    }

    /**
     * Who draws.
     *
     * @return names of the renderer and of the OpenGL version
     */
    public String renderer() {
        return context.renderer();
    }

    /**
     * How often poses were written to graphics memory so far.
     *
     * @return the count; it does not grow when the same snapshot is drawn again
     */
    public int uploads() {
        return renderer.uploads();
    }

    /**
     * How many models the last frame drew; those that lie outside of the picture are left out.
     *
     * @return the count
     */
    public int drawn() {
        return renderer.drawn();
    }

    /** Gives everything back; a second call does nothing. */
    @Override
    public void close() {
        if (closed) {
            return;
        }
        context.check();
        closed = true;
        try {
            renderer.close();
            target.close();
        } finally {
            context.close();
        }
    }
}
