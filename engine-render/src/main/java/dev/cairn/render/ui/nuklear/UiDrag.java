package dev.cairn.render.ui.nuklear;

import static org.lwjgl.nuklear.Nuklear.nk_widget_is_hovered;

import org.lwjgl.nuklear.NkContext;

/** The slider that the user drags. Nuklear moves one only by its knob; here it is the whole bar. */
final class UiDrag {
    private static final double KNOB_INSET = 9;

    private final NkContext context;
    private final NuklearInput input;
    private String panel = "";
    private String slider = "";
    private double share;

    UiDrag(NkContext context, NuklearInput input) {
        this.context = context;
        this.input = input;
    }

    boolean isHeld(String panelNow, String label) {
        return slider.equals(label) && panel.equals(panelNow);
    }

    /** Whether the next widget is dragged: the press was on it, and the button is still down. */
    boolean begins(String panelNow, String label) {
        if (input.wasPressed() && nk_widget_is_hovered(context)) {
            panel = panelNow;
            slider = label;
        } else if (!input.isDragging()) {
            slider = "";
        }
        return isHeld(panelNow, label);
    }

    /**
     * The value where the cursor is, or that of before where the knob is there.
     *
     * @param at the slider, logical pixels
     */
    double moved(double[] at, double scale, double value, double min, double max, double step) {
        share = SliderScale.share(min, max, value);
        double room = at[2] - 2 * KNOB_INSET;
        double wanted = Math.clamp((input.cursorX() / scale - at[0] - KNOB_INSET) / room, 0.0, 1.0);
        if (Math.abs(wanted - share) * room < 0.5) {
            return value;
        }
        share = wanted;
        return Math.clamp(SliderText.round(SliderScale.value(min, max, wanted), step), min, max);
    }

    /** Where the knob of what was moved is, 0..1. */
    double share() {
        return share;
    }
}
