package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.SceneWriter;
import dev.cairn.samples.scenefile.edit.SceneEdit;
import dev.cairn.samples.scenefile.edit.SceneHistory;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;

/** A scene with its history, its file, and whether it differs from that. One thread. */
final class SceneDocument {
    private SceneHistory history = new SceneHistory(Supply.emptyScene());
    private SceneFile saved = history.current();

    /** The scene that was compared with the saved one last, and the answer. */
    private @Nullable SceneFile compared;

    private boolean changed;
    private Path folder = Path.of("").toAbsolutePath();
    private @Nullable Path file;

    SceneHistory history() {
        return history;
    }

    SceneFile scene() {
        return history.current();
    }

    /** What the scene's paths are relative to. */
    Path folder() {
        return folder;
    }

    /** Where it was loaded from or saved to last, or null. */
    @Nullable Path file() {
        return file;
    }

    /** Begins anew with a scene that counts as saved. */
    void begin(SceneFile scene, @Nullable Path origin, Path relativeTo) {
        history = new SceneHistory(scene);
        savedIs(scene);
        file = origin;
        folder = relativeTo.toAbsolutePath().normalize();
    }

    /** Whether the scene differs from what was loaded or saved last. */
    @SuppressWarnings("ReferenceEquality") // each edit makes another object
    boolean isChanged() {
        SceneFile now = history.current();
        if (now != compared) {
            // Asked for in each frame, and a comparison of long lists.
            compared = now;
            changed = !now.equals(saved);
        }
        return changed;
    }

    private void savedIs(SceneFile scene) {
        saved = scene;
        compared = null;
    }

    /**
     * Writes the scene.
     *
     * @return whether its paths have changed, since they are relative to the file's folder
     */
    boolean save(Path target) {
        Path parent = target.getParent();
        Path home = parent == null ? folder : parent;
        SceneFile moved = SceneEdit.rebase(scene(), folder, home);
        SceneWriter.write(moved, target);
        boolean rebased = !moved.equals(scene());
        if (rebased) {
            // Paths of the older steps would lead nowhere from the new folder.
            history = new SceneHistory(moved);
        }
        folder = home;
        file = target;
        savedIs(moved);
        return rebased;
    }

    /** Reads a scene without taking it. */
    static SceneFile read(Path source) {
        return SceneReader.read(source);
    }
}
