package dev.cairn.physics.contact;

import dev.cairn.physics.internal.BodyStore;

/** What the step can compute with. Stateless. */
public final class StepLimits {
    /**
     * The largest coordinate (m), speed (m/s) and surface speed (m/s) that the step computes with:
     * the fourth power of it is still a number.
     */
    public static final double LARGEST = 1e60;

    private StepLimits() {}

    /**
     * Whether a body can be computed with in this tick; what is no number cannot.
     *
     * @param s slot of the body
     * @param vx velocity at the end of the tick, world, m/s
     * @param vy velocity at the end of the tick, world, m/s
     * @param vz velocity at the end of the tick, world, m/s
     * @param spin angular speed, rad/s
     */
    static boolean allow(BodyStore b, int s, double vx, double vy, double vz, double spin) {
        return Math.abs(vx) <= LARGEST
                && Math.abs(vy) <= LARGEST
                && Math.abs(vz) <= LARGEST
                && spin <= LARGEST
                && spin * b.outerRadius[s] <= LARGEST
                && Math.abs(b.positionX[s]) <= LARGEST
                && Math.abs(b.positionY[s]) <= LARGEST
                && Math.abs(b.positionZ[s]) <= LARGEST;
    }

    /**
     * An upper bound of the angular speed of a body at the end of the tick.
     *
     * @param s slot of the body
     * @param step length of the tick, s
     * @return rad/s
     */
    static double spin(BodyStore b, int s, double step) {
        double wx = b.angularVelocityX[s];
        double wy = b.angularVelocityY[s];
        double wz = b.angularVelocityZ[s];
        double tx = Math.abs(b.torqueX[s]);
        double ty = Math.abs(b.torqueY[s]);
        double tz = Math.abs(b.torqueZ[s]);
        double spin = Math.sqrt(wx * wx + wy * wy + wz * wz);
        double torque = tx + ty + tz;
        if (torque == 0) {
            return spin;
        }
        // The largest eigenvalue of a positive symmetric matrix is at most its trace.
        double trace = b.inverseInertiaXX[s] + b.inverseInertiaYY[s] + b.inverseInertiaZZ[s];
        return spin + step * torque * trace;
    }
}
