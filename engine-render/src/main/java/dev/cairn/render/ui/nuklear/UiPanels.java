package dev.cairn.render.ui.nuklear;

/** Where the panels of a frame are, and how many pairs of them overlap. Logical pixels. */
final class UiPanels {
    private static final int MOST = 32;

    private final double[] edges = new double[4 * MOST];
    private int count;
    private int overlapping;
    private int before;

    /** Begins to count. */
    void nextFrame() {
        before = overlapping;
        count = 0;
        overlapping = 0;
    }

    void add(double left, double top, double width, double height) {
        if (count == MOST) {
            return;
        }
        int at = 4 * count++;
        edges[at] = left;
        edges[at + 1] = top;
        edges[at + 2] = left + width;
        edges[at + 3] = top + height;
        for (int other = 0; other < at; other += 4) {
            if (edges[other] < edges[at + 2]
                    && edges[at] < edges[other + 2]
                    && edges[other + 1] < edges[at + 3]
                    && edges[at + 1] < edges[other + 3]) {
                overlapping++;
            }
        }
    }

    /** Pairs that overlapped in the last whole frame. */
    int overlapping() {
        return before;
    }
}
