package dev.cairn.physics.solver.body;

import static dev.cairn.physics.solver.body.SolverBodies.V;

import dev.cairn.physics.internal.BodyStore;

import java.util.Arrays;

/**
 * What holds single bodies back: damping, locked axes, limits of speed. A body without any of them
 * pays one comparison.
 *
 * <p>Damping is exact, for any rate and step. A velocity under constant acceleration {@code a} and
 * {@code v' = a - c v} becomes after the time h, with {@code z = c h},
 *
 * <pre>
 * v(h) = e^-z v + h f1(z) a,   x(h) = x + h f1(z) v + h² f2(z) a
 * f1(z) = (1 - e^-z) / z,      f2(z) = (1 - f1(z)) / z
 * </pre>
 *
 * <p>and an angular momentum {@code L' = -c L} keeps its direction: the body runs through its free
 * rotation slower and slower, by the time {@code h f1(z)}. (With {@code y} the momentum in the body
 * and {@code y = e^-ct u}: {@code u' = e^-ct u x I^-1 u}.)
 *
 * <p>A body that may not turn about some world axes has the inertia of the others: with {@code M}
 * the part of the world inertia in the free axes, {@code M^-1} there and 0 elsewhere. About one
 * axis it turns exactly; about two the gyroscopic torque is left out. A lock of movement takes its
 * component from the velocity before the body is moved and at the end of a sub-step.
 *
 * <p>Arithmetic and square roots only: the same bits on every machine.
 */
public final class AxisLocks {
    /** Bits of {@link BodyStore#motionFlags}: turns about x, y, z. */
    static final int TURNS = 7 << 3;

    /** Beyond this {@code z} nothing is left of a velocity after a step. */
    private static final double GONE = 30;

    private AxisLocks() {}

    /** {@code e^-z}, z at least 0. */
    public static double decay(double z) {
        if (z > 1) {
            if (z > 1024) {
                return 0;
            }
            double root = decay(0.5 * z);
            return root * root;
        }
        return 1 - z * mean(z);
    }

    /** {@code f1(z)}: mean of a decaying velocity over its first value. */
    static double mean(double z) {
        return z > 1 ? (1 - decay(z)) / z : 1 - z * travel(z);
    }

    /** {@code f2(z)}: path under a constant acceleration over that acceleration and h². */
    private static double travel(double z) {
        if (z > 1) {
            return (1 - mean(z)) / z;
        }
        // sum of (-z)^k / (k + 2)!; the next term is below 1e-18
        double sum = 0;
        for (int k = 17; k >= 0; k--) {
            sum = (1 - z * sum) / (k + 2);
        }
        return sum;
    }

    /** {@code f1/e^-z}: mean of a decaying velocity over its last value. */
    static double meanOverEnd(double z) {
        double y = Math.min(z, GONE);
        return mean(y) / decay(y);
    }

    /** {@code f1²/e^-z - f2}: by how much of {@code h a} the mean lags the last velocity. */
    static double behind(double z) {
        double y = Math.min(z, GONE);
        double m = mean(y);
        return m * m / decay(y) - travel(y);
    }

    /** Lets the velocities of a body with contacts decay over {@code h}. */
    static void damp(BodyStore b, double[] v, int i, double h) {
        if ((b.motionFlags[i] & BodyStore.DAMPED) == 0) {
            return;
        }
        int o = SolverBodies.offset(i) + V;
        double linear = decay(b.linearDamping[i] * h);
        double angular = decay(b.angularDamping[i] * h);
        for (int k = 0; k < 3; k++) {
            v[o + k] *= linear;
            v[o + 3 + k] *= angular;
        }
    }

    /** Takes the velocity along locked axes from the body at {@code o}. */
    public static void lock(BodyStore b, double[] v, int o) {
        if (o != 0 && SolverBodies.slot(o) < b.slotCount) {
            lock(b, v, o + V, SolverBodies.slot(o));
        }
    }

    /** Takes the part along locked axes of a body from the vector at {@code o}. */
    public static void lock(BodyStore b, double[] v, int o, int slot) {
        int locks = b.motionFlags[slot];
        for (int k = 0; k < 3; k++) {
            if ((locks >> k & 1) != 0) {
                v[o + k] = 0;
            }
        }
    }

    /** Cuts the speed down to its limit. */
    static void limit(BodyStore b, int i) {
        double x = b.velocityX[i];
        double y = b.velocityY[i];
        double z = b.velocityZ[i];
        double limit = b.speedLimit[i];
        double square = x * x + y * y + z * z;
        if (square > limit * limit) {
            double k = limit / Math.sqrt(square);
            b.velocityX[i] = k * x;
            b.velocityY[i] = k * y;
            b.velocityZ[i] = k * z;
        }
    }

    /** A tick without contacts under the acceleration {@code (ax, ay, az)}. */
    static void fly(
            BodyStore b,
            SolverBodies s,
            int i,
            double ax,
            double ay,
            double az,
            double t,
            int substeps) {
        int locks = b.motionFlags[i];
        double z = b.linearDamping[i] * t;
        double e = decay(z);
        double f1 = t * mean(z);
        double f2 = t * t * travel(z);
        double x = (locks & 1) == 0 ? 1 : 0;
        double y = (locks & 2) == 0 ? 1 : 0;
        double w = (locks & 4) == 0 ? 1 : 0;
        b.move(
                i,
                x * (f1 * b.velocityX[i] + f2 * ax),
                y * (f1 * b.velocityY[i] + f2 * ay),
                w * (f1 * b.velocityZ[i] + f2 * az));
        b.velocityX[i] = x * (e * b.velocityX[i] + f1 * ax);
        b.velocityY[i] = y * (e * b.velocityY[i] + f1 * ay);
        b.velocityZ[i] = w * (e * b.velocityZ[i] + f1 * az);
        if ((locks & BodyStore.LIMITED) != 0) {
            limit(b, i);
        }
        s.state[SolverBodies.offset(i) + SolverBodies.LOADED] = 0;
        if ((locks & TURNS) != 0) {
            turnAboutFreeAxes(b, s, i, t);
        } else {
            Motion.spin(b, s, i, t, substeps);
        }
    }

    /** {@code w' = M^-1 torque - c w}, and the turn that comes of it. */
    private static void turnAboutFreeAxes(BodyStore b, SolverBodies s, int i, double t) {
        int k = (i + 1) * SolverBodies.ROOT;
        rootOfInertia(b, i, 1, s.root, k);
        double[] r = s.root;
        double u0 = r[k] * b.torqueX[i] + r[k + 3] * b.torqueY[i] + r[k + 6] * b.torqueZ[i];
        double u1 = r[k + 1] * b.torqueX[i] + r[k + 4] * b.torqueY[i] + r[k + 7] * b.torqueZ[i];
        double z = b.angularDamping[i] * t;
        double e = decay(z);
        double f1 = t * mean(z);
        double f2 = t * t * travel(z);
        int locks = b.motionFlags[i] >> 3;
        double wx = (locks & 1) == 0 ? b.angularVelocityX[i] : 0;
        double wy = (locks & 2) == 0 ? b.angularVelocityY[i] : 0;
        double wz = (locks & 4) == 0 ? b.angularVelocityZ[i] : 0;
        double ax = r[k] * u0 + r[k + 1] * u1;
        double ay = r[k + 3] * u0 + r[k + 4] * u1;
        double az = r[k + 6] * u0 + r[k + 7] * u1;
        Rotation.turn(b, i, f1 * wx + f2 * ax, f1 * wy + f2 * ay, f1 * wz + f2 * az);
        b.angularVelocityX[i] = e * wx + f1 * ax;
        b.angularVelocityY[i] = e * wy + f1 * ay;
        b.angularVelocityZ[i] = e * wz + f1 * az;
    }

    /**
     * {@code L} with {@code L L^T = scale M^-1}, as {@link SolverBodies#root} at {@code k}: two
     * columns at most, the others 0.
     */
    static void rootOfInertia(BodyStore b, int i, double scale, double[] r, int k) {
        Arrays.fill(r, k, k + SolverBodies.ROOT, 0.0);
        int locks = b.motionFlags[i] >> 3;
        int p = -1;
        int q = -1;
        for (int axis = 0; axis < 3; axis++) {
            if ((locks >> axis & 1) == 0) {
                if (p < 0) {
                    p = axis;
                } else {
                    q = axis;
                }
            }
        }
        if (p < 0) {
            return;
        }
        double a = inertia(b, i, p, p);
        if (q < 0) {
            column(r, k, 0, p, 1, p, 0, scale / a);
            return;
        }
        double c = inertia(b, i, p, q);
        double d = inertia(b, i, q, q);
        // Jacobi rotation that clears c
        double tan = 0;
        if (c != 0) {
            double theta = (d - a) / (2 * c);
            tan = (theta >= 0 ? 1 : -1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
        }
        double cos = 1 / Math.sqrt(tan * tan + 1);
        double sin = tan * cos;
        column(r, k, 0, p, cos, q, -sin, scale / (a - tan * c));
        column(r, k, 1, p, sin, q, cos, scale / (d + tan * c));
    }

    private static void column(
            double[] r, int k, int column, int p, double x, int q, double y, double square) {
        double root = Math.sqrt(square);
        r[k + 3 * q + column] = root * y;
        r[k + 3 * p + column] = root * x;
        r[k + 9 + column] = 1 / square;
    }

    /** Entry of the world inertia, {@code R I R^T}. */
    private static double inertia(BodyStore b, int i, int row, int column) {
        double xr = Rotation.axis(b, i, 0, row);
        double yr = Rotation.axis(b, i, 1, row);
        double zr = Rotation.axis(b, i, 2, row);
        double xc = Rotation.axis(b, i, 0, column);
        double yc = Rotation.axis(b, i, 1, column);
        double zc = Rotation.axis(b, i, 2, column);
        return b.inertiaXX[i] * xr * xc
                + b.inertiaYY[i] * yr * yc
                + b.inertiaZZ[i] * zr * zc
                + b.inertiaXY[i] * (xr * yc + yr * xc)
                + b.inertiaXZ[i] * (xr * zc + zr * xc)
                + b.inertiaYZ[i] * (yr * zc + zr * yc);
    }
}
