package dev.cairn.physics.contact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;

/**
 * Two colliders along the motion of a tick: each body's centre on its parabola, turning about it at
 * its angular velocity.
 *
 * <p>Conservative advancement (B. Mirtich, 1996): with the distance d of now along the axis n, no
 * point closes along n faster than
 *
 * <pre>
 *   c = n . (vA - vB) + |wA| RA + |wB| RB,      R = how far a point is from its body's centre
 * </pre>
 *
 * so nothing meets before d/c, and nothing at all if c is not positive. Advance by that, and look
 * again.
 *
 * <p>One instance per worker.
 */
final class SweptPair {
    /** Steps; a pair that has not been decided by then is taken to meet. */
    private static final int MOST_STEPS = 128;

    /** Of the sizes: nearer counts as met. */
    private static final double MET = 0x1p-36;

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final BoundsStage bounds;
    private final PointStore points;
    private final PointStore.Scratch scratch = new PointStore.Scratch();
    private final NarrowPhase narrowPhase = new NarrowPhase();
    private final Manifold manifold = new Manifold();
    private final Side a = new Side(), b = new Side();
    private final double[] v = new double[3];

    private double step;
    private double time;

    SweptPair(
            ColliderStore colliders, ContactStore contacts, BoundsStage bounds, PointStore points) {
        this.colliders = colliders;
        this.contacts = contacts;
        this.bounds = bounds;
        this.points = points;
    }

    /** Whether the colliders of a row meet within a tick. */
    boolean meet(int row, double stepSeconds) {
        step = stepSeconds;
        a.set(contacts.colliderA[row]);
        b.set(contacts.colliderB[row]);
        Poses p = colliders.poses;
        double x = p.apartX(a.collider, b.collider);
        double y = p.apartY(a.collider, b.collider);
        double z = p.apartZ(a.collider, b.collider);
        double met = MET * (a.size + b.size) + a.doubt + b.doubt;
        time = 0;
        for (int i = 0; i < MOST_STEPS; i++) {
            a.move(time);
            b.move(time);
            double d = distance(x, y, z) - met;
            if (d <= 0) {
                return true;
            }
            double closing = Math.max(closing(time), closing(step)) + a.rim + b.rim;
            if (!(closing > 0)) {
                return false;
            }
            time += d / closing;
            if (time >= step) {
                return false;
            }
        }
        return true;
    }

    private double distance(double x, double y, double z) {
        return narrowPhase.distance(
                a.shape,
                b.shape,
                a.qx,
                a.qy,
                a.qz,
                a.qw,
                b.qx,
                b.qy,
                b.qz,
                b.qw,
                x + b.x - a.x,
                y + b.y - a.y,
                z + b.z - a.z);
    }

    /** How fast the centres of the bodies approach along the axis, at a time. */
    private double closing(double t) {
        return narrowPhase.axisX() * (a.vx + t * a.ax - b.vx - t * b.ax)
                + narrowPhase.axisY() * (a.vy + t * a.ay - b.vy - t * b.ay)
                + narrowPhase.axisZ() * (a.vz + t * a.az - b.vz - t * b.az);
    }

    /**
     * Puts the contact of the meeting into a row, told of the start of the tick: its points are
     * where they are on the bodies, and as far apart as they approach until then. Only after a way
     * that is longer than the bodies are thick.
     *
     * @param reach of the margin, s
     */
    void collideThere(int row, double reach) {
        Poses p = colliders.poses;
        double wayX = b.x - a.x;
        double wayY = b.y - a.y;
        double wayZ = b.z - a.z;
        double thin = Math.min(a.inner, b.inner);
        double way = wayX * wayX + wayY * wayY + wayZ * wayZ;
        double turned = (a.rim + b.rim) * time;
        if ((way <= thin * thin && turned <= thin) || (a.isBall && b.isBall)) {
            return;
        }
        narrowPhase.collide(
                a.shape,
                b.shape,
                a.qx,
                a.qy,
                a.qz,
                a.qw,
                b.qx,
                b.qy,
                b.qz,
                b.qw,
                p.apartX(a.collider, b.collider) + wayX,
                p.apartY(a.collider, b.collider) + wayY,
                p.apartZ(a.collider, b.collider) + wayZ,
                bounds.margin(a.collider, b.collider, reach, thin),
                0,
                manifold);
        if (manifold.pointCount == 0) {
            return;
        }
        ContactStore c = contacts;
        c.cache[row] = 0;
        c.keeps[row] = false;
        points.store(row, manifold, scratch);
        double nx = c.normalX(row);
        double ny = c.normalY(row);
        double nz = c.normalZ(row);
        double dx = p.apartX(a.collider, b.collider) + wayX;
        double dy = p.apartY(a.collider, b.collider) + wayY;
        double dz = p.apartZ(a.collider, b.collider) + wayZ;
        for (int k = 0; k < manifold.pointCount; k++) {
            int q = ContactStore.POINTS * row + k;
            double x = manifold.pointX[k];
            double y = manifold.pointY[k];
            double z = manifold.pointZ[k];
            a.back(x, y, z, v);
            double rx = v[0];
            double ry = v[1];
            double rz = v[2];
            double moved = nx * a.movedX + ny * a.movedY + nz * a.movedZ;
            b.back(x - dx, y - dy, z - dz, v);
            moved = nx * b.movedX + ny * b.movedY + nz * b.movedZ - moved;
            c.setAnchors(q, rx, ry, rz, v[0], v[1], v[2]);
            c.separation[q] = manifold.separation[k] - moved;
        }
    }

    /** One collider of the pair. */
    private final class Side {
        private final double[] turned = new double[3];
        private final double[] turn = new double[4];
        private int collider;
        private Shape shape = HalfSpace.of();
        private boolean isBall;

        /** Velocity of the body's centre at the start, m/s, and acceleration, m/s². */
        private double vx, vy, vz, ax, ay, az;

        private double wx, wy, wz;

        /** From the body's centre to the collider's at the start; all 0 for most. */
        private double leverX, leverY, leverZ;

        private double sx, sy, sz, sw;

        /**
         * Angular speed; surface speed of turning; size; inner radius; what the path of turning is
         * uncertain by.
         */
        private double spin, rim, size, inner, doubt;

        /** At a time: how far the collider's centre has moved; its orientation; its body's turn. */
        private double x, y, z, qx, qy, qz, qw, tx, ty, tz, tw;

        /** How far the point of the last {@link #back} has moved. */
        private double movedX, movedY, movedZ;

        void set(int slot) {
            collider = slot;
            shape = colliders.shape[slot];
            BodyStore s = colliders.bodies;
            int body = colliders.body[slot];
            isBall = s.isBall[body];
            vx = s.velocityX[body];
            vy = s.velocityY[body];
            vz = s.velocityZ[body];
            wx = s.angularVelocityX[body];
            wy = s.angularVelocityY[body];
            wz = s.angularVelocityZ[body];
            boolean isChild = colliders.isChild(slot);
            leverX = isChild ? s.apartX(body, slot) : 0;
            leverY = isChild ? s.apartY(body, slot) : 0;
            leverZ = isChild ? s.apartZ(body, slot) : 0;
            // what is ahead is of the collider's centre, which turns with the body
            boolean isDynamic = s.kind[body] == BodyStore.DYNAMIC;
            int at = BoundsStage.AHEAD * slot;
            ax = isDynamic ? (bounds.ahead[at] - wy * leverZ + wz * leverY - vx) / step : 0;
            ay = isDynamic ? (bounds.ahead[at + 1] - wz * leverX + wx * leverZ - vy) / step : 0;
            az = isDynamic ? (bounds.ahead[at + 2] - wx * leverY + wy * leverX - vz) / step : 0;
            sx = s.orientationX[slot];
            sy = s.orientationY[slot];
            sz = s.orientationZ[slot];
            sw = s.orientationW[slot];
            spin = Math.sqrt(wx * wx + wy * wy + wz * wz);
            double lever = Math.sqrt(leverX * leverX + leverY * leverY + leverZ * leverZ);
            double outer = colliders.outerRadius[slot];
            inner = colliders.innerRadius[slot];
            boolean turns = spin > 0 && !isBall;
            rim = turns ? spin * (lever + outer) : 0;
            size = outer < Double.POSITIVE_INFINITY ? outer : 0;
            // a body without symmetry changes its axis as it turns
            double angle = spin * step;
            doubt = turns && isDynamic ? 0.125 * angle * angle * inner : 0;
        }

        /** Where it is after a time. */
        void move(double t) {
            x = t * (vx + 0.5 * t * ax);
            y = t * (vy + 0.5 * t * ay);
            z = t * (vz + 0.5 * t * az);
            turn(t);
            qx = tw * sx + tx * sw + ty * sz - tz * sy;
            qy = tw * sy - tx * sz + ty * sw + tz * sx;
            qz = tw * sz + tx * sy - ty * sx + tz * sw;
            qw = tw * sw - tx * sx - ty * sy - tz * sz;
            if (leverX != 0 || leverY != 0 || leverZ != 0) {
                Rotations.rotate(tx, ty, tz, tw, leverX, leverY, leverZ, turned);
                x += turned[0] - leverX;
                y += turned[1] - leverY;
                z += turned[2] - leverZ;
            }
        }

        private void turn(double t) {
            if (spin == 0) {
                tx = ty = tz = 0;
                tw = 1;
                return;
            }
            Rotations.turn(wx, wy, wz, spin, t, turn);
            tx = turn[0];
            ty = turn[1];
            tz = turn[2];
            tw = turn[3];
        }

        /** Where a point of now, from the collider's centre, was at the start, from the body's. */
        void back(double px, double py, double pz, double[] out) {
            // from the body's centre now
            Rotations.rotate(tx, ty, tz, tw, leverX, leverY, leverZ, turned);
            double rx = px + turned[0];
            double ry = py + turned[1];
            double rz = pz + turned[2];
            Rotations.rotate(-tx, -ty, -tz, tw, rx, ry, rz, out);
            movedX = x - (turned[0] - leverX) + rx - out[0];
            movedY = y - (turned[1] - leverY) + ry - out[1];
            movedZ = z - (turned[2] - leverZ) + rz - out[2];
        }
    }
}
