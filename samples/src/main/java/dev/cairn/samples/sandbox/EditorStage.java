package dev.cairn.samples.sandbox;

import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.editor.Editor;
import dev.cairn.samples.editor.Stage;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneLoader;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicReference;

/**
 * The editor's scene in the sandbox's world. The window's thread asks; the simulation thread takes
 * the newest of what was asked for, so that a fast drag of a large scene skips what nobody would
 * see.
 */
final class EditorStage implements Stage {
    /**
     * A scene to show.
     *
     * @param scene what
     * @param folder of its files
     * @param playing whether it runs
     * @param places whether the camera goes to where the scene wants it
     */
    record Shown(SceneFile scene, Path folder, boolean playing, boolean places) {}

    private final Sandbox sandbox;
    private final AtomicReference<@Nullable Wish> asked = new AtomicReference<>();

    /** What is wanted: a scene, or none in the place of those of the list. */
    private record Wish(@Nullable Shown shown) {}

    // The simulation thread's own.
    private @Nullable Shown shown;
    private SceneLoader.Assets assets = new SceneLoader.Assets();
    private long[] entities = {};

    EditorStage(Sandbox sandbox) {
        this.sandbox = sandbox;
    }

    // Window thread ----------------------------------------------------------------------------

    @Override
    public void rest(SceneFile scene, Path folder, boolean places) {
        sandbox.setPaused(true);
        ask(new Wish(new Shown(scene, folder, false, places)));
    }

    @Override
    public void play(SceneFile scene, Path folder) {
        ask(new Wish(new Shown(scene, folder, true, false)));
        sandbox.setPaused(false);
    }

    private void ask(Wish what) {
        if (asked.getAndSet(what) == null) {
            sandbox.post(this::take);
        }
    }

    @Override
    public void leave() {
        // Through the same door: what was asked for after it must not come before it.
        ask(new Wish(null));
        sandbox.setPaused(false);
    }

    // Simulation thread ------------------------------------------------------------------------

    private void take() {
        Wish wish = asked.getAndSet(null);
        if (wish == null) {
            return;
        }
        Shown next = wish.shown();
        Shown before = shown;
        shown = next;
        if (next == null) {
            if (before != null) { // else the scenes of the list are there already
                sandbox.restart();
            }
            return;
        }
        if (before == null || before.playing() || next.playing() || next.places()) {
            // From the beginning, with files as they are now.
            assets = new SceneLoader.Assets();
            sandbox.showEdited(next.places());
        } else {
            sandbox.rebuildEdited();
        }
    }

    /** What is shown in place of the scenes of the list, or null. */
    @Nullable Shown shown() {
        return shown;
    }

    /**
     * Gives way to the scenes of the list. The window's thread may have asked for another one just
     * now, so that the editor is to be closed as well, which asks for none.
     */
    void forget() {
        shown = null;
    }

    /**
     * No numbers are too large for a scene, and some are for a world: when that fails, the scene
     * begins anew and waits, and what was edited is not lost with the window.
     */
    boolean goesOnAfter(RuntimeException failure) {
        sandbox.setPaused(true);
        sandbox.notice("The world failed and begins anew: " + failure.getMessage());
        if (shown != null) {
            sandbox.editorPanels().ask(Editor::stop);
        }
        return true;
    }

    /** Whether the world must not move. */
    boolean rests() {
        Shown now = shown;
        return now != null && !now.playing();
    }

    /** Fills a world. Throws what {@link SceneLoader#build} throws. */
    void build(Shown what, SceneBuilder into) {
        entities = new long[what.scene().entities().size()];
        SceneLoader.build(what.scene(), what.folder(), into, assets, entities);
    }

    /** Puts it to the moment that it begins with, if it has one. Throws the same. */
    void begin(Shown what, SceneBuilder built) {
        SceneLoader.begin(what.scene(), what.folder(), built, entities);
    }

    /** The world's entity for each of the scene's. */
    long[] entities() {
        return entities;
    }
}
