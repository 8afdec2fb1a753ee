package dev.cairn.physics.narrowphase.round;

import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

/**
 * A ball and a box in closed form: what the centre is beyond the box along each of its axes, or,
 * inside, the nearest face. Only the box has to be turned.
 */
public final class BallBox {
    /** Signed distance of a point from a box, and the unit axis to it, in the box's frame. */
    double distance, x, y, z;

    /** The box's turn, world from body. */
    private double w00, w01, w02, w10, w11, w12, w20, w21, w22;

    /** Measures a point against a box given by its half extents. */
    void measure(double px, double py, double pz, double bx, double by, double bz) {
        double ox = Math.abs(px) - bx;
        double oy = Math.abs(py) - by;
        double oz = Math.abs(pz) - bz;
        if (ox <= 0 && oy <= 0 && oz <= 0) {
            boolean alongX = ox >= oy && ox >= oz;
            boolean alongY = !alongX && oy >= oz;
            distance = Math.max(ox, Math.max(oy, oz));
            x = alongX ? (px < 0 ? -1 : 1) : 0;
            y = alongY ? (py < 0 ? -1 : 1) : 0;
            z = (alongX || alongY) ? 0 : (pz < 0 ? -1 : 1);
            return;
        }
        double ex = Math.max(ox, 0);
        double ey = Math.max(oy, 0);
        double ez = Math.max(oz, 0);
        double most = Math.max(ex, Math.max(ey, ez));
        ex /= most;
        ey /= most;
        ez /= most;
        double length = Math.sqrt(ex * ex + ey * ey + ez * ez);
        distance = length * most;
        x = (px < 0 ? -ex : ex) / length;
        y = (py < 0 ? -ey : ey) / length;
        z = (pz < 0 ? -ez : ez) / length;
    }

    /**
     * Finds the contact of a ball and a box, as {@code NarrowPhase.collide} does; false for other
     * pairs; nothing is written then.
     */
    public boolean collide(
            Shape a,
            Shape b,
            double qAx,
            double qAy,
            double qAz,
            double qAw,
            double qBx,
            double qBy,
            double qBz,
            double qBw,
            double dx,
            double dy,
            double dz,
            double margin,
            Manifold out) {
        if (a instanceof Box box && b instanceof Sphere ball) {
            turn(qAx, qAy, qAz, qAw);
            double reach = touch(box, ball, dx, dy, dz, margin, out);
            if (out.pointCount > 0) {
                out.pointX[0] = dx - reach * out.normalX;
                out.pointY[0] = dy - reach * out.normalY;
                out.pointZ[0] = dz - reach * out.normalZ;
            }
            return true;
        }
        if (a instanceof Sphere ball && b instanceof Box box) {
            turn(qBx, qBy, qBz, qBw);
            double reach = touch(box, ball, -dx, -dy, -dz, margin, out);
            if (out.pointCount > 0) {
                out.normalX = -out.normalX;
                out.normalY = -out.normalY;
                out.normalZ = -out.normalZ;
                out.pointX[0] = reach * out.normalX;
                out.pointY[0] = reach * out.normalY;
                out.pointZ[0] = reach * out.normalZ;
            }
            return true;
        }
        return false;
    }

    /** The contact but for its place; returns how far from the ball's centre that is. */
    private double touch(
            Box box, Sphere ball, double dx, double dy, double dz, double margin, Manifold out) {
        measure(
                w00 * dx + w10 * dy + w20 * dz,
                w01 * dx + w11 * dy + w21 * dz,
                w02 * dx + w12 * dy + w22 * dz,
                box.halfX(),
                box.halfY(),
                box.halfZ());
        double separation = distance - ball.radius();
        out.patch = 0;
        out.bound = 0;
        out.capped = false;
        out.pointCount = separation <= margin ? 1 : 0;
        if (out.pointCount > 0) {
            out.normalX = w00 * x + w01 * y + w02 * z;
            out.normalY = w10 * x + w11 * y + w12 * z;
            out.normalZ = w20 * x + w21 * y + w22 * z;
            out.separation[0] = separation;
            out.feature[0] = FeatureIds.CLOSEST;
            double far = Math.max(Math.abs(dx), Math.max(Math.abs(dy), Math.abs(dz)));
            out.bound = 0x1p-47 * (box.outerRadius() + ball.radius() + far);
        }
        return ball.radius() + 0.5 * separation;
    }

    /** As {@code Pair}'s. */
    private void turn(double qx, double qy, double qz, double qw) {
        double s = 2 / (qx * qx + qy * qy + qz * qz + qw * qw);
        w00 = 1 - s * (qy * qy + qz * qz);
        w01 = s * (qx * qy - qz * qw);
        w02 = s * (qx * qz + qy * qw);
        w10 = s * (qx * qy + qz * qw);
        w11 = 1 - s * (qx * qx + qz * qz);
        w12 = s * (qy * qz - qx * qw);
        w20 = s * (qx * qz - qy * qw);
        w21 = s * (qy * qz + qx * qw);
        w22 = 1 - s * (qx * qx + qy * qy);
    }
}
