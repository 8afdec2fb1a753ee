package dev.cairn.samples.window;

import dev.cairn.samples.Main;

/** The samples as they are started from a command line, seen by title and picture alone. */
abstract class MainFixture extends WindowFixture {
    @Override
    public Class<?> program() {
        return Main.class;
    }

    @Override
    public boolean tellsFrames() {
        return false;
    }

    @Override
    public boolean ready(Seen seen) {
        return true;
    }
}
