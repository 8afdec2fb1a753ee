package dev.cairn.physics.solver.body;

import dev.cairn.physics.internal.BodyStore;

/**
 * Free rotation of a body with different moments of inertia, in place in a {@link BodyStore}.
 *
 * <p><b>Two equal moments.</b> Exact, at any speed and for any time: with momentum {@code L}, the
 * momentum {@code m3} along the axis of symmetry {@code e3} and moments {@code A, A, C} the angular
 * velocity is {@code L/A + (1/C - 1/A) m3 e3}, of which the first part is constant in the world and
 * the second in the body, so {@code q(t) = exp(t L / 2A) q(0) exp(t (1/C - 1/A) m3 e3 / 2)}.
 *
 * <p><b>Three moments.</b> The discrete Moser-Veselov step: the turn {@code Q} of a step solves
 * {@code h y_1 / 2 = J_1 Q_0 Q_1 + (J_3 - J_2) Q_2 Q_3} and its cyclic images, {@code y} being the
 * momentum in the body and {@code (Q_0, Q_1, Q_2, Q_3)} a unit quaternion; then {@code q' = q Q, y'
 * = Q^-1 y Q}. It keeps the world momentum and the energy to the last digits: its path is the exact
 * one, run through in another time. With moments {@code J} that are a little other than the body's,
 *
 * <pre>
 * 1/J_k = (1 + h² s + h⁴ s') / I_k + h² d + h⁴ d'
 * s  = -e1 H/3 + e2 C/6
 * d  =  e2 H/6 - e3 C/3
 * s' = (e1²/30 - e2/60) H² + (2 e3/15 - e1 e2/30) H C + (e2²/30 - e1 e3/10) C²
 * d' = -(e1 e2/60 + e3/10) H² + (2 e1 e3/15 - e2²/60) H C - e2 e3 C²/60
 * </pre>
 *
 * <p>that time is right to the sixth order; {@code H} is the energy, {@code C = y²/2}, and {@code
 * e1, e2, e3} are the sums of the {@code 1/I_k}, of their products in pairs, and their product.
 * {@code H} and {@code C} are constants of the motion, so the moments are found once. The terms in
 * h² are those of McLachlan and Zanna; those in h⁴ follow from two demands: that turning about each
 * principal axis is exact, {@code 1/J = sin(h y/I) / h y}, and that the error of the sixth order
 * vanishes for any {@code y}. No sines: arithmetic and square roots only, the same bits on every
 * machine.
 *
 * <p>Sources: Moser and Veselov, "Discrete versions of some classical integrable systems" (1991);
 * McLachlan and Zanna, "The discrete Moser-Veselov algorithm for the free rigid body, revisited"
 * (2005); Hairer and Vilmart, "Preprocessed discrete Moser-Veselov algorithm for the full dynamics
 * of the rigid body" (2006).
 */
public final class FreeRotation {
    /** The largest turn of one step, rad; faster bodies take several. */
    private static final double TURN = 0.25;

    /** So many steps at most; of a body that turns faster still, only the mean motion is known. */
    private static final int STEPS = 128;

    /** Up to this turn of a step, rad, the iteration converges for any moments. */
    private static final double FAR = 1;

    private static final int ITERATIONS = 60;

    /** Change of a step's half turn, as a share of it, below which it has converged. */
    private static final double CONVERGED = 4e-16;

    /** Moments that differ by less than this share are equal. */
    private static final double SAME = 1e-13;

    private FreeRotation() {}

    /**
     * Turns a body by {@code count} steps.
     *
     * @param bodies orientation is read and written
     * @param i slot
     * @param axes principal axes, {@link PrincipalAxes#STRIDE} to a slot
     * @param w array that holds the world angular velocity, read and written
     * @param o index of its first component
     * @param h length of a step, s
     * @param count steps, 1 or more
     */
    public static void turn(
            BodyStore bodies, int i, double[] axes, double[] w, int o, double h, int count) {
        turn(bodies, i, axes, i * PrincipalAxes.STRIDE, w, o, h, count);
    }

    /** The same with the principal axes at {@code p}. */
    public static void turn(
            BodyStore bodies, int i, double[] axes, int p, double[] w, int o, double h, int count) {
        double i1 = axes[p + PrincipalAxes.MOMENT];
        double i2 = axes[p + PrincipalAxes.MOMENT + 1];
        double i3 = axes[p + PrincipalAxes.MOMENT + 2];
        int own = symmetry(axes, p);
        double speed = Math.sqrt(w[o] * w[o] + w[o + 1] * w[o + 1] + w[o + 2] * w[o + 2]);
        double parts = Math.max(1, Math.min(Math.ceil(Math.abs(h) * speed / TURN), STEPS));
        multiply(bodies, i, axes, p + PrincipalAxes.QX, 1);
        if (own >= 0) {
            symmetric(bodies, i, axes[p + own], axes[p + (own + 1) % 3], own, w, o, h * count);
        } else if (!(Math.abs(h) * speed <= FAR * parts)) {
            precess(bodies, i, i1, i2, i3, w, o, h * count);
        } else {
            moserVeselov(bodies, i, i1, i2, i3, w, o, h / parts, count * (int) parts);
        }
        multiply(bodies, i, axes, p + PrincipalAxes.QX, -1);
    }

    /** The axis about which the others' moments are equal, or -1. */
    public static int symmetry(double[] axes, int p) {
        double i1 = axes[p + PrincipalAxes.MOMENT];
        double i2 = axes[p + PrincipalAxes.MOMENT + 1];
        double i3 = axes[p + PrincipalAxes.MOMENT + 2];
        double same = SAME * i1;
        if (Math.abs(i1 - i2) <= same) {
            return 2;
        }
        if (Math.abs(i2 - i3) <= same) {
            return 0;
        }
        return Math.abs(i3 - i1) <= same ? 1 : -1;
    }

    /**
     * Turns a body by what it does in the mean, see {@link #precess}; any time.
     *
     * @param t s
     */
    public static void turnInTheMean(BodyStore bodies, int i, double[] axes, double[] w, double t) {
        int p = i * PrincipalAxes.STRIDE;
        multiply(bodies, i, axes, p + PrincipalAxes.QX, 1);
        precess(
                bodies,
                i,
                axes[p + PrincipalAxes.MOMENT],
                axes[p + PrincipalAxes.MOMENT + 1],
                axes[p + PrincipalAxes.MOMENT + 2],
                w,
                0,
                t);
        multiply(bodies, i, axes, p + PrincipalAxes.QX, -1);
    }

    /**
     * How fast a body turns at most, whatever becomes of its axis: the largest sum of the squares
     * {@code u} of its three rates, of those with {@code sum I u = 2E} and {@code sum I² u = L²},
     * is one in which a rate is 0.
     *
     * @return rad/s
     */
    public static double fastest(BodyStore bodies, int i, double[] axes, double[] w) {
        int p = i * PrincipalAxes.STRIDE;
        multiply(bodies, i, axes, p + PrincipalAxes.QX, 1);
        double energy = 0;
        double square = 0;
        for (int k = 0; k < 3; k++) {
            double rate = own(bodies, i, k, w, 0);
            double moment = axes[p + PrincipalAxes.MOMENT + k];
            energy += moment * rate * rate;
            square += moment * moment * rate * rate;
        }
        multiply(bodies, i, axes, p + PrincipalAxes.QX, -1);
        double most = 0;
        for (int k = 0; k < 3; k++) {
            double a = axes[p + PrincipalAxes.MOMENT + k];
            double b = axes[p + PrincipalAxes.MOMENT + (k + 1) % 3];
            double u = (square - b * energy) / (a * (a - b));
            double v = (square - a * energy) / (b * (b - a));
            most = u >= 0 && v >= 0 ? Math.max(most, u + v) : most;
        }
        return Math.sqrt(most);
    }

    /**
     * Multiplies the orientation from the right by bodyFromPrincipal ({@code sign} 1) or its
     * inverse (-1).
     */
    private static void multiply(BodyStore b, int i, double[] axes, int q, double sign) {
        double px = sign * axes[q];
        double py = sign * axes[q + 1];
        double pz = sign * axes[q + 2];
        double pw = axes[q + 3];
        double bx = b.orientationX[i];
        double by = b.orientationY[i];
        double bz = b.orientationZ[i];
        double bw = b.orientationW[i];
        b.orientationX[i] = bw * px + bx * pw + (by * pz - bz * py);
        b.orientationY[i] = bw * py + by * pw + (bz * px - bx * pz);
        b.orientationZ[i] = bw * pz + bz * pw + (bx * py - by * px);
        b.orientationW[i] = bw * pw - (bx * px + by * py + bz * pz);
    }

    /**
     * The exact motion for a time {@code t}; the orientation is that of the principal axes, moment
     * {@code along} about the one of number {@code axis}, {@code across} about the others.
     */
    private static void symmetric(
            BodyStore b,
            int i,
            double along,
            double across,
            int axis,
            double[] w,
            int o,
            double t) {
        double spin = 0;
        for (int k = 0; k < 3; k++) {
            spin += w[o + k] * Rotation.axis(b, i, axis, k);
        }
        // w = L/A + own e3, own = (1/C - 1/A) m3 = (1 - C/A) w.e3
        double own = (1 - along / across) * spin;
        for (int k = 0; k < 3; k++) {
            w[o + k] -= own * Rotation.axis(b, i, axis, k);
        }
        Rotation.turn(b, i, t * w[o], t * w[o + 1], t * w[o + 2]);
        Rotation.turnAboutOwn(b, i, axis, t * own);
        for (int k = 0; k < 3; k++) {
            w[o + k] += own * Rotation.axis(b, i, axis, k);
        }
    }

    /**
     * Whole rounds of the momentum's path in the body: there it stays, and the body turns about it
     * by what the path adds up to in the mean. Energy and momentum are kept to rounding.
     *
     * <p>About the axis of the least moment that is {@code t L (1/Ia + 1/Ib)/2} with the other two
     * moments, as of a body whose are equal: a needle that whirls about itself tumbles slowly.
     * About that of the largest it is {@code t 2E/L}, since {@code w.L = 2E} at all times.
     */
    private static void precess(
            BodyStore b, int i, double i1, double i2, double i3, double[] w, int o, double t) {
        double w1 = own(b, i, 0, w, o);
        double w2 = own(b, i, 1, w, o);
        double w3 = own(b, i, 2, w, o);
        double y1 = i1 * w1;
        double y2 = i2 * w2;
        double y3 = i3 * w3;
        double energy = y1 * w1 + y2 * w2 + y3 * w3;
        double square = y1 * y1 + y2 * y2 + y3 * y3;
        double largest = Math.max(i1, Math.max(i2, i3));
        double middle = Math.max(Math.min(i1, i2), Math.min(Math.max(i1, i2), i3));
        boolean aboutLeast = square < energy * middle;
        double perMoment = aboutLeast ? 0.5 * (1 / middle + 1 / largest) : energy / square;
        double x = y1 * Rotation.axis(b, i, 0, 0);
        double y = y1 * Rotation.axis(b, i, 0, 1);
        double z = y1 * Rotation.axis(b, i, 0, 2);
        x += y2 * Rotation.axis(b, i, 1, 0) + y3 * Rotation.axis(b, i, 2, 0);
        y += y2 * Rotation.axis(b, i, 1, 1) + y3 * Rotation.axis(b, i, 2, 1);
        z += y2 * Rotation.axis(b, i, 1, 2) + y3 * Rotation.axis(b, i, 2, 2);
        double angle = t * perMoment;
        Rotation.turn(b, i, angle * x, angle * y, angle * z);
        for (int k = 0; k < 3; k++) {
            w[o + k] =
                    w1 * Rotation.axis(b, i, 0, k)
                            + w2 * Rotation.axis(b, i, 1, k)
                            + w3 * Rotation.axis(b, i, 2, k);
        }
    }

    /** Component of a world vector along the body's axis of that number. */
    private static double own(BodyStore b, int i, int axis, double[] w, int o) {
        return w[o] * Rotation.axis(b, i, axis, 0)
                + w[o + 1] * Rotation.axis(b, i, axis, 1)
                + w[o + 2] * Rotation.axis(b, i, axis, 2);
    }

    /** {@code count} steps of length {@code h}; the orientation is that of the principal axes. */
    private static void moserVeselov(
            BodyStore b,
            int i,
            double i1,
            double i2,
            double i3,
            double[] w,
            int o,
            double h,
            int count) {
        double qx = b.orientationX[i];
        double qy = b.orientationY[i];
        double qz = b.orientationZ[i];
        double qw = b.orientationW[i];
        // y = I R^T w
        double wx = w[o];
        double wy = w[o + 1];
        double wz = w[o + 2];
        double tx = 2 * (qy * wz - qz * wy);
        double ty = 2 * (qz * wx - qx * wz);
        double tz = 2 * (qx * wy - qy * wx);
        wx += -qw * tx + (qy * tz - qz * ty);
        wy += -qw * ty + (qz * tx - qx * tz);
        wz += -qw * tz + (qx * ty - qy * tx);
        double y1 = i1 * wx;
        double y2 = i2 * wy;
        double y3 = i3 * wz;
        double energy = 0.5 * (y1 * wx + y2 * wy + y3 * wz);
        double casimir = 0.5 * (y1 * y1 + y2 * y2 + y3 * y3);
        double e3 = 1 / (i1 * i2 * i3);
        double e2 = (i1 + i2 + i3) * e3;
        double e1 = 1 / i1 + 1 / i2 + 1 / i3;
        double hh = h * h;
        double a = hh * energy;
        double c = hh * casimir;
        double s =
                1
                        + (e2 * c / 6 - e1 * a / 3)
                        + (e1 * e1 / 30 - e2 / 60) * (a * a)
                        + (2 * e3 / 15 - e1 * e2 / 30) * (a * c)
                        + (e2 * e2 / 30 - e1 * e3 / 10) * (c * c);
        double d =
                (e2 * a / 6 - e3 * c / 3)
                        - (e1 * e2 / 60 + e3 / 10) * (a * a)
                        + (2 * e1 * e3 / 15 - e2 * e2 / 60) * (a * c)
                        - e2 * e3 / 60 * (c * c);
        double j1 = 1 / (s / i1 + d);
        double j2 = 1 / (s / i2 + d);
        double j3 = 1 / (s / i3 + d);
        double g1 = 0.5 * h / j1;
        double g2 = 0.5 * h / j2;
        double g3 = 0.5 * h / j3;
        double k1 = (j3 - j2) / j1;
        double k2 = (j1 - j3) / j2;
        double k3 = (j2 - j1) / j3;
        for (int step = 0; step < count; step++) {
            double a1 = g1 * y1;
            double a2 = g2 * y2;
            double a3 = g3 * y3;
            double x1 = a1;
            double x2 = a2;
            double x3 = a3;
            double x0;
            double least = CONVERGED * (Math.abs(a1) + Math.abs(a2) + Math.abs(a3));
            double moved = 1;
            for (int n = 0; n < ITERATIONS && moved > least; n++) {
                x0 = Math.sqrt(1 - (x1 * x1 + x2 * x2 + x3 * x3));
                double r = 1 / x0;
                double u1 = r * (a1 - k1 * x2 * x3);
                double u2 = r * (a2 - k2 * x3 * u1);
                double u3 = r * (a3 - k3 * u1 * u2);
                moved = Math.abs(u1 - x1) + Math.abs(u2 - x2) + Math.abs(u3 - x3);
                x1 = u1;
                x2 = u2;
                x3 = u3;
            }
            x0 = Math.sqrt(1 - (x1 * x1 + x2 * x2 + x3 * x3));
            // q' = q Q
            double ax = qx;
            double ay = qy;
            double az = qz;
            double aw = qw;
            qx = aw * x1 + ax * x0 + (ay * x3 - az * x2);
            qy = aw * x2 + ay * x0 + (az * x1 - ax * x3);
            qz = aw * x3 + az * x0 + (ax * x2 - ay * x1);
            qw = aw * x0 - (ax * x1 + ay * x2 + az * x3);
            // y' = Q^-1 y Q
            tx = 2 * (x2 * y3 - x3 * y2);
            ty = 2 * (x3 * y1 - x1 * y3);
            tz = 2 * (x1 * y2 - x2 * y1);
            y1 += -x0 * tx + (x2 * tz - x3 * ty);
            y2 += -x0 * ty + (x3 * tx - x1 * tz);
            y3 += -x0 * tz + (x1 * ty - x2 * tx);
        }
        Rotation.store(b, i, qx, qy, qz, qw);
        qx = b.orientationX[i];
        qy = b.orientationY[i];
        qz = b.orientationZ[i];
        qw = b.orientationW[i];
        // w = R I^-1 y
        wx = y1 / i1;
        wy = y2 / i2;
        wz = y3 / i3;
        tx = 2 * (qy * wz - qz * wy);
        ty = 2 * (qz * wx - qx * wz);
        tz = 2 * (qx * wy - qy * wx);
        w[o] = wx + qw * tx + (qy * tz - qz * ty);
        w[o + 1] = wy + qw * ty + (qz * tx - qx * tz);
        w[o + 2] = wz + qw * tz + (qx * ty - qy * tx);
    }
}
