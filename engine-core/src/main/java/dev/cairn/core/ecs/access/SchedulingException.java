package dev.cairn.core.ecs.access;

/**
 * The systems of a schedule contradict each other; the message names them, the column and a remedy.
 */
public final class SchedulingException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    /**
     * An error that teaches.
     *
     * @param message what, where, and what to do
     */
    public SchedulingException(String message) {
        super(message);
    }
}
