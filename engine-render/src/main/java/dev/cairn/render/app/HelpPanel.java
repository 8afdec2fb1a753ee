package dev.cairn.render.app;

import dev.cairn.render.input.Bindings;
import dev.cairn.render.ui.Ui;

import java.util.List;

/** All keys, in the middle of the window. Window thread. */
final class HelpPanel {
    private static final double WIDTH = 660;
    private static final double LINE = 24;
    private static final double MARGIN = 40;

    void draw(Ui ui, Bindings bindings) {
        List<Bindings.Binding> all = bindings.actions();
        double width = Math.min(WIDTH, ui.width() - MARGIN);
        double height = Math.min((all.size() / 2 + 2) * LINE + 70, ui.height() - MARGIN);
        if (ui.panel(
                "Keys (F1 closes)",
                (ui.width() - width) / 2,
                (ui.height() - height) / 2,
                width,
                height)) {
            ui.columns(4);
            for (int i = 0; i < all.size(); i++) {
                Bindings.Binding binding = all.get(i);
                if (!binding.label().isEmpty()) {
                    ui.label(binding.label(), 0x74BBF0);
                    ui.label(binding.action());
                }
            }
            ui.text("The right mouse button, held, turns the view; the wheel scrolls panels.");
        }
        ui.endPanel();
    }
}
