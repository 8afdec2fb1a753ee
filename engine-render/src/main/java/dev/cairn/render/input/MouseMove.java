package dev.cairn.render.input;

/**
 * A way that the mouse goes, which a function can be bound to; see {@link Bindings#rebind}. While
 * the mouse turns the view its moves are the view's and start nothing.
 */
public enum MouseMove implements Trigger {
    /** To the left. */
    LEFT,
    /** To the right. */
    RIGHT,
    /** Away from the user. */
    UP,
    /** Towards the user. */
    DOWN;

    /** How far the mouse goes, points of the screen, to count like one step of the wheel. */
    public static final double POINTS_PER_STEP = 48;

    static final String PREFIX = "MOUSE_MOVE_";

    /**
     * How far a move goes this way.
     *
     * @param right of the whole move, points of the screen
     * @param down of the whole move, points of the screen
     * @return steps; 0 if it goes another way
     */
    public double steps(double right, double down) {
        double points =
                switch (this) {
                    case LEFT -> -right;
                    case RIGHT -> right;
                    case UP -> -down;
                    case DOWN -> down;
                };
        return Math.max(0, points) / POINTS_PER_STEP;
    }

    @Override
    public String label() {
        return switch (this) {
            case LEFT -> "Mouse left";
            case RIGHT -> "Mouse right";
            case UP -> "Mouse up";
            case DOWN -> "Mouse down";
        };
    }

    @Override
    public String id() {
        return PREFIX + name();
    }
}
