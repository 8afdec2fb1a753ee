package dev.cairn.render.mesh;

import org.jspecify.annotations.Nullable;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Lines of a text file of any encoding, each byte a character: names and comments pass. What is no
 * text has no ends of lines, so that a file of gigabytes would be one line in memory; here that is
 * an error after the first megabytes.
 */
final class BoundedLines implements AutoCloseable {
    /** Longest line, characters. */
    static final int LONGEST = 1 << 24;

    private final BufferedReader reader;
    private final StringBuilder line = new StringBuilder();
    private boolean afterReturn;

    BoundedLines(Path file) throws IOException {
        reader = Files.newBufferedReader(file, StandardCharsets.ISO_8859_1);
    }

    /** The next line without its end, which is LF, CR or both; null after the last one. */
    @Nullable String next() throws IOException {
        line.setLength(0);
        while (true) {
            int read = reader.read();
            if (read == '\n' && afterReturn) {
                afterReturn = false;
                continue;
            }
            afterReturn = read == '\r';
            if (read < 0) {
                return line.isEmpty() ? null : line.toString();
            }
            if (read == '\n' || read == '\r') {
                return line.toString();
            }
            if (line.length() == LONGEST) {
                throw new IOException("a line of more than " + LONGEST + " characters");
            }
            line.append((char) read);
        }
    }

    @Override
    public void close() throws IOException {
        reader.close();
    }
}
