package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneFile.CameraSpec;
import dev.cairn.samples.scenefile.SceneFileException;
import dev.cairn.samples.scenefile.Xyz;
import dev.cairn.samples.scenefile.edit.SceneEdit;
import dev.cairn.samples.scenefile.edit.SceneHistory;

import org.jspecify.annotations.Nullable;

import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
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

    /** Distance between an entity and its duplicate along x, beside its own width, m. */
    private static final double GAP = 0.1;

    private final Stage stage;
    private volatile Mode mode = Mode.CLOSED;
    private final SceneDocument document = new SceneDocument();
    private final EditorJoints joints = new EditorJoints(this);
    private int selected = NOTHING;
    private String message = "";
    private boolean wrong;
    private String confirming = "";
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
        return selected;
    }

    /**
     * What is selected.
     *
     * @return the entity, or null
     */
    public @Nullable EntitySpec selectedEntity() {
        return selected == NOTHING ? null : scene().entities().get(selected);
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
        if (isChanged() && !confirmed("copy")) {
            open();
            confirming = "copy";
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

    /** The window went to another scene by itself; closes the editor without asking for one. */
    public void left() {
        mode = Mode.CLOSED;
    }

    // Edits ------------------------------------------------------------------------------------

    /**
     * Selects an entity.
     *
     * @param index its place in the list, or {@link #NOTHING}
     */
    public void select(int index) {
        if (index != selected) {
            document.history().seal();
        }
        letGo();
        selected = index >= 0 && index < scene().entities().size() ? index : NOTHING;
    }

    /** Nothing is selected, and no joint is being placed. */
    void letGo() {
        selected = NOTHING;
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

    /** Adds one more of what is selected, beside it, and selects that. */
    public void duplicate() {
        EntitySpec like = selectedEntity();
        if (like == null) {
            fail("nothing is selected; choose an entity to duplicate");
            return;
        }
        Sizes sizes = Sizes.of(like);
        Xyz offset = new Xyz(sizes.high().x() - sizes.low().x() + GAP, 0, 0);
        int index = selected;
        if (edit(
                "duplicate " + like.name(),
                scene -> SceneEdit.duplicate(scene, index, offset),
                false)) {
            select(scene().entities().size() - 1);
        }
    }

    /** Deletes what is selected. */
    public void delete() {
        if (joints.selectedJoint() != null) {
            joints.delete();
            return;
        }
        EntitySpec gone = selectedEntity();
        if (gone == null) {
            fail("nothing is selected; choose an entity or a joint to delete");
            return;
        }
        int index = selected;
        if (edit("delete " + gone.name(), scene -> SceneEdit.delete(scene, index), false)) {
            letGo();
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
            int index = selected;
            edit(
                    "%s %s (%d)".formatted(what, entity.name(), index),
                    scene -> SceneEdit.change(scene, index, change),
                    true);
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
        stage.rest(scene(), document.folder(), false);
    }

    /** A step through the history, with the selection following what it was. */
    private @Nullable String travel(Supplier<@Nullable String> step) {
        if (mode != Mode.REST) {
            return null;
        }
        SceneFile before = scene();
        String label = step.get();
        if (label != null) {
            joints.cancel();
            joints.travelled(before.joints());
            int known = Selection.after(before.entities(), selected, scene().entities());
            selected = joints.selected() == NOTHING ? known : NOTHING;
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
            if (!document.history().edit(label, change.apply(scene()), joins)) {
                return false;
            }
        } catch (IllegalArgumentException refused) {
            fail(String.valueOf(refused.getMessage()));
            return false;
        }
        say("");
        edits++;
        stage.rest(scene(), document.folder(), false);
        return true;
    }

    // Files ------------------------------------------------------------------------------------

    /**
     * Saves the scene. A file that the scene does not come from is replaced only when this is
     * called twice.
     *
     * @param name path as typed, absolute or relative to the folder of the scene
     */
    public void save(String name) {
        try {
            Path target = path(name);
            if (target == null) {
                return;
            }
            if (!target.equals(file()) && Files.exists(target) && !confirmed("save " + target)) {
                fail(target + " is there already; save once more to replace it");
                return;
            }
            if (document.save(target) && mode == Mode.REST) {
                stage.rest(scene(), document.folder(), false);
            }
            say("saved in " + target);
        } catch (UncheckedIOException | InvalidPathException broken) {
            fail(String.valueOf(broken.getMessage()));
        }
    }

    /**
     * Loads a scene. Unsaved changes are given up only when this is called twice.
     *
     * @param name path as typed, absolute or relative to the folder of the scene
     */
    public void load(String name) {
        try {
            Path source = path(name);
            if (source == null) {
                return;
            }
            SceneFile loaded = SceneDocument.read(source);
            if (isChanged() && !confirmed("load " + source)) {
                fail("the scene has unsaved changes; load once more to give them up");
                return;
            }
            Path parent = source.getParent();
            open(loaded, source, parent == null ? document.folder() : parent);
            say("loaded " + source);
        } catch (SceneFileException | InvalidPathException broken) {
            fail(String.valueOf(broken.getMessage()));
        }
    }

    /** Begins an empty scene. Unsaved changes are given up only when this is called twice. */
    public void startNew() {
        if (isChanged() && !confirmed("new")) {
            fail("the scene has unsaved changes; press once more to give them up");
            return;
        }
        open(Supply.emptyScene(), null, document.folder());
    }

    private @Nullable Path path(String name) {
        String typed = name.strip();
        if (typed.isEmpty() || !typed.endsWith(".json")) {
            fail("\"%s\": expected the name of a file that ends in .json".formatted(typed));
            return null;
        }
        return document.folder().resolve(typed).toAbsolutePath().normalize();
    }

    private boolean confirmed(String action) {
        boolean second = confirming.equals(action);
        confirming = second ? "" : action;
        return second;
    }

    // Messages ---------------------------------------------------------------------------------

    void say(String text) {
        message = text;
        wrong = false;
        confirming = "";
    }

    void fail(String text) {
        message = text.replaceAll("\\s*\\R\\s*", " ");
        wrong = true;
    }
}
