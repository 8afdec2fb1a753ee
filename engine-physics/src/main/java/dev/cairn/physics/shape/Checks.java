package dev.cairn.physics.shape;

import dev.cairn.physics.shape.DegenerateShapeException.Reason;

/** Argument checks with messages that teach. */
final class Checks {
    /**
     * Cubes of lengths, and products of volumes with densities and squares, stay inside the range
     * of double.
     */
    static final double MIN_LENGTH = 1e-50;

    /** See {@link #MIN_LENGTH}. */
    static final double MAX_LENGTH = 1e50;

    private Checks() {}

    static void length(String name, double value) {
        if (!Double.isFinite(value)) {
            throw new DegenerateShapeException(
                    Reason.NOT_FINITE, name + " is " + value + "; give a finite length in metres");
        }
        if (!(value >= MIN_LENGTH && value <= MAX_LENGTH)) {
            throw new DegenerateShapeException(
                    Reason.EXTENT,
                    name
                            + " is "
                            + value
                            + " m; it must lie in ["
                            + MIN_LENGTH
                            + ", "
                            + MAX_LENGTH
                            + "]");
        }
    }

    static void coordinate(String name, double value) {
        if (!(Math.abs(value) <= MAX_LENGTH)) {
            throw new DegenerateShapeException(
                    Double.isFinite(value) ? Reason.EXTENT : Reason.NOT_FINITE,
                    name + " is " + value + " m; it must lie in [-1e50, 1e50]");
        }
    }

    static int material(String name, int number) {
        if (number < 0 || number > 254) {
            throw new IllegalArgumentException(
                    name + " is " + number + "; numbers of materials are 0 to 254");
        }
        return number;
    }

    static void density(double density) {
        if (!(density > 0 && density <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException(
                    "density is "
                            + density
                            + " kg/m³; it must be positive and finite (water: 1000)");
        }
    }
}
