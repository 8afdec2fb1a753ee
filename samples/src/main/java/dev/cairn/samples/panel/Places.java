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

    private Places() {}

    /**
     * Whether there is room for one column only.
     *
     * @param ui the window
     * @return true if panels have to take turns
     */
    public static boolean isNarrow(Ui ui) {
        return ui.width() < 2 * WIDTH + 2 * GAP + PICTURE;
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
