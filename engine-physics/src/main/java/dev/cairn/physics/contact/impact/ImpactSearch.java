package dev.cairn.physics.contact.impact;

import dev.cairn.physics.broadphase.AabbTree;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.broadphase.RayTraversal;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;

/**
 * Looks in the trees for the colliders that a struck body meets in the rest of the tick, and puts
 * them into the queue.
 */
final class ImpactSearch {
    private final ColliderStore colliders;
    private final StruckBodies bodies;
    private final MovingPair pair;
    private final ImpactQueue queue;
    private final RayTraversal walk = new RayTraversal();
    private final double[] box = new double[6];

    // the tick in work
    private BroadPhase broadPhase = new BroadPhase();
    private double[] start = {};
    private double step;

    ImpactSearch(ColliderStore colliders, StruckBodies bodies, MovingPair pair, ImpactQueue queue) {
        this.colliders = colliders;
        this.bodies = bodies;
        this.pair = pair;
        this.queue = queue;
    }

    void begin(BroadPhase boxes, double[] starts, double stepSeconds) {
        broadPhase = boxes;
        start = starts;
        step = stepSeconds;
    }

    /** Looks for what a body that was struck meets in the rest of the tick. */
    void follow(int body, double time) {
        BodyStore s = colliders.bodies;
        if (s.kind[body] != BodyStore.DYNAMIC || bodies.closed[body] || bodies.free[body] != 0) {
            return;
        }
        double rest = step - time;
        double x = s.velocityX[body];
        double y = s.velocityY[body];
        double z = s.velocityZ[body];
        // whatever accelerates it, it is no farther from the straight line than this
        double bend = pair.bend(body) * step * step;
        double reachOut = colliders.outerRadius[body] + bend;
        double speed = Math.sqrt(x * x + y * y + z * z);
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = start[3 * body + axis] - reachOut;
            box[axis + 3] = start[3 * body + axis] + reachOut;
        }
        double way = speed * rest;
        double inverse = speed > 0 ? 1 / speed : 0;
        for (int tree = 0; tree < 2; tree++) {
            walk.start(
                    tree == 0 ? broadPhase.staticTree() : broadPhase.dynamicTree(),
                    box,
                    x * inverse,
                    y * inverse,
                    z * inverse);
            for (int other = walk.next(way); other != AabbTree.NONE; other = walk.next(way)) {
                if (bodies.impacts[colliders.body[other]] == 0) {
                    look(body, other, time);
                }
            }
        }
        for (int i = 0; i < bodies.count; i++) {
            look(body, bodies.list[i], time);
        }
        for (int i = 0; i < broadPhase.endlessCount(); i++) {
            look(body, broadPhase.endless()[i], time);
        }
    }

    private void look(int collider, int other, double time) {
        int body = colliders.body[other];
        if (body == collider
                || isOutOfReach(collider, other, time)
                || isPartner(collider, other)
                || bodies.closed[body]
                || colliders.sensor[other]
                || !bodies.fits(collider, other)
                || !broadPhase.admits(collider, other)) {
            return;
        }
        int a = Math.min(collider, other);
        int b = Math.max(collider, other);
        if (pair.meet(a, b, time, step) || pair.isUndecided()) {
            queue.add(
                    pair.time(),
                    a,
                    b,
                    bodies.impacts[colliders.body[a]],
                    bodies.impacts[colliders.body[b]],
                    bodies.row(colliders.body[a], a, b),
                    pair.isUndecided());
        }
    }

    /** Whether two that both were struck are too far apart to meet in the rest of the tick. */
    private boolean isOutOfReach(int collider, int other, double time) {
        BodyStore s = colliders.bodies;
        int body = colliders.body[other];
        if (bodies.impacts[body] == 0 || bodies.impacts[collider] == 0) {
            return false;
        }
        double vx = s.velocityX[body] - s.velocityX[collider];
        double vy = s.velocityY[body] - s.velocityY[collider];
        double vz = s.velocityZ[body] - s.velocityZ[collider];
        double x = s.apartX(collider, body) + time * vx;
        double y = s.apartY(collider, body) + time * vy;
        double z = s.apartZ(collider, body) + time * vz;
        double reachOut =
                colliders.outerRadius[collider]
                        + colliders.outerRadius[other]
                        + 2 * step * step * (pair.bend(collider) + pair.bend(body))
                        + (step - time) * Math.sqrt(vx * vx + vy * vy + vz * vz);
        return x * x + y * y + z * z > reachOut * reachOut;
    }

    /** Whether two have just struck each other: that pair is looked at by the caller. */
    private boolean isPartner(int collider, int other) {
        return (collider == queue.a && other == queue.b)
                || (collider == queue.b && other == queue.a);
    }
}
