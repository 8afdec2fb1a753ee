package dev.cairn.core.ecs;

import org.jspecify.annotations.Nullable;

/**
 * A system threw during a step. The cause is the first failure in (system, chunk) order, those of
 * other chunks of the same level are suppressed. The tick was not published: the world shows its
 * last good state, and cannot step again.
 */
public final class WorldFailedException extends IllegalStateException {
    private static final long serialVersionUID = 1L;

    WorldFailedException(String message, @Nullable Throwable cause) {
        super(message, cause);
    }
}
