package dev.cairn.physics.internal;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.shape.mesh.Meshed;
import dev.cairn.physics.shape.revolution.Discs;
import dev.cairn.physics.shape.revolution.Revolved;

/**
 * What the surface of a collider is made of, as far as it matters to code that computes with
 * contacts. Collision tells it with each row, and with each point by its feature id whether that is
 * a tip, so no stage behind it asks for the class of a shape; a shape that is turned or shifted in
 * its body is as that shape. Stateless.
 */
public final class Surface {
    /**
     * Curved sides and rims: a contact point goes with the body's axis, and stays where it is while
     * the body turns about it; of a ball about any.
     */
    public static final byte ROUND = 0;

    /** Faces, edges and corners: a contact point turns with the body. */
    public static final byte CORNERED = 1;

    /** One plane without end. */
    public static final byte PLANE = 2;

    /** Curved, with one tip: that point turns with the body, the others as of {@link #ROUND}. */
    public static final byte TIPPED = 3;

    /** Name, within a feature id, of the upper end of a round side; of a cone it is the tip. */
    public static final int UPPER_END = 33;

    /** Bit of a feature id that names a feature of B. */
    private static final int OF_B = 1 << 30;

    private Surface() {}

    /**
     * The surface of a shape.
     *
     * @param shape any
     * @return one of the constants
     */
    public static byte of(Shape shape) {
        return switch (shape) {
            case Moved moved -> of(moved.inner());
            case Box box -> CORNERED;
            case ConvexHull hull -> CORNERED;
            case Revolved turned when Discs.of(turned).hasTip() -> TIPPED;
            case HalfSpace plane -> PLANE;
            case TriangleMesh mesh -> CORNERED;
            case HeightField field -> CORNERED;
            default -> ROUND;
        };
    }

    /**
     * A shape without its place in the body.
     *
     * @param shape any
     * @return the shape, neither moved nor turned
     */
    public static Shape unmoved(Shape shape) {
        return shape instanceof Moved m ? m.inner() : shape;
    }

    /**
     * Whether a shape is of triangles, without an inside.
     *
     * @param shape any, moved or not
     */
    public static boolean isMeshed(Shape shape) {
        return unmoved(shape) instanceof Meshed;
    }

    /**
     * What a solid of revolution turns about.
     *
     * @param shape any
     * @param dest receives the axis in the collider's frame, a unit vector, and the radius of what
     *     is laid around a core, of a capsule its radius, m; zeros for balls and for what is no
     *     such solid
     * @param at where to write the four numbers
     */
    public static void revolution(Shape shape, double[] dest, int at) {
        Shape inner = unmoved(shape);
        boolean isTurned = inner instanceof Revolved;
        double x = 0;
        double y = isTurned ? 1 : 0;
        double z = 0;
        if (isTurned && shape instanceof Moved m) {
            // the second column of the rotation
            double qx = m.rotationX();
            double qy = m.rotationY();
            double qz = m.rotationZ();
            double qw = m.rotationW();
            x = 2 * (qx * qy - qw * qz);
            y = 1 - 2 * (qx * qx + qz * qz);
            z = 2 * (qy * qz + qw * qx);
        }
        dest[at] = x;
        dest[at + 1] = y;
        dest[at + 2] = z;
        dest[at + 3] = inner instanceof Revolved solid ? Discs.of(solid).round : 0;
    }

    /**
     * Whether a surface is without curvature, so that a corner may roll on it and stay one point.
     *
     * @param surface one of the constants
     * @return whether it is cornered or a plane
     */
    public static boolean isFlat(byte surface) {
        return surface == CORNERED || surface == PLANE;
    }

    /**
     * Whether a contact point turns with the body, as a corner or a tip does.
     *
     * @param surface of the body's collider
     * @param feature id of the point
     * @param second whether the body is the second of the contact
     * @return whether it does
     */
    public static boolean isCorner(byte surface, int feature, boolean second) {
        return surface == CORNERED
                || (surface == TIPPED && feature == (second ? OF_B | UPPER_END : UPPER_END));
    }

    /**
     * The shape to collide, given that it is about its centre of mass: a shift then changes
     * nothing, nor does a turn of a ball.
     *
     * @param shape of a body
     * @return a shape that fills the same space about its centre of mass
     */
    static Shape aboutCentre(Shape shape) {
        return shape instanceof Moved m && (m.inner() instanceof Sphere || !m.isTurned())
                ? m.inner()
                : shape;
    }
}
