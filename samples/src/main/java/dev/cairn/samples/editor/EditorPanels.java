package dev.cairn.samples.editor;

import dev.cairn.render.app.View;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Key;
import dev.cairn.render.ui.TextBuffer;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.editor.files.FileDialog;
import dev.cairn.samples.editor.gizmo.Gizmo;
import dev.cairn.samples.panel.Places;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.SceneFile.CameraSpec;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;
import dev.cairn.samples.scenefile.edit.GroupEdit;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;

/**
 * The panels of the editor, and what the mouse does to the scene. Window thread; keys, which are
 * bound to the simulation thread, reach it by {@link #ask}.
 */
public final class EditorPanels {
    private static final double GAP = Places.GAP;
    private static final double LEFT_WIDTH = Places.WIDTH;
    private static final double MESSAGE_HEIGHT = 110;

    /** Height of what is shown while the scene runs, logical pixels. */
    public static final double PLAYING_HEIGHT = 150;

    private static final Gizmo.Mode[] MODES = Gizmo.Mode.values();
    private static final String[] TOOLS = {"Move", "Turn", "Scale"};
    private static final String[] CHOSEN_TOOLS = {"[Move]", "[Turn]", "[Scale]"};
    private static final int PROBLEM = 0xFF7A7A;

    /** Frames without an edit after which the next one is a step of its own. */
    private static final int REST_FRAMES = 30;

    private static final String DUPLICATE = "editor: duplicate";
    private static final double RAISE = 0.1;

    /** Files that are taken in one drop; a whole folder of them was hardly meant. */
    private static final int MOST_DROPPED = 100;

    private final Editor editor;
    private final EntityPanel entity;
    private final JointPanel joint;
    private final EditorMouse mouse;
    private final ConcurrentLinkedQueue<Consumer<Editor>> asked = new ConcurrentLinkedQueue<>();
    private String fileName = "scene.json";
    private String meshName = "";
    private @Nullable Path shownFile;
    private final Titles titles = new Titles();
    private final TextBuffer text = new TextBuffer();

    private final FileDialog chooser = new FileDialog();
    private final SelectionLines lines = new SelectionLines();
    private int stepsBefore;
    private int restFrames;

    /** Whether the camera shall go to what is selected. */
    private boolean frames;

    /**
     * Panels.
     *
     * @param editor what they show and act on
     */
    public EditorPanels(Editor editor) {
        this.editor = editor;
        this.entity = new EntityPanel(editor);
        this.joint = new JointPanel(editor);
        this.mouse = new EditorMouse(editor);
    }

    /**
     * Has something done to the editor before the next frame. Any thread.
     *
     * @param action what to do
     */
    public void ask(Consumer<Editor> action) {
        asked.add(action);
    }

    /**
     * Binds the editor's keys. Simulation thread.
     *
     * @param bindings of the application
     */
    public void bind(Bindings bindings) {
        bindings.onKey(
                        Key.F2,
                        "editor",
                        () ->
                                ask(known -> {
                                    if (known.mode() == Editor.Mode.CLOSED) {
                                        known.open();
                                    } else {
                                        known.close();
                                    }
                                }))
                .onKey(
                        Key.F5,
                        "editor: play, stop",
                        () ->
                                ask(known -> {
                                    if (known.mode() == Editor.Mode.PLAYING) {
                                        known.stop();
                                    } else {
                                        known.play();
                                    }
                                }))
                .onChord(Key.Z, "editor: undo", () -> askAtRest(Editor::undo))
                .onChord(Key.Y, "editor: redo", () -> askAtRest(Editor::redo))
                .onChord(Key.S, "editor: save", () -> askOpen(known -> save()))
                .onChord(Key.C, "editor: copy", () -> askAtRest(known -> known.group().copy()))
                .onChord(Key.V, "editor: paste", () -> askAtRest(known -> known.group().paste()))
                .onChord(Key.D, DUPLICATE, () -> askAtRest(known -> known.group().duplicate()))
                .onKey(Key.C, DUPLICATE, () -> askAtRest(known -> known.group().duplicate()))
                .onChord(Key.A, "editor: all", () -> askAtRest(known -> known.group().selectAll()))
                .onKey(Key.G, "editor: put down", () -> askAtRest(known -> known.group().drop()))
                .onKey(Key.T, "editor: next tool", () -> askAtRest(known -> nextTool()))
                .onKey(Key.F, "editor: look at it", () -> askAtRest(known -> frames = true))
                .onKey(Key.DELETE, "editor: delete", () -> askAtRest(Editor::delete));
    }

    private void askOpen(Consumer<Editor> action) {
        if (editor.mode() != Editor.Mode.CLOSED) {
            ask(action);
        }
    }

    private void askAtRest(Consumer<Editor> action) {
        if (editor.mode() == Editor.Mode.REST) {
            ask(action);
        }
    }

    /**
     * The handles at what is selected.
     *
     * @return the same object each time
     */
    public Gizmo gizmo() {
        return mouse.gizmo();
    }

    /** Does what keys asked for; once a frame, also while the editor is closed. */
    public void hear() {
        for (Consumer<Editor> next = asked.poll(); next != null; next = asked.poll()) {
            next.accept(editor);
        }
    }

    /**
     * Takes the files that were dropped into the window: a scene is loaded, a mesh placed under the
     * cursor, a picture put on what is there. Once a frame, also while the editor is closed.
     *
     * @param view what the frame shows
     * @param entities the world's entity for each of the scene's, in its order
     */
    public void dropped(View view, long[] entities) {
        List<Path> files = view.dropped();
        if (files.isEmpty()) {
            return;
        }
        if (editor.mode() == Editor.Mode.CLOSED) {
            editor.open();
        }
        editor.stop();
        if (files.size() > MOST_DROPPED) {
            editor.fail(files.size() + " files: at most " + MOST_DROPPED + " are taken at once");
            return;
        }
        int refused = 0;
        for (int i = 0; i < files.size(); i++) {
            mouse.dropped(view, entities, files.get(i));
            refused += editor.isWrong() ? 1 : 0;
        }
        if (refused > 1) {
            editor.fail(
                    "%d of %d files were not taken, the last one since: %s"
                            .formatted(refused, files.size(), editor.message()));
        }
    }

    /** Saves the scene under the name in the panel. Window thread. */
    public void save() {
        editor.files().save(fileName);
    }

    /**
     * Takes one step back: what is selected is let go, a scene that runs is stopped, the editor is
     * closed, which loses nothing. Window thread.
     *
     * @return false if the editor was closed
     */
    public boolean dismiss() {
        switch (editor.mode()) {
            case CLOSED -> {
                return false;
            }
            case PLAYING -> editor.stop();
            case REST -> {
                if (chooser.dismiss()) {
                    return true;
                }
                EditorJoints joints = editor.joints();
                boolean isFree = editor.selected() == Editor.NOTHING;
                if (joints.awaited() != EditorJoints.Click.NONE) {
                    joints.cancel();
                } else if (isFree && joints.selected() == Editor.NOTHING) {
                    editor.close();
                } else {
                    editor.select(Editor.NOTHING);
                }
            }
        }
        return true;
    }

    /**
     * Raises what is selected; the wheel. Any thread.
     *
     * @param steps of the wheel
     */
    public void raise(double steps) {
        ask(known -> {
            if (known.mode() == Editor.Mode.REST) {
                known.group()
                        .changeAll(
                                "raise",
                                (scene, which) ->
                                        GroupEdit.move(scene, which, new Xyz(0, RAISE * steps, 0)));
            }
        });
    }

    /**
     * Draws the panels of an open editor.
     *
     * @param ui what panels are made of
     * @param view what the frame shows
     * @param entities the world's entity for each of the scene's, in its order
     * @param notes what the world had to say about the scene; may be empty
     */
    public void draw(Ui ui, View view, long[] entities, String notes) {
        if (editor.mode() == Editor.Mode.PLAYING) {
            playing(ui);
            return;
        }
        if (!Objects.equals(shownFile, editor.file())) {
            Path file = editor.file();
            shownFile = file;
            fileName = file == null ? fileName : String.valueOf(file.getFileName());
        }
        mouse.frame(view, entities);
        if (frames && editor.selection().length > 0) {
            Sizes.around(chosen()).frame(view.camera());
        }
        frames = false;
        boolean picks = editor.selectedEntity() != null || editor.joints().selectedJoint() != null;
        if (!Places.isNarrow(ui) || !picks) {
            left(ui, view, notes);
        }
        if (!Places.isNarrow(ui) || picks) {
            right(ui);
        }
        message(ui);
        lines.draw(view, editor);
        chosenFile(ui, view);
        seal();
    }

    private void left(Ui ui, View view, String notes) {
        double height = Places.height(ui);
        double upper = Places.upperHeight(height);
        if (ui.panel("Editor", GAP, GAP, LEFT_WIDTH, upper)) {
            actions(ui, view);
            if (!notes.isEmpty()) {
                ui.label("The world says:", PROBLEM);
                ui.text(notes);
            }
            palette(ui, view);
        }
        ui.endPanel();
        list(ui, upper + 2 * GAP, height - upper - GAP);
    }

    /** Over the first column where there is one only; to let go of what is selected goes back. */
    private void right(Ui ui) {
        double right = Places.right(ui);
        double height = Places.height(ui);
        if (editor.joints().selectedJoint() == null) {
            entity.draw(ui, right, GAP, LEFT_WIDTH, height);
        } else {
            joint.draw(ui, right, GAP, LEFT_WIDTH, height);
        }
    }

    private void chosenFile(Ui ui, View view) {
        FileDialog.Taken taken = chooser.draw(ui);
        if (taken == null) {
            return;
        }
        String name = editor.files().relative(taken.file());
        if (taken.saves()) {
            fileName = name; // so that "save once more" means this file
            save();
        } else if (name.endsWith(".json")) {
            editor.files().load(name);
        } else {
            editor.placeMesh(name, mouse.free(view, Supply.ANY_MESH));
        }
    }

    private List<EntitySpec> chosen() {
        return Arrays.stream(editor.selection()).mapToObj(editor.scene().entities()::get).toList();
    }

    private void nextTool() {
        Gizmo gizmo = mouse.gizmo();
        gizmo.mode(
                switch (gizmo.mode()) {
                    case MOVE -> Gizmo.Mode.TURN;
                    case TURN -> Gizmo.Mode.SCALE;
                    case SCALE -> Gizmo.Mode.MOVE;
                });
    }

    /** What the handles at the selection do. */
    private void tools(Ui ui) {
        ui.columns(3);
        for (int i = 0; i < MODES.length; i++) {
            boolean chosen = MODES[i] == mouse.gizmo().mode();
            if (ui.button(chosen ? CHOSEN_TOOLS[i] : TOOLS[i])) {
                mouse.gizmo().mode(MODES[i]);
            }
        }
    }

    private void playing(Ui ui) {
        if (ui.panel("Editor", GAP, GAP, LEFT_WIDTH, PLAYING_HEIGHT)) {
            ui.heading(editor.scene().name());
            ui.columns(2);
            if (ui.button("Stop (F5)")) {
                editor.stop();
            }
            if (ui.button("Close (F2)")) {
                editor.close();
            }
            ui.text("The scene runs. Stop goes back to the scene as it was edited.");
        }
        ui.endPanel();
    }

    private void actions(Ui ui, View view) {
        ui.columns(3);
        if (ui.button("Play (F5)")) {
            editor.play();
        }
        if (ui.button("New")) {
            editor.files().startNew();
        }
        if (ui.button("Close (F2)")) {
            editor.close();
        }
        ui.columns(2);
        if (ui.button("Undo (Ctrl+Z)")) {
            editor.undo();
        }
        if (ui.button("Redo (Ctrl+Y)")) {
            editor.redo();
        }
        String label = editor.history().undoLabel();
        int steps = editor.history().steps();
        text.clear().put(steps).put(steps == 1 ? " step" : " steps");
        ui.columns(1);
        ui.label(editor.isChanged() ? text.put(", unsaved") : text);
        ui.text(label == null ? "nothing to undo" : label);
        tools(ui);
        fileName = ui.textField("file", fileName);
        ui.columns(2);
        if (ui.button("Save")) {
            save();
        }
        if (ui.button("Load")) {
            editor.files().load(fileName);
        }
        ui.columns(3);
        if (ui.button("Open...")) {
            chooser.open("Open a scene", editor.files().folder(), ".json");
        }
        if (ui.button("Save as...")) {
            chooser.save("Save the scene", editor.files().folder(), ".json", shortName());
        }
        if (ui.button("Keep view")) {
            keepView(view.camera());
        }
    }

    /**
     * What the editor has to say, below the picture: among the buttons it would push them away from
     * under the mouse.
     */
    private void message(Ui ui) {
        if (editor.message().isEmpty()) {
            return;
        }
        double left = Places.belowLeft(ui.width());
        double width = Places.belowWidth(ui.width());
        double top = ui.height() - MESSAGE_HEIGHT - GAP;
        if (ui.panel("Message", left, top, width, MESSAGE_HEIGHT)) {
            if (editor.isWrong()) {
                ui.label("That did not work:", PROBLEM);
            }
            ui.text(editor.message());
        }
        ui.endPanel();
    }

    /** The name of the file without folders. */
    private String shortName() {
        return fileName.substring(fileName.replace('\\', '/').lastIndexOf('/') + 1).strip();
    }

    private void palette(Ui ui, View view) {
        ui.heading("Place");
        ui.columns(3);
        for (int i = 0; i < Supply.ITEMS.size(); i++) {
            Supply.Item item = Supply.ITEMS.get(i);
            if (ui.button(item.name())) {
                EntitySpec made = EntitySpec.of(item.name(), item.body(), item.shape());
                editor.place(made.at(mouse.free(view, made), Turn.NONE).withName(item.name()));
            }
        }
        meshName = ui.textField("mesh (.obj)", meshName);
        ui.columns(2);
        if (ui.button("Choose...")) {
            chooser.open("Choose a mesh", editor.files().folder(), ".obj");
        }
        if (ui.button("Place mesh")) {
            editor.placeMesh(meshName, mouse.free(view, Supply.ANY_MESH));
        }
        ui.columns(1);
        mouse.snaps(ui.checkbox("snap: 0.25 m, 15 degrees", mouse.snaps()));
    }

    private void list(Ui ui, double top, double height) {
        List<EntitySpec> entities = editor.scene().entities();
        if (ui.panel("Entities", GAP, top, LEFT_WIDTH, height)) {
            for (int i = 0; i < entities.size(); i++) {
                if (ui.item(titles.of(i, entities.get(i)), editor.isSelected(i), "")) {
                    editor.select(i == editor.selected() ? Editor.NOTHING : i);
                }
            }
            EditorJoints joints = editor.joints();
            int count = editor.scene().joints().size();
            for (int i = 0; i < count && i < editor.scene().joints().size(); i++) {
                if (ui.item(titles.joint(i, editor.scene()), i == joints.selected(), "")) {
                    joints.select(i == joints.selected() ? Editor.NOTHING : i);
                }
            }
        }
        ui.endPanel();
    }

    private void keepView(Camera camera) {
        Vector3d eye = camera.position(new Vector3d());
        Vector3d target = camera.forward(new Vector3d()).mul(5).add(eye);
        editor.camera(
                new CameraSpec(
                        new Xyz(eye.x, eye.y, eye.z),
                        new Xyz(target.x, target.y, target.z),
                        editor.scene().camera().fieldOfViewDegrees()));
    }

    /** A slider that has rested for a while begins a new step when it moves again. */
    private void seal() {
        if (editor.edits() != stepsBefore) {
            stepsBefore = editor.edits();
            restFrames = 0;
        } else if (++restFrames == REST_FRAMES && !mouse.isBusy()) {
            editor.seal();
        }
    }
}
