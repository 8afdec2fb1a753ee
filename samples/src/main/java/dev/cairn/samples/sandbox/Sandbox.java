package dev.cairn.samples.sandbox;

import dev.cairn.core.snapshot.TripleBuffer;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.app.Application;
import dev.cairn.render.app.Scene;
import dev.cairn.render.app.View;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Key;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.Palette;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.UsageException;
import dev.cairn.samples.editor.Editor;
import dev.cairn.samples.editor.EditorPanels;
import dev.cairn.samples.editor.LeaveQuestion;
import dev.cairn.samples.scenefile.SceneExport;
import dev.cairn.samples.scenefile.SceneFile;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The window with the scenes: a list of them, their parameters as sliders, what the engine knows as
 * lines and plots, and a hand that pulls bodies about.
 *
 * <p>Each start of a scene makes a new world with the same settings as a run without a window, so
 * that both go through the same states until somebody pulls or throws something. Panels live on the
 * window's thread; all they want done is posted to the simulation thread, and all they show comes
 * by snapshots.
 */
public class Sandbox extends Application {
    private static final Key[] NUMBERS = {
        Key.DIGIT_1,
        Key.DIGIT_2,
        Key.DIGIT_3,
        Key.DIGIT_4,
        Key.DIGIT_5,
        Key.DIGIT_6,
        Key.DIGIT_7,
        Key.DIGIT_8,
        Key.DIGIT_9,
        Key.DIGIT_0
    };

    private final List<SampleScene> scenes;
    private final PrintStream out;
    private final SandboxPanels panels;
    private final EditorStage stage = new EditorStage(this);
    private final Editor editor = new Editor(stage);
    private final EditorPanels editorPanels = new EditorPanels(editor);
    private final LeaveQuestion leaving = new LeaveQuestion(editor, editorPanels, this::quit);
    private double windowStepSeconds = SampleScene.STEP_SECONDS;
    private final TripleBuffer<SandboxState> states = new TripleBuffer<>(SandboxState::new);

    // The simulation thread's own, from initScene on.
    private final Map<String, SceneOptions> options;
    private final PlotHistory history = new PlotHistory();
    private final Timeline timeline = new Timeline();
    private final MouseHand hand = new MouseHand();
    private int current;
    private int workers;
    private int substeps;
    private PhysicsSettings settings = PhysicsSettings.DEFAULT;
    private final boolean sleeping;
    private boolean bound;
    private boolean keepCamera;

    /** Whether the camera goes to where the scene wants it if that is not where it was before. */
    private boolean refits;

    private SceneBuilder.@Nullable View seenFrom;
    private @Nullable SceneBuilder built;
    private int remarksShown;
    private long stepStartNanos;
    private String problem = "";
    private Ball ball = Ball.DEFAULT;
    private int thrown;

    private EditorStage.@Nullable Shown notedFor;
    private int notedSize;
    private String noted = "";
    private @Nullable String noWindow;

    /**
     * What is thrown.
     *
     * @param radius m
     * @param density kg/m³
     * @param speed m/s
     */
    record Ball(double radius, double density, double speed) {
        static final Ball DEFAULT = new Ball(0.25, 1000, 15);
    }

    /**
     * A sandbox that is not open yet.
     *
     * @param scenes what can be chosen, at least one
     * @param options options by scene id
     * @param workers threads of the physics
     * @param substeps sub-steps of the solver
     * @param sleeping whether bodies at rest fall asleep
     * @param out receives the scenes' remarks
     * @return a sandbox
     */
    public static Sandbox of(
            List<SampleScene> scenes,
            Map<String, SceneOptions> options,
            int workers,
            int substeps,
            boolean sleeping,
            PrintStream out) {
        return new Sandbox(scenes, options, workers, substeps, sleeping, out);
    }

    Sandbox(
            List<SampleScene> scenes,
            Map<String, SceneOptions> options,
            int workers,
            int substeps,
            boolean sleeping,
            PrintStream out) {
        this.scenes = scenes;
        this.options = new HashMap<>(options);
        this.workers = workers;
        this.substeps = substeps;
        this.sleeping = sleeping;
        this.out = out;
        this.panels = new SandboxPanels(this, scenes);
    }

    /**
     * Has the window open with a scene file in the editor; before {@link #start}.
     *
     * @param file where it was read
     * @param scene what is in it
     */
    public void edit(Path file, SceneFile scene) {
        windowStepSeconds = scene.tick().seconds();
        Path whole = file.toAbsolutePath().normalize();
        Path folder = whole.getParent();
        editorPanels.ask(ready -> ready.open(scene, whole, folder == null ? whole : folder));
    }

    /**
     * Begins with another scene than the first of the list; before {@link #start}.
     *
     * @param scene one of the list
     */
    public void beginWith(SampleScene scene) {
        current = Math.max(0, scenes.indexOf(scene));
    }

    /** The editor; window thread. For tests. */
    Editor editor() {
        return editor;
    }

    /** What is asked before the window closes; window thread. For tests. */
    LeaveQuestion leaving() {
        return leaving;
    }

    /**
     * Why there was no window; after {@link #start}.
     *
     * @return a few words, or null if there was one
     */
    public @Nullable String noWindow() {
        return noWindow;
    }

    @Override
    protected void withoutWindow(String reason) {
        noWindow = reason;
    }

    /**
     * Sets what has no slider; before the start.
     *
     * @param value tunables of every scene; sub-steps and sleep are those of the window
     */
    public void settings(PhysicsSettings value) {
        settings = value;
    }

    @Override
    protected PhysicsWorld createPhysics() {
        EditorStage.Shown edited = stage.shown();
        PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(Math.max(workers, SimulationPanel.mostWorkers()))
                        .settings(settings)
                        .substeps(edited == null ? substeps : edited.scene().tick().substeps())
                        .sleeping(sleeping)
                        .seed(chosenOptions().seed())
                        .systems(scenes.get(current).systems(chosenOptions()))
                        .build();
        // The others are parked until the slider asks for them.
        world.ecs().jobs().limit(workers);
        return world;
    }

    private SceneOptions chosenOptions() {
        SampleScene chosen = scenes.get(current);
        SceneOptions known = options.get(chosen.id());
        if (known == null) {
            known = SceneOptions.defaults(chosen);
            options.put(chosen.id(), known);
        }
        return known;
    }

    @Override
    protected void initScene(Scene scene) {
        if (!bound) {
            bind(scene); // once, so that keys that were rebound stay so
            KeyRows.load(scene.bindings());
            bound = true;
        }
        scene.physics().profile().enable();
        hand.release();
        history.clear();
        remarksShown = 0;
        thrown = 0;
        problem = "";
        build(scene);
        remember(scene);
        keepCamera = false;
        refits = false;
        publishState();
    }

    private void build(Scene scene) {
        SampleScene chosen = scenes.get(current);
        EditorStage.Shown edited = stage.shown();
        scene.title("Cairn: " + (edited == null ? chosen.title() : edited.scene().name()));
        problem = "";
        built = null;
        try {
            SceneBuilder next = new SceneBuilder(scene.physics(), chosenOptions());
            if (edited == null) {
                chosen.build(next);
                built = next;
            } else {
                // Even if the world refuses an entity: what is there must be cleared some day.
                built = next;
                stage.build(edited, next);
            }
            scene.light(next.light());
            scene.camera().release();
            if (!keepCamera || (refits && !next.view().equals(seenFrom))) {
                next.view().place(scene.camera());
            }
            seenFrom = next.view();
        } catch (UsageException misuse) {
            problem = String.valueOf(misuse.getMessage());
            out.println(problem);
        } catch (IllegalArgumentException refused) {
            if (edited == null) {
                throw refused;
            }
            problem = String.valueOf(refused.getMessage());
        }
    }

    /** Starts the edited scene from its beginning. */
    void showEdited(boolean placesCamera) {
        keepCamera = !placesCamera;
        restart();
    }

    /** Puts the edited scene as it is now in place of what the world holds. */
    void rebuildEdited() {
        timeline.begin(scene().physics(), null);
        SceneBuilder old = built;
        if (old != null) {
            old.clear();
        }
        boolean kept = keepCamera;
        keepCamera = true;
        build(scene());
        keepCamera = kept;
        publishState();
    }

    /** Opens the editor with what the present scene begins with. */
    void editCopy() {
        SampleScene chosen = scenes.get(current);
        Path folder = Path.of("").toAbsolutePath();
        try {
            SceneFile copy = SceneExport.of(chosen, chosenOptions(), substeps, folder);
            editorPanels.ask(known -> known.openCopy(copy, folder));
        } catch (UsageException misuse) {
            problem = String.valueOf(misuse.getMessage());
            publishState();
        }
    }

    private void bind(Scene scene) {
        for (int i = 0; i < Math.min(NUMBERS.length, scenes.size()); i++) {
            int index = i;
            scene.bindings().onKey(NUMBERS[i], "scene " + scenes.get(i).id(), () -> show(index));
        }
        scene.bindings()
                .onKey(Key.PAGE_DOWN, "next scene", () -> show(current + 1))
                .onKey(Key.PAGE_UP, "previous scene", () -> show(current - 1))
                .onKey(Key.R, "restart", this::startAgain)
                .onKey(Key.B, "throw a ball", this::throwBall)
                .onKey(
                        Key.HOME,
                        "look from the start",
                        () -> {
                            SceneBuilder now = built;
                            if (now != null) {
                                now.view().place(scene().camera());
                            }
                        })
                .onKey(Key.COMMA, "back in time", this::back)
                .onKey(Key.PERIOD, "forth in time", this::forth)
                .onKey(Key.K, "keep moment", this::keepMoment)
                .onKey(Key.L, "to kept moment", this::backToKept)
                .onKey(Key.H, "hide panels", panels::toggleHidden)
                .onScroll("pull nearer, push away", hand::scroll)
                .onScroll("raise, lower in the editor", editorPanels::raise);
        editorPanels.bind(scene.bindings());
    }

    private void remember(Scene scene) {
        timeline.begin(scene.physics(), stage.rests() ? null : built);
    }

    // Time; simulation thread ------------------------------------------------------------------

    /** Goes to a moment of the past, or forth again. */
    void goTo(long tick) {
        hand.release();
        timeline.goTo(tick);
        publishState();
    }

    /** Pauses, and goes back by a moment. */
    void back() {
        setPaused(true);
        hand.release();
        timeline.back();
        publishState();
    }

    /** Pauses, and goes forth by a moment; beyond the last one by a tick that is computed. */
    void forth() {
        if (!isPaused()) {
            setPaused(true);
            return;
        }
        hand.release();
        if (timeline.forth()) {
            publishState();
        } else {
            singleStep();
        }
    }

    /** Keeps this moment, to come back to it and compare. */
    void keepMoment() {
        hand.release();
        timeline.keep();
        publishState();
    }

    /** Goes back to the moment that was kept. */
    void backToKept() {
        hand.release();
        if (timeline.backToKept()) {
            setPaused(true);
        }
        publishState();
    }

    void forgetFutures() {
        timeline.forgetFutures();
        publishState();
    }

    // What panels and keys ask for; simulation thread ------------------------------------------

    /** Shows a scene; the index wraps around. */
    void show(int index) {
        current = Math.floorMod(index, scenes.size());
        if (stage.shown() != null) {
            stage.forget();
            editorPanels.ask(Editor::left);
            setPaused(false);
        }
        restart();
    }

    /** Starts the scene again, seen from where the user is. */
    void startAgain() {
        keepCamera = true;
        restart();
    }

    /** Changes a parameter and starts again. */
    void set(String parameter, double value) {
        SceneOptions old = chosenOptions();
        Map<String, Double> values = new LinkedHashMap<>(old.values());
        values.put(parameter, value);
        options.put(scenes.get(current).id(), new SceneOptions(values, old.seed(), old.obj()));
        refits = true;
        startAgain();
    }

    /** Puts all parameters of the scene back. */
    void setDefaults() {
        SampleScene chosen = scenes.get(current);
        SceneOptions old = chosenOptions();
        options.put(
                chosen.id(),
                new SceneOptions(SceneOptions.defaults(chosen).values(), old.seed(), old.obj()));
        refits = true;
        startAgain();
    }

    /** Changes the solver or the workers while the scene runs. */
    void solve(int newWorkers, int newSubsteps) {
        workers = newWorkers;
        substeps = newSubsteps;
        PhysicsWorld world = scene().physics();
        world.ecs().jobs().limit(workers);
        world.setSubsteps(substeps);
        publishState();
    }

    /** Number of the last tick; simulation thread. For tests. */
    long builtTick() {
        SceneBuilder now = built;
        return now == null ? -1 : now.tick();
    }

    /** What keys do; any thread may read, the simulation thread binds. */
    Bindings keyBindings() {
        return scene().bindings();
    }

    void ball(Ball value) {
        ball = value;
    }

    void throwBall() {
        if (stage.rests()) {
            return; // What is edited is the file's contents and nothing else.
        }
        Camera camera = scene().camera();
        Vector3d eye = camera.position(new Vector3d());
        Vector3d ahead = camera.forward(new Vector3d());
        Sphere shape = Sphere.of(ball.radius);
        double start = ball.radius + camera.near() + 0.3;
        scene().add(
                        Body.dynamic()
                                .shape(shape)
                                .at(
                                        eye.x + start * ahead.x,
                                        eye.y + start * ahead.y,
                                        eye.z + start * ahead.z)
                                .velocity(
                                        ball.speed * ahead.x,
                                        ball.speed * ahead.y,
                                        ball.speed * ahead.z)
                                .material(
                                        Material.DEFAULT
                                                .withDensity(ball.density)
                                                .withRestitution(0.5))
                                .name("ball " + ++thrown),
                        Model.of(shape).color(Palette.BASKETBALL));
        publishState(); // also in a pause
    }

    void grab(long entity, double distance, Vector3d localPoint) {
        BodyRef body = scene().physics().bodyOf(entity);
        if (body != null) {
            hand.grab(scene().physics(), body, distance, localPoint);
            publishState();
        }
    }

    void pull(Vector3d eye, Vector3d direction) {
        hand.aim(eye, direction);
    }

    void letGo() {
        hand.release();
    }

    // Ticks ------------------------------------------------------------------------------------

    @Override
    protected void update(double seconds) {
        timeline.goingOn();
        SceneBuilder now = built;
        if (now != null) {
            now.beforeTick();
        }
        hand.apply();
        stepStartNanos = System.nanoTime();
    }

    @Override
    protected void updated(double seconds) {
        if (stage.rests()) {
            // The user let time pass, by the pause key or a single step: that is to play.
            editorPanels.ask(Editor::play);
        }
        double millis = (System.nanoTime() - stepStartNanos) / 1e6;
        SceneBuilder now = built;
        if (now != null) {
            now.afterTick();
            for (; remarksShown < now.remarks().size(); remarksShown++) {
                out.println(now.remarks().get(remarksShown));
            }
        }
        timeline.remember();
        history.add(scene().physics(), now, millis);
        publishState();
    }

    private void publishState() {
        SandboxState state = states.writing();
        SampleScene chosen = scenes.get(current);
        SceneBuilder now = built;
        state.scene = current;
        state.options = chosenOptions();
        state.tick = now == null ? 0 : now.tick();
        state.seconds = now == null ? 0 : now.tick() * now.stepSeconds();
        state.workers = workers;
        state.substeps = substeps;
        state.bodies = scene().physics().bodyCount();
        state.problem = problem;
        state.id = chosen.id();
        state.ball = ball;
        state.entities = stage.entities();
        state.notes = notes();
        hand.describe(state);
        timeline.describe(state);
        state.history.copy(history);
        states.publish();
    }

    /** What is said of an edited scene; made anew only after it has something more to say. */
    @SuppressWarnings("ReferenceEquality")
    private String notes() {
        EditorStage.Shown edited = stage.shown();
        SceneBuilder now = built;
        if (edited == null || now == null) {
            return "";
        }
        int said = now.remarks().size() + problem.length();
        if (edited == notedFor && said == notedSize) {
            return noted;
        }
        notedFor = edited;
        notedSize = said;
        noted = notes(edited, now);
        return noted;
    }

    private String notes(EditorStage.Shown edited, SceneBuilder now) {
        List<String> lines = new ArrayList<>(now.remarks());
        if (!problem.isEmpty()) {
            lines.add(problem);
        }
        double tick = edited.scene().tick().seconds();
        if (tick != windowStepSeconds) {
            lines.add(
                    "ticks are %s s here and %s s in the scene; open it by --scene-file"
                            .formatted(windowStepSeconds, tick));
        }
        return String.join("; ", lines);
    }

    // Window thread ----------------------------------------------------------------------------

    @Override
    protected void panels(Ui ui, View view) {
        SandboxState state = states.latest();
        editorPanels.hear();
        if (editor.mode() == Editor.Mode.CLOSED) {
            panels.draw(ui, view, state);
        } else {
            editorPanels.draw(ui, view, state.entities, state.notes);
            if (editor.mode() == Editor.Mode.PLAYING) {
                panels.drawPlaying(ui, view, state);
            }
        }
        leaving.draw(ui);
        shown(ui, view, state);
    }

    @Override
    protected boolean dismiss() {
        return leaving.dismiss() || editorPanels.dismiss();
    }

    @Override
    protected boolean closing() {
        return leaving.mayLeave();
    }

    /** Called after the panels of a frame; window thread. For tests. */
    void shown(Ui ui, View view, SandboxState state) {}
}
