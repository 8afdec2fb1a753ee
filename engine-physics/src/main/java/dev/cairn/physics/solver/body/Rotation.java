package dev.cairn.physics.solver.body;

import dev.cairn.physics.internal.BodyStore;

/**
 * Turns of one body, in place in a {@link BodyStore}; free rotation is {@link FreeRotation}'s.
 *
 * <p>Turns are the exact exponential. Sines and cosines are polynomials: the same bits on every
 * machine.
 */
public final class Rotation {
    private static final double SMALL = 0.25;

    /** Above this an angle is taken modulo a full turn, so that halving ends after a few steps. */
    private static final double LARGE = 4;

    /** Square of an angle for which three terms are enough. */
    private static final double TINY = 1e-6;

    private static final double TURN = 2 * Math.PI;

    /** Of a square: the root by one term of its series is exact. */
    private static final double NEARLY_UNIT = 1e-8;

    private Rotation() {}

    /** Sine; polynomial up to a quarter, by halving above. */
    static double sin(double x) {
        if (!(Math.abs(x) > SMALL)) {
            double y = x * x;
            return x + x * y * sinSeries(y);
        }
        if (Math.abs(x) > LARGE) {
            return sin(Math.IEEEremainder(x, TURN));
        }
        return 2 * sin(0.5 * x) * cos(0.5 * x);
    }

    /** Cosine; polynomial up to a quarter, by halving above. */
    static double cos(double x) {
        if (!(Math.abs(x) > SMALL)) {
            double y = x * x;
            return 1 + y * cosSeries(y);
        }
        if (Math.abs(x) > LARGE) {
            return cos(Math.IEEEremainder(x, TURN));
        }
        double s = sin(0.5 * x);
        return 1 - 2 * s * s;
    }

    /** {@code (sin x / x - 1) / y}, y the square of x: Taylor, the next term is below 1e-21. */
    private static double sinSeries(double y) {
        double p = 1 / 6227020800.0;
        p = p * y - 1 / 39916800.0;
        p = p * y + 1 / 362880.0;
        p = p * y - 1 / 5040.0;
        p = p * y + 1 / 120.0;
        return p * y - 1 / 6.0;
    }

    /** {@code (cos x - 1) / y}, y the square of x. */
    private static double cosSeries(double y) {
        double p = 1 / 479001600.0;
        p = p * y - 1 / 3628800.0;
        p = p * y + 1 / 40320.0;
        p = p * y - 1 / 720.0;
        p = p * y + 1 / 24.0;
        return p * y - 0.5;
    }

    /**
     * Turns the orientation of body {@code i} by the world rotation vector {@code (x, y, z)}, rad;
     * exact exponential, for small angles without a root or a quotient.
     */
    public static void turn(BodyStore bodies, int i, double x, double y, double z) {
        double square = 0.25 * (x * x + y * y + z * z);
        if (!(square > 0)) {
            return;
        }
        double k = halfSine(square);
        turn(bodies, i, x * k, y * k, z * k, halfCosine(square));
    }

    /**
     * Of the quaternion of a turn by an angle a: {@code sin(a/2)/a}.
     *
     * @param square {@code a²/4}
     */
    public static double halfSine(double square) {
        if (square <= TINY) {
            // sin x / x, x = sqrt(square): the next term is below 1e-23
            return 0.5 - square * (1 / 12.0 - square * (1 / 240.0 - square * (1 / 10080.0)));
        }
        if (square <= SMALL * SMALL) {
            return 0.5 + 0.5 * square * sinSeries(square);
        }
        double half = Math.sqrt(square);
        return 0.5 * sin(half) / half;
    }

    /** The same: {@code cos(a/2)}. */
    public static double halfCosine(double square) {
        if (square <= TINY) {
            return 1 - square * (0.5 - square * (1 / 24.0 - square * (1 / 720.0)));
        }
        return square <= SMALL * SMALL ? 1 + square * cosSeries(square) : cos(Math.sqrt(square));
    }

    /** Turns the orientation of body {@code i} by the quaternion of a turn, w last. */
    public static void turn(BodyStore bodies, int i, double dx, double dy, double dz, double dw) {
        double qx = bodies.orientationX[i];
        double qy = bodies.orientationY[i];
        double qz = bodies.orientationZ[i];
        double qw = bodies.orientationW[i];
        // q' = d q
        store(
                bodies,
                i,
                dw * qx + dx * qw + (dy * qz - dz * qy),
                dw * qy + dy * qw + (dz * qx - dx * qz),
                dw * qz + dz * qw + (dx * qy - dy * qx),
                dw * qw - (dx * qx + dy * qy + dz * qz));
    }

    /** Turns the orientation of body {@code i} about its own axis of that number; exact. */
    static void turnAboutOwn(BodyStore bodies, int i, int axis, double angle) {
        double s = sin(0.5 * angle);
        double c = cos(0.5 * angle);
        double dx = axis == 0 ? s : 0;
        double dy = axis == 1 ? s : 0;
        double dz = axis == 2 ? s : 0;
        double qx = bodies.orientationX[i];
        double qy = bodies.orientationY[i];
        double qz = bodies.orientationZ[i];
        double qw = bodies.orientationW[i];
        // q' = q d
        store(
                bodies,
                i,
                qw * dx + qx * c + (qy * dz - qz * dy),
                qw * dy + qy * c + (qz * dx - qx * dz),
                qw * dz + qz * c + (qx * dy - qy * dx),
                qw * c - (qx * dx + qy * dy + qz * dz));
    }

    /** World component {@code k} of the body's axis {@code axis}: column of its rotation matrix. */
    public static double axis(BodyStore b, int i, int axis, int k) {
        return axis(
                b.orientationX[i],
                b.orientationY[i],
                b.orientationZ[i],
                b.orientationW[i],
                axis,
                k);
    }

    /** The same of a unit quaternion. */
    public static double axis(double x, double y, double z, double w, int axis, int k) {
        return switch (3 * k + axis) {
            case 0 -> 1 - 2 * (y * y + z * z);
            case 1 -> 2 * (x * y - w * z);
            case 2 -> 2 * (x * z + w * y);
            case 3 -> 2 * (x * y + w * z);
            case 4 -> 1 - 2 * (x * x + z * z);
            case 5 -> 2 * (y * z - w * x);
            case 6 -> 2 * (x * z - w * y);
            case 7 -> 2 * (y * z + w * x);
            default -> 1 - 2 * (x * x + y * y);
        };
    }

    /** Sets the orientation of body {@code i} to a quaternion, made a unit one. */
    static void store(BodyStore bodies, int i, double x, double y, double z, double w) {
        double square = x * x + y * y + z * z + w * w;
        // 1 / sqrt(1 + e) = 1 - e/2 + 3/8 e²; the last term is below a bit of 1
        double k = Math.abs(square - 1) < NEARLY_UNIT ? 1.5 - 0.5 * square : 1 / Math.sqrt(square);
        bodies.orientationX[i] = x * k;
        bodies.orientationY[i] = y * k;
        bodies.orientationZ[i] = z * k;
        bodies.orientationW[i] = w * k;
    }
}
