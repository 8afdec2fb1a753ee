package dev.cairn.benchmarks.compare;

import com.google.gson.Gson;
import com.google.gson.JsonSyntaxException;

import dev.cairn.benchmarks.compare.measure.Protocol;

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
 * on; where that has changed, the file starts over. Any thread.
 */
final class CellStore implements AutoCloseable {
    private final Gson gson = new Gson();
    private final Map<String, Protocol.Answer> known = new LinkedHashMap<>();
    private final BufferedWriter out;
    private final @Nullable String changed;
    private final Map<String, Double> seconds = new LinkedHashMap<>();

    /** What a line holds. */
    private record Line(String key, Protocol.Answer answer, double seconds) {}

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
            write(gson.toJson(new Line(entry.getKey(), entry.getValue(), spent(entry.getKey()))));
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
                    seconds.put(one.key(), one.seconds());
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

    synchronized int size() {
        return known.size();
    }

    synchronized Protocol.@Nullable Answer get(String key) {
        return known.get(key);
    }

    /** Keeps an answer and how long it took, s. */
    synchronized void put(String key, Protocol.Answer answer, double took) throws IOException {
        known.put(key, answer);
        seconds.put(key, took);
        write(gson.toJson(new Line(key, answer, took)));
    }

    private double spent(String key) {
        return seconds.getOrDefault(key, 0.0);
    }

    /** Returns the time of all that is kept, s. */
    synchronized double seconds() {
        double sum = 0;
        for (double one : seconds.values()) {
            sum += one;
        }
        return sum;
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
