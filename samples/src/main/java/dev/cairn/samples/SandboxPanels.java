package dev.cairn.samples;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.StepStage;
import dev.cairn.render.app.DebugLayer;
import dev.cairn.render.app.Pick;
import dev.cairn.render.app.View;
import dev.cairn.render.input.MouseButton;
import dev.cairn.render.input.Pointer;
import dev.cairn.render.ui.Ui;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The panels of the sandbox. Window thread; acts on the world by posting only. */
final class SandboxPanels {
    private static final double GAP = 10;
    private static final double LEFT_WIDTH = 270;
    private static final double RIGHT_WIDTH = 290;
    private static final int MOST_SUBSTEPS = 32;
    private static final int ROPE = 0xFFE082;
    private static final int PROBLEM = 0xFF7A7A;
    private static final int[] CURVES = {0xFFB74D, 0xF06292, 0xBA68C8, 0xA1887F};

    private final Sandbox sandbox;
    private final List<SampleScene> scenes;
    private final List<String> groups = new ArrayList<>();

    /** Values that were asked for and may not have come back from the simulation yet. */
    private final Map<String, Double> asked = new HashMap<>();

    private int shownScene = -1;
    private int askedWorkers;
    private int askedSubsteps;
    private boolean pulling;
    private volatile boolean hidden;

    SandboxPanels(Sandbox sandbox, List<SampleScene> scenes) {
        this.sandbox = sandbox;
        this.scenes = scenes;
        for (SampleScene scene : scenes) {
            if (!groups.contains(scene.group())) {
                groups.add(scene.group());
            }
        }
    }

    void toggleHidden() {
        hidden = !hidden;
    }

    void draw(Ui ui, View view, SandboxState state) {
        hand(view, state);
        if (view.pointer().isTurning()) {
            ui.cross(ui.width() / 2, ui.height() / 2, 0xFFFFFF);
        }
        if (hidden) {
            return;
        }
        if (state.scene != shownScene) {
            shownScene = state.scene;
            asked.clear();
        }
        double height = ui.height() - 2 * GAP;
        double listHeight = Math.max(160, height * 0.5);
        scenes(ui, state, listHeight);
        chosen(ui, state, listHeight + 2 * GAP, height - listHeight - GAP);
        simulation(ui, view, state, height, false);
    }

    /** The part that goes with an edited scene that runs. */
    void drawPlaying(Ui ui, View view, SandboxState state) {
        hand(view, state);
        simulation(ui, view, state, ui.height() - 2 * GAP, true);
    }

    // The hand ---------------------------------------------------------------------------------

    private void hand(View view, SandboxState state) {
        Pointer pointer = view.pointer();
        if (pointer.wasPressed(MouseButton.LEFT)) {
            Pick pick = view.pick(pointer.across(), pointer.upwards());
            if (pick != null) {
                Vector3d local = new Vector3d(pick.localX(), pick.localY(), pick.localZ());
                sandbox.post(() -> sandbox.grab(pick.entity(), pick.distance(), local));
                pulling = true;
            }
        }
        if (pulling) {
            Vector3d from = view.camera().position(new Vector3d());
            Vector3d along =
                    view.camera()
                            .ray(
                                    pointer.across(),
                                    pointer.upwards(),
                                    view.aspect(),
                                    new Vector3d());
            sandbox.post(() -> sandbox.pull(from, along));
            if (!pointer.isDown(MouseButton.LEFT)) {
                pulling = false;
                sandbox.post(sandbox::letGo);
            }
        }
        if (state.pulling) {
            Vector3d a = state.pullFrom;
            Vector3d b = state.pullTo;
            view.line(a.x, a.y, a.z, b.x, b.y, b.z, ROPE, 1.5);
            view.line(a.x, a.y, a.z, a.x, a.y, a.z, ROPE, 4);
        }
    }

    // Left -------------------------------------------------------------------------------------

    private void scenes(Ui ui, SandboxState state, double height) {
        if (ui.panel("Scenes", GAP, GAP, LEFT_WIDTH, height)) {
            for (String group : groups) {
                if (ui.section(group, true)) {
                    for (int i = 0; i < scenes.size(); i++) {
                        SampleScene scene = scenes.get(i);
                        if (scene.group().equals(group)
                                && ui.item(scene.title(), i == state.scene, "")) {
                            int index = i;
                            sandbox.post(() -> sandbox.show(index));
                        }
                    }
                    ui.endSection();
                }
            }
        }
        ui.endPanel();
    }

    private void chosen(Ui ui, SandboxState state, double top, double height) {
        SampleScene scene = scenes.get(state.scene);
        if (ui.panel("Scene", GAP, top, LEFT_WIDTH, height)) {
            ui.heading(scene.title());
            ui.text(scene.description());
            if (!state.problem.isEmpty()) {
                ui.label("It cannot be built:", PROBLEM);
                ui.text(state.problem);
            }
            for (Parameter parameter : scene.parameters()) {
                parameter(ui, state, parameter);
            }
            ui.columns(2);
            if (ui.button("Restart")) {
                sandbox.post(sandbox::startAgain);
            }
            if (!scene.parameters().isEmpty() && ui.button("Defaults")) {
                asked.clear();
                sandbox.post(sandbox::setDefaults);
            }
            if (ui.button("Edit a copy")) {
                sandbox.post(sandbox::editCopy);
            }
            if (ui.button("Editor (F2)")) {
                sandbox.editor().open();
            }
        }
        ui.endPanel();
    }

    private void parameter(Ui ui, SandboxState state, Parameter parameter) {
        double known = state.options.values().getOrDefault(parameter.name(), 0.0);
        double shown = asked.getOrDefault(parameter.name(), known);
        double value =
                ui.slider(
                        parameter.name(),
                        shown,
                        parameter.min(),
                        parameter.max(),
                        parameter.whole() ? 1 : 0,
                        parameter.meaning());
        if (value != shown) {
            asked.put(parameter.name(), value);
            sandbox.post(() -> sandbox.set(parameter.name(), value));
        } else if (value == known) {
            asked.remove(parameter.name());
        }
    }

    // Right ------------------------------------------------------------------------------------

    private void simulation(Ui ui, View view, SandboxState state, double height, boolean edited) {
        if (ui.panel("Simulation", ui.width() - RIGHT_WIDTH - GAP, GAP, RIGHT_WIDTH, height)) {
            controls(ui, view, state);
            if (ui.section("Plots", true)) {
                plots(ui, state);
                ui.endSection();
            }
            if (ui.section("Stages of a tick", false)) {
                stages(ui, state.history);
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
                window(ui);
                ui.endSection();
            }
            held(ui, state);
        }
        ui.endPanel();
    }

    private void controls(Ui ui, View view, SandboxState state) {
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
        double scale = sandbox.timeScale();
        double octaves = Math.log(scale) / Math.log(2);
        double moved = ui.slider("speed 2^", octaves, -6, 4, 1, "simulated by real time");
        if (moved != octaves) {
            sandbox.timeScale(Math.pow(2, moved));
        }
        ui.value("time", String.format(Locale.ROOT, "%.2f s, tick %d", state.seconds, state.tick));
        ui.value(
                "bodies, contacts",
                String.format(Locale.ROOT, "%d, %d", state.bodies, state.history.touching));
        ui.value("frames/s", String.format(Locale.ROOT, "%.0f", view.framesPerSecond()));
    }

    private void plots(Ui ui, SandboxState state) {
        History h = state.history;
        plot(ui, "tick, ms", h.millisNow, h.millis, h, 0x81C784);
        plot(ui, "total energy, J", h.energyNow, h.energy, h, 0x4FC3F7);
        plot(ui, "kinetic energy, J", h.kineticNow, h.kinetic, h, 0x4DD0E1);
        plot(ui, "momentum, kg m/s", h.momentumNow, h.momentum, h, 0xFFF176);
        plot(ui, "deepest overlap, mm", 1000 * h.overlapNow, h.overlap, h, 0xE57373);
        for (int e = 0; e < h.errorCount; e++) {
            plot(ui, h.errorNames[e], h.errorNow[e], h.errors[e], h, CURVES[e]);
        }
    }

    private static void plot(
            Ui ui, String name, double now, float[] values, History history, int rgb) {
        ui.plot(
                name,
                String.format(Locale.ROOT, "%.4g", now),
                values,
                history.first,
                history.count,
                rgb);
    }

    private static void stages(Ui ui, History history) {
        ui.text("Mean over about half a second, wall time.");
        for (StepStage stage : StepStage.values()) {
            ui.value(
                    stage.name().toLowerCase(Locale.ROOT).replace('_', ' '),
                    String.format(Locale.ROOT, "%.1f µs", history.stageMicros(stage)));
        }
    }

    private void layers(Ui ui) {
        for (DebugLayer layer : DebugLayer.values()) {
            boolean shown = sandbox.isDebug(layer);
            boolean wanted = ui.checkbox(layer.title(), shown);
            if (wanted != shown) {
                sandbox.debug(layer, wanted);
            }
        }
    }

    private void solver(Ui ui, SandboxState state) {
        ui.text("A change starts the scene again. Workers never change the result.");
        if (askedWorkers == 0) {
            askedWorkers = state.workers;
            askedSubsteps = state.substeps;
        }
        int most = Math.min(Jobs.MAX_WORKERS, Math.max(8, Jobs.defaultWorkers()));
        int workers = (int) ui.slider("workers", askedWorkers, 1, most, 1, "threads");
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

    private void ball(Ui ui, SandboxState state) {
        Sandbox.Ball ball = state.ball;
        double radius = ui.slider("radius", ball.radius(), 0.05, 1, 0.05, "m");
        double density = ui.slider("density", ball.density(), 10, 20_000, 0, "kg/m³");
        double speed = ui.slider("throw", ball.speed(), 0, 60, 1, "m/s");
        Sandbox.Ball wanted = new Sandbox.Ball(radius, density, speed);
        if (!wanted.equals(ball)) {
            sandbox.post(() -> sandbox.ball(wanted));
        }
        ui.columns(1);
        if (ui.button("Throw")) {
            sandbox.post(sandbox::throwBall);
        }
    }

    private void window(Ui ui) {
        sandbox.fullscreen(ui.checkbox("full screen (F11)", sandbox.isFullscreen()));
        sandbox.vsync(ui.checkbox("wait for the screen", sandbox.isVsync()));
        double scale = sandbox.panelScale();
        ui.columns(4);
        for (double wanted : new double[] {1, 1.25, 1.5, 2}) {
            if (ui.button(wanted == scale ? "[" + wanted + "]" : Double.toString(wanted))) {
                sandbox.panelScale(wanted);
            }
        }
    }

    private static void held(Ui ui, SandboxState state) {
        if (state.held.isEmpty()) {
            ui.text("Press the left button on a body to pull it; the wheel pulls it nearer.");
            return;
        }
        ui.heading(state.held);
        ui.value(
                "mass",
                state.heldIsFixed
                        ? "fixed"
                        : String.format(Locale.ROOT, "%.4g kg", state.heldMass));
        ui.value("speed", String.format(Locale.ROOT, "%.3f m/s", state.heldSpeed));
        ui.value(
                "at",
                String.format(
                        Locale.ROOT,
                        "%.2f, %.2f, %.2f m",
                        state.heldAt.x,
                        state.heldAt.y,
                        state.heldAt.z));
    }
}
