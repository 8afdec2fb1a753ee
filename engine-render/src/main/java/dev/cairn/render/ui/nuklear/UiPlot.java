package dev.cairn.render.ui.nuklear;

import static org.lwjgl.nuklear.Nuklear.*;

import org.lwjgl.nuklear.NkColor;
import org.lwjgl.nuklear.NkContext;
import org.lwjgl.nuklear.NkRect;

/**
 * Curves in the widget at hand, one stroke each. Nuklear's own chart is a command and a rounded
 * line for each value, five times the time of all other widgets together.
 */
final class UiPlot implements AutoCloseable {
    /** Points of a curve; where there are more values, some of them share one. */
    private static final int MOST_POINTS = 120;

    private static final int BACKGROUND = 0xFF12151B;
    private static final double PADDING = 4;
    private static final double THICKNESS = 1;

    private final NkContext context;
    private final double scale;
    private final NkRect rect = NkRect.calloc();
    private final NkColor colour = NkColor.calloc();
    private final float[] points = new float[2 * MOST_POINTS];

    /** For panels of a scale, real pixels to a logical one. */
    UiPlot(NkContext context, double scale) {
        this.context = context;
        this.scale = scale;
    }

    /**
     * Draws the values of a ring; not a number is drawn at the lower edge.
     *
     * @param values the ring
     * @param begin where the oldest value is
     * @param count how many there are
     * @param rgb 0xRRGGBB in sRGB
     */
    void curve(float[] values, int begin, int count, int rgb) {
        if (nnk_widget(rect.address(), context.address()) == NK_WIDGET_INVALID) {
            return; // scrolled out of sight
        }
        long canvas = nnk_window_get_canvas(context.address());
        UiStyle.set(colour, BACKGROUND);
        nnk_fill_rect(canvas, rect.address(), (float) (PADDING * scale), colour.address());
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
            return;
        }
        // From zero where all is positive, so that the height of the curve means something.
        float low = Math.min(min, 0);
        float high = Math.max(max, low + Float.MIN_NORMAL);
        int drawn = place(values, begin, count, low, high);
        if (drawn > 1) {
            UiStyle.set(colour, 0xFF000000 | rgb);
            nnk_stroke_polyline(
                    canvas, points, drawn, (float) (THICKNESS * scale), colour.address());
        }
    }

    /** Of values that share a point the one is drawn that lies farthest from the point before. */
    private int place(float[] values, int begin, int count, float low, float high) {
        int share = Math.max(1, (count + MOST_POINTS - 1) / MOST_POINTS);
        float inset = (float) (PADDING * scale);
        float width = rect.w() - 2 * inset;
        float height = rect.h() - 2 * inset;
        float bottom = rect.y() + rect.h() - inset;
        int drawn = 0;
        float before = Float.NaN;
        for (int first = 0; first < count; first += share) {
            float chosen = Float.NaN;
            int at = first;
            for (int i = first; i < Math.min(first + share, count); i++) {
                float v = values[(begin + i) % values.length];
                v = Float.isNaN(v) ? low : v;
                if (Float.isNaN(chosen)
                        || (!Float.isNaN(before)
                                && Math.abs(v - before) > Math.abs(chosen - before))) {
                    chosen = v;
                    at = i;
                }
            }
            before = chosen;
            points[2 * drawn] = rect.x() + inset + width * at / Math.max(1, count - 1);
            points[2 * drawn + 1] = bottom - height * (chosen - low) / (high - low);
            drawn++;
        }
        return drawn;
    }

    @Override
    public void close() {
        rect.free();
        colour.free();
    }
}
