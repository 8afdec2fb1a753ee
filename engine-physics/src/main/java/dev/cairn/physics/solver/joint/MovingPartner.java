package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.Rotation;

/**
 * Where a kinematic body is within a tick, and how fast: what joints to it have to follow.
 *
 * <p>Its pose in the {@link BodyStore} is that of the tick's begin. With T the tick's length, v and
 * w its mean velocities and dv, {@code e w} the changes over the tick ({@link BodyStore#ramp}),
 *
 * <pre>
 * v(t) = v + (t/T - 1/2) dv      x(t) = x + t v + (t²/T - t)/2 dv
 * </pre>
 *
 * <p>and the same about its axis; so it ends where it shall. One to a worker. Does not allocate.
 */
final class MovingPartner {
    /** Way since the tick's begin, m. */
    double x, y, z;

    /** Orientation. */
    final double[] turn = new double[4];

    /** Velocity, m/s, and angular velocity, rad/s. */
    final double[] velocity = new double[6];

    /**
     * Finds where body {@code i} is.
     *
     * @param time since the tick's begin, s
     * @param step length of the tick, s
     */
    void place(BodyStore b, int i, double time, double step) {
        double late = step > 0 ? 0.5 * (time * time / step - time) : 0;
        x = time * b.velocityX[i] + late * ramp(b, i, 0);
        y = time * b.velocityY[i] + late * ramp(b, i, 1);
        z = time * b.velocityZ[i] + late * ramp(b, i, 2);
        double angle = time + late * ramp(b, i, 3);
        double rx = angle * b.angularVelocityX[i];
        double ry = angle * b.angularVelocityY[i];
        double rz = angle * b.angularVelocityZ[i];
        double square = 0.25 * (rx * rx + ry * ry + rz * rz);
        double k = Rotation.halfSine(square);
        double dw = Rotation.halfCosine(square);
        double dx = k * rx;
        double dy = k * ry;
        double dz = k * rz;
        double qx = b.orientationX[i];
        double qy = b.orientationY[i];
        double qz = b.orientationZ[i];
        double qw = b.orientationW[i];
        // q' = d q
        turn[0] = dw * qx + dx * qw + (dy * qz - dz * qy);
        turn[1] = dw * qy + dy * qw + (dz * qx - dx * qz);
        turn[2] = dw * qz + dz * qw + (dx * qy - dy * qx);
        turn[3] = dw * qw - (dx * qx + dy * qy + dz * qz);
    }

    /** Finds how fast body {@code i} is. */
    void speed(BodyStore b, int i, double time, double step) {
        double late = step > 0 ? time / step - 0.5 : 0;
        velocity[0] = b.velocityX[i] + late * ramp(b, i, 0);
        velocity[1] = b.velocityY[i] + late * ramp(b, i, 1);
        velocity[2] = b.velocityZ[i] + late * ramp(b, i, 2);
        double spin = 1 + late * ramp(b, i, 3);
        velocity[3] = spin * b.angularVelocityX[i];
        velocity[4] = spin * b.angularVelocityY[i];
        velocity[5] = spin * b.angularVelocityZ[i];
    }

    private static double ramp(BodyStore b, int i, int n) {
        // a world that never had a kinematic body has no room for these
        return BodyStore.RAMP * i < b.ramp.length ? b.ramp[BodyStore.RAMP * i + n] : 0;
    }
}
