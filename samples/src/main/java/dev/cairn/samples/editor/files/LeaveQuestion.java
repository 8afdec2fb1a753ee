package dev.cairn.samples.editor.files;

import dev.cairn.render.ui.Ui;
import dev.cairn.samples.editor.Editor;
import dev.cairn.samples.editor.EditorPanels;

/** Asks before a window with unsaved edits is closed. Window thread. */
public final class LeaveQuestion {
    /** Name of the button that saves first. */
    public static final String SAVE = "Save and quit";

    /** Name of the button that gives the edits up. */
    public static final String GIVE_UP = "Quit without saving";

    /** Name of the button that goes back. */
    public static final String STAY = "Stay (Esc)";

    private static final double WIDTH = 460;
    private static final double HEIGHT = 190;

    private final Editor editor;
    private final EditorPanels panels;
    private final Runnable quit;
    private boolean asked;

    /**
     * A question that is not asked yet.
     *
     * @param editor whose scene may have changed
     * @param panels who know the name of its file
     * @param quit ends the application
     */
    public LeaveQuestion(Editor editor, EditorPanels panels, Runnable quit) {
        this.editor = editor;
        this.panels = panels;
        this.quit = quit;
    }

    /**
     * Whether the window may close at once; if not, the question is shown from now on.
     *
     * @return true if nothing would be lost
     */
    public boolean mayLeave() {
        asked = editor.isChanged();
        return !asked;
    }

    /**
     * Whether the question is shown.
     *
     * @return true while it waits for an answer
     */
    public boolean isAsked() {
        return asked;
    }

    /**
     * Goes back to the scene.
     *
     * @return true if the question was shown
     */
    public boolean dismiss() {
        boolean was = asked;
        asked = false;
        return was;
    }

    /**
     * Draws the question if it is asked.
     *
     * @param ui what panels are made of
     */
    public void draw(Ui ui) {
        if (!asked) {
            return;
        }
        if (ui.panel(
                "Unsaved changes",
                (ui.width() - WIDTH) / 2,
                (ui.height() - HEIGHT) / 2,
                WIDTH,
                HEIGHT)) {
            ui.text("The scene in the editor has changes that no file has yet.");
            if (editor.isWrong()) {
                ui.text(editor.message());
            }
            ui.columns(3);
            if (ui.button(SAVE)) {
                panels.save();
                if (!editor.isWrong()) {
                    quit.run();
                }
            }
            if (ui.button(GIVE_UP)) {
                quit.run();
            }
            if (ui.button(STAY)) {
                asked = false;
            }
        }
        ui.endPanel();
    }
}
