package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneFile.CameraSpec;
import dev.cairn.samples.scenefile.Xyz;
import dev.cairn.samples.scenefile.edit.GroupEdit;
import dev.cairn.samples.scenefile.edit.SceneEdit;
import dev.cairn.samples.scenefile.edit.SceneHistory;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;

/**
 * The scene editor without its panels: the scene with its history, what is selected, the file, and
 * whether it rests or runs. Mistakes of the user end as a line in {@link #message}. The window's
 * thread.
 */
public final class Editor {
    /** What the window shows. */
    public enum Mode {
        /** Something else. */
        CLOSED,
        /** The scene as it will begin. */
        REST,
        /** The scene as it runs. */
        PLAYING
    }

    /** {@link #selected} while nothing is. */
    public static final int NOTHING = -1;

    private final Stage stage;
    private volatile Mode mode = Mode.CLOSED;
    private final SceneDocument document = new SceneDocument();
    private final EditorJoints joints = new EditorJoints(this);
    private final EditorFiles files = new EditorFiles(this, document);
    private final Selection selection = new Selection();
    private final EditorGroup group = new EditorGroup(this, selection);
    private String message = "";
    private boolean wrong;
    private int edits;

    /**
     * A closed editor with an empty scene.
     *
     * @param stage where scenes are seen
     */
    public Editor(Stage stage) {
        this.stage = stage;
    }

    // What is there ----------------------------------------------------------------------------

    /**
     * What the window shows. Any thread.
     *
     * @return the mode
     */
    public Mode mode() {
        return mode;
    }

    /**
     * The scene as it would be saved now.
     *
     * @return the value
     */
    public SceneFile scene() {
        return document.scene();
    }

    /**
     * The steps that can be undone.
     *
     * @return the history, not to be changed
     */
    public SceneHistory history() {
        return document.history();
    }

    /**
     * Whether the scene differs from what was loaded or saved last.
     *
     * @return true if so
     */
    public boolean isChanged() {
        return document.isChanged();
    }

    /**
     * The file that the scene was loaded from or saved to last.
     *
     * @return its path, or null if there is none yet
     */
    public @Nullable Path file() {
        return document.file();
    }

    /**
     * What is selected.
     *
     * @return the place in the list, or {@link #NOTHING}
     */
    public int selected() {
        return selection.primary();
    }

    /**
     * All that is selected.
     *
     * @return places in the list, the one chosen last at the end; not to be changed
     */
    public int[] selection() {
        return selection.all();
    }

    /**
     * Whether an entity is one of those selected.
     *
     * @param index its place in the list
     * @return true if so
     */
    public boolean isSelected(int index) {
        return selection.holds(index);
    }

    /**
     * What is selected.
     *
     * @return the entity, or null
     */
    public @Nullable EntitySpec selectedEntity() {
        return selected() == NOTHING ? null : scene().entities().get(selected());
    }

    /**
     * The joints of the scene. Either an entity or a joint is selected, or nothing.
     *
     * @return the same object each time
     */
    public EditorJoints joints() {
        return joints;
    }

    /**
     * What is done to all that is selected.
     *
     * @return the same object each time
     */
    public EditorGroup group() {
        return group;
    }

    /**
     * Saving and loading.
     *
     * @return the same object each time
     */
    public EditorFiles files() {
        return files;
    }

    /**
     * What the last action has to say.
     *
     * @return one line, may be empty
     */
    public String message() {
        return message;
    }

    /**
     * Whether the message tells of a mistake.
     *
     * @return true if the action was not done
     */
    public boolean isWrong() {
        return wrong;
    }

    /** How many edits were made, joined ones too. */
    int edits() {
        return edits;
    }

    // Modes ------------------------------------------------------------------------------------

    /** Opens the editor with the scene that it had when it was closed; nothing if it is open. */
    public void open() {
        if (mode == Mode.CLOSED) {
            mode = Mode.REST;
            say("");
            stage.rest(scene(), document.folder(), true);
        }
    }

    /**
     * Opens the editor with a scene.
     *
     * @param scene what to edit; the history begins anew
     * @param origin its file, or null if it has none yet
     * @param relativeTo what its paths are relative to
     */
    public void open(SceneFile scene, @Nullable Path origin, Path relativeTo) {
        document.begin(scene, origin, relativeTo);
        letGo();
        mode = Mode.REST;
        say("");
        stage.rest(scene, document.folder(), true);
    }

    /**
     * Opens the editor with a copy of another scene, or, the first time this is called while there
     * are unsaved changes, with these and a warning.
     *
     * @param scene what to edit
     * @param relativeTo what its paths are relative to
     */
    public void openCopy(SceneFile scene, Path relativeTo) {
        if (isChanged() && !files.confirmed("copy")) {
            open();
            files.expect("copy");
            fail("this scene has unsaved changes; ask for the copy once more to give them up");
            return;
        }
        open(scene, null, relativeTo);
    }

    /** Runs the scene from its beginning. */
    public void play() {
        if (mode == Mode.REST) {
            mode = Mode.PLAYING;
            joints.cancel();
            say("");
            stage.play(scene(), document.folder());
        }
    }

    /** Goes back to the scene as it was edited. */
    public void stop() {
        if (mode == Mode.PLAYING) {
            mode = Mode.REST;
            stage.rest(scene(), document.folder(), false);
        }
    }

    /** Closes the editor; the scene stays for the next time. */
    public void close() {
        if (mode != Mode.CLOSED) {
            mode = Mode.CLOSED;
            stage.leave();
        }
    }

    // Edits ------------------------------------------------------------------------------------

    /**
     * Selects an entity.
     *
     * @param index its place in the list, or {@link #NOTHING}
     */
    public void select(int index) {
        if (index != selected()) {
            seal();
        }
        letGo();
        if (index >= 0 && index < scene().entities().size()) {
            selection.only(index);
        }
    }

    /**
     * Selects one more entity, or lets go of it if it is selected.
     *
     * @param index its place in the list
     */
    public void toggle(int index) {
        seal();
        joints.letGo();
        selection.toggle(index);
    }

    /** Nothing is selected, and no joint is being placed. */
    void letGo() {
        selection.only();
        joints.letGo();
    }

    /**
     * Places an entity at the end of the list and selects it.
     *
     * @param entity what to place
     */
    public void place(EntitySpec entity) {
        if (edit("place " + entity.name(), scene -> SceneEdit.add(scene, entity), false)) {
            select(scene().entities().size() - 1);
        }
    }

    /**
     * Places a mesh file.
     *
     * @param path as typed, relative to the folder of the scene
     * @param at where the cube stands that is shown for a mesh nobody can read
     */
    public void placeMesh(String path, Xyz at) {
        try {
            place(Supply.mesh(document.folder(), path.strip(), at));
        } catch (IllegalArgumentException refused) {
            fail(String.valueOf(refused.getMessage()));
        }
    }

    /** Deletes what is selected. */
    public void delete() {
        if (joints.selectedJoint() != null) {
            joints.delete();
            return;
        }
        if (group.isAny("an entity or a joint to delete")) {
            int[] gone = selection();
            if (edit(group.label("delete"), scene -> GroupEdit.delete(scene, gone), false)) {
                letGo();
            }
        }
    }

    /**
     * Changes what is selected. Changes of one kind to one entity become one step of the history
     * until {@link #seal}.
     *
     * @param what the kind of change, a word
     * @param change from the entity as it is to what it shall be
     */
    public void change(String what, UnaryOperator<EntitySpec> change) {
        EntitySpec entity = selectedEntity();
        if (entity != null) {
            int index = selected();
            edit(
                    "%s %s (%d)".formatted(what, entity.name(), index),
                    scene -> SceneEdit.change(scene, index, change),
                    true);
        }
    }

    /**
     * Names the selected entity. Letters typed one after another are one step, so its label has no
     * name in it.
     *
     * @param name any
     */
    public void rename(String name) {
        int index = selected();
        if (index != NOTHING) {
            UnaryOperator<EntitySpec> named = e -> e.withName(name);
            edit("rename entity " + index, s -> SceneEdit.change(s, index, named), true);
        }
    }

    /**
     * Has the scene seen from elsewhere.
     *
     * @param camera the camera at its beginning
     */
    public void camera(CameraSpec camera) {
        edit("camera", scene -> scene.withCamera(camera), false);
    }

    /**
     * Names the layers of filters.
     *
     * @param names of the bits, from the lowest on
     */
    public void layers(List<String> names) {
        edit("layers", scene -> scene.withLayers(names), true);
    }

    /** Ends the present step of the history: a drag is over, a slider rests. */
    public void seal() {
        document.history().seal();
    }

    /** Takes the last step back. */
    public void undo() {
        travelled("undone: ", travel(document.history()::undo), "nothing to undo");
    }

    /** Does again what was undone last. */
    public void redo() {
        travelled("done again: ", travel(document.history()::redo), "nothing to redo");
    }

    private void travelled(String how, @Nullable String label, String otherwise) {
        if (label == null) {
            fail(mode == Mode.REST ? otherwise : "the scene runs; stop it to edit it");
            return;
        }
        say(how + label);
        showAgain();
    }

    /** Shows the scene as it is now. */
    void showAgain() {
        stage.rest(scene(), document.folder(), false);
    }

    /** A step through the history, with the selection following what it was. */
    private @Nullable String travel(Supplier<@Nullable String> step) {
        if (mode != Mode.REST) {
            return null;
        }
        SceneFile before = scene();
        history().choose(selection.all());
        String label = step.get();
        if (label != null) {
            joints.cancel();
            joints.travelled(before.joints());
            selection.travelled(before.entities(), scene().entities(), history().chosen());
            if (joints.selected() != NOTHING) {
                selection.only();
            }
        }
        return label;
    }

    /** Makes an edit if the scene rests and can be built after it; says so if not. */
    boolean edit(String label, UnaryOperator<SceneFile> change, boolean joins) {
        if (mode != Mode.REST) {
            fail("the scene runs; stop it to edit it");
            return false;
        }
        try {
            history().choose(selection.all());
            if (!document.history().edit(label, change.apply(scene()), joins)) {
                return false;
            }
        } catch (IllegalArgumentException refused) {
            fail(String.valueOf(refused.getMessage()));
            return false;
        }
        say("");
        edits++;
        showAgain();
        return true;
    }

    // Messages ---------------------------------------------------------------------------------

    void say(String text) {
        message = oneLine(text);
        wrong = false;
        files.forget();
    }

    void fail(String text) {
        message = oneLine(text);
        wrong = true;
    }

    /** Names of things and files may have line feeds. */
    private static String oneLine(String text) {
        return text.replaceAll("\\s*\\R\\s*", " ");
    }
}
