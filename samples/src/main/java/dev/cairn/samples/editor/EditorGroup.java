package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.Xyz;
import dev.cairn.samples.scenefile.edit.GroupEdit;
import dev.cairn.samples.scenefile.edit.GroupEdit.Part;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.Arrays;
import java.util.List;
import java.util.function.BiFunction;
import java.util.stream.IntStream;

/** What is done to all that is selected at once. Mistakes end as a line. Window thread. */
public final class EditorGroup {
    /** Distance between an entity and its duplicate along x, beside its own width, m. */
    private static final double GAP = 0.1;

    private final Editor editor;
    private final Selection selection;
    private @Nullable Part copied;
    private final Vector3d middle = new Vector3d();
    private int[] middleOf = {};
    private @Nullable SceneFile middleIn;

    EditorGroup(Editor editor, Selection selection) {
        this.editor = editor;
        this.selection = selection;
    }

    /**
     * The middle of the box around all that is selected. Makes no garbage while that stays the
     * same.
     *
     * @param dest receives the point, world, m; unchanged if nothing is selected
     */
    @SuppressWarnings("ReferenceEquality") // a changed scene or selection is another object
    public void middle(Vector3d dest) {
        int[] which = editor.selection();
        if (which.length > 0 && (which != middleOf || editor.scene() != middleIn)) {
            middleOf = which;
            middleIn = editor.scene();
            Sizes box =
                    Sizes.around(
                            Arrays.stream(which).mapToObj(editor.scene().entities()::get).toList());
            middle.set(
                    (box.low().x() + box.high().x()) / 2,
                    (box.low().y() + box.high().y()) / 2,
                    (box.low().z() + box.high().z()) / 2);
        }
        if (which.length > 0) {
            dest.set(middle);
        }
    }

    /** Selects all but the ground. */
    public void selectAll() {
        editor.seal();
        editor.letGo();
        List<EntitySpec> all = editor.scene().entities();
        selection.only(
                IntStream.range(0, all.size()).filter(i -> !Ground.is(all.get(i))).toArray());
    }

    /** Adds one more of all that is selected, beside it, and selects that. */
    public void duplicate() {
        if (isAny("an entity to duplicate")) {
            paste("duplicate ", GroupEdit.copy(editor.scene(), editor.selection()));
        }
    }

    /** Keeps what is selected for {@link #paste()}. */
    public void copy() {
        if (isAny("an entity to copy")) {
            Part part = GroupEdit.copy(editor.scene(), editor.selection());
            copied = part;
            editor.say(part.entities().size() + " copied; Ctrl+V puts more of it into the scene");
        }
    }

    /** Adds what was copied, beside where it was, and selects that. */
    public void paste() {
        Part part = copied;
        if (part == null) {
            editor.fail("nothing was copied; select something and press Ctrl+C");
            return;
        }
        paste("paste ", part);
    }

    private void paste(String what, Part part) {
        int count = part.entities().size();
        Xyz offset = new Xyz(Sizes.around(part.entities()).width() + GAP, 0, 0);
        String label = what + (count == 1 ? part.entities().get(0).name() : count + " entities");
        if (editor.edit(label, scene -> GroupEdit.paste(scene, part, offset), false)) {
            int[] added = GroupEdit.last(count, editor.scene());
            editor.letGo();
            selection.only(added);
            // Each of several copies stands beside the one before.
            copied = what.startsWith("paste") ? GroupEdit.copy(editor.scene(), added) : copied;
        }
    }

    boolean isAny(String what) {
        if (editor.selection().length == 0) {
            editor.fail("nothing is selected; choose " + what);
        }
        return editor.selection().length > 0;
    }

    /** Puts each entity that is selected down onto what is under it. */
    public void drop() {
        if (isAny("an entity to put down")) {
            int[] which = editor.selection();
            editor.edit(label("put down"), scene -> Ground.dropped(scene, which), false);
        }
    }

    /** What is done to what is selected, for the history. */
    String label(String what) {
        EntitySpec only = editor.selectedEntity();
        int count = editor.selection().length;
        return count == 1 && only != null
                ? "%s %s (%d)".formatted(what, only.name(), editor.selected())
                : "%s %d entities".formatted(what, count);
    }

    /**
     * Changes all that is selected, in one way. Changes of one kind become one step of the history
     * until {@link Editor#seal}.
     *
     * @param what the kind of change, a word
     * @param change from a scene and the places of what is selected to the changed scene
     */
    public void changeAll(String what, BiFunction<SceneFile, int[], SceneFile> change) {
        int[] which = editor.selection();
        if (which.length > 0) {
            editor.edit(label(what), scene -> change.apply(scene, which), true);
        }
    }
}
