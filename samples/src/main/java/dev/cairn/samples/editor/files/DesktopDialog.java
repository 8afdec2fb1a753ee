package dev.cairn.samples.editor.files;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.nio.file.Path;

/** The file dialog of a desktop. */
interface DesktopDialog {
    /**
     * Asks the user for a file, and waits for the answer.
     *
     * @param question what for
     * @return the file, or null if the user wants none
     * @throws IOException if the desktop has no such dialog; the message says why
     */
    @Nullable Path ask(FileQuestion question) throws IOException;

    /** Whether it has to be asked on the window's thread, which stands still meanwhile. */
    boolean needsWindowThread();
}
