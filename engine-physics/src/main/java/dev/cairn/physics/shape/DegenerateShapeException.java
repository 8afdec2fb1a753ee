package dev.cairn.physics.shape;

/**
 * A shape cannot be made from the given numbers: the message names what is degenerate, the value,
 * the bound and the remedy.
 */
public final class DegenerateShapeException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    /** What is wrong with the input. */
    public enum Reason {
        /** A coordinate, length or density is NaN or infinite. */
        NOT_FINITE,
        /**
         * A length is zero, negative, or so small or large that its cube leaves the range of {@code
         * double}.
         */
        EXTENT,
        /** Fewer than four points. */
        TOO_FEW_POINTS,
        /** All points coincide. */
        COINCIDENT,
        /** All points lie on one line. */
        COLLINEAR,
        /** All points lie in one plane. */
        COPLANAR,
        /** The hull has more vertices than feature ids can name. */
        TOO_COMPLEX
    }

    /** What is wrong with the input. */
    private final Reason reason;

    DegenerateShapeException(Reason reason, String message) {
        super(message);
        this.reason = reason;
    }

    /**
     * What is wrong with the input, for code that wants to react to it.
     *
     * @return the reason, never null
     */
    public Reason reason() {
        return reason;
    }
}
