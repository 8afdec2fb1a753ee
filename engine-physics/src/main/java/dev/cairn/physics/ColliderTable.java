package dev.cairn.physics;

import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.broadphase.PairFilter;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.ColliderStore;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiPredicate;

/**
 * The colliders as users know them, by slot: references, filters, who was taken apart. Simulation
 * thread, between steps.
 */
final class ColliderTable {
    final ColliderStore colliders;
    final PairFilter pairFilter;
    private final BodyTable table;
    private final BroadPhase broadPhase;

    /** Made when somebody asks. */
    private @Nullable ColliderRef[] refs = {};

    ColliderTable(BodyTable table) {
        this.table = table;
        colliders = table.colliders;
        broadPhase = table.broadPhase;
        pairFilter = table.roster.pairFilter;
    }

    /** The reference to a collider that exists; allocates when it is asked for the first time. */
    ColliderRef ref(int collider) {
        if (refs.length <= collider) {
            refs = Arrays.copyOf(refs, colliders.body.length);
        }
        ColliderRef ref = refs[collider];
        if (ref == null || !ref.isAlive()) {
            ref =
                    new ColliderRef(
                            this,
                            table.refs[colliders.body[collider]],
                            collider,
                            colliders.generation[collider]);
            refs[collider] = ref;
        }
        return ref;
    }

    List<ColliderRef> list(int body) {
        List<ColliderRef> list = new ArrayList<>();
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            list.add(ref(c));
        }
        return list;
    }

    // Whom to collide with -----------------------------------------------------------------------

    void setFilter(int collider, Filter filter) {
        Checks.notNull("filter", filter);
        if (filter.equals(colliders.filter[collider])) {
            return;
        }
        colliders.filter[collider] = filter;
        pairFilter.begin();
        broadPhase.refilter(collider);
    }

    void setFilters(int body, Filter filter) {
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            setFilter(c, filter);
        }
    }

    void ask(@Nullable BiPredicate<ColliderRef, ColliderRef> test) {
        pairFilter.ask(test == null ? null : (a, b) -> test.test(ref(a), ref(b)));
        for (int c = 0; c < colliders.slotCount; c++) {
            broadPhase.refilter(c);
        }
    }

    /** The seam of joints: counted, since several may bind the same two bodies. */
    void apart(int bodyA, int bodyB) {
        if (pairFilter.apart(bodyA, bodyB)) {
            refilter(bodyA);
        }
    }

    /** Takes back one {@link #apart}; also for a body that is leaving. */
    void together(int bodyA, int bodyB) {
        if (pairFilter.together(bodyA, bodyB)) {
            refilter(bodyA);
            refilter(bodyB);
        }
    }

    private void refilter(int body) {
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            broadPhase.refilter(c);
        }
    }
}
