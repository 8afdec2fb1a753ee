package dev.cairn.core.state;

/** A state cannot be restored here, or its bytes are not what was written. */
public final class StateException extends RuntimeException {
    private static final long serialVersionUID = 1;

    /**
     * With a reason.
     *
     * @param message what, where, which value, what to do
     */
    public StateException(String message) {
        super(message);
    }

    /**
     * With a reason and what it follows from.
     *
     * @param message what, where, which value, what to do
     * @param cause what was found
     */
    public StateException(String message, Throwable cause) {
        super(message, cause);
    }
}
