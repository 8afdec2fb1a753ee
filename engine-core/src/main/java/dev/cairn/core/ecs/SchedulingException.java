package dev.cairn.core.ecs;

/**
 * The systems of a schedule contradict each other; the message names them, the column and a remedy.
 */
public final class SchedulingException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    SchedulingException(String message) {
        super(message);
    }
}
