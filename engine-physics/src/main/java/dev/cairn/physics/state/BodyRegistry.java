package dev.cairn.physics.state;

import dev.cairn.core.ecs.World;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.broadphase.PairFilter;
import dev.cairn.physics.contact.BoundsStage;
import dev.cairn.physics.contact.ContactRows;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.EdgeSource;
import dev.cairn.physics.island.SleepingBodies;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * The bodies of the world: slots and their entities, lists of those that move, and what the kernels
 * of the step do not need.
 *
 * <p>A slot is free, or in use, or gone: its entity was found dead at the start of a tick, and its
 * rows leave in that tick; then it is free. Free slots are used again last freed first, which is
 * part of the deterministic state.
 */
public final class BodyRegistry implements Stateful {
    public final BodyStore bodies = new BodyStore();
    public final ColliderStore colliders = new ColliderStore(bodies);
    public final PairFilter pairFilter = new PairFilter(colliders);
    public final BroadPhase broadPhase = new BroadPhase(pairFilter);
    public final BoundsStage bounds;
    public final SleepingBodies sleepers;
    private final EdgeSource[] edges;

    /** From the origin of the shape's frame to the centre of mass, in that frame, m. */
    public double[] comX = {}, comY = {}, comZ = {};

    /** How often each body was teleported. */
    public int[] jumps = {};

    /** By slot: before which {@link #sweep} its entity was there. */
    private long[] seen = {};

    /** Slots of dynamic bodies that are awake, of fixed and of kinematic ones, each ascending. */
    public int[] dynamic = {}, fixed = {}, kinematic = {};

    public int dynamicCount;
    public int fixedCount;
    public int kinematicCount;

    /** What the kinematic ones do. */
    public final KinematicMotion motion = new KinematicMotion(bodies);

    private boolean listsStale;

    /** How often {@link #sweep} ran: entities may have moved between chunks since. */
    public long revision;

    /** The tick in which fixed bodies were last looked at for those that are gone. */
    private long sweptTick;

    private int[] free = new int[16];
    private int freeCount;
    private int[] goneChildren = new int[16];
    private int goneChildCount;
    private int[] gone = new int[16];
    private int goneCount;

    /** Fixed bodies whose box must be placed at the next tick, in the order of the calls. */
    public int[] unplaced = new int[16];

    public int unplacedCount;

    /** Grows whenever a body may have come to another place. */
    public long places;

    private @Nullable World world;

    /**
     * An empty registry.
     *
     * @param tuning numbers of the step
     * @param sleeping whether bodies at rest fall asleep
     * @param sleepSeconds after what time
     * @param edges all that binds bodies
     */
    public BodyRegistry(Tuning tuning, boolean sleeping, double sleepSeconds, EdgeSource[] edges) {
        bounds = new BoundsStage(colliders, tuning);
        this.edges = edges;
        double learning = tuning.get(Tunable.OFFSET_GAIN);
        sleepers =
                new SleepingBodies(
                        sleeping, sleepSeconds, softness(tuning), learning, bodies, edges);
    }

    /** {@code sag / (g T^2)} on static bodies: {@code sag = g/w^2}, {@code w} in ticks T. */
    private static double softness(Tuning tuning) {
        double perSubStep =
                2
                        * Math.PI
                        * tuning.get(Tunable.CONTACT_STIFFNESS)
                        * tuning.get(Tunable.STATIC_STIFFNESS_SCALE);
        double perTick = perSubStep * tuning.get(Tunable.SUBSTEPS);
        return 1 / (perTick * perTick);
    }

    /** The ECS that holds the entities. */
    public void bind(World ecs) {
        world = ecs;
    }

    /** The ECS that holds the entities. */
    public World world() {
        if (world == null) {
            throw new IllegalStateException("the physics system is in no world yet");
        }
        return world;
    }

    /** Bodies, colliders, boxes, which bodies sleep, which are about to come or go. */
    @Override
    public void state(StateVisitor s) {
        bodies.state(s);
        colliders.state(s);
        int slots = bodies.slotCount;
        if (s.isRestoring()) {
            ensureSlots(slots);
            listsStale = true;
            revision++;
            places++;
        }
        pairFilter.state(s);
        broadPhase.state(s, slots);
        bounds.state(s, slots);
        sleepers.state(s, slots);
        motion.state(s, slots);
        s.section("registry", this);
        comX = s.array("comX", comX, slots);
        comY = s.array("comY", comY, slots);
        comZ = s.array("comZ", comZ, slots);
        jumps = s.array("jumps", jumps, slots);
        sweptTick = s.value("sweptTick", sweptTick);
        freeCount = s.value("freeCount", freeCount);
        free = s.array("free", free, freeCount);
        goneCount = s.value("goneCount", goneCount);
        gone = s.array("gone", gone, goneCount);
        goneChildCount = s.value("goneChildCount", goneChildCount);
        goneChildren = s.array("goneChildren", goneChildren, goneChildCount);
        unplacedCount = s.value("unplacedCount", unplacedCount);
        unplaced = s.array("unplaced", unplaced, unplacedCount);
    }

    // Birth ------------------------------------------------------------------------------------

    /** The slot that the next body will have, with room for it. */
    public int nextSlot() {
        int slot = freeCount > 0 ? free[freeCount - 1] : bodies.slotCount;
        ensureSlots(slot + 1);
        return slot;
    }

    /** Takes the slot of {@link #nextSlot}. */
    public void take() {
        if (freeCount > 0) {
            freeCount--;
        } else {
            bodies.slotCount++;
        }
    }

    /** Takes a slot for one of several colliders of a body; no body is in it. */
    public int takeChild() {
        int slot = nextSlot();
        take();
        bodies.clear(slot);
        return slot;
    }

    /** A child leaves its body; its slot is free after its rows have left. */
    public void leaveChild(int collider) {
        broadPhase.remove(collider);
        if (goneChildCount == goneChildren.length) {
            goneChildren = Arrays.copyOf(goneChildren, 2 * goneChildCount);
        }
        goneChildren[goneChildCount++] = collider;
    }

    /** A body is made of something else now: it wakes, and its boxes are found anew. */
    public void changed(int slot) {
        places++;
        sleepers.wake(slot);
        if (stands(slot)) {
            addUnplaced(slot);
        }
    }

    /** Whether a body's centre of mass is where it is, in the body's frame. */
    public boolean isCentre(int slot, MassProperties p) {
        return p.comX() == comX[slot] && p.comY() == comY[slot] && p.comZ() == comZ[slot];
    }

    /** The body of a slot that was taken is complete. */
    public void born(int slot, boolean maySleep) {
        jumps[slot] = 0;
        sleepers.born(slot, maySleep);
        listsStale = true;
        places++;
        motion.born(slot);
        if (stands(slot)) {
            addUnplaced(slot);
        }
    }

    /** Whether nothing moves a body, but for itself. */
    private boolean stands(int slot) {
        return bodies.kind[slot] == BodyStore.STATIC || bodies.kind[slot] == BodyStore.KINEMATIC;
    }

    /** A body is of another type: boxes and lists are made anew. */
    public void retyped(int slot) {
        listsStale = true;
        places++;
        motion.born(slot);
        for (int c = bodies.collider[slot]; c != ColliderStore.NONE; c = colliders.next[c]) {
            broadPhase.remove(c);
        }
        sleepers.rowsWillBeStale();
        sleepers.renew(slot);
        if (stands(slot)) {
            addUnplaced(slot);
        }
    }

    private void ensureSlots(int capacity) {
        bodies.ensureCapacity(capacity);
        colliders.ensureCapacity(capacity);
        broadPhase.ensureSlots(capacity);
        bounds.ensureSlots(capacity);
        sleepers.ensureSlots(capacity);
        motion.ensureSlots(capacity);
        if (capacity > jumps.length) {
            int n = bodies.kind.length;
            comX = Arrays.copyOf(comX, n);
            comY = Arrays.copyOf(comY, n);
            comZ = Arrays.copyOf(comZ, n);
            jumps = Arrays.copyOf(jumps, n);
            seen = Arrays.copyOf(seen, n);
        }
    }

    // Life and death ---------------------------------------------------------------------------

    /** Whether the slot holds the body of this entity. */
    public boolean isAlive(int slot, long entity) {
        return bodies.kind[slot] != BodyStore.FREE
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
    public void see(int slot, long entity) {
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
        seen[slot] = revision + 1;
    }

    /**
     * Bodies that can move and whose entity is gone leave the trees; their slots are free after
     * {@link #freeGone}. After {@link #see} for all that are there.
     */
    public void sweep() {
        revision++;
        for (int slot = 0; slot < bodies.slotCount; slot++) {
            byte kind = bodies.kind[slot];
            if (kind != BodyStore.FREE && kind != BodyStore.STATIC && seen[slot] != revision) {
                leave(slot);
            }
        }
    }

    /** The same for fixed bodies, whose chunks the physics does not walk, if one may be gone. */
    private void sweepFixed(long tick) {
        World ecs = world();
        if (ecs.lastDeparture(RigidBody.COMPONENT) < sweptTick) {
            return;
        }
        sweptTick = tick;
        for (int i = 0; i < fixedCount; i++) {
            int slot = fixed[i];
            long entity = bodies.entity[slot];
            if (!isBody(ecs, entity) && bodies.kind[slot] == BodyStore.STATIC) {
                leave(slot);
            }
        }
    }

    /** Before the bounds: lists are up to date, and fixed bodies where they were put. */
    public void beginTick(long tick) {
        places++;
        refreshLists();
        sweepFixed(tick);
        refreshLists();
        sleepers.forgetFresh();
        placeFixed();
    }

    /** Makes the lists anew if a body came, went, woke or fell asleep. */
    public void refreshLists() {
        boolean slept = sleepers.takeListsStale();
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
    }

    /** After the rows of the gone bodies have left. */
    public void freeGone() {
        while (goneChildCount > 0) {
            addFree(goneChildren[--goneChildCount]);
        }
        for (int i = goneCount - 1; i >= 0; i--) {
            int slot = gone[i];
            assert bodies.kind[slot] == BodyStore.FREE : "slot " + slot + " has a body";
            for (int c = bodies.collider[slot]; c != ColliderStore.NONE; c = colliders.next[c]) {
                if (c != slot) {
                    addFree(c);
                }
            }
            colliders.detach(slot);
            addFree(slot);
        }
        goneCount = 0;
    }

    private void addFree(int slot) {
        if (freeCount == free.length) {
            free = Arrays.copyOf(free, 2 * freeCount);
        }
        free[freeCount++] = slot;
    }

    private void rebuildLists() {
        int n = bodies.slotCount;
        if (dynamic.length < n) {
            dynamic = new int[bodies.kind.length];
            fixed = new int[bodies.kind.length];
            kinematic = new int[bodies.kind.length];
        }
        dynamicCount = 0;
        fixedCount = 0;
        kinematicCount = 0;
        for (int slot = 0; slot < n; slot++) {
            if (bodies.kind[slot] == BodyStore.DYNAMIC) {
                dynamic[dynamicCount++] = slot;
            } else if (bodies.kind[slot] == BodyStore.STATIC) {
                fixed[fixedCount++] = slot;
            } else if (bodies.kind[slot] == BodyStore.KINEMATIC) {
                kinematic[kinematicCount++] = slot;
            }
        }
        listsStale = false;
    }

    public void addUnplaced(int slot) {
        if (unplacedCount == unplaced.length) {
            unplaced = Arrays.copyOf(unplaced, 2 * unplacedCount);
        }
        unplaced[unplacedCount++] = slot;
    }

    /** Kinematic bodies start to move, go on, or stop. */
    public void beginMotion(double stepSeconds, double gravity) {
        motion.begin(kinematic, kinematicCount, stepSeconds, gravity);
        for (int i = 0; i < kinematicCount; i++) {
            boolean changes = motion.takeChange(kinematic[i]);
            if (bodies.isDriven(kinematic[i])) {
                bounds.placeDriven(broadPhase, kinematic[i], stepSeconds);
            } else if (changes) {
                bounds.placeFixed(broadPhase, kinematic[i], false);
            }
        }
    }

    private void placeFixed() {
        for (int i = 0; i < unplacedCount; i++) {
            if (stands(unplaced[i])) {
                bounds.placeFixed(broadPhase, unplaced[i], true);
            }
        }
        broadPhase.finishPlaces();
        unplacedCount = 0;
    }

    public boolean isUnplaced(int slot) {
        for (int i = 0; i < unplacedCount; i++) {
            if (unplaced[i] == slot) {
                return true;
            }
        }
        return false;
    }

    /** Stops a body where it is and fixes it there. */
    public void stop(int slot) {
        BodyStore b = bodies;
        b.kind[slot] = BodyStore.STATIC;
        b.stop(slot);
        b.inverseMass[slot] = 0;
        b.inverseInertiaXX[slot] = 0;
        b.inverseInertiaYY[slot] = 0;
        b.inverseInertiaZZ[slot] = 0;
        b.inverseInertiaXY[slot] = 0;
        b.inverseInertiaXZ[slot] = 0;
        b.inverseInertiaYZ[slot] = 0;
        clearForces(slot);
        listsStale = true;
    }

    /** The island of a body that moves falls asleep, now. */
    public void sleep(int slot, ContactStore contacts) {
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
    public void restBounds() {
        for (int i = 0; i < dynamicCount; i++) {
            if (sleepers.asleep(dynamic[i])) {
                bounds.rest(dynamic[i]);
                clearForces(dynamic[i]);
            }
        }
    }

    public void clearForces(int slot) {
        bodies.forceX[slot] = 0;
        bodies.forceY[slot] = 0;
        bodies.forceZ[slot] = 0;
        bodies.torqueX[slot] = 0;
        bodies.torqueY[slot] = 0;
        bodies.torqueZ[slot] = 0;
    }

    public void clearAllForces() {
        for (int slot = 0; slot < bodies.slotCount; slot++) {
            clearForces(slot);
        }
    }
}
