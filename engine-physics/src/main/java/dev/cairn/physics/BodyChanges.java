package dev.cairn.physics;

import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.MassOverride;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.Shape;

import java.util.List;

/**
 * What a body is, changed while the world lives: type, shape, material, mass. The slot is alive.
 *
 * <p>What can be refused is refused before anything changes. The frame of the shape stays where it
 * is; if the centre of mass moves in it, the body goes on as the same rigid motion.
 */
final class BodyChanges {
    private final BodyTable table;
    private final BodyStore bodies;

    BodyChanges(BodyTable table) {
        this.table = table;
        bodies = table.bodies;
    }

    void setType(int s, BodyType type) {
        if (table.access.type(s) == type) {
            return;
        }
        boolean moves = type == BodyType.DYNAMIC;
        MassProperties mass = table.collision.massAs(s, !moves);
        long entity = bodies.entity[s];
        boolean wasFixed = table.access.isFixed(s);
        wakeAround(s);
        // the ECS first: if it refuses, nothing has changed
        if (wasFixed) {
            if (!table.world().has(entity, Velocity.COMPONENT)) {
                table.world().add(entity, Velocity.ZERO);
            }
            table.release(s);
        } else if (type == BodyType.FIXED) {
            table.world().remove(entity, Velocity.COMPONENT);
            bodies.stop(s);
        }
        bodies.kind[s] = BodyTable.kind(type);
        table.collision.settle(s, mass);
        learn(s);
        table.registry.retyped(s);
    }

    void setShape(int s, Shape shape) {
        int c = bodies.collider[s];
        if (table.colliders.next[c] != ColliderStore.NONE) {
            throw new IllegalStateException(
                    table.refs[s]
                            + " has several colliders; choose one of colliders() and replace that");
        }
        if (table.collision.edit(c, table.collision.now(c).reshaped(shape))) {
            return;
        }
        wakeAround(s);
        table.collision.replace(c, Collider.of(shape));
        table.contacts.forget(s);
        learn(s);
    }

    void setMaterial(int s, Material material) {
        Checks.notNull("material", material);
        ColliderTable collision = table.collision;
        List<Collider> parts = collision.parts(s);
        if (parts.stream().allMatch(part -> part.material().equals(material))) {
            return;
        }
        parts.replaceAll(part -> part.material(material));
        MassProperties mass = collision.massNow(s, parts);
        wakeAround(s);
        for (ColliderRef part : collision.list(s)) {
            collision.applyMaterial(part.slot(), material);
        }
        collision.settle(s, mass);
        learn(s);
    }

    void setMass(int s, double kilograms) {
        state(s, table.collision.stated(s).withMass(kilograms));
    }

    void setInertia(int s, double xx, double yy, double zz) {
        Checks.inertia(xx, yy, zz);
        state(s, table.collision.stated(s).withInertia(xx, yy, zz));
    }

    void setCentreOfMass(int s, double x, double y, double z) {
        Checks.finite("centre x", x);
        Checks.finite("centre y", y);
        Checks.finite("centre z", z);
        state(s, table.collision.stated(s).withCentre(x, y, z));
    }

    void setCanSleep(int s, boolean may) {
        table.staysAwake[s] = !may;
        table.sleepers.allow(s, may);
        if (!may) {
            table.sleepers.wake(s);
        }
    }

    /** The mass of a body that does not move concerns no other. */
    private void state(int s, MassOverride mass) {
        if (table.access.type(s) == BodyType.DYNAMIC) {
            wakeAround(s);
        }
        table.collision.state(s, mass);
        learn(s);
    }

    /** What was learnt of the body's loads was another body's. */
    private void learn(int s) {
        bodies.inertiaScale[s] = 0;
        bodies.restTicks[s] = 0;
    }

    /** The body, and those that have a contact with it, which may be asleep on a fixed one. */
    void wakeAround(int s) {
        table.sleepers.wake(s);
        ContactStore rows = table.contacts;
        for (int row = 0; table.sleepers.asleepCount() > 0 && row < rows.count; row++) {
            if (rows.isSolved(row) && (rows.bodyA[row] == s || rows.bodyB[row] == s)) {
                table.sleepers.wake(rows.bodyA[row]);
                table.sleepers.wake(rows.bodyB[row]);
            }
        }
    }
}
