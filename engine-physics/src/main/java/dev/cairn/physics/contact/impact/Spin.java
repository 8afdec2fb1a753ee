package dev.cairn.physics.contact.impact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Rotations;

/** Angular momentum of a body that tumbles, and its angular velocity when it lies otherwise. */
final class Spin {
    /** Angular velocity, world, rad/s. */
    double x, y, z;

    private final double[] v = new double[3];
    private double lx, ly, lz;

    /** Twice the energy of turning, J. */
    private double energy;

    /**
     * Takes momentum and energy.
     *
     * @param of from {@code at} on: orientation, four numbers, and angular velocity, three
     */
    void momentum(BodyStore s, int body, double[] of, int at) {
        double qx = of[at];
        double qy = of[at + 1];
        double qz = of[at + 2];
        double qw = of[at + 3];
        Rotations.rotate(-qx, -qy, -qz, qw, of[at + 4], of[at + 5], of[at + 6], v);
        double a = v[0];
        double b = v[1];
        double c = v[2];
        double p = s.inertiaXX[body] * a + s.inertiaXY[body] * b + s.inertiaXZ[body] * c;
        double q = s.inertiaXY[body] * a + s.inertiaYY[body] * b + s.inertiaYZ[body] * c;
        double r = s.inertiaXZ[body] * a + s.inertiaYZ[body] * b + s.inertiaZZ[body] * c;
        energy = a * p + b * q + c * r;
        Rotations.rotate(qx, qy, qz, qw, p, q, r, v);
        lx = v[0];
        ly = v[1];
        lz = v[2];
    }

    /** J x, in body axes. */
    static void inverseInertia(BodyStore s, int body, double x, double y, double z, double[] out) {
        double xy = s.inverseInertiaXY[body];
        double xz = s.inverseInertiaXZ[body];
        double yz = s.inverseInertiaYZ[body];
        out[0] = s.inverseInertiaXX[body] * x + xy * y + xz * z;
        out[1] = xy * x + s.inverseInertiaYY[body] * y + yz * z;
        out[2] = xz * x + yz * y + s.inverseInertiaZZ[body] * z;
    }

    /** The velocity with that momentum at another orientation, or less, so that no energy comes. */
    void velocity(BodyStore s, int body, double qx, double qy, double qz, double qw) {
        Rotations.rotate(-qx, -qy, -qz, qw, lx, ly, lz, v);
        double p = v[0];
        double q = v[1];
        double r = v[2];
        inverseInertia(s, body, p, q, r, v);
        double a = v[0];
        double b = v[1];
        double c = v[2];
        double now = a * p + b * q + c * r;
        double share = now > energy ? Math.sqrt(energy / now) : 1;
        Rotations.rotate(qx, qy, qz, qw, share * a, share * b, share * c, v);
        x = v[0];
        y = v[1];
        z = v[2];
    }
}
