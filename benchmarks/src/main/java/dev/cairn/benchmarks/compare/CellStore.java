package dev.cairn.benchmarks.compare;

import com.google.gson.Gson;
import com.google.gson.JsonSyntaxException;

import org.jspecify.annotations.Nullable;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The finished measurements of a campaign, in a file that grows by a line with each, so that an
 * interrupted campaign goes on where it stopped. The first line says what the measurements depend
 * on; where that has changed, the file starts over. One thread.
 */
final class CellStore implements AutoCloseable {
    private final Gson gson = new Gson();
    private final Map<String, Protocol.Answer> known = new LinkedHashMap<>();
    private final BufferedWriter out;
    private final @Nullable String changed;

    /** What a line holds. */
    private record Line(String key, Protocol.Answer answer) {}

    /** What the first line holds. */
    private record Head(Map<String, String> setup) {}

    CellStore(Path file, Map<String, String> setup) throws IOException {
        String difference = null;
        boolean goOn = false;
        if (Files.exists(file)) {
            List<String> lines = Files.readAllLines(file, StandardCharsets.UTF_8);
            difference = lines.isEmpty() ? null : difference(lines.getFirst(), setup);
            goOn = !lines.isEmpty() && difference == null;
            if (goOn) {
                read(lines);
            }
        }
        changed = difference;
        // Written anew, so that a line that was cut off is gone.
        out =
                Files.newBufferedWriter(
                        file,
                        StandardCharsets.UTF_8,
                        StandardOpenOption.CREATE,
                        StandardOpenOption.TRUNCATE_EXISTING);
        write(gson.toJson(new Head(setup)));
        for (Map.Entry<String, Protocol.Answer> entry : known.entrySet()) {
            write(gson.toJson(new Line(entry.getKey(), entry.getValue())));
        }
    }

    private @Nullable String difference(String line, Map<String, String> setup) {
        Head head;
        try {
            head = gson.fromJson(line, Head.class);
        } catch (JsonSyntaxException torn) {
            return "its first line cannot be read";
        }
        if (head == null || head.setup() == null) {
            return "its first line cannot be read";
        }
        for (Map.Entry<String, String> entry : setup.entrySet()) {
            String before = head.setup().get(entry.getKey());
            if (!entry.getValue().equals(before)) {
                return "%s was \"%s\" and is \"%s\""
                        .formatted(entry.getKey(), before, entry.getValue());
            }
        }
        return null;
    }

    private void read(List<String> lines) {
        for (String line : lines.subList(1, lines.size())) {
            try {
                Line one = gson.fromJson(line, Line.class);
                if (one != null && one.key() != null && one.answer() != null) {
                    known.put(one.key(), one.answer());
                }
            } catch (JsonSyntaxException torn) {
                // The line that was being written when the last campaign was stopped.
                return;
            }
        }
    }

    /** Returns what has changed since the file was written, or null. */
    @Nullable String changed() {
        return changed;
    }

    int size() {
        return known.size();
    }

    Protocol.@Nullable Answer get(String key) {
        return known.get(key);
    }

    void put(String key, Protocol.Answer answer) throws IOException {
        known.put(key, answer);
        write(gson.toJson(new Line(key, answer)));
    }

    private void write(String line) throws IOException {
        out.write(line);
        out.newLine();
        out.flush();
    }

    @Override
    public void close() throws IOException {
        out.close();
    }
}
