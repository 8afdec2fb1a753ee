package dev.cairn.render.input;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Keeps what the user has rebound in a text file, one action a line: {@code pause = F5, CTRL+P}.
 * Only what differs from {@link Bindings#keepAsDefaults} is written, so that new defaults of a
 * later version reach the user. Stateless; on the thread that owns the bindings.
 */
public final class BindingsFile {
    private static final String HEAD =
            "# Keys that differ from the defaults: action = trigger, trigger";

    private BindingsFile() {}

    /**
     * Writes what differs from the defaults; a file for which nothing differs is deleted.
     *
     * @param bindings whose triggers
     * @param file where to; folders are made
     * @throws UncheckedIOException if it cannot be written
     */
    public static void save(Bindings bindings, Path file) {
        List<String> lines = new ArrayList<>(List.of(HEAD));
        for (Bindings.Binding binding : bindings.actions()) {
            List<Trigger> now = bindings.triggersOf(binding.action());
            if (!new HashSet<>(now).equals(new HashSet<>(bindings.defaultsOf(binding.action())))) {
                lines.add(
                        binding.action()
                                + " = "
                                + String.join(", ", now.stream().map(Trigger::id).toList()));
            }
        }
        try {
            if (lines.size() == 1) {
                Files.deleteIfExists(file);
                return;
            }
            Path folder = file.toAbsolutePath().getParent();
            if (folder != null) {
                Files.createDirectories(folder);
            }
            Files.write(file, lines, StandardCharsets.UTF_8);
        } catch (IOException refused) {
            throw new UncheckedIOException(
                    file + ": the keys cannot be kept there: " + refused, refused);
        }
    }

    /**
     * Reads what was saved into bindings whose actions are all bound. A trigger that two lines name
     * goes to the last of them.
     *
     * @param bindings what to change
     * @param file from where; nothing happens if there is none
     * @return what could not be used, one line each with file and line number; the rest is used
     */
    public static List<String> load(Bindings bindings, Path file) {
        List<String> lines;
        try {
            lines = Files.readAllLines(file, StandardCharsets.UTF_8);
        } catch (NoSuchFileException none) {
            return List.of();
        } catch (IOException broken) {
            return List.of(file + ": the keys cannot be read: " + broken);
        }
        Set<String> known = new HashSet<>();
        bindings.actions().forEach(binding -> known.add(binding.action()));
        List<String> remarks = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            String line = lines.get(i).strip();
            if (!line.isEmpty() && !line.startsWith("#")) {
                String remark = take(bindings, known, line);
                if (!remark.isEmpty()) {
                    remarks.add("%s:%d: %s".formatted(file, i + 1, remark));
                }
            }
        }
        return remarks;
    }

    /** Empty if the line was used. */
    private static String take(Bindings bindings, Set<String> known, String line) {
        int equals = line.indexOf('=');
        String action = equals < 0 ? line : line.substring(0, equals).strip();
        if (equals < 0 || !known.contains(action)) {
            return "expected \"action = triggers\" of an action that there is, got \"%s\""
                    .formatted(line);
        }
        List<Trigger> triggers = new ArrayList<>();
        String rest = line.substring(equals + 1).strip();
        for (String id : rest.isEmpty() ? new String[0] : rest.split(",", -1)) {
            Trigger trigger = Trigger.parse(id);
            if (trigger == null) {
                return "\"%s\" is no key, button, wheel, move or CTRL+key".formatted(id.strip());
            }
            triggers.add(trigger);
        }
        bindings.rebind(action, triggers);
        return "";
    }
}
