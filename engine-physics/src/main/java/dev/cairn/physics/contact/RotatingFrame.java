package dev.cairn.physics.contact;

import dev.cairn.physics.contact.impact.ImpactStage;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.Rotations;

import org.jspecify.annotations.Nullable;

/**
 * Where something was, as seen from a body that has turned within the tick: as it would lie now if
 * it had turned with the body. Simulation thread; allocates nothing.
 */
final class RotatingFrame {
    /**
     * Of a body that contacts can move, rad: beyond, the chord does not tell where one was seen
     * from it.
     */
    private static final double TURN = 1;

    /** cos(TURN / 2). */
    private static final double COS_HALF_TURN = 0.8775825618903728;

    private final ColliderStore colliders;
    private final BoundsStage bounds;
    private final double[] turned = new double[4];

    RotatingFrame(ColliderStore colliders, BoundsStage bounds) {
        this.colliders = colliders;
        this.bounds = bounds;
    }

    /** Whether a body may have another place or orientation than at the tick's start. */
    boolean moves(int body) {
        return colliders.bodies.kind[body] == BodyStore.DYNAMIC || colliders.bodies.isMoved(body);
    }

    /**
     * Turns a point with a body.
     *
     * @param body slot of the body that is looked from
     * @param from share of the tick from which on it turns
     * @param step of the tick, s
     * @param impacts the bodies that were struck within the tick
     * @param seen from the body's centre to the point, world axes, m; turned
     * @return false if the body turns too far
     */
    boolean turn(int body, double from, double step, @Nullable ImpactStage impacts, double[] seen) {
        BodyStore s = colliders.bodies;
        double wx = s.angularVelocityX[body];
        double wy = s.angularVelocityY[body];
        double wz = s.angularVelocityZ[body];
        double spin = Math.sqrt(wx * wx + wy * wy + wz * wz);
        double seconds = step * (1 - from);
        if (!moves(body) || spin == 0) {
            return true;
        }
        boolean isDynamic = s.kind[body] == BodyStore.DYNAMIC;
        if (!(seconds * spin < TURN)) {
            return !isDynamic;
        }
        double[] q = turned;
        if (impacts == null || !impacts.lay(body, from, q)) {
            // of bodies of several shapes nothing was kept
            if (from > 0 || s.collider[body] != body) {
                Rotations.turn(wx, wy, wz, spin, seconds, q);
                rotate(q[0], q[1], q[2], q[3], seen);
                return true;
            }
            System.arraycopy(bounds.began, BoundsStage.POSE * body + 3, q, 0, 4);
        }
        // a body that turns slowly now may have turned fast before an impact within the tick
        if (isDynamic && !(Math.abs(cosHalfTurn(q, body)) > COS_HALF_TURN)) {
            return false;
        }
        rotate(-q[0], -q[1], -q[2], q[3], seen);
        rotate(
                s.orientationX[body],
                s.orientationY[body],
                s.orientationZ[body],
                s.orientationW[body],
                seen);
        return true;
    }

    /** Cosine of half the angle between an orientation and that of a body. */
    private double cosHalfTurn(double[] q, int body) {
        BodyStore s = colliders.bodies;
        return q[0] * s.orientationX[body]
                + q[1] * s.orientationY[body]
                + q[2] * s.orientationZ[body]
                + q[3] * s.orientationW[body];
    }

    private static void rotate(double x, double y, double z, double w, double[] seen) {
        Rotations.rotate(x, y, z, w, seen[0], seen[1], seen[2], seen);
    }
}
