package dev.cairn.benchmarks.peer;

/** An engine's classes or its native library are not there, or do not fit this machine. */
public final class MissingEngineException extends RuntimeException {
    /**
     * Creates the exception.
     *
     * @param message what is missing and what would help
     * @param cause what the loader said
     */
    public MissingEngineException(String message, Throwable cause) {
        super(message, cause);
    }

    /**
     * Creates the exception.
     *
     * @param message what is missing and what would help
     */
    public MissingEngineException(String message) {
        super(message);
    }
}
