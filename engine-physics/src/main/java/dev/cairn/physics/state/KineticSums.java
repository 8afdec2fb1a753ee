package dev.cairn.physics.state;

import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Rotations;

/** Energy and momenta of all dynamic bodies, see {@link Kinetics}. Between steps. */
public final class KineticSums {
    /** How many sums there are. */
    public static final int ROOM = 7;

    private KineticSums() {}

    /** Sums in slot order, into an array whose first places also hold the spin of one body. */
    public static void sum(BodyStore b, double[] sums) {
        if (sums.length < ROOM) {
            throw new IllegalArgumentException(
                    "sums has room for " + sums.length + " numbers, expected at least " + ROOM);
        }
        double energy = 0;
        double px = 0;
        double py = 0;
        double pz = 0;
        double lx = 0;
        double ly = 0;
        double lz = 0;
        for (int s = 0; s < b.slotCount; s++) {
            if (b.kind[s] != BodyStore.DYNAMIC) {
                continue;
            }
            double mass = 1 / b.inverseMass[s];
            double mx = mass * b.velocityX[s];
            double my = mass * b.velocityY[s];
            double mz = mass * b.velocityZ[s];
            spin(b, s, sums);
            double spinX = sums[0];
            double spinY = sums[1];
            double spinZ = sums[2];
            energy +=
                    0.5 * (mx * b.velocityX[s] + my * b.velocityY[s] + mz * b.velocityZ[s])
                            + 0.5
                                    * (spinX * b.angularVelocityX[s]
                                            + spinY * b.angularVelocityY[s]
                                            + spinZ * b.angularVelocityZ[s]);
            px += mx;
            py += my;
            pz += mz;
            lx += b.positionY[s] * mz - b.positionZ[s] * my + spinX;
            ly += b.positionZ[s] * mx - b.positionX[s] * mz + spinY;
            lz += b.positionX[s] * my - b.positionY[s] * mx + spinZ;
        }
        sums[0] = energy;
        sums[1] = px;
        sums[2] = py;
        sums[3] = pz;
        sums[4] = lx;
        sums[5] = ly;
        sums[6] = lz;
    }

    /** In gravity (x, y, z), zero at the origin, J. */
    public static double potentialEnergy(BodyStore b, double x, double y, double z) {
        double sum = 0;
        for (int s = 0; s < b.slotCount; s++) {
            if (b.kind[s] == BodyStore.DYNAMIC || b.kind[s] == BodyStore.ASLEEP) {
                sum -=
                        (x * b.positionX[s] + y * b.positionY[s] + z * b.positionZ[s])
                                / b.inverseMass[s];
            }
        }
        return sum;
    }

    /** Spin angular momentum in world axes: R I Rᵀ w. */
    private static void spin(BodyStore b, int s, double[] v) {
        double qx = b.orientationX[s];
        double qy = b.orientationY[s];
        double qz = b.orientationZ[s];
        double qw = b.orientationW[s];
        Rotations.rotate(
                -qx,
                -qy,
                -qz,
                qw,
                b.angularVelocityX[s],
                b.angularVelocityY[s],
                b.angularVelocityZ[s],
                v);
        double wx = v[0];
        double wy = v[1];
        double wz = v[2];
        Rotations.rotate(
                qx,
                qy,
                qz,
                qw,
                b.inertiaXX[s] * wx + b.inertiaXY[s] * wy + b.inertiaXZ[s] * wz,
                b.inertiaXY[s] * wx + b.inertiaYY[s] * wy + b.inertiaYZ[s] * wz,
                b.inertiaXZ[s] * wx + b.inertiaYZ[s] * wy + b.inertiaZZ[s] * wz,
                v);
    }
}
