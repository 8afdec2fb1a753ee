package dev.cairn.samples.editor.files;

import dev.cairn.render.ui.Ui;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.nio.file.Path;

/**
 * Asks for a file by the desktop's dialog where there is one, else by the window's own {@link
 * FileChooser list}. The dialog is waited for on a thread of its own, so that the window goes on,
 * except on macOS, which wants it on the first thread. A dialog that fails, or that never comes and
 * is given up by a button, is followed by the list. {@code -Dcairn.dialog=window} chooses the list.
 * Window thread.
 */
public final class FileDialog {
    /** The button that gives the desktop's dialog up. */
    public static final String HERE = "List here instead";

    private static final double WIDTH = 360;
    private static final double HEIGHT = 110;

    /**
     * A file that the user chose.
     *
     * @param file which
     * @param saves whether it is to be written
     */
    public record Taken(Path file, boolean saves) {}

    /** What comes back from the thread of the dialog; written there, read here. */
    private static final class Answer {
        private volatile boolean done;
        private @Nullable Path file;
        private @Nullable String problem;
    }

    private @Nullable DesktopDialog desktop;
    private final FileChooser list = new FileChooser();
    private FileQuestion question = new FileQuestion("", Path.of(""), ".json", false, "");
    private @Nullable Answer awaited;

    /** The last answer that was asked for; the dialog is open until it is done. */
    private @Nullable Answer asked;

    /** With the desktop's dialog, if this desktop has one. */
    public FileDialog() {
        this(NativeDialog.find());
    }

    FileDialog(@Nullable DesktopDialog desktop) {
        this.desktop = desktop;
    }

    /**
     * Asks for a file to be read.
     *
     * @param heading of the dialog
     * @param where an existing folder
     * @param ending of the names of files, such as {@code .json}
     */
    public void open(String heading, Path where, String ending) {
        ask(new FileQuestion(heading, where, ending, false, ""));
    }

    /**
     * Asks for a file to be written.
     *
     * @param heading of the dialog
     * @param where an existing folder
     * @param ending of its name, such as {@code .json}
     * @param name what is proposed
     */
    public void save(String heading, Path where, String ending, String name) {
        ask(new FileQuestion(heading, where, ending, true, name));
    }

    private void ask(FileQuestion wanted) {
        if (awaited != null) {
            return; // the user is asked already
        }
        question = wanted;
        DesktopDialog known = desktop;
        if (known == null || (asked != null && !asked.done)) {
            list.show(wanted);
            return;
        }
        Answer answer = new Answer();
        awaited = answer;
        asked = answer;
        if (known.needsWindowThread()) {
            fill(answer, known, wanted);
            return;
        }
        Thread thread = new Thread(() -> fill(answer, known, wanted), "cairn-file-dialog");
        thread.setDaemon(true); // a dialog that is still open must not keep a closed window alive
        thread.start();
    }

    private static void fill(Answer answer, DesktopDialog desktop, FileQuestion question) {
        try {
            answer.file = desktop.ask(question);
        } catch (IOException | RuntimeException failed) {
            answer.problem = String.valueOf(failed.getMessage());
        }
        answer.done = true;
    }

    /**
     * Puts away what is shown.
     *
     * @return true if something was
     */
    public boolean dismiss() {
        boolean waited = awaited != null;
        awaited = null;
        return list.dismiss() || waited;
    }

    /**
     * Draws what is shown.
     *
     * @param ui what panels are made of
     * @return the file that was chosen, once, or null
     */
    public @Nullable Taken draw(Ui ui) {
        Answer answer = awaited;
        Path file = null;
        if (answer == null) {
            file = list.draw(ui);
        } else if (!answer.done) {
            waiting(ui);
        } else {
            awaited = null;
            file = answer.file;
            String problem = answer.problem;
            if (problem != null) {
                desktop = null; // not asked again
                list.show(question);
                String told = "The desktop's file dialog cannot be used: " + problem;
                System.err.println(told);
                list.tell(told);
            }
        }
        return file == null ? null : new Taken(withEnding(file), question.saves());
    }

    private Path withEnding(Path file) {
        String name = String.valueOf(file.getFileName());
        boolean whole = !question.saves() || name.endsWith(question.ending());
        return whole ? file : file.resolveSibling(name + question.ending());
    }

    private void waiting(Ui ui) {
        double left = (ui.width() - WIDTH) / 2;
        if (ui.panel(question.heading(), left, (ui.height() - HEIGHT) / 2, WIDTH, HEIGHT)) {
            ui.text("The desktop's dialog is open.");
            ui.columns(1);
            if (ui.button(HERE)) {
                awaited = null;
                list.show(question);
            }
        }
        ui.endPanel();
    }

    /** Whether the window's own list is shown. */
    boolean isListShown() {
        return list.isShown();
    }
}
