package dev.cairn.render.app;

import dev.cairn.render.gl.GlContext;
import dev.cairn.render.gl.GlUnavailableException;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.Objects;

/** How an application runs from its start to its end: in a window, or for one picture. */
final class Launch {
    private final Application application;
    private final int width;
    private final int height;

    /** Of the window or the picture, pixels. */
    Launch(Application application, int width, int height) {
        this.application = application;
        this.width = width;
        this.height = height;
    }

    /** Runs until the window is closed; or returns at once why there can be none, a few words. */
    @Nullable String window() {
        if (!StartProperties.hasDisplay()) {
            return "neither DISPLAY nor WAYLAND_DISPLAY is set";
        }
        GlContext context;
        try {
            context = GlContext.window(width, height, application.getClass().getSimpleName());
        } catch (GlUnavailableException e) {
            return Objects.requireNonNullElse(e.getMessage(), "no reason given");
        }
        Simulation running = application.newSimulation(-1);
        try (GlContext open = context) {
            running.start();
            new WindowLoop(application, running, open).run();
        } finally {
            running.stop();
        }
        finish(running);
        return null;
    }

    /**
     * Runs without a window to the tick of the picture, and draws it.
     *
     * @param required whether it is an error that no picture can be drawn here
     */
    void picture(Path file, boolean required) {
        String reason = Offscreen.unavailableReason();
        if (reason != null && required) {
            throw new IllegalStateException("the picture " + file + " cannot be drawn: " + reason);
        }
        Simulation running = application.newSimulation(application.pictureTick());
        if (!ApplicationHost.runToEnd(running)) {
            return;
        }
        finish(running);
        if (reason != null) {
            System.err.println("No picture can be drawn either: " + reason);
            return;
        }
        try (Offscreen view = Offscreen.open(width, height)) {
            view.effects(application.effects());
            view.draw(
                    running.exchange().latest(),
                    1,
                    application.camera(),
                    application.scene().light());
            view.savePng(file);
        }
        System.out.println("Tick " + running.ticks() + " is in " + file.toAbsolutePath());
    }

    private static void finish(Simulation running) {
        String text = running.failureText();
        if (text != null) {
            System.err.println(text);
        }
        running.rethrow();
    }
}
