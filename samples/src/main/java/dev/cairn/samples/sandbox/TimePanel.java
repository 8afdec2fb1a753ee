package dev.cairn.samples.sandbox;

import dev.cairn.render.app.View;
import dev.cairn.render.ui.TextBuffer;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.panel.Places;

/** The bar of time at the lower edge of the window. Window thread. */
final class TimePanel {
    static final String BAR = "tick";
    static final String KEEP = "Keep (K)";
    static final String RETURN = "Return (L)";
    static final String FORGET = "Forget";
    private static final double GAP = 10;

    /** Narrower than this three buttons have no room beside each other. */
    private static final double LEAST_FOR_THREE = 300;

    private static final double ROW = 29;
    private static final double HEIGHT = 108;
    private static final double KEPT_HEIGHT = 172;

    private final Sandbox sandbox;
    private final Readings now;
    private final TextBuffer text = new TextBuffer();
    private int columns = 3;
    private boolean holding;
    private boolean goesOn;
    private long asked = -1;

    TimePanel(Sandbox sandbox, Readings now) {
        this.sandbox = sandbox;
        this.now = now;
    }

    /** Draws the other future's bodies; also where panels are hidden. */
    void ghosts(View view, SandboxState state) {
        OtherFuture future = state.future;
        if (future != null) {
            future.draw(view, state.tick);
        }
    }

    void draw(Ui ui, SandboxState state) {
        if (!Places.hasBelow(ui.width())) {
            return;
        }
        double width = Math.min(Places.belowWidth(ui.width()), 720);
        columns = width < LEAST_FOR_THREE ? 2 : 3;
        double height = (state.keptTick < 0 ? HEIGHT : KEPT_HEIGHT) + (3 - columns) * ROW;
        double left = Places.isNarrow(ui) ? Places.belowLeft(ui.width()) : (ui.width() - width) / 2;
        if (ui.panel("Time", left, ui.height() - height - GAP, width, height)) {
            bar(ui);
            buttons(ui, state);
        }
        ui.endPanel();
    }

    private void bar(Ui ui) {
        double shown = holding && asked >= 0 ? asked : now.tick;
        double moved =
                ui.slider(
                        BAR,
                        shown,
                        (double) now.oldestTick,
                        (double) now.newestTick,
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
        ui.columns(columns);
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
