package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.SceneFile;

import java.nio.file.Path;

/** Where an edited scene is seen. Called by the editor, on the window's thread. */
public interface Stage {
    /**
     * Shows a scene as it is at tick 0, without time passing.
     *
     * @param scene what to show
     * @param folder what its paths are relative to
     * @param places whether the camera goes to where the scene wants it
     */
    void rest(SceneFile scene, Path folder, boolean places);

    /**
     * Runs a scene from tick 0.
     *
     * @param scene what to run
     * @param folder what its paths are relative to
     */
    void play(SceneFile scene, Path folder);

    /** Shows what was there before the editor. */
    void leave();
}
