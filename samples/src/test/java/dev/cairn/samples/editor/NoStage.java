package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.SceneFile;

import java.nio.file.Path;

/** Nothing is shown. */
final class NoStage implements Stage {
    @Override
    public void rest(SceneFile scene, Path folder, boolean places) {}

    @Override
    public void play(SceneFile scene, Path folder) {}

    @Override
    public void leave() {}
}
