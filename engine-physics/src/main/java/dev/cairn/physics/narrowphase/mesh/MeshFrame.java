package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.internal.MovedTurn;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;

/** How a surface and a shape are turned, and from whose axes into whose a vector is brought. */
final class MeshFrame {
    /** Orientation of the shape in the mesh's axes, unit quaternion. */
    double qx, qy, qz, qw;

    /** What the last turn gave. */
    double x, y, z;

    /** Orientation of the mesh in the world. */
    private double mx, my, mz, mw;

    /**
     * Begins with a pair.
     *
     * @param ax orientation of the surface, world from shape, unit quaternion
     * @param convex the shape, perhaps moved within its body
     * @param bx its orientation
     * @return the shape that is turned by q, which is that within a moved one
     */
    Shape set(
            double ax,
            double ay,
            double az,
            double aw,
            Shape convex,
            double bx,
            double by,
            double bz,
            double bw) {
        mx = ax;
        my = ay;
        mz = az;
        mw = aw;
        qx = aw * bx - ax * bw - ay * bz + az * by;
        qy = aw * by + ax * bz - ay * bw - az * bx;
        qz = aw * bz - ax * by + ay * bx - az * bw;
        qw = aw * bw + ax * bx + ay * by + az * bz;
        if (convex instanceof Moved m) {
            turn(m);
            return m.inner();
        }
        return convex;
    }

    private void turn(Moved m) {
        double rx = MovedTurn.x(m, qx, qy, qz, qw);
        double ry = MovedTurn.y(m, qx, qy, qz, qw);
        double rz = MovedTurn.z(m, qx, qy, qz, qw);
        qw = MovedTurn.w(m, qx, qy, qz, qw);
        qx = rx;
        qy = ry;
        qz = rz;
    }

    /** From world axes into the mesh's. */
    void toMesh(double x, double y, double z) {
        rotate(-mx, -my, -mz, mw, x, y, z);
    }

    /** From the mesh's axes into the world's. */
    void toWorld(double x, double y, double z) {
        rotate(mx, my, mz, mw, x, y, z);
    }

    /** By v + 2 u x (u x v + w v), with u the vector of the quaternion. */
    private void rotate(double x, double y, double z, double w, double vx, double vy, double vz) {
        double ux = 2 * (y * vz - z * vy);
        double uy = 2 * (z * vx - x * vz);
        double uz = 2 * (x * vy - y * vx);
        this.x = vx + w * ux + (y * uz - z * uy);
        this.y = vy + w * uy + (z * ux - x * uz);
        this.z = vz + w * uz + (x * uy - y * ux);
    }
}
