package dev.cairn.physics.solver.body;

import dev.cairn.physics.internal.BodyStore;

/**
 * Free rotation of one body, in place in a {@link BodyStore}.
 *
 * <p>Sphere-like bodies turn by the exact exponential. Others take one Strang step: with body
 * momentum {@code m = I R^T w} the energy is {@code sum m_i^2 / 2 I_i}, each term of which turns
 * the body about a principal axis at constant rate; the flows are composed 1 2 3 2 1 with half
 * steps outside. Each flow turns body and momentum by opposite angles, so the world momentum {@code
 * R m} is exact, energy stays bounded, and the order is two. Sines and cosines are polynomials: the
 * same bits on every machine.
 *
 * <p>Source: McLachlan, "Explicit Lie-Poisson integration and the Euler equations" (1993);
 * Dullweber, Leimkuhler, McLachlan, "Symplectic splitting methods for rigid body molecular
 * dynamics" (1997).
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
        double k;
        double dw;
        if (square <= TINY) {
            // sin x / x and cos x, x = sqrt(square): the next terms are below 1e-23
            k = 0.5 - square * (1 / 12.0 - square * (1 / 240.0 - square * (1 / 10080.0)));
            dw = 1 - square * (0.5 - square * (1 / 24.0 - square * (1 / 720.0)));
        } else if (square <= SMALL * SMALL) {
            k = 0.5 + 0.5 * square * sinSeries(square);
            dw = 1 + square * cosSeries(square);
        } else {
            double half = Math.sqrt(square);
            k = 0.5 * sin(half) / half;
            dw = cos(half);
        }
        double dx = x * k;
        double dy = y * k;
        double dz = z * k;
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

    /**
     * One Strang step of a body with different moments of inertia.
     *
     * @param bodies orientation is read and written
     * @param i slot
     * @param axes principal axes, its own at {@code p}
     * @param p index there
     * @param w array that holds the world angular velocity, read and written
     * @param o index of its first component
     * @param h step, s
     */
    static void strang(BodyStore bodies, int i, double[] axes, int p, double[] w, int o, double h) {
        double px = axes[p + PrincipalAxes.QX];
        double py = axes[p + PrincipalAxes.QX + 1];
        double pz = axes[p + PrincipalAxes.QX + 2];
        double pw = axes[p + PrincipalAxes.QX + 3];
        double bx = bodies.orientationX[i];
        double by = bodies.orientationY[i];
        double bz = bodies.orientationZ[i];
        double bw = bodies.orientationW[i];
        // q = worldFromPrincipal = worldFromBody bodyFromPrincipal
        double qx = bw * px + bx * pw + (by * pz - bz * py);
        double qy = bw * py + by * pw + (bz * px - bx * pz);
        double qz = bw * pz + bz * pw + (bx * py - by * px);
        double qw = bw * pw - (bx * px + by * py + bz * pz);
        double i1 = axes[p + PrincipalAxes.MOMENT];
        double i2 = axes[p + PrincipalAxes.MOMENT + 1];
        double i3 = axes[p + PrincipalAxes.MOMENT + 2];
        // m = I R^T w, with R^T w = w + 2 u x (u x w - qw w), u the vector part
        double wx = w[o];
        double wy = w[o + 1];
        double wz = w[o + 2];
        double tx = 2 * (qy * wz - qz * wy);
        double ty = 2 * (qz * wx - qx * wz);
        double tz = 2 * (qx * wy - qy * wx);
        double m1 = i1 * (wx - qw * tx + (qy * tz - qz * ty));
        double m2 = i2 * (wy - qw * ty + (qz * tx - qx * tz));
        double m3 = i3 * (wz - qw * tz + (qx * ty - qy * tx));
        for (int flow = 0; flow < 5; flow++) {
            // flow of m_k^2 / 2 I_k: turn by a = m_k h / I_k about axis k; half angle x
            int axis = flow < 3 ? flow : 4 - flow;
            double rate = axis == 0 ? m1 / i1 : axis == 1 ? m2 / i2 : m3 / i3;
            double x = rate * (flow == 2 ? 0.5 * h : 0.25 * h);
            double s = sin(x);
            double c = cos(x);
            double sin2 = 2 * s * c;
            double cos2 = c * c - s * s;
            double ax = qx;
            double ay = qy;
            double az = qz;
            double aw = qw;
            if (axis == 0) {
                qx = ax * c + aw * s;
                qy = ay * c + az * s;
                qz = az * c - ay * s;
                qw = aw * c - ax * s;
                double n = cos2 * m2 + sin2 * m3;
                m3 = cos2 * m3 - sin2 * m2;
                m2 = n;
            } else if (axis == 1) {
                qx = ax * c - az * s;
                qy = ay * c + aw * s;
                qz = az * c + ax * s;
                qw = aw * c - ay * s;
                double n = cos2 * m3 + sin2 * m1;
                m1 = cos2 * m1 - sin2 * m3;
                m3 = n;
            } else {
                qx = ax * c + ay * s;
                qy = ay * c - ax * s;
                qz = az * c + aw * s;
                qw = aw * c - az * s;
                double n = cos2 * m1 + sin2 * m2;
                m2 = cos2 * m2 - sin2 * m1;
                m1 = n;
            }
        }
        double k = 1 / Math.sqrt(qx * qx + qy * qy + qz * qz + qw * qw);
        qx *= k;
        qy *= k;
        qz *= k;
        qw *= k;
        // w = R I^-1 m
        double vx = m1 / i1;
        double vy = m2 / i2;
        double vz = m3 / i3;
        tx = 2 * (qy * vz - qz * vy);
        ty = 2 * (qz * vx - qx * vz);
        tz = 2 * (qx * vy - qy * vx);
        w[o] = vx + qw * tx + (qy * tz - qz * ty);
        w[o + 1] = vy + qw * ty + (qz * tx - qx * tz);
        w[o + 2] = vz + qw * tz + (qx * ty - qy * tx);
        // worldFromBody = q bodyFromPrincipal^-1
        store(
                bodies,
                i,
                -qw * px + qx * pw - (qy * pz - qz * py),
                -qw * py + qy * pw - (qz * px - qx * pz),
                -qw * pz + qz * pw - (qx * py - qy * px),
                qw * pw + (qx * px + qy * py + qz * pz));
    }
}
