package dev.cairn.core.ecs;

/**
 * A system threw. The cause is the first failure in (system, chunk) order, the others are
 * suppressed; the tick was not committed.
 */
public final class WorldFailedException extends IllegalStateException {
    private static final long serialVersionUID = 1L;

    WorldFailedException(String message, Throwable cause) {
        super(message, cause);
    }
}
