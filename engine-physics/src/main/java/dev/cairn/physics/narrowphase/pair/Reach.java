package dev.cairn.physics.narrowphase.pair;

import dev.cairn.physics.internal.MovedTurn;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.polyhedron.Polyhedral;
import dev.cairn.physics.shape.polyhedron.Polyhedron;
import dev.cairn.physics.shape.revolution.Revolved;

/**
 * How far one shape reaches along directions of the world, its support function, and whether it
 * holds a point; both from its centre of mass. One instance per worker; allocates nothing.
 */
public final class Reach {
    /** Cosine of an angle that is 0 up to rounding, less 1. */
    private static final double PARALLEL = 1 - 0x1p-48;

    private final SolidOfRevolution solid = new SolidOfRevolution();
    private Shape shape = HalfSpace.of();
    private double qx, qy, qz, qw;
    private double x, y, z;

    /** Half extents of a box: levels are made of those, and need no list of faces. */
    private double halfX, halfY, halfZ;

    private boolean isBox;

    /** The outward normal that the last {@link #findFace} found, unit, world. */
    public double faceX, faceY, faceZ;

    /** Of no shape yet. */
    public Reach() {}

    /**
     * Whether a shape is one of those that this can tell of: convex, with a surface of its own.
     *
     * @param shape any
     * @return whether {@link #set} takes it
     */
    public static boolean fits(Shape shape) {
        // No switch over types: that is linked at its first run, which would be within a tick.
        if (shape instanceof Moved moved) {
            return fits(moved.inner());
        }
        return shape instanceof Box
                || shape instanceof ConvexHull
                || shape instanceof Sphere
                || shape instanceof Revolved
                || shape instanceof HalfSpace;
    }

    /**
     * Chooses a shape and how it is turned.
     *
     * @param value one that {@link #fits}
     * @param ox world from body, unit quaternion
     * @param oy see {@code ox}
     * @param oz see {@code ox}
     * @param ow see {@code ox}
     */
    public void set(Shape value, double ox, double oy, double oz, double ow) {
        shape = value;
        qx = ox;
        qy = oy;
        qz = oz;
        qw = ow;
        if (value instanceof Moved m) {
            shape = m.inner();
            qx = MovedTurn.x(m, ox, oy, oz, ow);
            qy = MovedTurn.y(m, ox, oy, oz, ow);
            qz = MovedTurn.z(m, ox, oy, oz, ow);
            qw = MovedTurn.w(m, ox, oy, oz, ow);
        }
        isBox = shape instanceof Box;
        if (shape instanceof Box box) {
            halfX = box.halfX();
            halfY = box.halfY();
            halfZ = box.halfZ();
        } else if (!(shape instanceof Polyhedral) && !(shape instanceof HalfSpace)) {
            solid.set(shape);
        }
    }

    /**
     * How far the shape reaches from its centre along a direction.
     *
     * @param ux unit vector, world
     * @param uy unit vector, world
     * @param uz unit vector, world
     * @return m; infinite for a half-space, but along its normal
     */
    public double along(double ux, double uy, double uz) {
        turn(ux, uy, uz);
        if (isBox) {
            return halfX * Math.abs(x) + halfY * Math.abs(y) + halfZ * Math.abs(z);
        }
        if (shape instanceof Polyhedral polyhedral) {
            Polyhedron p = Polyhedron.of(polyhedral);
            int v = p.support(x, y, z);
            return p.vertexX(v) * x + p.vertexY(v) * y + p.vertexZ(v) * z;
        }
        if (shape instanceof HalfSpace) {
            return y >= PARALLEL ? 0 : Double.POSITIVE_INFINITY;
        }
        return solid.reach(x, y, z) + solid.round;
    }

    /**
     * Finds the corner that reaches farthest along a direction.
     *
     * @param ux unit vector, world
     * @param uy unit vector, world
     * @param uz unit vector, world
     * @param out receives it, from the shape's centre, world, m
     * @return false for shapes without corners
     */
    public boolean corner(double ux, double uy, double uz, double[] out) {
        if (!(shape instanceof Polyhedral polyhedral)) {
            return false;
        }
        turn(ux, uy, uz);
        Polyhedron p = Polyhedron.of(polyhedral);
        int v = p.support(x, y, z);
        Rotations.rotate(qx, qy, qz, qw, p.vertexX(v), p.vertexY(v), p.vertexZ(v), out);
        return true;
    }

    /**
     * Whether a point is in the shape.
     *
     * @param px from the shape's centre, world, m
     * @param py from the shape's centre, world, m
     * @param pz from the shape's centre, world, m
     * @param slack how far outside of the planes of its faces counts as in it, m
     * @return whether it is; false for shapes with a round side
     */
    public boolean holds(double px, double py, double pz, double slack) {
        turn(px, py, pz);
        if (isBox) {
            return Math.abs(x) - halfX <= slack
                    && Math.abs(y) - halfY <= slack
                    && Math.abs(z) - halfZ <= slack;
        }
        if (shape instanceof HalfSpace) {
            return y <= slack;
        }
        if (!(shape instanceof Polyhedral polyhedral)) {
            return false;
        }
        Polyhedron p = Polyhedron.of(polyhedral);
        for (int f = 0; f < p.faceCount(); f++) {
            double out = p.normalX(f) * x + p.normalY(f) * y + p.normalZ(f) * z - p.offset(f);
            if (!(out <= slack)) {
                return false;
            }
        }
        return true;
    }

    /**
     * Finds the face that looks most along a direction.
     *
     * @param ux unit vector, world
     * @param uy unit vector, world
     * @param uz unit vector, world
     * @return cosine of the angle between them; -1 for shapes with a round side
     */
    public double findFace(double ux, double uy, double uz) {
        turn(ux, uy, uz);
        if (isBox) {
            return findSide();
        }
        if (shape instanceof HalfSpace) {
            turnBack(0, 1, 0);
            return y;
        }
        if (!(shape instanceof Polyhedral polyhedral)) {
            return -1;
        }
        Polyhedron p = Polyhedron.of(polyhedral);
        int best = 0;
        double most = -1;
        for (int f = 0; f < p.faceCount(); f++) {
            double cosine = p.normalX(f) * x + p.normalY(f) * y + p.normalZ(f) * z;
            if (cosine > most) {
                most = cosine;
                best = f;
            }
        }
        turnBack(p.normalX(best), p.normalY(best), p.normalZ(best));
        return most;
    }

    /** The side of a box that looks most along the direction in its axes. */
    private double findSide() {
        double most = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        if (Math.abs(x) == most) {
            turnBack(Math.signum(x), 0, 0);
        } else if (Math.abs(y) == most) {
            turnBack(0, Math.signum(y), 0);
        } else {
            turnBack(0, 0, Math.signum(z));
        }
        return most;
    }

    private void turnBack(double vx, double vy, double vz) {
        double s = 2 / (qx * qx + qy * qy + qz * qz + qw * qw);
        double tx = s * (qy * vz - qz * vy);
        double ty = s * (qz * vx - qx * vz);
        double tz = s * (qx * vy - qy * vx);
        faceX = vx + qw * tx + (qy * tz - qz * ty);
        faceY = vy + qw * ty + (qz * tx - qx * tz);
        faceZ = vz + qw * tz + (qx * ty - qy * tx);
    }

    /** Into the axes of the shape: v - 2 w (q x v) + 2 q x (q x v), over the square of q. */
    private void turn(double vx, double vy, double vz) {
        double s = 2 / (qx * qx + qy * qy + qz * qz + qw * qw);
        double tx = s * (qy * vz - qz * vy);
        double ty = s * (qz * vx - qx * vz);
        double tz = s * (qx * vy - qy * vx);
        x = vx - qw * tx + (qy * tz - qz * ty);
        y = vy - qw * ty + (qz * tx - qx * tz);
        z = vz - qw * tz + (qx * ty - qy * tx);
    }
}
