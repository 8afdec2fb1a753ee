package dev.cairn.render.input;

import org.jspecify.annotations.Nullable;

import java.util.Locale;
import java.util.Objects;

/**
 * One thing that the user does to an entity: a key or a mouse button, and what it moves. Immutable.
 *
 * @param key the key, or null if it is a button
 * @param button the mouse button, or null if it is a key
 * @param effect what it does
 * @param axes whose axes the vector is along
 * @param x size and direction, in the unit of the effect
 * @param y same
 * @param z same
 * @see Controllable
 */
public record Control(
        @Nullable Key key,
        @Nullable MouseButton button,
        Effect effect,
        Axes axes,
        double x,
        double y,
        double z) {

    /**
     * What a control does to a body. Without a body the entity's pose moves by the same numbers,
     * taken as m/s, rad/s and m.
     */
    public enum Effect {
        /** Accelerates while it is held, m/s². */
        PUSH,
        /** Accelerates the turning while it is held, rad/s². */
        TURN,
        /** Changes the velocity once for each press, m/s. */
        KICK;

        /**
         * The word in scene files.
         *
         * @return lower case
         */
        public String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /** Whose axes a control is along. */
    public enum Axes {
        /** Those of the world: y is up. */
        WORLD,
        /** Those of the entity. */
        ENTITY,
        /** As the user sees it, on the level: x to the right, y up, -z away from the camera. */
        VIEW;

        /**
         * The word in scene files.
         *
         * @return lower case
         */
        public String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /**
     * Checks the trigger and the vector.
     *
     * @throws IllegalArgumentException if there is not exactly one trigger, or the vector is not
     *     finite
     */
    public Control {
        if ((key == null) == (button == null)) {
            throw new IllegalArgumentException(
                    "a control has key "
                            + key
                            + " and button "
                            + button
                            + ", expected one of them");
        }
        Objects.requireNonNull(effect, "effect");
        Objects.requireNonNull(axes, "axes");
        if (!(Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z))) {
            throw new IllegalArgumentException(
                    "a control is along (%s, %s, %s), expected finite numbers".formatted(x, y, z));
        }
    }

    /**
     * A control by a key, along the axes of the view.
     *
     * @param key which key
     * @param effect what it does
     * @param x to the right
     * @param y upwards
     * @param z towards the camera
     * @return the control
     */
    public static Control of(Key key, Effect effect, double x, double y, double z) {
        return new Control(key, null, effect, Axes.VIEW, x, y, z);
    }

    /**
     * A control by a mouse button, along the axes of the view.
     *
     * @param button which button
     * @param effect what it does
     * @param x to the right
     * @param y upwards
     * @param z towards the camera
     * @return the control
     */
    public static Control of(MouseButton button, Effect effect, double x, double y, double z) {
        return new Control(null, button, effect, Axes.VIEW, x, y, z);
    }

    /**
     * The same by another key.
     *
     * @param value which key
     * @return a copy
     */
    public Control withKey(Key value) {
        return new Control(value, null, effect, axes, x, y, z);
    }

    /**
     * The name of the key or button.
     *
     * @return such as {@code UP} or {@code mouse MIDDLE}
     */
    public String trigger() {
        return key != null ? key.name() : "mouse " + button;
    }
}
