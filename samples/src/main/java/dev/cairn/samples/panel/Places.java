package dev.cairn.samples.panel;

import dev.cairn.render.ui.Ui;

/**
 * Two columns of panels with the picture between them; one column where the window has no room for
 * two. Logical pixels. Stateless.
 */
public final class Places {
    /** Between panels, and between panels and the window's edge. */
    public static final double GAP = 10;

    /** Width of a column. */
    public static final double WIDTH = 290;

    /** What is left for the picture between two columns, at least. */
    private static final double PICTURE = 220;

    /** Width of a panel below the picture, at least. */
    private static final double LEAST_BELOW = 120;

    /** Height of the panel that lists what there is, at least. */
    private static final double LIST_HEIGHT = 150;

    private static final double MOST_UPPER = 420;
    private static final double UPPER_SHARE = 0.6;

    private Places() {}

    /**
     * Whether there is room for one column only.
     *
     * @param ui the window
     * @return true if panels have to take turns
     */
    public static boolean isNarrow(Ui ui) {
        return isNarrow(ui.width());
    }

    private static boolean isNarrow(double width) {
        return width < 2 * WIDTH + 2 * GAP + PICTURE;
    }

    /**
     * Whether there is room for a panel below the picture, beside the columns.
     *
     * @param width of the window
     * @return false if it would cover a column or leave the window
     */
    public static boolean hasBelow(double width) {
        return beside(width) >= LEAST_BELOW;
    }

    private static double beside(double width) {
        return width - (WIDTH + 2 * GAP) - (isNarrow(width) ? GAP : WIDTH + 2 * GAP);
    }

    /**
     * Left edge of a panel below the picture; over the column where there is no room beside it.
     *
     * @param width of the window
     * @return its place
     */
    public static double belowLeft(double width) {
        return hasBelow(width) ? WIDTH + 2 * GAP : GAP;
    }

    /**
     * Width of that panel.
     *
     * @param width of the window
     * @return what is left of it
     */
    public static double belowWidth(double width) {
        return hasBelow(width) ? beside(width) : width - 2 * GAP;
    }

    /**
     * Height of the upper one of two panels in a column; the lower one has the rest less a gap.
     *
     * @param height of the column
     * @return more than half of a low column, and room for a list below it in a high one
     */
    public static double upperHeight(double height) {
        return Math.min(Math.max(height - LIST_HEIGHT, UPPER_SHARE * height), MOST_UPPER);
    }

    /**
     * Left edge of the second column; that of the first where there is one only.
     *
     * @param ui the window
     * @return its place
     */
    public static double right(Ui ui) {
        return isNarrow(ui) ? GAP : ui.width() - WIDTH - GAP;
    }

    /**
     * Height of a column.
     *
     * @param ui the window
     * @return what is left between two gaps
     */
    public static double height(Ui ui) {
        return ui.height() - 2 * GAP;
    }
}
