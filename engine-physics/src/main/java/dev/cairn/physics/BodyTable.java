package dev.cairn.physics;

import dev.cairn.core.ecs.World;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.contact.BoundsStage;
import dev.cairn.physics.contact.StepLimits;
import dev.cairn.physics.internal.BodyMass;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.EdgeSource;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.island.SleepingBodies;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.state.AppliedForces;
import dev.cairn.physics.state.BodyRegistry;
import dev.cairn.physics.state.RigidBody;
import dev.cairn.physics.state.WorldCheck;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;

/**
 * The bodies of a world as users know them: a reference, a material and a shape to each slot of the
 * {@link BodyRegistry}; what is born is checked and filled in here.
 */
final class BodyTable implements Stateful {
    /** No entity. */
    private static final long NONE = 0;

    private static final BodyRef[] NO_BODIES = {};

    /** Of a kinematic body: room for some ticks until what the step computes with ends. */
    private static final double MOST_SPEED = 1e59;

    final BodyRegistry registry;
    final BodyStore bodies;
    final ColliderStore colliders;
    final BroadPhase broadPhase;
    final BoundsStage bounds;
    final SleepingBodies sleepers;
    final ContactStore contacts;
    final BodyAccess access;
    final AppliedForces forces;
    final BodyChanges changes;
    final ColliderTable collision;

    BodyRef[] refs = new BodyRef[0];

    /** Room to restore the references. */
    private BodyRef[] savedRefs = {};

    @Nullable Object[] userData = {};

    /** By slot: whether the body may not sleep. */
    boolean[] staysAwake = {};

    /** Bodies that were ever made. */
    long born;

    private final List<BodyRef> quarantined = new ArrayList<>();
    private boolean closed;

    /** The numbers of a body's contacts, as {@link PhysicsWorld#contacts} has them. */
    IntFunction<int[]> contactsOf = slot -> new int[0];

    /** While the physics runs nobody else may change a body; read by any thread. */
    volatile boolean isStepping;

    BodyTable(PhysicsSettings settings, ContactStore contacts, EdgeSource[] edges) {
        registry =
                new BodyRegistry(
                        settings.tuning(), settings.sleeping(), settings.sleepSeconds(), edges);
        bodies = registry.bodies;
        colliders = registry.colliders;
        broadPhase = registry.broadPhase;
        bounds = registry.bounds;
        sleepers = registry.sleepers;
        this.contacts = contacts;
        access = new BodyAccess(this);
        forces = new AppliedForces(registry);
        collision = new ColliderTable(this);
        changes = new BodyChanges(this);
    }

    World world() {
        return registry.world();
    }

    void close() {
        closed = true;
    }

    boolean isClosed() {
        return closed;
    }

    boolean isAlive(int slot, long entity) {
        return !closed && registry.isAlive(slot, entity);
    }

    // Birth ------------------------------------------------------------------------------------

    /** A body with an entity of its own. */
    BodyRef add(Body body) {
        return add(body, NONE);
    }

    /**
     * Everything that can fail happens before anything changes.
     *
     * @param given the entity that becomes the body, or {@link #NONE} for a new one
     */
    BodyRef add(Body body, long given) {
        List<Collider> parts = body.parts();
        if (parts.isEmpty()) {
            throw new IllegalArgumentException(
                    "body"
                            + (body.name.isEmpty() ? "" : " '" + body.name + "'")
                            + " has no shape; call .shape(..) before adding it");
        }
        MassProperties mass = ColliderTable.mass(parts, body);
        if (body.type == BodyType.DYNAMIC) {
            BodyMass.inverseInertia(mass); // throws where there is none
        }
        double[] com = new double[3];
        Rotations.rotate(
                body.qx, body.qy, body.qz, body.qw, mass.comX(), mass.comY(), mass.comZ(), com);
        checkReach("x", body.x + com[0]);
        checkReach("y", body.y + com[1]);
        checkReach("z", body.z + com[2]);
        if (body.type == BodyType.KINEMATIC) {
            checkSpeed("velocity", body.vx, body.vy, body.vz, 1);
            checkSpeed("angular velocity", body.wx, body.wy, body.wz, outerRadius(parts, mass));
        }
        int slot = registry.nextSlot();
        ensureSlots();
        Record[] records = records(body, slot);
        if (given == NONE) {
            // An observer of what the body is made of may throw or delete it: it is whole by then.
            BodyRef[] made = new BodyRef[1];
            world().spawn(entity -> made[0] = begin(slot, entity, body, parts, mass, com), records);
            return made[0];
        }
        give(given, records);
        return begin(slot, given, body, parts, mass, com);
    }

    private BodyRef begin(
            int slot,
            long entity,
            Body body,
            List<Collider> parts,
            MassProperties mass,
            double[] com) {
        registry.take();
        born++;
        BodyRef ref = new BodyRef(this, slot, entity, body.name);
        refs[slot] = ref;
        userData[slot] = body.userData;
        staysAwake[slot] = !body.maySleep;
        registry.comX[slot] = mass.comX();
        registry.comY[slot] = mass.comY();
        registry.comZ[slot] = mass.comZ();
        fill(slot, entity, body, mass, com);
        collision.attach(slot, parts, body);
        registry.born(slot, body.maySleep);
        return ref;
    }

    static byte kind(BodyType type) {
        return switch (type) {
            case FIXED -> BodyStore.STATIC;
            case KINEMATIC -> BodyStore.KINEMATIC;
            case DYNAMIC -> BodyStore.DYNAMIC;
        };
    }

    /** At least as far as any point of the parts is from the centre of mass. */
    private static double outerRadius(List<Collider> parts, MassProperties mass) {
        double outer = 0;
        for (Collider part : parts) {
            MassProperties own = part.placed.massProperties(1);
            double x = own.comX() - mass.comX();
            double y = own.comY() - mass.comY();
            double z = own.comZ() - mass.comZ();
            outer = Math.max(outer, Math.sqrt(x * x + y * y + z * z) + part.placed.outerRadius());
        }
        return outer;
    }

    /** A speed that a step can go on from, of a body that nothing slows down. */
    static void checkSpeed(String what, double x, double y, double z, double radius) {
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        // what does not turn may be without end
        if (!(largest <= MOST_SPEED && (largest == 0 || largest * radius <= MOST_SPEED))) {
            throw new IllegalArgumentException(
                    what
                            + " of a kinematic body is ("
                            + x
                            + ", "
                            + y
                            + ", "
                            + z
                            + "); its surface may move at 1e59 m/s at most, so choose less");
        }
    }

    private static void checkReach(String name, double value) {
        if (!(Math.abs(value) <= StepLimits.LARGEST)) {
            throw new IllegalArgumentException(
                    name + " is " + value + " m; it must be from -1e60 to 1e60");
        }
    }

    /** The body of an entity that is alive, or {@code null}. */
    @Nullable BodyRef of(long entity) {
        if (!world().has(entity, RigidBody.COMPONENT)) {
            return null;
        }
        BodyRef ref = refs[world().get(entity, RigidBody.COMPONENT).slot()];
        return ref.entity() == entity ? ref : null;
    }

    private void give(long entity, Record[] records) {
        for (Record record : records) {
            if (world().has(entity, Component.of(record.getClass()))) {
                throw new IllegalArgumentException(
                        "the entity of a NewBody has a "
                                + record.getClass().getSimpleName()
                                + " already; leave it to the body, or say it with Body.with(..)");
            }
        }
        for (Record record : records) {
            world().add(entity, record);
        }
    }

    private Record[] records(Body body, int slot) {
        boolean fixed = body.type == BodyType.FIXED;
        int own = fixed ? 2 : 3;
        Record[] records = new Record[own + body.components.size()];
        records[0] = new Pose(body.x, body.y, body.z, body.qx, body.qy, body.qz, body.qw, 0);
        records[1] = new RigidBody(slot);
        if (!fixed) {
            records[2] = new Velocity(body.vx, body.vy, body.vz, body.wx, body.wy, body.wz);
        }
        for (int i = 0; i < body.components.size(); i++) {
            Record component = body.components.get(i);
            for (int j = 0; j < own + i; j++) {
                if (records[j].getClass() == component.getClass()) {
                    throw new IllegalArgumentException(
                            "component "
                                    + component.getClass().getSimpleName()
                                    + " is given twice; pass one of each type, and leave Pose,"
                                    + " Velocity and RigidBody to the body");
                }
            }
            if (component instanceof Velocity) {
                throw new IllegalArgumentException(
                        "component Velocity is given to a fixed body; make it dynamic or leave it"
                                + " out");
            }
            records[own + i] = component;
        }
        return records;
    }

    private void fill(int s, long entity, Body body, MassProperties mass, double[] com) {
        BodyStore b = bodies;
        b.clear(s);
        boolean fixed = body.type == BodyType.FIXED;
        b.kind[s] = kind(body.type);
        b.entity[s] = entity;
        b.place(s, body.x + com[0], body.y + com[1], body.z + com[2]);
        b.orientationX[s] = body.qx;
        b.orientationY[s] = body.qy;
        b.orientationZ[s] = body.qz;
        b.orientationW[s] = body.qw;
        b.velocityX[s] = fixed ? 0 : body.vx;
        b.velocityY[s] = fixed ? 0 : body.vy;
        b.velocityZ[s] = fixed ? 0 : body.vz;
        b.angularVelocityX[s] = fixed ? 0 : body.wx;
        b.angularVelocityY[s] = fixed ? 0 : body.wy;
        b.angularVelocityZ[s] = fixed ? 0 : body.wz;
        setMass(s, mass, body.type != BodyType.DYNAMIC);
        b.gravityScale[s] = body.gravityScale;
        b.linearDamping[s] = body.linearDamping;
        b.angularDamping[s] = body.angularDamping;
        b.speedLimit[s] = body.speedLimit;
        access.restrain(s, body.locks);
    }

    /** Sets mass, inertia and their inverses, those of a fixed body to 0. */
    void setMass(int s, MassProperties mass, boolean fixed) {
        BodyStore b = bodies;
        double[] inverse = fixed ? new double[6] : BodyMass.inverseInertia(mass);
        b.inverseMass[s] = fixed ? 0 : 1 / mass.mass();
        b.inertiaXX[s] = mass.ixx();
        b.inertiaYY[s] = mass.iyy();
        b.inertiaZZ[s] = mass.izz();
        b.inertiaXY[s] = mass.ixy();
        b.inertiaXZ[s] = mass.ixz();
        b.inertiaYZ[s] = mass.iyz();
        b.inverseInertiaXX[s] = inverse[0];
        b.inverseInertiaYY[s] = inverse[1];
        b.inverseInertiaZZ[s] = inverse[2];
        b.inverseInertiaXY[s] = inverse[3];
        b.inverseInertiaXZ[s] = inverse[4];
        b.inverseInertiaYZ[s] = inverse[5];
    }

    private void ensureSlots() {
        int n = bodies.kind.length;
        if (n > refs.length) {
            refs = Arrays.copyOf(refs, n);
            userData = Arrays.copyOf(userData, n);
            staysAwake = Arrays.copyOf(staysAwake, n);
        }
    }

    // State ------------------------------------------------------------------------------------

    /**
     * Bodies and their colliders. A reference that the world has given stays the one to its body.
     */
    @Override
    @SuppressWarnings("NullAway") // a slot without a body has no reference
    public void state(StateVisitor s) {
        registry.state(s);
        s.section("references", this);
        int slots = bodies.slotCount;
        ensureSlots(); // slots of further colliders have no body, and may have come since
        BodyRef[] saved = s.array("refs", s.isRestoring() ? savedRefs : refs, slots);
        savedRefs = s.isRestoring() ? saved : savedRefs;
        userData = s.array("userData", userData, slots);
        staysAwake = s.array("staysAwake", staysAwake, slots);
        int count = s.value("quarantined", quarantined.size());
        BodyRef[] stopped = s.array("stopped", quarantined.toArray(NO_BODIES), count);
        if (s.isRestoring()) {
            for (int slot = 0; slot < refs.length; slot++) {
                refs[slot] = slot < slots ? own(saved[slot], refs[slot]) : null;
            }
            quarantined.clear();
            for (BodyRef ref : stopped) {
                quarantined.add(own(ref, refs[ref.slot()]));
            }
        }
        collision.state(s);
    }

    /** This world's reference to the body that a saved one, maybe another world's, names. */
    private @Nullable BodyRef own(@Nullable BodyRef saved, @Nullable BodyRef now) {
        if (saved == null || saved.table == this) {
            return saved;
        }
        boolean same =
                now != null
                        && now.slot() == saved.slot()
                        && now.entity() == saved.entity()
                        && now.name().equals(saved.name());
        return same ? now : new BodyRef(this, saved.slot(), saved.entity(), saved.name());
    }

    // Life -------------------------------------------------------------------------------------

    /** Stops a body where it is and fixes it there. */
    void quarantine(int slot) {
        registry.stop(slot);
        quarantined.add(refs[slot]);
    }

    /** A body that was quarantined may move again. */
    void release(int slot) {
        quarantined.remove(refs[slot]);
    }

    boolean isQuarantined(int slot) {
        return quarantined.contains(refs[slot]);
    }

    /** Those that are still there, in the order in which they were quarantined. */
    List<BodyRef> quarantined() {
        quarantined.removeIf(ref -> !ref.isAlive());
        return new ArrayList<>(quarantined);
    }

    /** See {@link PhysicsWorld#validate}. */
    void validate() {
        new WorldCheck(
                        bodies,
                        colliders,
                        contacts,
                        broadPhase,
                        sleepers,
                        slot -> refs[slot].toString(),
                        registry::isUnplaced)
                .run();
    }

    /** The body's island falls asleep, now. */
    void sleep(int slot) {
        if (!sleepers.enabled()) {
            throw new IllegalStateException(
                    refs[slot]
                            + " cannot sleep: this world was built with sleeping(false); build it"
                            + " with sleeping(true)");
        }
        if (bodies.kind[slot] != BodyStore.DYNAMIC) {
            return;
        }
        registry.sleep(slot, contacts);
    }
}
