package dev.cairn.render.input;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * For how much of a frame's time each action is held: all of it while a key or button of its is
 * down, and a tenth of a second for each step of the wheel or of the mouse that it is bound to.
 * Window thread.
 */
public final class Held {
    /** How long a step of the wheel or of the mouse holds what is held otherwise by a key. */
    public static final double SECONDS_PER_STEP = 0.1;

    private final Set<Trigger> down = new HashSet<>();
    private double movedRight;
    private double movedDown;
    private double turned;

    /** Nothing is held. */
    public Held() {}

    /**
     * Called by the window for what belongs to the scene.
     *
     * @param trigger which key or button
     * @param isDown whether it went down
     */
    public void press(Trigger trigger, boolean isDown) {
        if (isDown) {
            down.add(trigger);
        } else {
            down.remove(trigger);
        }
    }

    /** Called by the window when it loses the focus. */
    public void releaseAll() {
        down.clear();
    }

    /**
     * Called by the window when the mouse moves and does not turn the view.
     *
     * @param right how far, points of the screen
     * @param downwards how far, points of the screen
     */
    public void move(double right, double downwards) {
        movedRight += right;
        movedDown += downwards;
    }

    /**
     * Called by the window when the wheel turns.
     *
     * @param steps positive away from the user
     */
    public void scroll(double steps) {
        turned += steps;
    }

    /** Called by the window once a frame has seen how far wheel and mouse went. */
    public void endFrame() {
        movedRight = 0;
        movedDown = 0;
        turned = 0;
    }

    /**
     * For how much of a time an action is held.
     *
     * @param bindings what its triggers are
     * @param action its name
     * @param frame the time that has passed since the last frame, s
     * @return seconds; more than those of the frame where wheel or mouse go fast; no allocation
     */
    public double seconds(Bindings bindings, String action, double frame) {
        List<Trigger> triggers = bindings.triggers(action);
        double steps = 0;
        boolean isDown = false;
        for (int i = 0; i < triggers.size(); i++) {
            Trigger trigger = triggers.get(i);
            isDown |= down.contains(trigger);
            steps += steps(trigger);
        }
        return (isDown ? frame : 0) + steps * SECONDS_PER_STEP;
    }

    private double steps(Trigger trigger) {
        return switch (trigger) {
            case Wheel way -> way.steps(turned);
            case MouseMove way -> way.steps(movedRight, movedDown);
            default -> 0;
        };
    }
}
