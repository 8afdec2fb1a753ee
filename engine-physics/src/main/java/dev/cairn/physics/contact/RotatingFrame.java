package dev.cairn.physics.contact;

import dev.cairn.physics.contact.impact.ImpactStage;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.internal.Rotations;

import org.jspecify.annotations.Nullable;

/**
 * Ways of colliders in a tick, and where something was, as seen from a body that has turned within
 * it: as it would lie now if it had turned with the body. Simulation thread, but for the ways;
 * allocates only when something grows.
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

    private @Nullable ImpactStage impacts;
    private double step;

    /** By body slot, of bodies of several shapes: orientation at the start of the tick. */
    private double[] began = {};

    RotatingFrame(ColliderStore colliders, BoundsStage bounds) {
        this.colliders = colliders;
        this.bounds = bounds;
    }

    /** Keeps how bodies of several shapes lie; before the solve. */
    void begin() {
        int count = colliders.compoundCount;
        BodyStore s = colliders.bodies;
        if (count > 0 && began.length < 4 * s.slotCount) {
            began = new double[4 * (s.slotCount + (s.slotCount >> 1))];
        }
        for (int i = 0; i < count; i++) {
            int body = colliders.compound[i];
            began[4 * body] = s.orientationX[body];
            began[4 * body + 1] = s.orientationY[body];
            began[4 * body + 2] = s.orientationZ[body];
            began[4 * body + 3] = s.orientationW[body];
        }
    }

    /** The tick in work: which bodies were struck in it, and its length, s. */
    void use(@Nullable ImpactStage struck, double stepSeconds) {
        impacts = struck;
        step = stepSeconds;
    }

    /** How far a collider's centre has gone in the tick, or since it was struck; m, world. */
    double wayX(int c) {
        return colliders.poses.positionX[c] - bounds.start[3 * c];
    }

    /** See {@link #wayX}. */
    double wayY(int c) {
        return colliders.poses.positionY[c] - bounds.start[3 * c + 1];
    }

    /** See {@link #wayX}. */
    double wayZ(int c) {
        return colliders.poses.positionZ[c] - bounds.start[3 * c + 2];
    }

    /** The length of {@link #wayX}, {@link #wayY}, {@link #wayZ}. */
    double way(int c) {
        double x = wayX(c);
        double y = wayY(c);
        double z = wayZ(c);
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** The share of the tick after which a collider was struck last. */
    double late(int c) {
        return impacts == null ? 0 : impacts.late(colliders.body[c]);
    }

    /** Whether a body may have another place or orientation than at the tick's start. */
    boolean moves(int body) {
        return colliders.bodies.kind[body] == BodyStore.DYNAMIC || colliders.bodies.isMoved(body);
    }

    /**
     * From where the way of a part's centre begins to the other collider's centre, as seen from
     * that: into {@code out}, world, m. False if it turns too far to tell.
     */
    boolean see(int part, int other, double[] out) {
        Poses p = colliders.poses;
        // a body that was struck is looked at from there on
        double from = Math.max(late(part), late(other));
        double mine = since(part, from);
        int body = colliders.body[other];
        double its = moves(body) ? since(other, from) : 0;
        out[0] = p.apartX(part, other) - its * wayX(other) + mine * wayX(part);
        out[1] = p.apartY(part, other) - its * wayY(other) + mine * wayY(part);
        out[2] = p.apartZ(part, other) - its * wayZ(other) + mine * wayZ(part);
        return turn(body, from, out);
    }

    /** The share of a collider's way that it goes from a share of the tick on. */
    private double since(int c, double from) {
        double start = late(c);
        return from > start ? (1 - from) / (1 - start) : 1;
    }

    /**
     * Turns a point with a body.
     *
     * @param body slot of the body that is looked from
     * @param from share of the tick from which on it turns
     * @param seen from the body's centre to the point, world axes, m; turned
     * @return false if the body turns too far
     */
    private boolean turn(int body, double from, double[] seen) {
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
        ImpactStage struck = impacts;
        if (struck == null || !struck.lay(body, from, q)) {
            if (from > 0 || !isDynamic) {
                Rotations.turn(wx, wy, wz, spin, seconds, q);
                rotate(q[0], q[1], q[2], q[3], seen);
                return true;
            }
            if (s.collider[body] == body) {
                System.arraycopy(bounds.began, BoundsStage.POSE * body + 3, q, 0, 4);
            } else {
                System.arraycopy(began, 4 * body, q, 0, 4);
            }
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
