package dev.cairn.physics;

import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.Shape;

/**
 * What a body is, changed while the world lives: type, shape, material, mass. The slot is alive.
 *
 * <p>What can be refused is refused before anything changes. The frame of the shape stays where it
 * is; if the centre of mass moves in it, the body goes on as the same rigid motion.
 */
final class BodyChanges {
    private final BodyTable table;
    private final BodyStore bodies;
    private final double[] arm = new double[3];

    BodyChanges(BodyTable table) {
        this.table = table;
        bodies = table.bodies;
    }

    void setType(int s, BodyType type) {
        if (table.access.type(s) == type) {
            return;
        }
        MassProperties mass =
                BodyTable.mass(table.shapes[s], table.materials[s], type, stated(s, 0), inertia(s));
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
        apply(s, type, mass);
        table.roster.changed(s);
    }

    void setShape(int s, Shape shape) {
        BodyType type = table.access.type(s);
        MassProperties mass =
                BodyTable.mass(shape, table.materials[s], type, stated(s, 0), inertia(s));
        wakeAround(s);
        table.shapes[s] = shape;
        bodies.innerRadius[s] = shape.innerRadius();
        bodies.outerRadius[s] = shape.outerRadius();
        table.colliders.replace(bodies.collider[s], shape);
        apply(s, type, mass);
        table.contacts.forget(s);
        table.roster.changed(s);
    }

    void setMaterial(int s, Material material) {
        BodyType type = table.access.type(s);
        MassProperties mass =
                BodyTable.mass(table.shapes[s], material, type, stated(s, 0), inertia(s));
        wakeAround(s);
        table.materials[s] = material;
        ColliderStore k = table.colliders;
        for (int c = bodies.collider[s]; c != ColliderStore.NONE; c = k.next[c]) {
            k.friction[c] = material.friction();
            k.restitution[c] = material.restitution();
            k.rollingArm[c] = material.rollingArm();
        }
        if (material.rollingArm() > 0) {
            table.contacts.beginRolling();
        }
        ContactStore rows = table.contacts;
        for (int row = 0; row < rows.count; row++) {
            if (rows.bodyA[row] == s || rows.bodyB[row] == s) {
                rows.mix(row, k);
            }
        }
        apply(s, type, mass);
    }

    void setMass(int s, double kilograms) {
        MassProperties mass =
                BodyTable.mass(
                        table.shapes[s],
                        table.materials[s],
                        table.access.type(s),
                        kilograms,
                        inertia(s));
        wakeAround(s);
        table.stated[4 * s] = kilograms;
        apply(s, table.access.type(s), mass);
    }

    void setInertia(int s, double xx, double yy, double zz) {
        Body.checkInertia(xx, yy, zz);
        double[] stated = {xx, yy, zz};
        MassProperties mass =
                BodyTable.mass(
                        table.shapes[s],
                        table.materials[s],
                        table.access.type(s),
                        stated(s, 0),
                        stated);
        wakeAround(s);
        System.arraycopy(stated, 0, table.stated, 4 * s + 1, 3);
        apply(s, table.access.type(s), mass);
    }

    private double stated(int s, int at) {
        return table.stated[4 * s + at];
    }

    private double[] inertia(int s) {
        return new double[] {stated(s, 1), stated(s, 2), stated(s, 3)};
    }

    /** Mass and centre; the velocity is that of the body's new centre, {@code v + w x d}. */
    private void apply(int s, BodyType type, MassProperties mass) {
        BodyStore b = bodies;
        rotate(s, table.roster.comX[s], table.roster.comY[s], table.roster.comZ[s]);
        double x = arm[0];
        double y = arm[1];
        double z = arm[2];
        table.setMass(s, type, mass);
        rotate(s, mass.comX(), mass.comY(), mass.comZ());
        double dx = arm[0] - x;
        double dy = arm[1] - y;
        double dz = arm[2] - z;
        if (dx != 0 || dy != 0 || dz != 0) {
            b.move(s, dx, dy, dz);
            b.velocityX[s] += b.angularVelocityY[s] * dz - b.angularVelocityZ[s] * dy;
            b.velocityY[s] += b.angularVelocityZ[s] * dx - b.angularVelocityX[s] * dz;
            b.velocityZ[s] += b.angularVelocityX[s] * dy - b.angularVelocityY[s] * dx;
        }
        // what was learnt of its loads was another body's
        b.inertiaScale[s] = 0;
        b.restTicks[s] = 0;
    }

    private void rotate(int s, double x, double y, double z) {
        Rotations.rotate(
                bodies.orientationX[s],
                bodies.orientationY[s],
                bodies.orientationZ[s],
                bodies.orientationW[s],
                x,
                y,
                z,
                arm);
    }

    /** The body, and whoever has a contact with it, which may be asleep on a fixed one. */
    private void wakeAround(int s) {
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
