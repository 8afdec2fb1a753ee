package dev.cairn.physics.body;

/** A body was used after it had left its world. */
public final class BodyRemovedException extends IllegalStateException {
    private static final long serialVersionUID = 1L;

    /**
     * Says which body, and what to do.
     *
     * @param message the text
     */
    public BodyRemovedException(String message) {
        super(message);
    }
}
