package dev.cairn.render.gl;

/**
 * No OpenGL context could be had; the message is one sentence that says why and what to install.
 */
public final class GlUnavailableException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /**
     * Says why.
     *
     * @param message one sentence with the remedy
     */
    public GlUnavailableException(String message) {
        super(message);
    }
}
