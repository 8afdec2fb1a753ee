package dev.cairn.core.ecs.component;

/** An entity that is not alive, or that never was. */
public final class DeadEntityException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    /**
     * An error that teaches.
     *
     * @param message what, where, and what to do
     */
    public DeadEntityException(String message) {
        super(message);
    }
}
