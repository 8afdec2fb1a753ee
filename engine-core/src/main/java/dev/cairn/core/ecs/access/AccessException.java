package dev.cairn.core.ecs.access;

import dev.cairn.core.ecs.EcsSystem;

/** A system broke the contract that it declared in {@link EcsSystem#describe}. */
public final class AccessException extends IllegalStateException {
    private static final long serialVersionUID = 1L;

    /**
     * An error that teaches.
     *
     * @param message what, where, and what to do
     */
    public AccessException(String message) {
        super(message);
    }
}
