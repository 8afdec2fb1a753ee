package dev.cairn.render.ui.nuklear;

import static org.lwjgl.nuklear.Nuklear.*;

import org.lwjgl.nuklear.NkColor;
import org.lwjgl.nuklear.NkContext;

/** A curve in the widget at hand. */
final class UiPlot {
    private UiPlot() {}

    /**
     * Draws the values of a ring; not a number is drawn at the lower edge.
     *
     * @param line room for the colour of the line
     * @param mark room for that of the point under the mouse
     * @param begin where the oldest value is
     * @param count how many there are
     */
    static void curve(
            NkContext context,
            NkColor line,
            NkColor mark,
            float[] values,
            int begin,
            int count,
            int rgb) {
        float min = Float.POSITIVE_INFINITY;
        float max = Float.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            float v = values[(begin + i) % values.length];
            if (!Float.isNaN(v)) {
                min = Math.min(min, v);
                max = Math.max(max, v);
            }
        }
        if (min > max) {
            min = 0;
            max = 1;
        }
        // From zero where all is positive, so that the height of the curve means something.
        float low = Math.min(min, 0);
        float high = Math.max(max, low + Float.MIN_NORMAL);
        UiStyle.set(line, 0xFF000000 | rgb);
        UiStyle.set(mark, 0xFFFFFFFF);
        if (nnk_chart_begin_colored(
                context.address(),
                NK_CHART_LINES,
                line.address(),
                mark.address(),
                Math.max(count, 2),
                low,
                high)) {
            for (int i = 0; i < count; i++) {
                float v = values[(begin + i) % values.length];
                nk_chart_push(context, Float.isNaN(v) ? low : v);
            }
            nk_chart_end(context);
        }
    }
}
