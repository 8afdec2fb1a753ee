package dev.cairn.physics;

import org.jspecify.annotations.Nullable;

/** Argument checks of the façade: each message names the value, its bound and what to do. */
final class Checks {
    private Checks() {}

    static <T> T notNull(String name, @Nullable T value) {
        if (value == null) {
            throw new IllegalArgumentException(name + " is null; pass a value");
        }
        return value;
    }

    static double finite(String name, double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(
                    name + " is " + value + "; it must be finite (neither NaN nor infinite)");
        }
        return value;
    }

    static double positive(String name, double value) {
        if (!(value > 0) || value == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    name + " is " + value + "; it must be finite and greater than 0");
        }
        return value;
    }

    static double atLeastZero(String name, double value) {
        if (!(value >= 0) || value == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    name + " is " + value + "; it must be finite and at least 0");
        }
        return value;
    }

    static double limit(String name, double value) {
        if (!(value > 0)) {
            throw new IllegalArgumentException(
                    name + " is " + value + "; it must be greater than 0, or infinite for none");
        }
        return value;
    }

    static double between(String name, double value, double low, double high) {
        if (!(value >= low && value <= high)) {
            throw new IllegalArgumentException(
                    name + " is " + value + "; it must be from " + low + " to " + high);
        }
        return value;
    }

    static int between(String name, int value, int low, int high) {
        if (value < low || value > high) {
            throw new IllegalArgumentException(
                    name + " is " + value + "; it must be from " + low + " to " + high);
        }
        return value;
    }
}
