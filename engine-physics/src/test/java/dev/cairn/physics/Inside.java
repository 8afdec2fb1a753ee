package dev.cairn.physics;

import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;

/** The stores behind the façade, for tests of other chapters. */
public final class Inside {
    private Inside() {}

    public static BodyStore bodies(PhysicsWorld world) {
        return world.physics.table.bodies;
    }

    public static ColliderStore colliders(PhysicsWorld world) {
        return world.physics.table.colliders;
    }

    public static ContactStore contacts(PhysicsWorld world) {
        return world.physics.contacts;
    }

    public static BroadPhase broadPhase(PhysicsWorld world) {
        return world.physics.table.broadPhase;
    }

    public static boolean filtersPairs(PhysicsWorld world) {
        return world.physics.table.registry.pairFilter.isActive();
    }

    public static int slot(BodyState body) {
        return body.slot();
    }

    public static int slot(ColliderRef collider) {
        return collider.slot();
    }
}
