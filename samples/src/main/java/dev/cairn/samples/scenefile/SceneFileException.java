package dev.cairn.samples.scenefile;

import org.jspecify.annotations.Nullable;

/**
 * A scene file that cannot be used. The message is one line: {@code file:line: $.path: expected
 * ..., found ...}.
 */
public final class SceneFileException extends IllegalArgumentException {
    private static final long serialVersionUID = 1;

    /** Characters of a name or path in a message. */
    private static final int SHOWN = 300;

    /** The file as it was given. */
    private final String file;

    /** The line, or 0. */
    private final int line;

    /** The place in the document. */
    private final String path;

    SceneFileException(
            String file, int line, String path, String message, @Nullable Throwable cause) {
        super(
                shown(file) + (line > 0 ? ":" + line : "") + ": " + shown(path) + ": " + message,
                cause);
        this.file = file;
        this.line = line;
        this.path = path;
    }

    /** What a file or its maker chose, on one line of a terminal. */
    static String shown(String text) {
        String printable = text.replaceAll("\\p{Cntrl}", "?");
        int length = printable.length();
        return length <= SHOWN
                ? printable
                : printable.substring(0, SHOWN / 2)
                        + "..."
                        + printable.substring(length - SHOWN / 2);
    }

    /**
     * The file as it was given.
     *
     * @return its path
     */
    public String file() {
        return file;
    }

    /**
     * The line that is wrong.
     *
     * @return the number, from 1; 0 if the file as a whole is wrong
     */
    public int line() {
        return line;
    }

    /**
     * What is wrong, as a JSON path.
     *
     * @return {@code $} for the whole document, {@code $.entities[3].mass} for a field
     */
    public String path() {
        return path;
    }
}
