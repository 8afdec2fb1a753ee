package dev.cairn.samples.sandbox;

import dev.cairn.core.ecs.EcsSystem;
import dev.cairn.core.snapshot.TripleBuffer;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.render.app.Application;
import dev.cairn.render.app.DebugLayer;
import dev.cairn.render.app.Scene;
import dev.cairn.render.app.View;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Key;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.UsageException;
import dev.cairn.samples.editor.Editor;
import dev.cairn.samples.editor.EditorPanels;
import dev.cairn.samples.editor.files.LeaveQuestion;
import dev.cairn.samples.replay.Act.What;
import dev.cairn.samples.replay.Looks;
import dev.cairn.samples.replay.RunFile;
import dev.cairn.samples.scenefile.SceneExport;
import dev.cairn.samples.scenefile.SceneFile;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;

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
    private final List<SampleScene> scenes;
    private final SandboxPanels panels;
    private final EditorStage stage = new EditorStage(this);
    private final Editor editor = new Editor(stage);
    private final EditorPanels editorPanels = new EditorPanels(editor);
    private final LeaveQuestion leaving = new LeaveQuestion(editor, editorPanels, this::leave);
    private boolean editsJoints;
    private boolean drewJoints;
    private double windowStepSeconds = SampleScene.STEP_SECONDS;
    private final TripleBuffer<SandboxState> states = new TripleBuffer<>(SandboxState::new);

    // The simulation thread's own, from initScene on.
    private final SceneChoice choice;
    private final BuiltScene built;
    private final PlotHistory history = new PlotHistory();
    private final Diary diary = new Diary();
    private final MouseHand hand = new MouseHand(diary);
    private final Thrower thrower = new Thrower(diary);
    private final TimeTravel time = new TimeTravel(this, diary, hand);
    private final StageNotes notes = new StageNotes();
    private double tickSeconds = SampleScene.STEP_SECONDS;
    private int workers;
    private int substeps;
    private PhysicsSettings settings = PhysicsSettings.DEFAULT;
    private final boolean sleeping;
    private boolean bound;
    private long stepStartNanos;

    private @Nullable String noWindow;
    private final MomentFiles files;

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
        this.choice = new SceneChoice(scenes, options);
        this.built = new BuiltScene(choice, stage, out);
        this.files = new MomentFiles(this, choice, stage, built, time, out);
        this.workers = workers;
        this.substeps = substeps;
        this.sleeping = sleeping;
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
        choice.show(scene);
    }

    /**
     * Begins with a saved moment of that scene; before {@link #start}.
     *
     * @param file which one, null for the scene's own beginning
     */
    public void beginAt(@Nullable RunFile file) {
        built.beginAt(file);
    }

    /**
     * Has the run of the scene be written to a file when the window is closed, from the scene's
     * last beginning on; before {@link #start}.
     *
     * @param file where to
     */
    public void record(Path file) {
        files.record(file);
    }

    /**
     * Why there is no file; after {@link #start}.
     *
     * @return the reason, or null if it is there or was not wanted
     */
    public @Nullable String notRecorded() {
        return files.notRecorded();
    }

    /** The editor; window thread. For tests. */
    Editor editor() {
        return editor;
    }

    /** The editor's panels; window thread. For tests. */
    EditorPanels editorPanels() {
        return editorPanels;
    }

    /** The panels beside the editor's; window thread. For tests. */
    SandboxPanels scenePanels() {
        return panels;
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
                        .seed(choice.options().seed())
                        .systems(
                                edited == null
                                        ? choice.scene().systems(choice.options())
                                        : new EcsSystem[0])
                        .build();
        // The others are parked until the slider asks for them.
        world.ecs().jobs().limit(workers);
        return world;
    }

    @Override
    protected void initScene(Scene scene) {
        if (!bound) {
            // Once, so that keys that were rebound stay so.
            SandboxKeys.bind(
                    scene.bindings(), this, time, scenes, () -> built.lookFromStart(scene()));
            scene.bindings()
                    .onKey(Key.H, "hide panels", panels::toggleHidden)
                    .onScroll("pull nearer, push away", hand::scroll)
                    .onScroll("raise, lower in the editor", editorPanels::raise);
            editorPanels.bind(scene.bindings());
            KeyRows.load(scene.bindings());
            bound = true;
        }
        scene.physics().profile().enable();
        scene.onDrive(diary::drive).onFailure(stage::goesOnAfter);
        hand.release();
        history.clear();
        thrower.begin();
        built.begin(scene, substeps);
        time.begin(scene.physics(), stage.rests() ? null : built.now());
        publishState();
    }

    /** Starts the edited scene from its beginning. */
    void showEdited(boolean placesCamera) {
        built.seen(!placesCamera, false);
        restart();
    }

    /** Puts the edited scene as it is now in place of what the world holds. */
    void rebuildEdited() {
        time.timeline().begin(scene().physics(), null);
        built.rebuild(scene(), substeps);
        publishState();
    }

    /** Opens the editor with what the present scene begins with. */
    void editCopy() {
        SampleScene chosen = choice.scene();
        Path folder = Path.of("").toAbsolutePath();
        try {
            SceneFile copy = SceneExport.of(chosen, choice.options(), substeps, folder);
            editorPanels.ask(known -> known.openCopy(copy, folder));
        } catch (UsageException misuse) {
            built.problem(misuse);
            publishState();
        }
    }

    // What panels and keys ask for; simulation thread ------------------------------------------

    /** Shows a scene; the index wraps around. */
    void show(int index) {
        choice.show(index);
        if (stage.shown() != null) {
            stage.forget();
            editorPanels.ask(Editor::close);
            setPaused(false);
        }
        restart();
    }

    /** Starts the scene again, seen from where the user is. */
    void startAgain() {
        built.seen(true, false);
        restart();
    }

    /** Shows the scene so many places further down the list. */
    void step(int places) {
        show(choice.index() + places);
    }

    /** Changes a parameter and starts again. */
    void set(String parameter, double value) {
        choice.set(parameter, value);
        built.seen(true, true);
        restart();
    }

    /** Puts all parameters of the scene back. */
    void setDefaults() {
        choice.setDefaults();
        built.seen(true, true);
        restart();
    }

    /** Changes the solver or the workers while the scene runs. */
    void solve(int newWorkers, int newSubsteps) {
        workers = newWorkers;
        if (substeps != newSubsteps) {
            substeps = newSubsteps;
            diary.add(What.SUBSTEPS, 0, substeps, 0, 0);
        }
        PhysicsWorld world = scene().physics();
        world.ecs().jobs().limit(workers);
        world.setSubsteps(substeps);
        publishState();
    }

    /** The present world; simulation thread. */
    PhysicsWorld physics() {
        return scene().physics();
    }

    /** Number of the last tick; simulation thread. For tests. */
    long builtTick() {
        return built.tick();
    }

    /** What keys do; any thread may read, the simulation thread binds. */
    Bindings keyBindings() {
        return scene().bindings();
    }

    /** Throws something or blows it apart. */
    void act(BiConsumer<Scene, Thrower> what) {
        if (!stage.rests()) { // What is edited is the file's contents and nothing else.
            what.accept(scene(), thrower);
            publishState(); // also in a pause
        }
    }

    /** Goes back and forth, and keeps moments. */
    TimeTravel time() {
        return time;
    }

    /** Writes moments, reports and runs to files. */
    MomentFiles files() {
        return files;
    }

    /** With what decides the bits of the present world. */
    MomentWriter writer(
            Path folder, SampleScene scene, String text, SceneOptions options, Looks looks) {
        return new MomentWriter(folder, scene, text, options, substeps, settings, sleeping, looks);
    }

    /** Length of the last tick, s. */
    double tickSeconds() {
        return tickSeconds;
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

    /** What a double click on a body does to the camera. */
    void follow(long entity) {
        String told = built.follow(scene(), entity);
        if (!told.isEmpty()) {
            notice(told);
        }
    }

    void letGo() {
        hand.release();
    }

    // Ticks ------------------------------------------------------------------------------------

    @Override
    protected void update(double seconds) {
        time.timeline().goingOn();
        tickSeconds = seconds;
        if (built.beforeTick()) {
            diary.add(What.BEFORE);
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
        built.afterTick();
        time.ticked();
        history.add(scene().physics(), built.now(), millis);
        publishState();
    }

    /** Tells the panels how things are. */
    void publishState() {
        SandboxState state = states.writing();
        SampleScene chosen = choice.scene();
        SceneBuilder now = built.now();
        state.scene = choice.index();
        state.options = choice.options();
        state.tick = now == null ? 0 : now.tick();
        state.seconds = now == null ? 0 : now.tick() * now.stepSeconds();
        state.workers = workers;
        state.substeps = substeps;
        state.bodies = scene().physics().bodyCount();
        state.problem = built.problem();
        state.id = chosen.id();
        state.ball = thrower.ball();
        state.entities = stage.entities();
        state.notes = notes.of(stage.shown(), now, built.problem(), windowStepSeconds);
        hand.describe(state);
        time.timeline().describe(state);
        state.history.copy(history);
        states.publish();
    }

    // Window thread ----------------------------------------------------------------------------

    @Override
    protected void panels(Ui ui, View view) {
        SandboxState state = states.latest();
        panels.read(ui, view, state);
        thrower.aspect(view.aspect());
        editorPanels.dropped(view, state.entities);
        showJoints(editor.mode() == Editor.Mode.REST);
        if (editor.mode() == Editor.Mode.CLOSED) {
            panels.draw(ui, view, state);
        } else {
            editorPanels.draw(ui, view, state.entities, state.notes);
            if (editor.mode() == Editor.Mode.PLAYING) {
                panels.drawPlaying(ui, view, state);
            }
        }
        // After the mouse: the end of a drag comes before the key that undoes it.
        editorPanels.hear();
        leaving.draw(ui);
        shown(ui, view, state);
    }

    /** Joints are drawn while a scene is edited, whatever is drawn else. */
    private void showJoints(boolean edited) {
        if (edited != editsJoints) {
            editsJoints = edited;
            drewJoints = edited ? isDebug(DebugLayer.JOINTS) : drewJoints;
            debug(DebugLayer.JOINTS, edited || drewJoints);
        }
    }

    @Override
    protected boolean dismiss() {
        return leaving.dismiss() || editorPanels.dismiss();
    }

    private void leave() {
        if (!files.writesBefore(this::quit)) {
            quit();
        }
    }

    @Override
    protected boolean closing() {
        return leaving.mayLeave() && !files.writesBefore(this::quit);
    }

    /** Called after the panels of a frame; window thread. For tests. */
    void shown(Ui ui, View view, SandboxState state) {}
}
