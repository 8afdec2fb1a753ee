package dev.cairn.samples.scenefile;

/**
 * Three numbers: a point, a direction, a velocity or a scale. Immutable.
 *
 * @param x first, finite
 * @param y second, finite
 * @param z third, finite
 */
public record Xyz(double x, double y, double z) {
    /** (0, 0, 0). */
    public static final Xyz ZERO = new Xyz(0, 0, 0);

    /** (1, 1, 1). */
    public static final Xyz ONE = new Xyz(1, 1, 1);

    /** Checks that the numbers are finite. */
    public Xyz {
        if (!Double.isFinite(x) || !Double.isFinite(y) || !Double.isFinite(z)) {
            throw new IllegalArgumentException(
                    "(%s, %s, %s): expected finite numbers".formatted(x, y, z));
        }
    }
}
