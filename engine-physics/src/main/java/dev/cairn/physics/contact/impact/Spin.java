package dev.cairn.physics.contact.impact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.sweep.Flight;

/** How a body lies and turns at the end of a tick in which it was struck and tumbles. */
final class Spin {
    /** Numbers to a body of {@link #last}. */
    private static final int STATE = 7;

    /** Share of the angular momentum below which a pose does not fit it. */
    private static final double FITS = 0.999;

    /** By body: orientation and angular velocity at the last impact, or at the tick's start. */
    private double[] last = {};

    /** Angular velocity of who arrives, world, rad/s. */
    final double[] velocity = new double[3];

    private final double[] v = new double[3];
    private final double[] turn = new double[4];
    private final double[] pose = new double[4];

    /** Angular momentum, world, kg m²/s. */
    private double lx, ly, lz;

    /** Twice the energy of turning, J. */
    private double energy;

    /** Makes room for bodies; returns for how many there is. */
    int ensureSlots(int slots) {
        if (last.length < STATE * slots) {
            last = new double[STATE * (slots + (slots >> 1))];
        }
        return last.length / STATE;
    }

    /** A body that has not been struck yet turns as when the tick began. */
    void begin(BodyStore s, int body) {
        int k = STATE * body;
        last[k] = s.orientationX[body];
        last[k + 1] = s.orientationY[body];
        last[k + 2] = s.orientationZ[body];
        last[k + 3] = s.orientationW[body];
        last[k + 4] = s.angularVelocityX[body];
        last[k + 5] = s.angularVelocityY[body];
        last[k + 6] = s.angularVelocityZ[body];
    }

    /** A body leaves an impact with the three numbers of {@code w} from {@code at} on. */
    void leaves(int body, Flight f, double[] w, int at) {
        int k = STATE * body;
        pose(f, last, k);
        System.arraycopy(w, at, last, k + 4, 3);
    }

    /**
     * Finds the angular velocity of a body that was followed to an impact at a constant one: with
     * the momentum that it had. Where that would have more energy in this pose than it had, as of a
     * stick that turns by a round, it has less: of that much momentum, the impact is wrong.
     *
     * @param f how it lies
     * @param isSteady whether its velocity is constant
     */
    void arrives(BodyStore s, int body, Flight f, boolean isSteady) {
        if (isSteady || s.kind[body] != BodyStore.DYNAMIC) {
            System.arraycopy(last, STATE * body + 4, velocity, 0, 3);
            return;
        }
        pose(f, pose, 0);
        momentum(s, body);
        velocity(s, body, pose, 0);
        System.arraycopy(v, 0, velocity, 0, 3);
    }

    private static void pose(Flight f, double[] out, int at) {
        out[at] = f.qx;
        out[at + 1] = f.qy;
        out[at + 2] = f.qz;
        out[at + 3] = f.qw;
    }

    /**
     * Keeps the angular momentum of the last impact, and no more than its energy.
     *
     * <p>The body was followed at the angular velocity of the impact, and lies so if its momentum
     * fits that pose. It does not where a stick turns by several rounds: a little of the momentum
     * along its axis would be all of the energy. Then it lies as it does if it turns about the
     * momentum at the rate of the mean, {@code 2E/L}, the momentum in the body being as it was.
     *
     * @param t since then, s
     * @param end from {@code at} on: orientation as followed, four numbers, read and written; from
     *     {@code at + 10} on receives the angular velocity, three
     */
    void end(BodyStore s, int body, double t, double[] end, int at) {
        momentum(s, body);
        int k = STATE * body;
        boolean fits = velocity(s, body, end, at) >= FITS;
        System.arraycopy(v, 0, end, at + 10, 3);
        if (fits) {
            return;
        }
        double square = lx * lx + ly * ly + lz * lz;
        double rate = energy / square;
        Rotations.turn(rate * lx, rate * ly, rate * lz, rate * Math.sqrt(square), t, turn);
        double x = last[k];
        double y = last[k + 1];
        double z = last[k + 2];
        double w = last[k + 3];
        end[at] = turn[3] * x + turn[0] * w + turn[1] * z - turn[2] * y;
        end[at + 1] = turn[3] * y - turn[0] * z + turn[1] * w + turn[2] * x;
        end[at + 2] = turn[3] * z + turn[0] * y - turn[1] * x + turn[2] * w;
        end[at + 3] = turn[3] * w - turn[0] * x - turn[1] * y - turn[2] * z;
        velocity(s, body, end, at);
        System.arraycopy(v, 0, end, at + 10, 3);
    }

    /** Takes momentum and energy of the last impact. */
    private void momentum(BodyStore s, int body) {
        double[] of = last;
        int at = STATE * body;
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

    /**
     * Sets {@link #v} to the velocity with that momentum at another orientation, or less, so that
     * no energy comes.
     *
     * @return the share of the momentum that is left
     */
    private double velocity(BodyStore s, int body, double[] end, int at) {
        double qx = end[at];
        double qy = end[at + 1];
        double qz = end[at + 2];
        double qw = end[at + 3];
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
        return share;
    }
}
