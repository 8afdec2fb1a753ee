package dev.cairn.physics.state;

import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.broadphase.PairFilter;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.ColliderStore;

/**
 * Changes, while the world runs, of which pairs collide: what is told to {@link PairFilter} has the
 * pairs that it concerns filtered anew. Simulation thread, between steps; makes no garbage.
 */
public final class PairRules {
    private final ColliderStore colliders;
    private final PairFilter pairFilter;
    private final BroadPhase broadPhase;

    /** Of the pairs that a tree finds. */
    public PairRules(ColliderStore colliders, PairFilter pairFilter, BroadPhase broadPhase) {
        this.colliders = colliders;
        this.pairFilter = pairFilter;
        this.broadPhase = broadPhase;
    }

    /** Another filter of a collider. */
    public void setFilter(int collider, Filter filter) {
        Checks.notNull("filter", filter);
        if (filter.equals(colliders.filter[collider])) {
            return;
        }
        colliders.filter[collider] = filter;
        pairFilter.begin();
        broadPhase.refilter(collider);
    }

    /** Another filter of all colliders of a body. */
    public void setFilters(int body, Filter filter) {
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            setFilter(c, filter);
        }
    }

    /** All pairs are asked anew. */
    public void renew() {
        for (int c = 0; c < colliders.slotCount; c++) {
            broadPhase.refilter(c);
        }
    }

    /** The seam of joints: counted, since several may bind the same two bodies. */
    public void apart(int bodyA, int bodyB) {
        if (pairFilter.apart(bodyA, bodyB)) {
            refilter(canMove(bodyA) ? bodyA : bodyB);
        }
    }

    /** Takes back one {@link #apart}; also for a body that is leaving. */
    public void together(int bodyA, int bodyB) {
        if (pairFilter.together(bodyA, bodyB)) {
            if (canMove(bodyA) || !canMove(bodyB)) {
                refilter(bodyA);
            }
            if (canMove(bodyB) || !canMove(bodyA)) {
                refilter(bodyB);
            }
        }
    }

    /** Whether forces move a body. Asking a floor anew would wake all that lies on it. */
    public boolean canMove(int body) {
        byte kind = colliders.bodies.kind[body];
        return kind == BodyStore.DYNAMIC || kind == BodyStore.ASLEEP;
    }

    private void refilter(int body) {
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            broadPhase.refilter(c);
        }
    }
}
