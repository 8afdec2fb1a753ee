package dev.cairn.physics.body;

import dev.cairn.physics.internal.Checks;

import org.joml.Vector3dc;

/**
 * What pushes and turns a body, as three doubles or as vectors of JOML's; all in world axes.
 *
 * <p>Forces and torques add up and act over the whole next step, then are cleared; impulses act at
 * once. On a body that is fixed or kinematic, which none of them moves, they throw {@link
 * IllegalStateException}; on one that the world has stopped, see {@code quarantined()}, they have
 * no effect. Simulation thread, between steps. Does not allocate.
 */
public interface BodyForces {
    /**
     * AppliedForces at the centre of mass during the next step.
     *
     * @param fx N, finite
     * @param fy N, finite
     * @param fz N, finite
     */
    void applyForce(double fx, double fy, double fz);

    /**
     * AppliedForces at the centre of mass during the next step.
     *
     * @param force N, finite
     */
    default void applyForce(Vector3dc force) {
        Checks.notNull("force", force);
        applyForce(force.x(), force.y(), force.z());
    }

    /**
     * AppliedForces at a point during the next step.
     *
     * @param fx N, finite
     * @param fy N, finite
     * @param fz N, finite
     * @param px point, world, m, finite
     * @param py point, world, m, finite
     * @param pz point, world, m, finite
     */
    void applyForceAt(double fx, double fy, double fz, double px, double py, double pz);

    /**
     * AppliedForces at a point during the next step.
     *
     * @param force N, finite
     * @param point world, m, finite
     */
    default void applyForceAt(Vector3dc force, Vector3dc point) {
        Checks.notNull("force", force);
        Checks.notNull("point", point);
        applyForceAt(force.x(), force.y(), force.z(), point.x(), point.y(), point.z());
    }

    /**
     * Turns during the next step.
     *
     * @param tx N m, finite
     * @param ty N m, finite
     * @param tz N m, finite
     */
    void applyTorque(double tx, double ty, double tz);

    /**
     * Turns during the next step.
     *
     * @param torque N m, finite
     */
    default void applyTorque(Vector3dc torque) {
        Checks.notNull("torque", torque);
        applyTorque(torque.x(), torque.y(), torque.z());
    }

    /**
     * Changes the velocity at once.
     *
     * @param jx impulse at the centre of mass, N s, finite
     * @param jy N s, finite
     * @param jz N s, finite
     */
    void applyImpulse(double jx, double jy, double jz);

    /**
     * Changes the velocity at once.
     *
     * @param impulse at the centre of mass, N s, finite
     */
    default void applyImpulse(Vector3dc impulse) {
        Checks.notNull("impulse", impulse);
        applyImpulse(impulse.x(), impulse.y(), impulse.z());
    }

    /**
     * Changes velocity and angular velocity at once.
     *
     * @param jx impulse, N s, finite
     * @param jy N s, finite
     * @param jz N s, finite
     * @param px point that it acts at, world, m, finite
     * @param py point, world, m, finite
     * @param pz point, world, m, finite
     */
    void applyImpulseAt(double jx, double jy, double jz, double px, double py, double pz);

    /**
     * Changes velocity and angular velocity at once.
     *
     * @param impulse N s, finite
     * @param point that it acts at, world, m, finite
     */
    default void applyImpulseAt(Vector3dc impulse, Vector3dc point) {
        Checks.notNull("impulse", impulse);
        Checks.notNull("point", point);
        applyImpulseAt(impulse.x(), impulse.y(), impulse.z(), point.x(), point.y(), point.z());
    }

    /**
     * Changes the angular velocity at once.
     *
     * @param lx angular impulse, N m s, finite
     * @param ly N m s, finite
     * @param lz N m s, finite
     */
    void applyAngularImpulse(double lx, double ly, double lz);

    /**
     * Changes the angular velocity at once.
     *
     * @param impulse N m s, finite
     */
    default void applyAngularImpulse(Vector3dc impulse) {
        Checks.notNull("impulse", impulse);
        applyAngularImpulse(impulse.x(), impulse.y(), impulse.z());
    }
}
