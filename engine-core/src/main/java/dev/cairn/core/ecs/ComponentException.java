package dev.cairn.core.ecs;

/**
 * A component that is present where it must not be, absent where it must be, or that has no such
 * field.
 */
public final class ComponentException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    ComponentException(String message) {
        super(message);
    }
}
