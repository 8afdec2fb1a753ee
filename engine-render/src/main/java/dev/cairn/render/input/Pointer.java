package dev.cairn.render.input;

import java.util.EnumMap;
import java.util.EnumSet;

/**
 * Where the mouse is and what its buttons do, as of the present frame, as far as the panels leave
 * it to the scene. While the mouse turns the view it points at the middle. Window thread.
 */
public final class Pointer {
    private final EnumSet<MouseButton> down = EnumSet.noneOf(MouseButton.class);
    private final EnumMap<MouseButton, Integer> presses = new EnumMap<>(MouseButton.class);
    private double x;
    private double y;
    private double across;
    private double upwards;
    private boolean overPanel;
    private boolean turning;
    private boolean withShift;
    private boolean withControl;

    /** A pointer in the middle. */
    public Pointer() {}

    /** Called by the window before the events of a frame. */
    public void nextFrame() {
        presses.clear();
    }

    /**
     * Called by the window.
     *
     * @param newX from the left edge, as a share of the width
     * @param newY from the upper edge, as a share of the height
     * @param isTurning whether the mouse turns the view
     * @param isOverPanel whether a panel is under the cursor
     */
    public void place(double newX, double newY, boolean isTurning, boolean isOverPanel) {
        turning = isTurning;
        x = isTurning ? 0.5 : newX;
        y = isTurning ? 0.5 : newY;
        across = 2 * x - 1;
        upwards = 1 - 2 * y;
        overPanel = isOverPanel && !isTurning;
    }

    /**
     * Called by the window for buttons that belong to the scene.
     *
     * @param button which
     * @param isDown whether it went down
     */
    public void button(MouseButton button, boolean isDown) {
        if (isDown) {
            down.add(button);
            presses.merge(button, 1, Integer::sum);
        } else {
            down.remove(button);
        }
    }

    /**
     * Called by the window with each press.
     *
     * @param shift whether a Shift key is held
     * @param control whether a Ctrl key is held
     */
    public void modifiers(boolean shift, boolean control) {
        withShift = shift;
        withControl = control;
    }

    /**
     * Whether a Shift key was held at the last press of a button.
     *
     * @return true if so
     */
    public boolean isWithShift() {
        return withShift;
    }

    /**
     * Whether a Ctrl key was held at the last press of a button.
     *
     * @return true if so
     */
    public boolean isWithControl() {
        return withControl;
    }

    /** Called by the window when it loses the focus. */
    public void releaseAll() {
        down.clear();
    }

    /**
     * Whether a button went down since the last frame, outside of the panels.
     *
     * @param button which
     * @return true for one frame
     */
    public boolean wasPressed(MouseButton button) {
        return presses.containsKey(button);
    }

    /**
     * How often a button went down since the last frame, outside of the panels: 2 for a double
     * click in a slow frame.
     *
     * @param button which
     * @return the count, for one frame
     */
    public int presses(MouseButton button) {
        return presses.getOrDefault(button, 0);
    }

    /**
     * Whether a button that went down outside of the panels is held.
     *
     * @param button which
     * @return true while it is
     */
    public boolean isDown(MouseButton button) {
        return down.contains(button);
    }

    /**
     * Whether a panel is under the cursor.
     *
     * @return false while the mouse turns the view
     */
    public boolean isOverPanel() {
        return overPanel;
    }

    /**
     * Whether the mouse turns the view and there is no cursor.
     *
     * @return true while it does
     */
    public boolean isTurning() {
        return turning;
    }

    /**
     * Place in the picture from the left.
     *
     * @return 0 at the left edge, 1 at the right edge
     */
    public double x() {
        return x;
    }

    /**
     * Place in the picture from above.
     *
     * @return 0 at the upper edge, 1 at the lower edge
     */
    public double y() {
        return y;
    }

    /**
     * Place in the picture for {@code Camera.ray}.
     *
     * @return -1 at the left edge, 1 at the right edge
     */
    public double across() {
        return across;
    }

    /**
     * Place in the picture for {@code Camera.ray}.
     *
     * @return -1 at the lower edge, 1 at the upper edge
     */
    public double upwards() {
        return upwards;
    }
}
