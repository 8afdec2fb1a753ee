package dev.cairn.render.ui.nuklear;

import static org.lwjgl.nuklear.Nuklear.*;

import org.lwjgl.nuklear.NkColor;
import org.lwjgl.nuklear.NkContext;
import org.lwjgl.nuklear.NkRect;
import org.lwjgl.nuklear.NkStyleItem;

/** A cross of four strokes, in a window without a background that no mouse can hit. */
final class UiCross implements AutoCloseable {
    /** Of the window; Nuklear clips to it less a panel's padding, which hid two of the strokes. */
    private static final double HALF = 24;

    private static final double ARM = 8;
    private static final double GAP = 2;
    private static final double THICKNESS = 2;

    private final NkContext context;
    private final double scale;
    private final NkRect rect = NkRect.calloc();
    private final NkColor colour = NkColor.calloc();
    private final NkColor nothing = NkColor.calloc();
    private final NkStyleItem background;
    private final NkStyleItem savedBackground = NkStyleItem.calloc();
    private final NativeText name = new NativeText();

    /** For panels of a scale, real pixels to a logical one. */
    UiCross(NkContext context, double scale) {
        this.context = context;
        this.scale = scale;
        background = context.style().window().fixed_background();
    }

    /** Draws it around a point, logical pixels from the upper left corner. */
    void draw(double x, double y, int rgb) {
        rect.set(px(x - HALF), px(y - HALF), px(2 * HALF), px(2 * HALF));
        savedBackground.set(background);
        nk_style_item_color(nothing, background);
        if (nnk_begin(
                context.address(),
                name.of("cross"),
                rect.address(),
                NK_WINDOW_NO_INPUT | NK_WINDOW_BACKGROUND | NK_WINDOW_NO_SCROLLBAR)) {
            UiStyle.set(colour, 0xD0000000 | rgb);
            float cx = px(x);
            float cy = px(y);
            float arm = px(ARM);
            float gap = px(GAP);
            stroke(cx - arm, cy, cx - gap, cy);
            stroke(cx + gap, cy, cx + arm, cy);
            stroke(cx, cy - arm, cx, cy - gap);
            stroke(cx, cy + gap, cx, cy + arm);
        }
        nk_end(context);
        background.set(savedBackground);
    }

    private float px(double logical) {
        return (float) Math.rint(logical * scale);
    }

    /** By address: an object that wraps the canvas would be garbage of every frame. */
    private void stroke(float ax, float ay, float bx, float by) {
        long canvas = nnk_window_get_canvas(context.address());
        nnk_stroke_line(canvas, ax, ay, bx, by, px(THICKNESS), colour.address());
    }

    @Override
    public void close() {
        rect.free();
        colour.free();
        nothing.free();
        savedBackground.free();
        name.close();
    }
}
