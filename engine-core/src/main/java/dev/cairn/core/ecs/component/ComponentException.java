package dev.cairn.core.ecs.component;

/**
 * A component that is present where it must not be, absent where it must be, or that has no such
 * field.
 */
public final class ComponentException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    /**
     * An error that teaches.
     *
     * @param message what, where, and what to do
     */
    public ComponentException(String message) {
        super(message);
    }
}
