package dev.cairn.render.mesh;

import org.jspecify.annotations.Nullable;

import java.nio.file.Path;

/**
 * A {@code .obj} file that cannot be used. The message is one line: {@code file:line: expected ...,
 * found ...}.
 */
public final class ObjFormatException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    /** The file as it was given. */
    private final String file;

    /** The line that is wrong, or 0. */
    private final int line;

    ObjFormatException(Path file, int line, String message, @Nullable Throwable cause) {
        super(file + (line > 0 ? ":" + line : "") + ": " + message, cause);
        this.file = file.toString();
        this.line = line;
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
     * @return the number, from 1; 0 if the file as a whole is wrong (missing, empty, too large)
     */
    public int line() {
        return line;
    }
}
