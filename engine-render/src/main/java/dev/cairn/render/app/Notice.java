package dev.cairn.render.app;

import dev.cairn.render.ui.Ui;

/** A line at the upper edge of the window that goes away by itself. Window thread. */
final class Notice {
    private static final double SECONDS = 5;
    private static final double LETTER = 7.5;
    private static final double HEIGHT = 76;
    private static final double LEAST_WIDTH = 300;
    private static final double SHARE = 0.4;
    private static final double MARGIN = 20;

    private String text = "";
    private double left;

    void show(String newText) {
        text = newText;
        left = SECONDS;
    }

    void draw(Ui ui, double elapsed) {
        if (left <= 0) {
            return;
        }
        left -= elapsed;
        double width =
                Math.min(text.length() * LETTER + 60, Math.max(LEAST_WIDTH, SHARE * ui.width()));
        double rows = Math.ceil(text.length() * LETTER / Math.max(width - 40, 40));
        double height = HEIGHT + 19 * (rows - 1);
        if (ui.panel("Notice", (ui.width() - width) / 2, MARGIN, width, height)) {
            ui.text(text);
        }
        ui.endPanel();
    }
}
