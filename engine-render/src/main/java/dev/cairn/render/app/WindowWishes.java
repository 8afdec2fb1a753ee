package dev.cairn.render.app;

import dev.cairn.render.camera.Effects;
import dev.cairn.render.input.Trigger;

import org.jspecify.annotations.Nullable;

import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;

/** What the application wants of its window; any thread asks, the window's thread does it. */
final class WindowWishes {
    volatile boolean quitting;
    volatile boolean mouseLook;
    volatile boolean helpShown;
    volatile boolean fullscreen;
    volatile boolean vsync = true;
    volatile double panelScale = 1;

    /** Null as long as nobody has chosen. */
    volatile @Nullable Effects effects;

    private volatile boolean closeAsked;
    private volatile boolean escapeAsked;
    private volatile boolean screenshot;
    private final AtomicReference<@Nullable String> notice = new AtomicReference<>();
    private final AtomicReference<@Nullable Consumer<@Nullable Trigger>> capture =
            new AtomicReference<>();

    void askToClose() {
        closeAsked = true;
    }

    boolean takeClose() {
        boolean asked = closeAsked;
        closeAsked = false;
        return asked;
    }

    void escape() {
        escapeAsked = true;
    }

    boolean takeEscape() {
        boolean asked = escapeAsked;
        escapeAsked = false;
        return asked;
    }

    void askForScreenshot() {
        screenshot = true;
    }

    boolean takeScreenshot() {
        boolean asked = screenshot;
        screenshot = false;
        return asked;
    }

    void notice(String text) {
        notice.set(text);
    }

    @Nullable String takeNotice() {
        return notice.get() == null ? null : notice.getAndSet(null);
    }

    void capture(@Nullable Consumer<@Nullable Trigger> taker) {
        capture.set(taker);
    }

    boolean isCapturing() {
        return capture.get() != null;
    }

    @Nullable Consumer<@Nullable Trigger> takeCapture() {
        return capture.get() == null ? null : capture.getAndSet(null);
    }
}
