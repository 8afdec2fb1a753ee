package dev.cairn.core.ecs;

/** An entity that is not alive, or that never was. */
public final class DeadEntityException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    DeadEntityException(String message) {
        super(message);
    }
}
