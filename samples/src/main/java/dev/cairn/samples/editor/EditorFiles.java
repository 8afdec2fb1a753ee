package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneFileException;

import org.jspecify.annotations.Nullable;

import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;

/**
 * Saving, loading and beginning anew. What would lose something is done when it is asked for twice.
 * Window thread.
 */
public final class EditorFiles {
    private final Editor editor;
    private final SceneDocument document;
    private String confirming = "";

    EditorFiles(Editor editor, SceneDocument document) {
        this.editor = editor;
        this.document = document;
    }

    /** Another action than the one that waits to be asked for again. */
    void forget() {
        confirming = "";
    }

    /** The next call of that action counts as the second. */
    void expect(String action) {
        confirming = action;
    }

    /**
     * What the scene's paths are relative to.
     *
     * @return a folder
     */
    public Path folder() {
        return document.folder();
    }

    /**
     * A file as scenes name it.
     *
     * @param file whole path
     * @return relative to the folder of the scene if it lies in there, else whole; with slashes
     */
    public String relative(Path file) {
        Path whole = file.toAbsolutePath().normalize();
        Path home = document.folder();
        Path named = whole.startsWith(home) ? home.relativize(whole) : whole;
        return named.toString().replace('\\', '/');
    }

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
            if (!target.equals(document.file())
                    && Files.exists(target)
                    && !Files.isDirectory(target)
                    && !confirmed("save " + target)) {
                editor.fail(target + " is there already; save once more to replace it");
                return;
            }
            if (document.save(target) && editor.mode() == Editor.Mode.REST) {
                editor.showAgain();
            }
            editor.say("saved in " + target);
        } catch (UncheckedIOException | InvalidPathException broken) {
            editor.fail(String.valueOf(broken.getMessage()));
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
            if (document.isChanged() && !confirmed("load " + source)) {
                editor.fail("the scene has unsaved changes; load once more to give them up");
                return;
            }
            Path parent = source.getParent();
            editor.open(loaded, source, parent == null ? document.folder() : parent);
            editor.say("loaded " + source);
        } catch (SceneFileException | InvalidPathException broken) {
            editor.fail(String.valueOf(broken.getMessage()));
        }
    }

    /** Begins an empty scene. Unsaved changes are given up only when this is called twice. */
    public void startNew() {
        if (document.isChanged() && !confirmed("new")) {
            editor.fail("the scene has unsaved changes; press once more to give them up");
            return;
        }
        editor.open(Supply.emptyScene(), null, document.folder());
    }

    private @Nullable Path path(String name) {
        String typed = name.strip();
        if (typed.isEmpty() || !typed.endsWith(".json")) {
            editor.fail("\"%s\": expected the name of a file that ends in .json".formatted(typed));
            return null;
        }
        return document.folder().resolve(typed).toAbsolutePath().normalize();
    }

    boolean confirmed(String action) {
        boolean second = confirming.equals(action);
        confirming = second ? "" : action;
        return second;
    }
}
