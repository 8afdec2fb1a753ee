package dev.cairn.physics.body;

import dev.cairn.physics.internal.Checks;

import org.joml.Vector3dc;

/**
 * What the description of a body says in three doubles, or in vectors of JOML's. One thread at a
 * time.
 *
 * @param <B> the description
 */
public interface BodyVectors<B> {
    /**
     * Places the origin of the shape's frame; (0, 0, 0) by default.
     *
     * @param worldX m, finite
     * @param worldY m, finite
     * @param worldZ m, finite
     * @return this
     */
    B at(double worldX, double worldY, double worldZ);

    /**
     * Places the origin of the shape's frame.
     *
     * @param world m, finite
     * @return this
     */
    default B at(Vector3dc world) {
        Checks.notNull("world", world);
        return at(world.x(), world.y(), world.z());
    }

    /**
     * Turns the shape's frame about an axis through its origin.
     *
     * @param axisX world axis, any length above 0
     * @param axisY world axis
     * @param axisZ world axis
     * @param radians angle by the right-hand rule, finite
     * @return this
     * @throws IllegalArgumentException if the axis is zero or anything is not finite
     */
    B rotationAbout(double axisX, double axisY, double axisZ, double radians);

    /**
     * Turns the shape's frame about an axis through its origin.
     *
     * @param axis world, any length above 0
     * @param radians angle by the right-hand rule, finite
     * @return this
     */
    default B rotationAbout(Vector3dc axis, double radians) {
        Checks.notNull("axis", axis);
        return rotationAbout(axis.x(), axis.y(), axis.z(), radians);
    }

    /**
     * States the inertia about the centre of mass, instead of that of the shape filled evenly: a
     * shell, a hoop, a gyroscope. The shape's axes are its principal axes.
     *
     * @param xx about the shape's x axis, kg m², finite, above 0
     * @param yy about the shape's y axis, kg m², finite, above 0
     * @param zz about the shape's z axis, kg m², finite, above 0
     * @return this
     * @throws IllegalArgumentException if one is not, or is larger than the sum of the others: no
     *     matter can be arranged so
     */
    B inertia(double xx, double yy, double zz);

    /**
     * States the inertia about the centre of mass.
     *
     * @param principal about the shape's axes, kg m², each finite, above 0
     * @return this
     */
    default B inertia(Vector3dc principal) {
        Checks.notNull("principal", principal);
        return inertia(principal.x(), principal.y(), principal.z());
    }

    /**
     * States the centre of mass, instead of that of the shapes filled evenly: a tumbler, a keel, a
     * loaded die. The inertia is about it: the one that is stated, or that of the shapes about
     * their own centre.
     *
     * @param bodyX in the body's frame, m, finite
     * @param bodyY in the body's frame, m, finite
     * @param bodyZ in the body's frame, m, finite
     * @return this
     */
    B centreOfMass(double bodyX, double bodyY, double bodyZ);

    /**
     * States the centre of mass.
     *
     * @param body in the body's frame, m, finite
     * @return this
     */
    default B centreOfMass(Vector3dc body) {
        Checks.notNull("body", body);
        return centreOfMass(body.x(), body.y(), body.z());
    }

    /**
     * Sets the velocity of the centre of mass at the start; ignored for fixed bodies.
     *
     * @param worldX m/s, finite
     * @param worldY m/s, finite
     * @param worldZ m/s, finite
     * @return this
     */
    B velocity(double worldX, double worldY, double worldZ);

    /**
     * Sets the velocity of the centre of mass at the start.
     *
     * @param world m/s, finite
     * @return this
     */
    default B velocity(Vector3dc world) {
        Checks.notNull("world", world);
        return velocity(world.x(), world.y(), world.z());
    }

    /**
     * Sets the angular velocity at the start; ignored for fixed bodies.
     *
     * @param worldX rad/s, finite
     * @param worldY rad/s, finite
     * @param worldZ rad/s, finite
     * @return this
     */
    B angularVelocity(double worldX, double worldY, double worldZ);

    /**
     * Sets the angular velocity at the start.
     *
     * @param world rad/s, finite
     * @return this
     */
    default B angularVelocity(Vector3dc world) {
        Checks.notNull("world", world);
        return angularVelocity(world.x(), world.y(), world.z());
    }
}
