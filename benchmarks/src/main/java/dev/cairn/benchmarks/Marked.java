package dev.cairn.benchmarks;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** The part of a page between two comments, which a command writes. */
public final class Marked {
    private final String begin;
    private final String end;

    /**
     * Names the part.
     *
     * @param name of the command; the lines are {@code <!-- name: begin -->} and {@code ... end}
     */
    public Marked(String name) {
        begin = "<!-- " + name + ": begin -->";
        end = "<!-- " + name + ": end -->";
    }

    /**
     * Reads a page.
     *
     * @param file where it is
     * @return its text; of one that is not there yet, the two lines
     * @throws IOException if it is there and cannot be read
     */
    public String page(Path file) throws IOException {
        return Files.exists(file)
                ? Files.readString(file, StandardCharsets.UTF_8)
                : begin + "\n" + end + "\n";
    }

    /**
     * Puts a text between the two lines.
     *
     * @param page the page
     * @param text what comes there
     * @return the page with it
     * @throws IllegalArgumentException if the page lacks the lines
     */
    public String replaced(String page, String text) {
        int from = page.indexOf(begin);
        int to = page.indexOf(end);
        if (from < 0 || to < from) {
            throw new IllegalArgumentException(
                    "the file has no lines \"%s\" and \"%s\"".formatted(begin, end));
        }
        return page.substring(0, from + begin.length()) + "\n\n" + text + "\n" + page.substring(to);
    }
}
