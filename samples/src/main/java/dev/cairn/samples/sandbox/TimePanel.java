package dev.cairn.samples.sandbox;

import dev.cairn.render.app.View;
import dev.cairn.render.ui.TextBuffer;
import dev.cairn.render.ui.Ui;

/** The bar of time at the lower edge of the window. Window thread. */
final class TimePanel {
    static final String BAR = "tick";
    static final String KEEP = "Keep (K)";
    static final String RETURN = "Return (L)";
    static final String FORGET = "Forget";
    private static final double GAP = 10;
    private static final double SIDE = 310;
    private static final double HEIGHT = 108;
    private static final double KEPT_HEIGHT = 172;

    private final Sandbox sandbox;
    private final TextBuffer text = new TextBuffer();
    private boolean holding;
    private boolean goesOn;
    private long asked = -1;

    TimePanel(Sandbox sandbox) {
        this.sandbox = sandbox;
    }

    /** Draws the other future's bodies; also where panels are hidden. */
    void ghosts(View view, SandboxState state) {
        OtherFuture future = state.future;
        if (future != null) {
            future.draw(view, state.tick);
        }
    }

    void draw(Ui ui, SandboxState state) {
        double height = state.keptTick < 0 ? HEIGHT : KEPT_HEIGHT;
        double width = Math.clamp(ui.width() - 2 * SIDE, 300, 720);
        double left = (ui.width() - width) / 2;
        if (ui.panel("Time", left, ui.height() - height - GAP, width, height)) {
            bar(ui, state);
            buttons(ui, state);
        }
        ui.endPanel();
    }

    private void bar(Ui ui, SandboxState state) {
        double shown = holding && asked >= 0 ? asked : state.tick;
        double moved =
                ui.slider(
                        BAR,
                        shown,
                        (double) state.oldestTick,
                        (double) state.newestTick,
                        1,
                        "drag to go back; let go, and it goes on from there");
        boolean held = ui.isHeld(BAR);
        if (held && !holding) {
            goesOn = !sandbox.isPaused();
            sandbox.setPaused(true);
        }
        if (moved != shown) {
            long tick = Math.round(moved);
            asked = tick;
            sandbox.post(() -> sandbox.time().goTo(tick));
        }
        if (!held && holding) {
            asked = -1;
            if (goesOn) {
                sandbox.setPaused(false);
            }
        }
        holding = held;
    }

    private void buttons(Ui ui, SandboxState state) {
        ui.columns(3);
        if (ui.button("Back (,)")) {
            sandbox.post(sandbox.time()::back);
        }
        if (ui.button("Forth (.)")) {
            sandbox.post(sandbox.time()::forth);
        }
        if (ui.button(KEEP)) {
            sandbox.post(sandbox.time()::keepMoment);
        }
        if (state.keptTick < 0) {
            return;
        }
        if (ui.button(RETURN)) {
            sandbox.post(sandbox.time()::backToKept);
        }
        if (ui.button(FORGET)) {
            sandbox.post(sandbox.time()::forgetFutures);
        }
        text.clear().put("tick ").put(state.keptTick);
        if (state.future != null && !Double.isNaN(state.apart)) {
            text.put(", apart by ").put(state.apart, 3).put(" m");
        }
        ui.value("kept moment", text);
    }
}
