package dev.cairn.core.ecs;

/** A system broke the contract that it declared in {@link EcsSystem#describe}. */
public final class AccessException extends IllegalStateException {
    private static final long serialVersionUID = 1L;

    AccessException(String message) {
        super(message);
    }
}
