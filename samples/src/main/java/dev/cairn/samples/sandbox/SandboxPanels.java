package dev.cairn.samples.sandbox;

import dev.cairn.render.app.Pick;
import dev.cairn.render.app.View;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.MouseButton;
import dev.cairn.render.input.Pointer;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.editor.EditorPanels;
import dev.cairn.samples.film.Thumbnails;
import dev.cairn.samples.panel.Places;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The panels of the sandbox. Window thread; acts on the world by posting only. */
final class SandboxPanels {
    private static final double GAP = Places.GAP;
    private static final double LEFT_WIDTH = Places.WIDTH;
    private static final double TABS_HEIGHT = 76;
    static final String SEARCH = "search";
    private static final int WORLD_TAB = 2;
    private static final String[] TABS = {"Scenes", "Scene", "World"};
    private static final String[] CHOSEN_TABS = {"[Scenes]", "[Scene]", "[World]"};
    private static final int ROPE = 0xFFE082;
    private static final long DOUBLE_NANOS = 400_000_000;

    private static final int PROBLEM = 0xFF7A7A;

    private final Sandbox sandbox;
    private final List<SampleScene> scenes;
    private final List<Ui.@Nullable Part> thumbnails;
    private final SimulationPanel simulation;
    private final TimePanel time;
    private final List<String> groups = new ArrayList<>();

    /** Values that were asked for and may not have come back from the simulation yet. */
    private final Map<String, Double> asked = new HashMap<>();

    private String sought = "";
    private boolean listed;
    private final boolean[] isHit;
    private final int[] hits;
    private int tab;
    private int shownScene = -1;
    private long pressedEntity = Camera.NOTHING;
    private long pressedNanos;
    private long pressedFrame;
    private boolean pulling;
    private final Readings readings = new Readings();
    private volatile boolean hidden;

    SandboxPanels(Sandbox sandbox, List<SampleScene> scenes) {
        this.sandbox = sandbox;
        this.scenes = scenes;
        this.thumbnails = Thumbnails.of(scenes);
        this.simulation = new SimulationPanel(sandbox, readings);
        this.time = new TimePanel(sandbox, readings);
        for (SampleScene scene : scenes) {
            if (!groups.contains(scene.group())) {
                groups.add(scene.group());
            }
        }
        isHit = new boolean[scenes.size()];
        hits = new int[groups.size()];
    }

    /** How many scenes the search leaves. */
    int listed() {
        return Arrays.stream(hits).sum();
    }

    /** The words that are searched for. */
    String sought() {
        return sought;
    }

    void toggleHidden() {
        hidden = !hidden;
    }

    void draw(Ui ui, View view, SandboxState state) {
        hand(view, state);
        time.ghosts(view, state);
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
        if (Places.isNarrow(ui)) {
            oneOfThree(ui, view, state);
        } else {
            tab = WORLD_TAB; // where the buttons are that make the window narrow
            double height = Places.height(ui);
            double listHeight = Math.max(160, height * 0.5);
            scenes(ui, state, GAP, listHeight);
            chosen(ui, state, listHeight + 2 * GAP, height - listHeight - GAP);
            simulation.draw(ui, view, state, GAP, false);
        }
        time.draw(ui, state);
    }

    /** Takes the numbers of now where panels are made anew; has them stay where they may. */
    void read(Ui ui, View view, SandboxState state) {
        boolean stands = sandbox.isPaused();
        if (readings.mustShow(state, stands) || !ui.keep()) {
            readings.read(state, view.framesPerSecond(), stands, System.nanoTime());
        }
    }

    /** The part that goes with an edited scene that runs. */
    void drawPlaying(Ui ui, View view, SandboxState state) {
        hand(view, state);
        time.ghosts(view, state);
        time.draw(ui, state);
        double above = Places.isNarrow(ui) ? EditorPanels.PLAYING_HEIGHT + GAP : 0;
        simulation.draw(ui, view, state, GAP + above, true);
    }

    /** Where there is room for one column: the panels take turns. */
    private void oneOfThree(Ui ui, View view, SandboxState state) {
        if (ui.panel("Cairn", GAP, GAP, LEFT_WIDTH, TABS_HEIGHT)) {
            ui.columns(3);
            for (int i = 0; i < TABS.length; i++) {
                if (ui.button(i == tab ? CHOSEN_TABS[i] : TABS[i])) {
                    tab = i;
                }
            }
        }
        ui.endPanel();
        double top = TABS_HEIGHT + 2 * GAP;
        double height = ui.height() - top - GAP;
        switch (tab) {
            case 0 -> scenes(ui, state, top, height);
            case 1 -> chosen(ui, state, top, height);
            default -> simulation.draw(ui, view, state, top, false);
        }
    }

    // The hand ---------------------------------------------------------------------------------

    private void hand(View view, SandboxState state) {
        Pointer pointer = view.pointer();
        if (pointer.wasPressed(MouseButton.LEFT)) {
            Pick pick = view.pick(pointer.across(), pointer.upwards());
            if (pick != null) {
                if (isDouble(pick.entity(), pointer.presses(MouseButton.LEFT), view.frames())) {
                    sandbox.post(() -> sandbox.follow(pick.entity()));
                    return;
                }
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

    /**
     * Whether this press is the second on one thing. When it was is known to a frame, so that in
     * slow frames the second one is what comes in the same frame or the next.
     */
    private boolean isDouble(long entity, int presses, long frame) {
        long now = System.nanoTime();
        boolean soon = now - pressedNanos < DOUBLE_NANOS || frame <= pressedFrame + 1;
        boolean second = presses > 1 || (entity == pressedEntity && soon);
        pressedEntity = second ? Camera.NOTHING : entity;
        pressedNanos = now;
        pressedFrame = frame;
        return second;
    }

    // Left -------------------------------------------------------------------------------------

    private void scenes(Ui ui, SandboxState state, double top, double height) {
        if (ui.panel("Scenes", GAP, top, LEFT_WIDTH, height)) {
            search(ui);
            // By index: an iterator would be garbage of every frame.
            for (int g = 0; g < groups.size(); g++) {
                String group = groups.get(g);
                if (hits[g] > 0 && ui.section(group, true)) {
                    for (int i = 0; i < scenes.size(); i++) {
                        SampleScene scene = scenes.get(i);
                        if (isHit[i]
                                && scene.group().equals(group)
                                && item(ui, i, i == state.scene)) {
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

    private boolean item(Ui ui, int scene, boolean shown) {
        Ui.Part picture = thumbnails.get(scene);
        String title = scenes.get(scene).title();
        return picture == null ? ui.item(title, shown, "") : ui.item(title, shown, "", picture);
    }

    /** A field for words; only scenes whose texts have all of them are listed. */
    private void search(Ui ui) {
        String typed = ui.textField(SEARCH, sought);
        if (typed.equals(sought) && listed) {
            return;
        }
        listed = true;
        sought = typed;
        String[] words = typed.toLowerCase(Locale.ROOT).strip().split("\\s+");
        Arrays.fill(hits, 0);
        for (int i = 0; i < scenes.size(); i++) {
            SampleScene scene = scenes.get(i);
            String texts =
                    (scene.id()
                                    + " "
                                    + scene.title()
                                    + " "
                                    + scene.group()
                                    + " "
                                    + scene.description())
                            .toLowerCase(Locale.ROOT);
            isHit[i] = Arrays.stream(words).allMatch(texts::contains);
            hits[groups.indexOf(scene.group())] += isHit[i] ? 1 : 0;
        }
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
            List<Parameter> parameters = scene.parameters();
            for (int i = 0; i < parameters.size(); i++) {
                parameter(ui, state, parameters.get(i));
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
        Double set = state.options.values().get(parameter.name());
        Double wanted = asked.get(parameter.name());
        double known = set == null ? 0 : set;
        double shown = wanted == null ? known : wanted;
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
        } else if (wanted != null && value == known) {
            asked.remove(parameter.name());
        }
    }
}
