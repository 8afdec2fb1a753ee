package dev.cairn.physics;

import dev.cairn.core.ecs.World;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.broadphase.PairFilter;
import dev.cairn.physics.contact.BoundsStage;
import dev.cairn.physics.contact.ContactRows;
import dev.cairn.physics.internal.BodyMass;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.EdgeSource;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.island.Sleepers;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.state.WorldCheck;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Who is in the world: slots, their entities and references, and what the kernels of the step do
 * not need.
 *
 * <p>A slot is free, or in use, or gone: its entity was found dead at the start of a tick, and its
 * rows leave in that tick; then it is free. Free slots are used again last freed first, which is
 * part of the deterministic state.
 */
final class BodyTable {
    final BodyStore bodies = new BodyStore();
    final ColliderStore colliders = new ColliderStore(bodies);
    private final PairFilter pairFilter = new PairFilter(colliders);
    final BroadPhase broadPhase = new BroadPhase(pairFilter);
    final ColliderTable collision = new ColliderTable(this, colliders, broadPhase, pairFilter);
    final BoundsStage bounds;
    final ContactStore contacts;
    private final EdgeSource[] edges;
    final Sleepers sleepers;
    final BodyAccess access = new BodyAccess(this);

    BodyRef[] refs = new BodyRef[0];
    Material[] materials = new Material[0];

    /** As the user gave them. */
    Shape[] shapes = new Shape[0];

    double[] comX = {}, comY = {}, comZ = {};
    int[] jumps = {};
    private long[] seen = {};

    /** Slots of dynamic bodies that are awake, and of fixed ones, each ascending. */
    int[] dynamic = {}, fixed = {};

    int dynamicCount;
    int fixedCount;
    private boolean listsStale;

    /** How often {@link #sweep} ran: entities may have moved between chunks since. */
    long rosters;

    private int[] free = new int[16];
    private int freeCount;
    private int[] gone = new int[16];
    private int goneCount;

    /** Fixed bodies whose box must be placed at the next tick, in the order of the calls. */
    int[] unplaced = new int[16];

    int unplacedCount;

    /** Grows whenever a body may have come to another place. */
    long places;

    final List<BodyRef> quarantined = new ArrayList<>();
    private @Nullable World world;
    private boolean closed;

    /** While the physics runs nobody else may change a body; read by any thread. */
    volatile boolean isStepping;

    BodyTable(PhysicsSettings settings, ContactStore contacts, EdgeSource[] edges) {
        bounds = new BoundsStage(colliders, settings.tuning());
        this.contacts = contacts;
        this.edges = edges;
        sleepers = new Sleepers(settings.sleeping(), settings.sleepSeconds(), bodies, edges);
    }

    void bind(World ecs) {
        world = ecs;
    }

    World world() {
        if (world == null) {
            throw new IllegalStateException("the physics system is in no world yet");
        }
        return world;
    }

    void close() {
        closed = true;
    }

    boolean isClosed() {
        return closed;
    }

    // Birth ------------------------------------------------------------------------------------

    /** Everything that can fail happens before anything changes. */
    BodyRef add(Body body) {
        Shape shape = body.shape;
        if (shape == null) {
            throw new IllegalArgumentException(
                    "body"
                            + (body.name.isEmpty() ? "" : " '" + body.name + "'")
                            + " has no shape; call .shape(..) before adding it");
        }
        MassProperties mass =
                BodyMass.of(
                        shape,
                        body.material.density(),
                        body.fixed,
                        body.mass,
                        body.inertiaXX,
                        body.inertiaYY,
                        body.inertiaZZ);
        double[] inverse = body.fixed ? new double[6] : BodyMass.inverseInertia(mass);
        double[] com = new double[3];
        Rotations.rotate(
                body.qx, body.qy, body.qz, body.qw, mass.comX(), mass.comY(), mass.comZ(), com);
        checkReach("x", body.x + com[0]);
        checkReach("y", body.y + com[1]);
        checkReach("z", body.z + com[2]);
        int slot = freeCount > 0 ? free[freeCount - 1] : bodies.slotCount;
        ensureSlots(slot + 1);
        Record[] records = records(body, slot);
        long entity = world().spawn(records);
        if (freeCount > 0) {
            freeCount--;
        } else {
            bodies.slotCount++;
        }
        BodyRef ref = new BodyRef(this, slot, entity, body.name);
        refs[slot] = ref;
        materials[slot] = body.material;
        shapes[slot] = shape;
        comX[slot] = mass.comX();
        comY[slot] = mass.comY();
        comZ[slot] = mass.comZ();
        jumps[slot] = 0;
        fill(slot, entity, body, shape, mass, inverse, com);
        sleepers.born(slot, body.maySleep);
        listsStale = true;
        places++;
        if (body.fixed) {
            addUnplaced(slot);
        }
        return ref;
    }

    private static void checkReach(String name, double value) {
        if (!(Math.abs(value) <= BoundsStage.LIMIT)) {
            throw new IllegalArgumentException(
                    name + " is " + value + " m; it must be from -1e60 to 1e60");
        }
    }

    private Record[] records(Body body, int slot) {
        int own = body.fixed ? 2 : 3;
        Record[] records = new Record[own + body.components.size()];
        records[0] = new Pose(body.x, body.y, body.z, body.qx, body.qy, body.qz, body.qw, 0);
        records[1] = new RigidBody(slot);
        if (!body.fixed) {
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

    private void fill(
            int s,
            long entity,
            Body body,
            Shape shape,
            MassProperties mass,
            double[] inverse,
            double[] com) {
        BodyStore b = bodies;
        b.clear(s);
        b.kind[s] = body.fixed ? BodyStore.STATIC : BodyStore.DYNAMIC;
        b.entity[s] = entity;
        b.innerRadius[s] = shape.innerRadius();
        b.outerRadius[s] = shape.outerRadius();
        b.place(s, body.x + com[0], body.y + com[1], body.z + com[2]);
        b.orientationX[s] = body.qx;
        b.orientationY[s] = body.qy;
        b.orientationZ[s] = body.qz;
        b.orientationW[s] = body.qw;
        b.velocityX[s] = body.fixed ? 0 : body.vx;
        b.velocityY[s] = body.fixed ? 0 : body.vy;
        b.velocityZ[s] = body.fixed ? 0 : body.vz;
        b.angularVelocityX[s] = body.fixed ? 0 : body.wx;
        b.angularVelocityY[s] = body.fixed ? 0 : body.wy;
        b.angularVelocityZ[s] = body.fixed ? 0 : body.wz;
        b.inverseMass[s] = body.fixed ? 0 : 1 / mass.mass();
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
        int collider = colliders.attach(s, shape);
        colliders.friction[collider] = body.material.friction();
        colliders.restitution[collider] = body.material.restitution();
        colliders.rollingArm[collider] = body.material.rollingArm();
        collision.setFilter(collider, body.filter);
        if (body.material.rollingArm() > 0) {
            contacts.beginRolling();
        }
        b.gravityScale[s] = body.gravityScale;
        b.linearDamping[s] = body.linearDamping;
        b.angularDamping[s] = body.angularDamping;
        b.speedLimit[s] = body.speedLimit;
        access.restrain(s, body.locks);
    }

    private void ensureSlots(int capacity) {
        bodies.ensureCapacity(capacity);
        colliders.ensureCapacity(capacity);
        broadPhase.ensureSlots(capacity);
        bounds.ensureSlots(capacity);
        sleepers.ensureSlots(capacity);
        if (capacity > refs.length) {
            int n = bodies.kind.length;
            refs = Arrays.copyOf(refs, n);
            materials = Arrays.copyOf(materials, n);
            shapes = Arrays.copyOf(shapes, n);
            comX = Arrays.copyOf(comX, n);
            comY = Arrays.copyOf(comY, n);
            comZ = Arrays.copyOf(comZ, n);
            jumps = Arrays.copyOf(jumps, n);
            seen = Arrays.copyOf(seen, n);
        }
    }

    // Life and death ---------------------------------------------------------------------------

    boolean isAlive(int slot, long entity) {
        return !closed
                && bodies.kind[slot] != BodyStore.FREE
                && bodies.entity[slot] == entity
                && isBody(world(), entity);
    }

    /** Whether an entity is one of the rows that the physics steps. */
    private static boolean isBody(World ecs, long entity) {
        return ecs.isAlive(entity)
                && ecs.has(entity, RigidBody.COMPONENT)
                && ecs.has(entity, Pose.COMPONENT);
    }

    /** A row of the ECS says that its body is there. */
    void see(int slot, long entity, long tick) {
        if (slot < 0
                || slot >= bodies.slotCount
                || bodies.kind[slot] == BodyStore.FREE
                || bodies.entity[slot] != entity) {
            throw new IllegalStateException(
                    "an entity has RigidBody["
                            + slot
                            + "] that is not its own; bodies are made by PhysicsWorld.add, do not"
                            + " add RigidBody by hand");
        }
        seen[slot] = tick;
    }

    /**
     * Bodies that can move and whose entity is gone leave the trees; their slots are free after
     * {@link #freeGone}. After {@link #see} for all that are there.
     */
    void sweep(long tick) {
        rosters++;
        for (int slot = 0; slot < bodies.slotCount; slot++) {
            byte kind = bodies.kind[slot];
            if ((kind == BodyStore.DYNAMIC || kind == BodyStore.ASLEEP) && seen[slot] != tick) {
                leave(slot);
            }
        }
    }

    /** The same for fixed bodies, whose chunks the physics does not walk. */
    void sweepFixed() {
        World ecs = world();
        for (int i = 0; i < fixedCount; i++) {
            int slot = fixed[i];
            long entity = bodies.entity[slot];
            if (!isBody(ecs, entity) && bodies.kind[slot] == BodyStore.STATIC) {
                leave(slot);
            }
        }
    }

    /** Before the bounds: lists are up to date, and fixed bodies where they were put. */
    void beginTick() {
        places++;
        refreshLists();
        sweepFixed();
        refreshLists();
        sleepers.forgetFresh();
        placeFixed();
    }

    /** Makes the lists anew if somebody came, went, woke or fell asleep. */
    void refreshLists() {
        boolean slept = sleepers.takeRostersStale();
        if (listsStale || slept) {
            rebuildLists();
        }
    }

    private void leave(int slot) {
        sleepers.wake(slot);
        listsStale = true;
        for (int c = bodies.collider[slot]; c != ColliderStore.NONE; c = colliders.next[c]) {
            broadPhase.remove(c);
        }
        for (EdgeSource source : edges) {
            source.leave(slot);
        }
        pairFilter.leave(slot);
        bodies.kind[slot] = BodyStore.FREE;
        if (goneCount == gone.length) {
            gone = Arrays.copyOf(gone, 2 * goneCount);
        }
        gone[goneCount++] = slot;
        quarantined.remove(refs[slot]);
    }

    /** After the rows of the gone bodies have left. */
    void freeGone() {
        for (int i = goneCount - 1; i >= 0; i--) {
            if (freeCount == free.length) {
                free = Arrays.copyOf(free, 2 * freeCount);
            }
            assert bodies.kind[gone[i]] == BodyStore.FREE : "slot " + gone[i] + " has a body";
            collision.forget(gone[i]);
            colliders.detach(gone[i]);
            free[freeCount++] = gone[i];
        }
        goneCount = 0;
    }

    private void rebuildLists() {
        int n = bodies.slotCount;
        if (dynamic.length < n) {
            dynamic = new int[bodies.kind.length];
            fixed = new int[bodies.kind.length];
        }
        dynamicCount = 0;
        fixedCount = 0;
        for (int slot = 0; slot < n; slot++) {
            if (bodies.kind[slot] == BodyStore.DYNAMIC) {
                dynamic[dynamicCount++] = slot;
            } else if (bodies.kind[slot] == BodyStore.STATIC) {
                fixed[fixedCount++] = slot;
            }
        }
        listsStale = false;
    }

    void addUnplaced(int slot) {
        if (unplacedCount == unplaced.length) {
            unplaced = Arrays.copyOf(unplaced, 2 * unplacedCount);
        }
        unplaced[unplacedCount++] = slot;
    }

    private void placeFixed() {
        for (int i = 0; i < unplacedCount; i++) {
            if (bodies.kind[unplaced[i]] == BodyStore.STATIC) {
                bounds.placeFixed(broadPhase, unplaced[i]);
            }
        }
        unplacedCount = 0;
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
                        this::isUnplaced)
                .run();
    }

    private boolean isUnplaced(int slot) {
        for (int i = 0; i < unplacedCount; i++) {
            if (unplaced[i] == slot) {
                return true;
            }
        }
        return false;
    }

    /** Stops a body where it is and fixes it there. */
    void quarantine(int slot) {
        BodyStore b = bodies;
        b.kind[slot] = BodyStore.STATIC;
        b.velocityX[slot] = 0;
        b.velocityY[slot] = 0;
        b.velocityZ[slot] = 0;
        b.angularVelocityX[slot] = 0;
        b.angularVelocityY[slot] = 0;
        b.angularVelocityZ[slot] = 0;
        b.inverseMass[slot] = 0;
        b.inverseInertiaXX[slot] = 0;
        b.inverseInertiaYY[slot] = 0;
        b.inverseInertiaZZ[slot] = 0;
        b.inverseInertiaXY[slot] = 0;
        b.inverseInertiaXZ[slot] = 0;
        b.inverseInertiaYZ[slot] = 0;
        clearForces(slot);
        quarantined.add(refs[slot]);
        listsStale = true;
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
        refreshLists();
        ContactRows.activate(bodies, contacts, broadPhase);
        sleepers.sleep(slot, dynamic, dynamicCount);
        for (int i = 0; i < dynamicCount; i++) {
            if (sleepers.asleep(dynamic[i])) {
                bounds.settle(broadPhase, dynamic[i]);
            }
        }
        restBounds();
    }

    /** Bodies that have fallen asleep reach nowhere. */
    void restBounds() {
        for (int i = 0; i < dynamicCount; i++) {
            if (sleepers.asleep(dynamic[i])) {
                bounds.rest(dynamic[i]);
                clearForces(dynamic[i]);
            }
        }
    }

    void clearForces(int slot) {
        bodies.forceX[slot] = 0;
        bodies.forceY[slot] = 0;
        bodies.forceZ[slot] = 0;
        bodies.torqueX[slot] = 0;
        bodies.torqueY[slot] = 0;
        bodies.torqueZ[slot] = 0;
    }

    void clearAllForces() {
        for (int slot = 0; slot < bodies.slotCount; slot++) {
            clearForces(slot);
        }
    }
}
