package dev.cairn.samples;

/**
 * The user asked for something that is not there or makes no sense: an unknown scene, a number out
 * of range, a broken file. The message is one line that says what is wrong and what to type
 * instead. {@link Main} prints it and exits with code 2.
 */
public final class UsageException extends IllegalArgumentException {
    private static final long serialVersionUID = 1;

    /**
     * Creates the exception.
     *
     * @param message one line: name, value, bound, remedy
     */
    public UsageException(String message) {
        super(message);
    }

    /**
     * Creates the exception with its cause.
     *
     * @param message one line: name, value, bound, remedy
     * @param cause what was thrown below
     */
    public UsageException(String message, Throwable cause) {
        super(message, cause);
    }
}
