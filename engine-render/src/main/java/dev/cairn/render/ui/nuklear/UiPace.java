package dev.cairn.render.ui.nuklear;

/**
 * Which frames make panels anew, and in which what was drawn stays. Events have them made in each
 * frame for a while, since what an event does may come back from the simulation some frames later.
 */
final class UiPace {
    /** How long panels stay as they are where nobody does anything to them. */
    static final long KEPT_NANOS = 100_000_000;

    /** How long after an event each frame makes them. */
    static final long AWAKE_NANOS = 200_000_000;

    private int width;
    private int height;
    private long nowNanos;
    private long madeNanos;
    private long awakeUntilNanos;
    private boolean made;
    private boolean begun;
    private boolean kept;

    /** A frame begins, of this size in pixels; at a clock's time that never goes back. */
    void begin(int newWidth, int newHeight, long now, boolean stirred) {
        if (stirred || newWidth != width || newHeight != height) {
            awakeUntilNanos = now + AWAKE_NANOS;
        }
        made &= newWidth == width && newHeight == height;
        width = newWidth;
        height = newHeight;
        nowNanos = now;
        begun = false;
        kept = false;
    }

    /** Has panels stay in this frame if none was begun yet, and if they may. */
    boolean keep() {
        kept =
                made
                        && !begun
                        && nowNanos - awakeUntilNanos >= 0
                        && nowNanos - madeNanos < KEPT_NANOS;
        return kept;
    }

    /** True once in a frame that makes panels: before the first of them. */
    boolean begins() {
        boolean first = !kept && !begun;
        begun |= first;
        return first;
    }

    boolean makes() {
        return !kept;
    }

    /** The frame was made and drawn. */
    void done() {
        made = true;
        madeNanos = nowNanos;
    }
}
