package dev.cairn.physics.state;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.island.SleepingBodies;

/**
 * Forces, torques and impulses that users give bodies, by slot; the slot is alive. Forces and
 * torques are summed until the next step, impulses act at once: {@code v += j/m, w += I⁻¹ l}. What
 * does not move takes none: a body that the world has stopped. Simulation thread, between steps;
 * makes no garbage.
 */
public final class AppliedForces {
    private final BodyStore bodies;
    private final SleepingBodies sleepers;
    private final double[] rotated = new double[3];

    /** On the bodies of a registry. */
    public AppliedForces(BodyRegistry registry) {
        bodies = registry.bodies;
        sleepers = registry.sleepers;
    }

    private boolean isUnmoved(int s) {
        return bodies.kind[s] == BodyStore.STATIC || bodies.kind[s] == BodyStore.KINEMATIC;
    }

    /** What changes nothing wakes no body. */
    private void wakeUnlessZero(int s, double x, double y, double z) {
        if (x != 0 || y != 0 || z != 0) {
            sleepers.wake(s);
        }
    }

    /** Adds to the force of the next step, N. */
    public void applyForce(int s, double fx, double fy, double fz) {
        Checks.finite("fx", fx);
        Checks.finite("fy", fy);
        Checks.finite("fz", fz);
        if (isUnmoved(s)) {
            return;
        }
        wakeUnlessZero(s, fx, fy, fz);
        bodies.forceX[s] += fx;
        bodies.forceY[s] += fy;
        bodies.forceZ[s] += fz;
    }

    /** The same at a point of the world, m. */
    public void applyForceAt(
            int s, double fx, double fy, double fz, double px, double py, double pz) {
        Checks.finite("px", px);
        Checks.finite("py", py);
        Checks.finite("pz", pz);
        applyForce(s, fx, fy, fz);
        if (isUnmoved(s)) {
            return;
        }
        double rx = px - bodies.positionX[s];
        double ry = py - bodies.positionY[s];
        double rz = pz - bodies.positionZ[s];
        bodies.torqueX[s] += ry * fz - rz * fy;
        bodies.torqueY[s] += rz * fx - rx * fz;
        bodies.torqueZ[s] += rx * fy - ry * fx;
    }

    /** Adds to the torque of the next step, N m. */
    public void applyTorque(int s, double tx, double ty, double tz) {
        Checks.finite("tx", tx);
        Checks.finite("ty", ty);
        Checks.finite("tz", tz);
        if (isUnmoved(s)) {
            return;
        }
        wakeUnlessZero(s, tx, ty, tz);
        bodies.torqueX[s] += tx;
        bodies.torqueY[s] += ty;
        bodies.torqueZ[s] += tz;
    }

    /** Changes the velocity, by N s over the mass. */
    public void applyImpulse(int s, double jx, double jy, double jz) {
        Checks.finite("jx", jx);
        Checks.finite("jy", jy);
        Checks.finite("jz", jz);
        wakeUnlessZero(s, jx, jy, jz);
        bodies.velocityX[s] += jx * bodies.inverseMass[s];
        bodies.velocityY[s] += jy * bodies.inverseMass[s];
        bodies.velocityZ[s] += jz * bodies.inverseMass[s];
    }

    /** The same at a point of the world, m. */
    public void applyImpulseAt(
            int s, double jx, double jy, double jz, double px, double py, double pz) {
        Checks.finite("px", px);
        Checks.finite("py", py);
        Checks.finite("pz", pz);
        applyImpulse(s, jx, jy, jz);
        double rx = px - bodies.positionX[s];
        double ry = py - bodies.positionY[s];
        double rz = pz - bodies.positionZ[s];
        turn(s, ry * jz - rz * jy, rz * jx - rx * jz, rx * jy - ry * jx);
    }

    /** Changes the angular velocity, by N m s over the inertia. */
    public void applyAngularImpulse(int s, double lx, double ly, double lz) {
        Checks.finite("lx", lx);
        Checks.finite("ly", ly);
        Checks.finite("lz", lz);
        turn(s, lx, ly, lz);
    }

    /** w += R I⁻¹ Rᵀ l. */
    private void turn(int s, double lx, double ly, double lz) {
        if (isUnmoved(s)) {
            return;
        }
        wakeUnlessZero(s, lx, ly, lz);
        double qx = bodies.orientationX[s];
        double qy = bodies.orientationY[s];
        double qz = bodies.orientationZ[s];
        double qw = bodies.orientationW[s];
        double[] v = rotated;
        Rotations.rotate(-qx, -qy, -qz, qw, lx, ly, lz, v);
        double bx = v[0];
        double by = v[1];
        double bz = v[2];
        double xx = bodies.inverseInertiaXX[s];
        double yy = bodies.inverseInertiaYY[s];
        double zz = bodies.inverseInertiaZZ[s];
        double xy = bodies.inverseInertiaXY[s];
        double xz = bodies.inverseInertiaXZ[s];
        double yz = bodies.inverseInertiaYZ[s];
        Rotations.rotate(
                qx,
                qy,
                qz,
                qw,
                xx * bx + xy * by + xz * bz,
                xy * bx + yy * by + yz * bz,
                xz * bx + yz * by + zz * bz,
                v);
        bodies.angularVelocityX[s] += v[0];
        bodies.angularVelocityY[s] += v[1];
        bodies.angularVelocityZ[s] += v[2];
    }
}
