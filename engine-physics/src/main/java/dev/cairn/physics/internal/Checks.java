package dev.cairn.physics.internal;

import org.jspecify.annotations.Nullable;

/** Argument checks of the façade: each message names the value, its bound and what to do. */
public final class Checks {
    private Checks() {}

    /** Checks that there is a value. */
    public static <T> T notNull(String name, @Nullable T value) {
        if (value == null) {
            throw new IllegalArgumentException(name + " is null; pass a value");
        }
        return value;
    }

    /** Checks that a value is finite. */
    public static double finite(String name, double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(
                    name + " is " + value + "; it must be finite (neither NaN nor infinite)");
        }
        return value;
    }

    /** Checks a direction of any length above 0. */
    public static void direction(double x, double y, double z) {
        finite("directionX", x);
        finite("directionY", y);
        finite("directionZ", z);
        if (x == 0 && y == 0 && z == 0) {
            throw new IllegalArgumentException(
                    "direction is (0, 0, 0); it must point somewhere, its length does not matter");
        }
    }

    /** Checks that a value is finite and above 0. */
    public static double positive(String name, double value) {
        if (!(value > 0) || value == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    name + " is " + value + "; it must be finite and greater than 0");
        }
        return value;
    }

    /** Checks that a value is finite and at least 0. */
    public static double atLeastZero(String name, double value) {
        if (!(value >= 0) || value == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    name + " is " + value + "; it must be finite and at least 0");
        }
        return value;
    }

    /** Checks that a value is above 0; it may be infinite. */
    public static double limit(String name, double value) {
        if (!(value > 0)) {
            throw new IllegalArgumentException(
                    name + " is " + value + "; it must be greater than 0, or infinite for none");
        }
        return value;
    }

    /** Checks that a value is in a range. */
    public static double between(String name, double value, double low, double high) {
        if (!(value >= low && value <= high)) {
            throw new IllegalArgumentException(
                    name + " is " + value + "; it must be from " + low + " to " + high);
        }
        return value;
    }

    /** Checks that a value is in a range. */
    public static int between(String name, int value, int low, int high) {
        if (value < low || value > high) {
            throw new IllegalArgumentException(
                    name + " is " + value + "; it must be from " + low + " to " + high);
        }
        return value;
    }

    /** Checks three moments of inertia, kg m². */
    public static void inertia(double xx, double yy, double zz) {
        positive("inertia xx", xx);
        positive("inertia yy", yy);
        positive("inertia zz", zz);
        double largest = Math.max(xx, Math.max(yy, zz));
        // a flat plate has exactly the sum; rounding may put it a little above
        if (largest > (xx + yy + zz - largest) * (1 + 1e-9)) {
            throw new IllegalArgumentException(
                    "inertia is ("
                            + xx
                            + ", "
                            + yy
                            + ", "
                            + zz
                            + ") kg m²; none may be larger than the sum of the other two, since"
                            + " each is a sum of squares of distances: reduce the largest");
        }
    }
}
