package dev.cairn.render.ui.nuklear;

import dev.cairn.render.ui.TextBuffer;

/**
 * Texts as Nuklear wants them, made to fit: one that is wider than its place ends in "..." rather
 * than in half a letter. Counts those, so that a test can say that none of ours does.
 */
final class UiText implements AutoCloseable {
    private static final String DOTS = "...";

    private final NativeText letters = new NativeText();
    private final TextBuffer shorter = new TextBuffer();
    private int shortened;
    private int before;

    /** Begins to count. */
    void nextFrame() {
        before = shortened;
        shortened = 0;
    }

    /** How many texts did not fit in the last whole frame. */
    int shortened() {
        return before;
    }

    /** The whole text; see {@link NativeText#of}. */
    long of(CharSequence text) {
        return letters.of(text);
    }

    /**
     * As much of a text as fits.
     *
     * @param text what
     * @param widths the widths of its letters
     * @param room real pixels
     * @return its address, valid until the next call
     */
    long fitted(CharSequence text, float[] widths, double room) {
        if (width(text, 0, text.length(), widths) <= room + 0.5) {
            return letters.of(text);
        }
        shortened++;
        double left = room - width(DOTS, 0, DOTS.length(), widths);
        int end = 0;
        while (end < text.length() && width(text, 0, end + 1, widths) <= left) {
            end++;
        }
        shorter.clear();
        for (int i = 0; i < end; i++) {
            shorter.put(text.charAt(i));
        }
        return letters.of(shorter.put(DOTS));
    }

    static double width(CharSequence text, int from, int to, float[] widths) {
        double width = 0;
        for (int i = from; i < to; i++) {
            char letter = text.charAt(i);
            width += widths[letter < widths.length ? letter : '?'];
        }
        return width;
    }

    /** Rows that a text takes where it is broken between words, as Nuklear breaks it. */
    static int rows(CharSequence text, float[] widths, double room) {
        int rows = 1;
        double used = 0;
        int start = 0;
        for (int i = 0; i <= text.length(); i++) {
            if (i < text.length() && text.charAt(i) != ' ') {
                continue;
            }
            double word = width(text, start, i, widths);
            if (used > 0 && used + word > room) {
                rows++;
                used = 0;
            }
            // A word that is longer than a row is broken wherever the row ends.
            rows += (int) (word / Math.max(room, 1));
            used += word % Math.max(room, 1) + widths[' '];
            start = i + 1;
        }
        return rows;
    }

    @Override
    public void close() {
        letters.close();
    }
}
