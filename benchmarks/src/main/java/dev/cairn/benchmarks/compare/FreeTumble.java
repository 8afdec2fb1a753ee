package dev.cairn.benchmarks.compare;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The scene {@code tumble} by the integrators that engines have for a free body, in double: what
 * the change of its angular momentum would be if nothing else were in the engine. A first-order
 * step: new angular velocity w from the torque -w x I w, then the body turns by w h.
 */
final class FreeTumble {
    private static final double TICK = 1.0 / 60;
    private static final int TICKS = 600;

    /** A box of 10 kg, 0.1 x 0.9 x 0.4 m: m/12 (b² + c²) about each axis. */
    private static final Matrix3d BODY_INERTIA =
            new Matrix3d().scaling(10 / 12.0 * 0.97, 10 / 12.0 * 0.17, 10 / 12.0 * 0.82);

    /** How an engine takes up the gyroscopic torque. */
    enum Torque {
        /** Not at all: w stays as it is. */
        NONE,
        /** w - h I⁻¹ (w x I w): ODE at the time of the Gazebo boxes, Bullet before 2.83. */
        EXPLICIT,
        /**
         * I w' + h w' x L = L with the old L = I w: linear in w' (Lacoursiere, Stabilizing
         * Gyroscopic Forces in Rigid Multibody Simulations, 2006); ode4j 0.5.3 names it as its
         * source.
         */
        IMPLICIT,
        /** One Newton step for I (w' - w) + h w' x I w' = 0 in the body's frame: Bullet, Box3D. */
        NEWTON
    }

    private FreeTumble() {}

    /**
     * Returns the largest change of the angular momentum after a tick, as a share of it.
     *
     * @param torque how it is taken up
     * @param stepSeconds a tick or a whole fraction of it
     */
    static double momentumError(Torque torque, double stepSeconds) {
        int substeps = (int) Math.round(TICK / stepSeconds);
        Quaterniond attitude = new Quaterniond();
        Vector3d w = new Vector3d(0.1, 0.1, -5);
        Vector3d first = BODY_INERTIA.transform(w, new Vector3d());
        double worst = 0;
        for (int tick = 0; tick < TICKS; tick++) {
            for (int step = 0; step < substeps; step++) {
                Vector3d body = attitude.transformInverse(w, new Vector3d());
                attitude.transform(next(torque, body, stepSeconds), w);
                double speed = w.length();
                Quaterniond turn =
                        new Quaterniond()
                                .fromAxisAngleRad(
                                        w.x / speed, w.y / speed, w.z / speed, speed * stepSeconds);
                attitude.premul(turn).normalize();
            }
            Vector3d body = attitude.transformInverse(w, new Vector3d());
            Vector3d now = attitude.transform(BODY_INERTIA.transform(body));
            worst = Math.max(worst, now.distance(first) / first.length());
        }
        return worst;
    }

    /** The angular velocity after a step, in the body's frame at its start. */
    private static Vector3d next(Torque torque, Vector3d w, double h) {
        Vector3d momentum = BODY_INERTIA.transform(w, new Vector3d());
        Vector3d gyroscopic = w.cross(momentum, new Vector3d());
        return switch (torque) {
            case NONE -> w;
            case EXPLICIT ->
                    new Matrix3d(BODY_INERTIA).invert().transform(gyroscopic).mul(-h).add(w);
            // w' x L = -[L] w'
            case IMPLICIT ->
                    new Matrix3d(BODY_INERTIA)
                            .sub(scaled(cross(momentum), h))
                            .invert()
                            .transform(momentum);
            // derivative of w' x I w': [w] I - [I w]
            case NEWTON ->
                    scaled(cross(w).mul(BODY_INERTIA).sub(cross(momentum)), h)
                            .add(BODY_INERTIA)
                            .invert()
                            .transform(gyroscopic)
                            .mul(-h)
                            .add(w);
        };
    }

    private static Matrix3d scaled(Matrix3d matrix, double factor) {
        return matrix.scaleLocal(factor, factor, factor);
    }

    /** The matrix [v] with [v] u = v x u. */
    private static Matrix3d cross(Vector3d v) {
        return new Matrix3d(0, v.z, -v.y, -v.z, 0, v.x, v.y, -v.x, 0);
    }
}
