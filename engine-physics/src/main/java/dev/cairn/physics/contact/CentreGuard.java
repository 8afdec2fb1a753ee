package dev.cairn.physics.contact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

/**
 * The centre of mass of a convex body does not pass what does not answer to it, however fast the
 * body is and whatever its contacts did.
 *
 * <p>A contact has the points of one moment. A stick that strikes with a tip at a thousand metres a
 * second turns about it by many rounds within the tick, and its contacts know of none. So the way
 * of the centre over the whole tick is looked at afterwards; where it meets the other surface, the
 * body stops there, and loses the rest of the tick and the speed at which it went in. Only bodies
 * that cover more than a part of their inner radius in a tick; of these, in almost all cases,
 * contacts have done it, and nothing is changed.
 */
final class CentreGuard {
    /** Of the inner radius: what covers less in a tick is not looked at. */
    private static final double FAST = 0.5;

    /** Of the inner radius: how far the centre stays away. */
    private static final double AWAY = 0.25;

    private static final int MOST_STEPS = 64;

    private static final Shape POINT = Sphere.of(1e-50);

    private final ColliderStore colliders;
    private final NarrowPhase narrowPhase = new NarrowPhase();

    CentreGuard(ColliderStore colliders) {
        this.colliders = colliders;
    }

    /**
     * Whether the body of a row is to be looked at after the solve.
     *
     * @return 0 if not; 1 if it is body A, 2 if it is B
     */
    byte watches(ContactStore c, int row, double step) {
        BodyStore s = colliders.bodies;
        int a = c.bodyA[row];
        int b = c.bodyB[row];
        boolean movesA = s.kind[a] == BodyStore.DYNAMIC;
        boolean movesB = s.kind[b] == BodyStore.DYNAMIC;
        if (movesA == movesB) {
            return 0;
        }
        int body = movesA ? a : b;
        if (colliders.isChild(movesA ? c.colliderA[row] : c.colliderB[row])) {
            return 0;
        }
        double v = length(s.velocityX[body], s.velocityY[body], s.velocityZ[body]);
        double w =
                length(
                        s.angularVelocityX[body],
                        s.angularVelocityY[body],
                        s.angularVelocityZ[body]);
        double inner = colliders.innerRadius[body];
        double turn = Math.max(0, colliders.outerRadius[body] - 2 * inner);
        return step * (v + w * turn) > FAST * inner ? (byte) (movesA ? 1 : 2) : 0;
    }

    private static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }

    /**
     * Looks at the way of a body's centre, as seen from the other collider's centre.
     *
     * @param body a dynamic one
     * @param other a collider that is where it is at the end of the tick
     * @param from where the other one's centre was from the body's, at the start, three numbers
     */
    void keepOut(int body, int other, double[] from, int at) {
        Poses p = colliders.poses;
        double x = from[at];
        double y = from[at + 1];
        double z = from[at + 2];
        double wayX = p.apartX(body, other) - x;
        double wayY = p.apartY(body, other) - y;
        double wayZ = p.apartZ(body, other) - z;
        double inner = colliders.innerRadius[body];
        double square = wayX * wayX + wayY * wayY + wayZ * wayZ;
        if (!(square > FAST * FAST * inner * inner)) {
            return;
        }
        double away = Math.min(AWAY * inner, 0.5 * distance(other, x, y, z));
        if (!(away > 0)) {
            return;
        }
        double t = 0;
        for (int i = 0; i < MOST_STEPS; i++) {
            double d = distance(other, x + t * wayX, y + t * wayY, z + t * wayZ) - away;
            if (d <= 0x1p-20 * inner) {
                break;
            }
            // the point sees the other one come
            double nx = narrowPhase.axisX();
            double ny = narrowPhase.axisY();
            double nz = narrowPhase.axisZ();
            double closing = -(nx * wayX + ny * wayY + nz * wayZ);
            if (!(closing > 0) || t + d / closing >= 1) {
                return;
            }
            t += d / closing;
        }
        stop(body, wayX, wayY, wayZ, 1 - t);
    }

    private double distance(int other, double x, double y, double z) {
        Poses p = colliders.poses;
        return narrowPhase.distance(
                POINT,
                colliders.shape[other],
                0,
                0,
                0,
                1,
                p.orientationX[other],
                p.orientationY[other],
                p.orientationZ[other],
                p.orientationW[other],
                x,
                y,
                z);
    }

    /** Takes the rest of its way from a body, and what goes in of its velocity. */
    private void stop(int body, double wayX, double wayY, double wayZ, double rest) {
        BodyStore s = colliders.bodies;
        s.move(body, rest * wayX, rest * wayY, rest * wayZ);
        double nx = narrowPhase.axisX();
        double ny = narrowPhase.axisY();
        double nz = narrowPhase.axisZ();
        double in = nx * s.velocityX[body] + ny * s.velocityY[body] + nz * s.velocityZ[body];
        if (in > 0) {
            s.velocityX[body] -= in * nx;
            s.velocityY[body] -= in * ny;
            s.velocityZ[body] -= in * nz;
        }
    }
}
