package dev.cairn.render.app;

import dev.cairn.render.input.Key;

/** The keys that every application has from the start, all of which can be rebound. */
final class DefaultKeys {
    private DefaultKeys() {}

    static void bind(Application to) {
        WindowWishes wishes = to.wishes();
        to.bindings()
                .onHold(Key.W, WindowInput.FORWARD)
                .onHold(Key.S, WindowInput.BACK)
                .onHold(Key.A, WindowInput.LEFT)
                .onHold(Key.D, WindowInput.RIGHT)
                .onHold(Key.E, WindowInput.UP)
                .onHold(Key.Q, WindowInput.DOWN)
                .onHold(Key.LEFT_SHIFT, WindowInput.FAST)
                .onHold(Key.LEFT, WindowInput.TURN_LEFT)
                .onHold(Key.RIGHT, WindowInput.TURN_RIGHT)
                .onHold(Key.UP, WindowInput.TURN_UP)
                .onHold(Key.DOWN, WindowInput.TURN_DOWN)
                .onKey(Key.TAB, "mouse look", () -> wishes.mouseLook = !wishes.mouseLook)
                .onKey(Key.P, "pause", to::togglePause)
                .onKey(Key.SPACE, "pause", to::togglePause)
                .onKey(Key.N, "single step", to::singleStep)
                .onKey(
                        Key.LEFT_BRACKET,
                        "slower",
                        () -> to.timeScale(Math.max(to.timeScale() / 2, Speeds.SLOWEST)))
                .onKey(
                        Key.RIGHT_BRACKET,
                        "faster",
                        () -> to.timeScale(Math.min(to.timeScale() * 2, Speeds.FASTEST)))
                .onKey(Key.BACKSLASH, "real time", () -> to.timeScale(1))
                .onKey(Key.F12, "save picture", wishes::askForScreenshot)
                .onKey(Key.F11, "full screen", () -> to.fullscreen(!to.isFullscreen()))
                .onKey(Key.F1, "list keys", () -> to.showHelp(!to.isHelpShown()))
                .onKey(Key.ESCAPE, "quit", wishes::escape);
    }
}
