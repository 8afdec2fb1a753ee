package dev.cairn.physics.internal;

/** The kinetic energy of one body. */
public final class KineticEnergy {
    private KineticEnergy() {}

    /**
     * {@code m v²/2 + w I w/2}.
     *
     * @param slot of a dynamic body
     * @param work three numbers, written
     * @return J
     */
    public static double of(BodyStore b, int slot, double[] work) {
        double x = b.velocityX[slot];
        double y = b.velocityY[slot];
        double z = b.velocityZ[slot];
        return 0.5 * ((x * x + y * y + z * z) / b.inverseMass[slot]) + ofTurning(b, slot, work);
    }

    /** The part of turning, see {@link #of}: {@code w I w/2}. */
    public static double ofTurning(BodyStore b, int slot, double[] work) {
        Rotations.rotate(
                -b.orientationX[slot],
                -b.orientationY[slot],
                -b.orientationZ[slot],
                b.orientationW[slot],
                b.angularVelocityX[slot],
                b.angularVelocityY[slot],
                b.angularVelocityZ[slot],
                work);
        double u = work[0];
        double v = work[1];
        double w = work[2];
        return 0.5
                * (b.inertiaXX[slot] * u * u
                        + b.inertiaYY[slot] * v * v
                        + b.inertiaZZ[slot] * w * w
                        + 2
                                * (b.inertiaXY[slot] * u * v
                                        + b.inertiaXZ[slot] * u * w
                                        + b.inertiaYZ[slot] * v * w));
    }
}
