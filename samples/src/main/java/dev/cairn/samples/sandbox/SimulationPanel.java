package dev.cairn.samples.sandbox;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.profile.StepStage;
import dev.cairn.render.app.DebugLayer;
import dev.cairn.render.app.View;
import dev.cairn.render.camera.Effects;
import dev.cairn.render.ui.TextBuffer;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.panel.Places;

import java.util.Locale;

/** The sandbox's panel on the right: time, plots, debug drawing, solver, ball, window, keys. */
final class SimulationPanel {
    static final String SMOOTH = "smooth edges";
    private static final double SLOWEST = 1.0 / 64;
    private static final double FASTEST = 16;
    private static final int MOST_SUBSTEPS = 32;
    private static final int[] CURVES = {0xFFB74D, 0xF06292, 0xBA68C8, 0xA1887F};
    private static final int[] STAGE_CURVES = {0x81C784, 0x4FC3F7, 0xFFB74D, 0xF06292, 0xBA68C8};
    private static final DebugLayer[] LAYERS = DebugLayer.values();
    private static final StepStage[] STAGES = StepStage.values();
    private static final String[] STAGE_NAMES = new String[STAGES.length];
    private static final double[] SCALES = {1, 1.25, 1.5, 2};
    private static final String[] SCALE_NAMES = {"1", "1.25", "1.5", "2"};
    private static final String[] CHOSEN_SCALE_NAMES = {"[1]", "[1.25]", "[1.5]", "[2]"};

    static {
        for (int i = 0; i < STAGES.length; i++) {
            STAGE_NAMES[i] = STAGES[i].name().toLowerCase(Locale.ROOT).replace('_', ' ') + ", µs";
        }
    }

    private final Sandbox sandbox;
    private final Readings now;
    private final KeyRows keys;
    private final TextBuffer text = new TextBuffer();
    private int askedWorkers;
    private int askedSubsteps;
    private int knownWorkers;
    private int knownSubsteps;

    SimulationPanel(Sandbox sandbox, Readings now) {
        this.sandbox = sandbox;
        this.now = now;
        this.keys = new KeyRows(sandbox);
    }

    void draw(Ui ui, View view, SandboxState state, double top, boolean edited) {
        double height = ui.height() - Places.GAP - top;
        if (ui.panel("Simulation", Places.right(ui), top, Places.WIDTH, height)) {
            controls(ui);
            if (ui.section("Plots", false)) {
                plots(ui, now.history);
                ui.endSection();
            }
            if (ui.section("Stages of a tick", false)) {
                stages(ui, now.history);
                ui.endSection();
            }
            if (ui.section("Draw", false)) {
                layers(ui);
                ui.endSection();
            }
            // An edited scene says itself how many sub-steps it wants.
            if (!edited && ui.section("Solver", false)) {
                solver(ui, state);
                ui.endSection();
            }
            if (ui.section("Ball (key B)", false)) {
                ball(ui, state);
                ui.endSection();
            }
            if (ui.section("Window", false)) {
                window(ui, view);
                ui.endSection();
            }
            if (ui.section("Keys", false)) {
                keys.draw(ui);
                ui.endSection();
            }
            held(ui, state);
        }
        ui.endPanel();
    }

    private void controls(Ui ui) {
        ui.columns(3);
        if (ui.button(sandbox.isPaused() ? "Play" : "Pause")) {
            sandbox.togglePause();
        }
        if (ui.button("Step")) {
            sandbox.singleStep();
        }
        if (ui.button("Keys (F1)")) {
            sandbox.showHelp(!sandbox.isHelpShown());
        }
        if (ui.button("Slower ([)")) {
            sandbox.timeScale(Math.max(SLOWEST, sandbox.timeScale() / 2));
        }
        if (ui.button(sandbox.speedText())) {
            sandbox.timeScale(1);
        }
        if (ui.button("Faster (])")) {
            sandbox.timeScale(Math.min(FASTEST, sandbox.timeScale() * 2));
        }
        ui.value("time", text.clear().put(now.seconds, 2).put(" s"));
        ui.value("tick", text.clear().put(now.tick));
        ui.value(
                "bodies, contacts",
                text.clear().put(now.bodies).put(", ").put(now.history.touching));
        ui.value("frames/s", text.clear().put(now.framesPerSecond, 0));
    }

    private void plots(Ui ui, PlotHistory h) {
        plot(ui, "tick, ms", h.millisNow, h.millis, h, 0x81C784);
        plot(ui, "total energy, J", h.energyNow, h.energy, h, 0x4FC3F7);
        plot(ui, "kinetic energy, J", h.kineticNow, h.kinetic, h, 0x4DD0E1);
        plot(ui, "momentum, kg m/s", h.momentumNow, h.momentum, h, 0xFFF176);
        plot(ui, "deepest overlap, mm", 1000 * h.overlapNow, h.overlap, h, 0xE57373);
        for (int e = 0; e < h.errorCount; e++) {
            plot(ui, h.errorNames[e], h.errorNow[e], h.errors[e], h, CURVES[e]);
        }
    }

    private void plot(
            Ui ui, String name, double now, float[] values, PlotHistory history, int rgb) {
        ui.plot(name, text.clear().putDigits(now, 4), values, history.first, history.count, rgb);
    }

    private void stages(Ui ui, PlotHistory h) {
        ui.text("Wall time; the number is a mean over half a second.");
        for (int i = 0; i < STAGES.length; i++) {
            ui.plot(
                    STAGE_NAMES[i],
                    text.clear().put(h.stageMicros(STAGES[i]), 1),
                    h.stages[i],
                    h.first,
                    h.count,
                    STAGE_CURVES[i % STAGE_CURVES.length]);
        }
        ui.heading("Systems: their work, on all workers");
        for (int i = 0; i < h.systemNames.length; i++) {
            ui.value(h.systemNames[i], text.clear().put(h.systemMicros(i), 1));
        }
    }

    private void layers(Ui ui) {
        ui.columns(2);
        for (DebugLayer layer : LAYERS) {
            boolean shown = sandbox.isDebug(layer);
            boolean wanted = ui.checkbox(layer.title(), shown);
            if (wanted != shown) {
                sandbox.debug(layer, wanted);
            }
        }
    }

    private void solver(Ui ui, SandboxState state) {
        ui.text("Both change while the scene runs. Workers never change the result.");
        if (state.workers != knownWorkers || state.substeps != knownSubsteps) {
            knownWorkers = state.workers;
            knownSubsteps = state.substeps;
            askedWorkers = state.workers;
            askedSubsteps = state.substeps;
        }
        int workers = (int) ui.slider("workers", askedWorkers, 1, mostWorkers(), 1, "threads");
        int substeps =
                (int)
                        ui.slider(
                                "sub-steps",
                                askedSubsteps,
                                1,
                                MOST_SUBSTEPS,
                                1,
                                "solver steps in a tick");
        if (workers != askedWorkers || substeps != askedSubsteps) {
            askedWorkers = workers;
            askedSubsteps = substeps;
            sandbox.post(() -> sandbox.solve(workers, substeps));
        }
    }

    /** Threads that the slider offers. */
    static int mostWorkers() {
        return Math.min(Jobs.MAX_WORKERS, Math.max(8, Jobs.defaultWorkers()));
    }

    private void ball(Ui ui, SandboxState state) {
        Thrower.Ball ball = state.ball;
        double radius = ui.slider("radius", ball.radius(), 0.05, 1, 0.05, "m");
        double density = ui.slider("density", ball.density(), 10, 20_000, 0, "kg/m³");
        double speed = ui.slider("throw", ball.speed(), 0, 60, 1, "m/s");
        if (radius != ball.radius() || density != ball.density() || speed != ball.speed()) {
            Thrower.Ball wanted = new Thrower.Ball(radius, density, speed);
            sandbox.post(() -> sandbox.act((scene, thrower) -> thrower.ball(wanted)));
        }
        ui.columns(1);
        if (ui.button("Throw")) {
            sandbox.post(() -> sandbox.act(SandboxKeys::throwBall));
        }
    }

    private void window(Ui ui, View view) {
        ui.value("panels, ms a frame", text.clear().put(view.panelMillis(), 2));
        sandbox.fullscreen(ui.checkbox("full screen (F11)", sandbox.isFullscreen()));
        sandbox.vsync(ui.checkbox("wait for the screen", sandbox.isVsync()));
        ui.columns(4);
        for (int i = 0; i < SCALES.length; i++) {
            boolean chosen = SCALES[i] == sandbox.panelScale();
            if (ui.button(chosen ? CHOSEN_SCALE_NAMES[i] : SCALE_NAMES[i])) {
                sandbox.panelScale(SCALES[i]);
            }
        }
        ui.columns(1);
        effects(ui);
    }

    private void effects(Ui ui) {
        Effects now = sandbox.effects();
        boolean soft = ui.checkbox("soft shadows", now.softShadows());
        boolean dim = ui.checkbox("dim corners", now.occlusion());
        boolean mirrors = ui.checkbox("reflections", now.reflections());
        boolean film = ui.checkbox("film's light and dark", now.filmic());
        boolean horizon = ui.checkbox("ground to the horizon", now.horizon());
        boolean sky = ui.checkbox("light of the whole sky", now.skyLight());
        boolean wide = ui.checkbox("shadows near and far", now.cascades());
        boolean smooth = ui.checkbox(SMOOTH, now.antialiasing());
        if (soft != now.softShadows()
                || dim != now.occlusion()
                || mirrors != now.reflections()
                || film != now.filmic()
                || horizon != now.horizon()
                || sky != now.skyLight()
                || wide != now.cascades()
                || smooth != now.antialiasing()) {
            sandbox.effects(new Effects(soft, dim, mirrors, film, horizon, sky, wide, smooth));
        }
    }

    private void held(Ui ui, SandboxState state) {
        if (state.held.isEmpty()) {
            ui.text("Press the left button on a body to pull it; the wheel pulls it nearer.");
            return;
        }
        ui.heading(state.held);
        text.clear();
        if (state.heldIsFixed) {
            text.put("fixed");
        } else {
            text.putDigits(state.heldMass, 4).put(" kg");
        }
        ui.value("mass", text);
        ui.value("speed", text.clear().put(now.heldSpeed, 3).put(" m/s"));
        // On a row of its own: three numbers with signs are wider than a value's share.
        ui.columns(1);
        ui.label(
                text.clear()
                        .put("at ")
                        .put(now.heldAt.x, 2)
                        .put(", ")
                        .put(now.heldAt.y, 2)
                        .put(", ")
                        .put(now.heldAt.z, 2)
                        .put(" m"));
    }
}
