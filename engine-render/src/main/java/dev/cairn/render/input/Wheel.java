package dev.cairn.render.input;

/** A step of the mouse wheel that a function can be bound to; see {@link Bindings#rebind}. */
public enum Wheel implements Trigger {
    /** Away from the user. */
    UP,
    /** Towards the user. */
    DOWN;

    static final String PREFIX = "WHEEL_";

    /**
     * Which way the wheel turns.
     *
     * @param steps positive away from the user, as GLFW tells
     * @return the way
     */
    public static Wheel of(double steps) {
        return steps > 0 ? UP : DOWN;
    }

    /**
     * How far a turn goes this way.
     *
     * @param turned positive away from the user
     * @return steps; 0 if it goes the other way
     */
    public double steps(double turned) {
        return Math.max(0, this == UP ? turned : -turned);
    }

    @Override
    public String label() {
        return this == UP ? "Wheel up" : "Wheel down";
    }

    @Override
    public String id() {
        return PREFIX + name();
    }
}
