package dev.cairn.samples.editor;

import dev.cairn.render.app.Pick;
import dev.cairn.render.app.View;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Key;
import dev.cairn.render.input.MouseButton;
import dev.cairn.render.input.Pointer;
import dev.cairn.render.ui.TextBuffer;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.SceneFile.CameraSpec;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;

/**
 * The panels of the editor, and what the mouse does to the scene. Window thread; keys, which are
 * bound to the simulation thread, reach it by {@link #ask}.
 */
public final class EditorPanels {
    private static final double GAP = 10;
    private static final double LEFT_WIDTH = 290;
    private static final double PLAYING_HEIGHT = 150;
    private static final int PROBLEM = 0xFF7A7A;

    /** Frames without an edit after which the next one is a step of its own. */
    private static final int REST_FRAMES = 30;

    private static final double RAISE = 0.1;

    /** Where a click over the sky is while nothing is selected, m. */
    private static final double AHEAD = 8;

    /** What places are multiples of while the grid is on, m. */
    private static final double GRID = 0.25;

    /**
     * How far the cursor goes before a click becomes a drag, as a share of the picture's height.
     */
    private static final double STRAY = 0.008;

    private final Editor editor;
    private final EntityPanel entity;
    private final JointPanel joint;
    private final ConcurrentLinkedQueue<Consumer<Editor>> asked = new ConcurrentLinkedQueue<>();
    private String fileName = "scene.json";
    private String meshName = "";
    private @Nullable Path shownFile;
    private @Nullable GroundDrag drag;

    /** Whether the cursor has gone far enough from where the button went down. */
    private boolean drags;

    private double pressedX;
    private double pressedY;
    private boolean snaps = true;
    private final EntityTitles titles = new EntityTitles();
    private final JointTitles jointTitles = new JointTitles();
    private final TextBuffer text = new TextBuffer();

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
                .onChord(Key.D, "editor: duplicate", () -> askAtRest(Editor::duplicate))
                .onKey(Key.C, "editor: duplicate", () -> askAtRest(Editor::duplicate))
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

    /** Does what keys asked for; once a frame, also while the editor is closed. */
    public void hear() {
        for (Consumer<Editor> next = asked.poll(); next != null; next = asked.poll()) {
            next.accept(editor);
        }
    }

    /** Saves the scene under the name in the panel. Window thread. */
    public void save() {
        editor.save(fileName);
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
                known.change(
                        "raise",
                        e -> {
                            double y = e.position().y() + RAISE * steps;
                            double rounded = Math.rint(y * 1000) / 1000;
                            return e.at(
                                    new Xyz(e.position().x(), rounded, e.position().z()),
                                    e.rotation());
                        });
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
        mouse(view, entities);
        EntitySpec chosen = editor.selectedEntity();
        if (frames && chosen != null) {
            Sizes.of(chosen).frame(view.camera(), chosen.position());
        }
        frames = false;
        double height = ui.height() - 2 * GAP;
        double upper = Math.min(height - 150, 420);
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
        double right = ui.width() - LEFT_WIDTH - GAP;
        if (editor.joints().selectedJoint() == null) {
            entity.draw(ui, right, GAP, LEFT_WIDTH, height);
        } else {
            joint.draw(ui, right, GAP, LEFT_WIDTH, height);
        }
        lines.draw(view, editor);
        seal();
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
            editor.startNew();
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
        text.clear().put(editor.history().steps()).put(" steps");
        ui.value(editor.isChanged() ? text.put(", unsaved") : text, label == null ? "" : label);
        fileName = ui.textField("file", fileName);
        ui.columns(3);
        if (ui.button("Save")) {
            save();
        }
        if (ui.button("Load")) {
            editor.load(fileName);
        }
        if (ui.button("Keep view")) {
            keepView(view.camera());
        }
        if (!editor.message().isEmpty()) {
            if (editor.isWrong()) {
                ui.label("That did not work:", PROBLEM);
            }
            ui.text(editor.message());
        }
    }

    private void palette(Ui ui, View view) {
        ui.heading("Place");
        ui.columns(3);
        for (int i = 0; i < Supply.ITEMS.size(); i++) {
            Supply.Item item = Supply.ITEMS.get(i);
            if (ui.button(item.name())) {
                EntitySpec made = EntitySpec.of(item.name(), item.body(), item.shape());
                editor.place(made.at(free(view, made), Turn.NONE).withName(item.name()));
            }
        }
        meshName = ui.textField("mesh (.obj)", meshName);
        ui.columns(1);
        if (ui.button("Place mesh")) {
            editor.placeMesh(meshName, free(view, Supply.ANY_MESH));
        }
        snaps = ui.checkbox("snap to a grid of 0.25 m", snaps);
    }

    private void list(Ui ui, double top, double height) {
        List<EntitySpec> entities = editor.scene().entities();
        if (ui.panel("Entities", GAP, top, LEFT_WIDTH, height)) {
            for (int i = 0; i < entities.size(); i++) {
                if (ui.item(titles.of(i, entities.get(i)), i == editor.selected(), "")) {
                    editor.select(i == editor.selected() ? Editor.NOTHING : i);
                }
            }
            EditorJoints joints = editor.joints();
            int count = editor.scene().joints().size();
            for (int i = 0; i < count && i < editor.scene().joints().size(); i++) {
                if (ui.item(jointTitles.of(i, editor.scene()), i == joints.selected(), "")) {
                    joints.select(i == joints.selected() ? Editor.NOTHING : i);
                }
            }
        }
        ui.endPanel();
    }

    // Mouse ------------------------------------------------------------------------------------

    private void mouse(View view, long[] entities) {
        Pointer pointer = view.pointer();
        if (pointer.wasPressed(MouseButton.LEFT)) {
            take(view, entities);
        } else if (drag != null) {
            // Also in the frame of the release: the way up to it belongs to the drag.
            drags |=
                    Math.hypot((pointer.x() - pressedX) * view.aspect(), pointer.y() - pressedY)
                            > STRAY;
            if (drags) {
                move(view, drag);
            }
            if (!pointer.isDown(MouseButton.LEFT)) {
                drag = null;
                editor.seal();
            }
        }
    }

    private void take(View view, long[] entities) {
        Pointer pointer = view.pointer();
        Pick pick = view.pick(pointer.across(), pointer.upwards());
        int index = pick == null ? Editor.NOTHING : indexOf(pick.entity(), entities);
        if (editor.joints().awaited() != EditorJoints.Click.NONE) {
            editor.joints().click(index, clicked(view, pick));
            return;
        }
        if (index != Editor.NOTHING && Ground.is(editor.scene().entities().get(index))) {
            index = Editor.NOTHING; // A click beside all things: the floor is chosen in the list.
        }
        editor.select(index);
        EntitySpec taken = editor.selectedEntity();
        if (pick != null && taken != null) {
            Vector3d at = view.camera().position(new Vector3d()).fma(pick.distance(), ray(view));
            drag = new GroundDrag(new Xyz(at.x, at.y, at.z), taken.position());
            drags = false;
            pressedX = pointer.x();
            pressedY = pointer.y();
        }
    }

    /** The point under the cursor; over the sky one as far away as what is selected. */
    private Xyz clicked(View view, @Nullable Pick pick) {
        Vector3d eye = view.camera().position(new Vector3d());
        Vector3d along = ray(view);
        EntitySpec near = editor.selectedEntity();
        double far = AHEAD;
        if (pick != null) {
            far = pick.distance();
        } else if (near != null) {
            Xyz at = near.position();
            Vector3d forward = view.camera().forward(new Vector3d());
            double depth = new Vector3d(at.x(), at.y(), at.z()).sub(eye).dot(forward);
            far = Math.max(0, depth) / along.dot(forward);
        }
        Vector3d at = eye.fma(far, along);
        return new Xyz(at.x, at.y, at.z);
    }

    private void move(View view, GroundDrag by) {
        EntitySpec held = editor.selectedEntity();
        if (held != null) {
            Vector3d eye = view.camera().position(new Vector3d());
            Vector3d along = ray(view);
            Xyz to =
                    by.to(
                            new Xyz(eye.x, eye.y, eye.z),
                            new Xyz(along.x, along.y, along.z),
                            held.position(),
                            snaps ? GRID : 0);
            editor.change("drag", e -> e.at(to, e.rotation()));
        }
    }

    private static int indexOf(long wanted, long[] entities) {
        for (int i = 0; i < entities.length; i++) {
            if (entities[i] == wanted) {
                return i;
            }
        }
        return Editor.NOTHING;
    }

    private static Vector3d ray(View view) {
        Pointer pointer = view.pointer();
        return view.camera()
                .ray(pointer.across(), pointer.upwards(), view.aspect(), new Vector3d());
    }

    /** On the ground in the middle of the picture, beside what stands there. */
    private Xyz free(View view, EntitySpec made) {
        Vector3d eye = view.camera().position(new Vector3d());
        Vector3d along = view.camera().forward(new Vector3d());
        List<EntitySpec> all = editor.scene().entities();
        Xyz ahead = Ground.ahead(eye, along, all);
        double grid = snaps ? GRID : 0.001;
        Xyz wanted = new Xyz(GroundDrag.snap(ahead.x(), grid), 0, GroundDrag.snap(ahead.z(), grid));
        Xyz standing = Ground.under(made, wanted, all);
        Xyz aside =
                FreePlace.near(
                        made,
                        standing,
                        all.stream().filter(other -> !Ground.is(other)).toList(),
                        Math.abs(along.z) >= Math.abs(along.x),
                        snaps ? GRID : 0);
        boolean isOnTop = aside.x() == standing.x() && aside.z() == standing.z();
        return isOnTop ? aside : Ground.under(made, aside, all);
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
        } else if (++restFrames == REST_FRAMES && drag == null) {
            editor.seal();
        }
    }
}
