package dev.cairn.core.ecs;

/** A call to a world after {@link World#close()}. */
public final class WorldClosedException extends IllegalStateException {
    private static final long serialVersionUID = 1L;

    WorldClosedException(String message) {
        super(message);
    }
}
