package dev.cairn.render.input;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;

/**
 * The mouse as the simulation sees it: where it is, how far it has moved since the last tick, and
 * who is told of each move. What is over a panel is the panel's and does not come here.
 *
 * <pre>{@code
 * Mouse mouse = scene.bindings().mouse();
 * mouse.onMove("steer", (right, down) -> car.steer(0.01 * right));
 * double across = mouse.x(); // in update
 * }</pre>
 *
 * <p>Simulation thread. Where the mouse turns the view (the right button is held, or Tab was
 * pressed) it moves without end, and its place is the middle of the window.
 */
public final class Mouse {
    private final Map<String, Motion> motions = new LinkedHashMap<>();
    private double x = 0.5;
    private double y = 0.5;
    private double movedRight;
    private double movedDown;

    Mouse() {}

    /** What happens when the mouse moves. */
    @FunctionalInterface
    public interface Motion {
        /**
         * The mouse has moved; called before the tick that follows, also during a pause.
         *
         * @param right how far, points of the screen
         * @param down how far, points of the screen
         */
        void moved(double right, double down);
    }

    /**
     * Has a function told of each move.
     *
     * @param action its name; an earlier function of this name is told no longer
     * @param function what happens
     * @return this
     */
    public Mouse onMove(String action, Motion function) {
        motions.put(
                Objects.requireNonNull(action, "action: give the function a name"),
                Objects.requireNonNull(function, "function"));
        return this;
    }

    /**
     * Tells a function no longer.
     *
     * @param action the name it was given
     * @return whether there was one
     */
    public boolean forget(String action) {
        return motions.remove(action) != null;
    }

    /**
     * Where the mouse is, from the left edge of the window.
     *
     * @return a share of the width, 0..1; less or more where a drag leaves the window
     */
    public double x() {
        return x;
    }

    /**
     * Where the mouse is, from the upper edge of the window.
     *
     * @return a share of the height, 0..1; less or more where a drag leaves the window
     */
    public double y() {
        return y;
    }

    /**
     * How far the mouse has moved to the right since the last tick that was not paused.
     *
     * @return points of the screen
     */
    public double movedRight() {
        return movedRight;
    }

    /**
     * How far the mouse has moved down since the last tick that was not paused.
     *
     * @return points of the screen
     */
    public double movedDown() {
        return movedDown;
    }

    /**
     * What the window does when the mouse moves; scripts may do it too.
     *
     * @param toX where it is then, share of the width from the left
     * @param toY share of the height from above
     * @param right how far it has moved, points of the screen
     * @param down how far it has moved, points of the screen
     */
    public void move(double toX, double toY, double right, double down) {
        x = toX;
        y = toY;
        movedRight += right;
        movedDown += down;
        for (Motion motion : motions.values()) {
            motion.moved(right, down);
        }
    }

    void endTick() {
        movedRight = 0;
        movedDown = 0;
    }
}
