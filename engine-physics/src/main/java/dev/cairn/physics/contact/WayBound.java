package dev.cairn.physics.contact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.KineticEnergy;

/**
 * How far points of two colliders pass each other in a tick at most, from what bodies have at hand:
 * for those that need no search if they go less far than they are thick.
 *
 * <p>A body that nothing turns keeps its energy E, so with the least moment I
 *
 * <pre>
 *   |w|² &lt;= 2E/I,  1/I &lt;= trace J        |dw/dt| &lt;= |w|²/sqrt(3)
 * </pre>
 *
 * and a point at the distance R is no faster than the centre and R |w|. One per worker.
 */
final class WayBound {
    /** 1 + 1/sqrt(3), rounded up: what a point is bent by turning and by the change of w. */
    private static final double BEND = 1.5774;

    /** More than rounding takes. */
    private static final double SURE = 1 - 0x1p-30;

    private final ColliderStore colliders;
    private final BoundsStage bounds;
    private final double[] w = new double[3];

    WayBound(ColliderStore colliders, BoundsStage bounds) {
        this.colliders = colliders;
        this.bounds = bounds;
    }

    /**
     * Whether two colliders of free bodies surely go less far than they are thick; false says
     * nothing. See {@link SweptPair#isShort}.
     */
    boolean isShort(int a, int b, double step) {
        if (colliders.isChild(a) || colliders.isChild(b)) {
            return false;
        }
        BodyStore s = colliders.bodies;
        int i = colliders.body[a];
        int j = colliders.body[b];
        double thin = Math.min(colliders.innerRadius[a], colliders.innerRadius[b]);
        double x = s.velocityX[i] - s.velocityX[j];
        double y = s.velocityY[i] - s.velocityY[j];
        double z = s.velocityZ[i] - s.velocityZ[j];
        double centres = Math.sqrt(x * x + y * y + z * z) + step * (fall(i) + fall(j));
        return step * (centres + surface(a, i, step) + surface(b, j, step)) <= SURE * thin;
    }

    private double fall(int body) {
        BodyStore s = colliders.bodies;
        if (s.kind[body] != BodyStore.DYNAMIC) {
            return 0;
        }
        double scale = s.gravityScale[body];
        double light = s.inverseMass[body];
        return Math.abs(scale * bounds.gravityX + light * s.forceX[body])
                + Math.abs(scale * bounds.gravityY + light * s.forceY[body])
                + Math.abs(scale * bounds.gravityZ + light * s.forceZ[body]);
    }

    /** How fast turning moves a surface, and what that may become within a tick, m/s. */
    private double surface(int collider, int body, double step) {
        BodyStore s = colliders.bodies;
        double x = s.angularVelocityX[body];
        double y = s.angularVelocityY[body];
        double z = s.angularVelocityZ[body];
        double square = x * x + y * y + z * z;
        if (square == 0) {
            return 0;
        }
        if (s.kind[body] == BodyStore.DYNAMIC) {
            square = mostSquare(body);
        }
        return (Math.sqrt(square) + BEND * square * step) * colliders.outerRadius[collider];
    }

    /** {@code 2E trace J}. */
    private double mostSquare(int body) {
        BodyStore s = colliders.bodies;
        return 2
                * KineticEnergy.ofTurning(s, body, w)
                * (s.inverseInertiaXX[body] + s.inverseInertiaYY[body] + s.inverseInertiaZZ[body]);
    }
}
