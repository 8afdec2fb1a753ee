package dev.cairn.physics.shape;

import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * A convex solid, or a surface of triangles that does not move by itself. Immutable; share one
 * instance between bodies and threads freely. Lengths are metres in the shape frame; what the
 * engine collides is relative to the centre of mass ({@link #centreOfMass}).
 */
public sealed interface Shape
        permits Sphere,
                Box,
                Capsule,
                Cylinder,
                Cone,
                ConvexHull,
                HalfSpace,
                TriangleMesh,
                HeightField,
                Moved {
    /**
     * The volume.
     *
     * @return m³, positive; infinite for what only fixed and kinematic bodies have
     */
    double volume();

    /**
     * Mass, centre of mass and inertia at uniform density.
     *
     * @param density kg/m³, positive and finite
     * @return the properties, inertia about the centre of mass in shape axes
     * @throws IllegalArgumentException if the density is not positive and finite
     */
    MassProperties massProperties(double density);

    /**
     * The radius of the largest ball around the centre of mass that the shape contains.
     *
     * @return m, positive
     */
    double innerRadius();

    /**
     * The radius of the smallest ball around the centre of mass that contains the shape.
     *
     * @return m, positive
     */
    double outerRadius();

    /**
     * The centre of mass in the shape frame: what turns a shape frame's origin into a body's
     * position.
     *
     * @param dest receives the result
     * @return {@code dest}
     */
    Vector3d centreOfMass(Vector3d dest);

    /**
     * The axis-aligned box of the rotated shape, tight for convex ones, relative to its centre of
     * mass, in world axes. Allocates nothing; any thread.
     *
     * @param qx orientation, world from body, unit quaternion
     * @param qy orientation
     * @param qz orientation
     * @param qw orientation
     * @param dest receives minX, minY, minZ, maxX, maxY, maxZ in metres
     * @param offset index of minX in {@code dest}
     */
    void bounds(double qx, double qy, double qz, double qw, double[] dest, int offset);

    /**
     * This shape at another place of the body: first turned about its frame's origin, then shifted.
     * Mass, centre of mass and inertia follow.
     *
     * @param x where its frame's origin goes, m, finite
     * @param y see {@code x}
     * @param z see {@code x}
     * @param turn unit quaternion within 1e-6; it is normalised
     * @return this shape if that changes nothing, else a new one that shares it
     * @throws IllegalArgumentException if a number is not finite, the quaternion is not a unit one,
     *     or this is a {@link HalfSpace}
     */
    default Shape moved(double x, double y, double z, Quaterniond turn) {
        return Moved.of(this, x, y, z, turn);
    }
}
