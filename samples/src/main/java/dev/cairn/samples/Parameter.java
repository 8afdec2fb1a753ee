package dev.cairn.samples;

import org.jspecify.annotations.Nullable;

/**
 * A number that the user of a scene may set, as {@code --set name=value}.
 *
 * @param name name on the command line and in reports
 * @param defaultValue value where the user gives none
 * @param min smallest value allowed
 * @param max largest value allowed
 * @param whole true if only whole numbers make sense (a count)
 * @param meaning what it is, with its unit
 */
public record Parameter(
        String name, double defaultValue, double min, double max, boolean whole, String meaning) {

    /** Checks the bounds against each other. */
    public Parameter {
        if (!(min <= defaultValue && defaultValue <= max)) {
            throw new IllegalArgumentException(
                    "parameter %s: the default %s is outside [%s, %s]"
                            .formatted(name, defaultValue, min, max));
        }
    }

    /**
     * Returns a parameter that takes any number in a range.
     *
     * @param name name on the command line
     * @param defaultValue value where the user gives none
     * @param min smallest value allowed
     * @param max largest value allowed
     * @param meaning what it is, with its unit
     * @return the parameter
     */
    public static Parameter real(
            String name, double defaultValue, double min, double max, String meaning) {
        return new Parameter(name, defaultValue, min, max, false, meaning);
    }

    /**
     * Returns a parameter that counts something.
     *
     * @param name name on the command line
     * @param defaultValue value where the user gives none
     * @param min smallest value allowed
     * @param max largest value allowed
     * @param meaning what it counts
     * @return the parameter
     */
    public static Parameter count(String name, int defaultValue, int min, int max, String meaning) {
        return new Parameter(name, defaultValue, min, max, true, meaning);
    }

    /**
     * Reads a value that the user typed.
     *
     * @param scene id of the scene, for the message
     * @param text what was typed
     * @return the value, finite and within the bounds
     * @throws UsageException if the text is no number or is out of bounds
     */
    public double parse(String scene, String text) {
        double value;
        try {
            value = Double.parseDouble(text.trim());
            // Java also reads 1d, 1f and 0x1p3, which nobody types on purpose.
            char last = text.trim().charAt(text.trim().length() - 1);
            if (Character.isLetter(last) || text.indexOf('x') >= 0 || text.indexOf('X') >= 0) {
                throw refuse(scene, text, null);
            }
        } catch (NumberFormatException notANumber) {
            throw refuse(scene, text, notANumber);
        }
        // Written so that NaN fails.
        boolean inside = value >= min && value <= max;
        if (!inside || (whole && value != Math.rint(value))) {
            throw refuse(scene, text, null);
        }
        return value;
    }

    private UsageException refuse(
            String scene, String text, @Nullable NumberFormatException cause) {
        String message =
                "--set %s=%s: %s of scene %s takes a %s from %s to %s (%s)"
                        .formatted(
                                name,
                                text,
                                name,
                                scene,
                                whole ? "whole number" : "number",
                                show(min),
                                show(max),
                                meaning);
        return cause == null ? new UsageException(message) : new UsageException(message, cause);
    }

    /**
     * Writes a number the way a person would: 20 and not 20.0.
     *
     * @param value the number
     * @return its shortest text
     */
    public static String show(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9
                ? Long.toString((long) value)
                : Double.toString(value);
    }
}
