package dev.cairn.samples.editor.files;

import dev.cairn.render.ui.Ui;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * A panel that lists a folder: a click on a folder goes there, a click on a file takes it, or its
 * name where a file is to be written. The folder is read when it is entered. Window thread.
 */
public final class FileChooser {
    /** The button that puts the list away. */
    public static final String CANCEL = "Cancel";

    /** The button that takes the name in the field, in the folder that is listed. */
    public static final String SAVE = "Save here";

    /** The field of the name. */
    public static final String NAME = "save as";

    private static final double WIDTH = 360;
    private static final double HEIGHT = 420;
    private static final int MOST = 500;

    private boolean shown;
    private String title = "";
    private String ending = "";
    private boolean saves;
    private String saveName = "";
    private Path folder = Path.of("");
    private String place = "";
    private String problem = "";
    private final List<String> names = new ArrayList<>();
    private final List<Path> targets = new ArrayList<>();

    /** A list that is not shown. */
    public FileChooser() {}

    /** Shows the folder of a question. */
    void show(FileQuestion question) {
        shown = true;
        title = question.heading();
        ending = question.ending();
        saves = question.saves();
        saveName = question.name();
        enter(question.folder().toAbsolutePath().normalize());
    }

    /** Says something above the list until another folder is entered. */
    void tell(String text) {
        problem = problem.isEmpty() ? text : text + "; " + problem;
    }

    boolean isShown() {
        return shown;
    }

    /**
     * Puts the list away.
     *
     * @return true if it was shown
     */
    public boolean dismiss() {
        boolean was = shown;
        shown = false;
        return was;
    }

    private void enter(Path where) {
        folder = where;
        place = where.toString();
        problem = "";
        names.clear();
        targets.clear();
        Path parent = where.getParent();
        if (parent != null) {
            names.add("..");
            targets.add(parent);
        }
        try (Stream<Path> all = Files.list(where)) {
            List<Path> sorted =
                    all.filter(this::isListed)
                            .sorted(
                                    Comparator.comparing((Path p) -> !Files.isDirectory(p))
                                            .thenComparing(p -> name(p).toLowerCase(Locale.ROOT)))
                            .toList();
            for (Path each : sorted.subList(0, Math.min(MOST, sorted.size()))) {
                names.add(name(each) + (Files.isDirectory(each) ? "/" : ""));
                targets.add(each);
            }
            if (sorted.size() > MOST) {
                problem = (sorted.size() - MOST) + " more are not listed; type the name instead";
            } else if (sorted.isEmpty()) {
                problem = "no folder and no file that ends in " + ending;
            }
        } catch (IOException | UncheckedIOException unreadable) {
            problem = "cannot be read: " + unreadable.getMessage();
        }
    }

    private boolean isListed(Path path) {
        String name = name(path);
        return !name.startsWith(".")
                && (Files.isDirectory(path) || name.toLowerCase(Locale.ROOT).endsWith(ending));
    }

    private static String name(Path path) {
        return String.valueOf(path.getFileName());
    }

    /**
     * Draws the list if it is shown.
     *
     * @param ui what panels are made of
     * @return the file that was clicked on in this frame, or null
     */
    public @Nullable Path draw(Ui ui) {
        if (!shown) {
            return null;
        }
        Path taken = null;
        Path entered = null;
        double width = Math.min(WIDTH, ui.width());
        double height = Math.min(HEIGHT, ui.height());
        double left = (ui.width() - width) / 2;
        if (ui.panel(title, left, (ui.height() - height) / 2, width, height)) {
            ui.text(place);
            if (!problem.isEmpty()) {
                ui.text(problem);
            }
            if (saves) {
                saveName = ui.textField(NAME, saveName);
                ui.columns(2);
                if (ui.button(SAVE)) {
                    taken = named();
                }
            } else {
                ui.columns(1);
            }
            if (ui.button(CANCEL)) {
                shown = false;
            }
            ui.columns(1);
            for (int i = 0; i < names.size(); i++) {
                if (ui.item(names.get(i), false, "")) {
                    Path target = targets.get(i);
                    if (names.get(i).endsWith("/") || names.get(i).equals("..")) {
                        entered = target;
                    } else if (saves) {
                        saveName = names.get(i);
                    } else {
                        taken = target;
                        shown = false;
                    }
                }
            }
        }
        ui.endPanel();
        if (entered != null) {
            enter(entered);
        }
        return taken;
    }

    private @Nullable Path named() {
        String typed = saveName.strip();
        try {
            Path whole = folder.resolve(typed).normalize();
            // "", "..", "/": with an ending behind it that would be a file somewhere else.
            if (typed.endsWith("/") || folder.startsWith(whole)) {
                problem = "\"%s\" is a folder; type the name of a file".formatted(typed);
                return null;
            }
            shown = false;
            return whole;
        } catch (InvalidPathException broken) {
            problem = "no name of a file: " + broken.getReason();
            return null;
        }
    }

    /**
     * Which folder is listed.
     *
     * @return its whole path
     */
    public Path folder() {
        return folder;
    }
}
