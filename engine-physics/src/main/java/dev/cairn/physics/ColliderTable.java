package dev.cairn.physics;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.broadphase.PairFilter;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.internal.BodyMass;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactMaterials;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.MassOverride;
import dev.cairn.physics.internal.MassOverrides;
import dev.cairn.physics.internal.Surface;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.state.GroundEdit;
import dev.cairn.physics.state.PairRules;
import dev.cairn.physics.state.Wholes;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiPredicate;

/**
 * The colliders as users know them, by slot: references, filters, which shapes were taken apart.
 * Simulation thread, between steps.
 */
final class ColliderTable implements Stateful {
    final ColliderStore colliders;
    final PairFilter pairFilter;

    /** Which pairs collide. */
    final PairRules rules;

    private final Wholes wholes;
    private final BodyTable table;
    private final BroadPhase broadPhase;

    private @Nullable BiPredicate<ColliderRef, ColliderRef> asked;

    private final ColliderRef.All refs;

    /** What each collider was made of, with material; its filter may be another one by now. */
    private Collider[] specs = {};

    /** By body: what the user gave instead. */
    private final MassOverrides given = new MassOverrides();

    ColliderTable(BodyTable table) {
        this.table = table;
        colliders = table.colliders;
        broadPhase = table.broadPhase;
        pairFilter = table.registry.pairFilter;
        rules = new PairRules(colliders, pairFilter, broadPhase);
        wholes = new Wholes(table.registry, rules);
        refs = new ColliderRef.All(this);
    }

    /** The reference to a collider, or to the last one in its slot. */
    ColliderRef ref(int collider) {
        return refs.get(collider);
    }

    /** What a collider is made of; its filter may be another one by now. */
    Collider spec(int collider) {
        return specs[collider];
    }

    /** The same with the filter that it has now. */
    Collider now(int collider) {
        return specs[collider].filter(colliders.filter[collider]);
    }

    private int first(int body) {
        return colliders.bodies.collider[body];
    }

    List<ColliderRef> list(int body) {
        List<ColliderRef> list = new ArrayList<>();
        for (int c = first(body); c != ColliderStore.NONE; c = colliders.next[c]) {
            if (!colliders.isWhole(c)) {
                list.add(ref(c));
            }
        }
        return list;
    }

    /**
     * A reference that the world has given stays the one to its collider, and one to none is dead.
     */
    @Override
    public void state(StateVisitor s) {
        s.section("colliderTable", this);
        ensureSlots();
        int slots = colliders.slotCount;
        specs = s.array("specs", specs, slots);
        refs.state(s, slots, table.refs);
        given.state(s, slots);
        for (int c = 0; c < slots && s.isRestoring(); c++) {
            if (refs.has(c)) {
                setPalette(c, specs[c]);
            }
        }
    }

    /** Mass, centre and inertia of parts, or what the user gave instead. */
    static MassProperties mass(List<Collider> parts, Body body) {
        return Collider.mass(parts, body.type != BodyType.DYNAMIC, body.given);
    }

    /** Gives a body that has none its colliders; its slot and pose are set. */
    void attach(int body, List<Collider> parts, Body description) {
        ensureSlots();
        given.set(body, description.given);
        colliders.bodies.collider[body] = ColliderStore.NONE;
        if (parts.size() == 1 && !description.given.hasCentre()) {
            only(body, parts.get(0));
        } else {
            for (Collider part : parts) {
                child(body, part);
            }
            joinParts(body, true);
        }
        colliders.measure(body);
    }

    /** Finds anew what the parts of a body make together. */
    private void joinParts(int body) {
        joinParts(body, false);
    }

    private void joinParts(int body, boolean isNew) {
        if (first(body) == body || !wholes.mayMake(body)) {
            return;
        }
        wholes.begin(body);
        for (int c = first(body); c != ColliderStore.NONE; c = colliders.next[c]) {
            if (!colliders.isWhole(c)) {
                wholes.part(c, specs[c].solid(), local(body, specs[c]));
            }
        }
        wholes.end(isNew);
        ensureSlots();
        colliders.measure(body);
        for (int c = first(body); c != ColliderStore.NONE && !isNew; c = colliders.next[c]) {
            if (colliders.isWhole(c)) {
                ContactMaterials.mixAll(contacts(), c, colliders);
            }
        }
    }

    /** Another filter of a collider. */
    void setFilter(int c, Filter filter) {
        rules.setFilter(c, filter);
        joinParts(colliders.body[c]);
    }

    /** Another filter of all colliders of a body. */
    void setFilters(int body, Filter filter) {
        boolean wereAlike = wholes.meetAlike(body);
        rules.setFilters(body, filter);
        if (!wereAlike) {
            joinParts(body);
        }
    }

    private void only(int body, Collider part) {
        colliders.attach(body, part.placed);
        begin(body, part);
    }

    private int child(int body, Collider part) {
        int c = table.registry.takeChild();
        ensureSlots();
        contacts().beginCompounds();
        pairFilter.begin(); // parts of a body do not meet
        colliders.append(body, c, part.solid(), local(body, part));
        begin(c, part);
        return c;
    }

    /** Where a part is, from the body's centre of mass. */
    private double[] local(int body, Collider part) {
        return part.from(
                table.registry.comX[body], table.registry.comY[body], table.registry.comZ[body]);
    }

    /** A collider that is new in its slot. */
    private void begin(int c, Collider part) {
        refs.begin(c, table.refs[colliders.body[c]]);
        surface(c, part);
    }

    private void surface(int c, Collider part) {
        Material material = part.material();
        specs[c] = part;
        colliders.friction[c] = material.friction();
        colliders.restitution[c] = material.restitution();
        colliders.rollingArm[c] = material.rollingArm();
        colliders.mixing[c] = Collider.rules(material);
        double rolls = setPalette(c, part);
        colliders.userData[c] = part.userData;
        Vector3d run = part.surfaceVelocity(new Vector3d());
        colliders.setBelt(c, run.x, run.y, run.z);
        if (colliders.belts) {
            contacts().beginBelts();
        }
        colliders.sensor[c] = part.sensor;
        if (part.sensor) {
            colliders.sensors = true;
            pairFilter.begin(); // two sensors do not meet
        }
        if (material.rollingArm() > 0 || rolls > 0) {
            contacts().beginRolling();
        }
        rules.setFilter(c, part.filter());
    }

    /** The materials of its triangles; returns the longest arm of rolling friction of these. */
    private double setPalette(int c, Collider part) {
        colliders.palettes.set(c, part.palette());
        double most = 0;
        for (int i = 0; i < part.materials().size(); i++) {
            most = Math.max(most, part.materials().get(i).rollingArm());
        }
        return most;
    }

    /** Another surface; contacts have it from the next step on. */
    void setMaterial(int c, Material material) {
        if (Checks.notNull("material", material).equals(specs[c].material())) {
            return;
        }
        applyMaterial(c, material);
        joinParts(colliders.body[c]);
        colliders.measure(colliders.body[c]);
        table.registry.changed(colliders.body[c]);
        table.changes.wakeAround(colliders.body[c]);
    }

    /** Another surface of one collider; nothing follows yet. */
    void applyMaterial(int c, Material material) {
        surface(c, now(c).material(material));
        ContactMaterials.mixAll(contacts(), c, colliders);
    }

    private void ensureSlots() {
        int n = colliders.body.length;
        if (specs.length < n) {
            specs = Arrays.copyOf(specs, n);
            refs.ensureSlots(n);
            given.ensureSlots(n);
        }
    }

    private ContactStore contacts() {
        return table.contacts;
    }

    /** One more collider on a body. */
    ColliderRef add(int body, Collider part) {
        Collider whole = part.orElse(specs[first(body)].material(), colliders.filter[first(body)]);
        List<Collider> parts = parts(body);
        parts.add(whole);
        MassProperties mass = massNow(body, parts);
        split(body);
        int c = child(body, whole);
        settle(body, mass);
        table.changes.wakeAround(body);
        return ref(c);
    }

    /** A collider goes; it is not the last one. */
    void remove(int collider) {
        int body = colliders.body[collider];
        List<Collider> parts = parts(body);
        parts.remove(placeOf(collider));
        if (parts.isEmpty()) {
            throw new IllegalStateException(
                    ref(collider)
                            + " is the only one; a body has at least one collider: replace it, or"
                            + " remove the body");
        }
        MassProperties mass = massNow(body, parts);
        takeOut(body, collider);
        wholes.leave(body, collider);
        join(body);
        settle(body, mass);
        table.changes.wakeAround(body);
    }

    /** Another collider in the place of one, in the same slot. */
    void replace(int collider, Collider part) {
        int body = colliders.body[collider];
        Collider whole = part.orElse(specs[collider].material(), colliders.filter[collider]);
        if (edit(collider, whole)) {
            return;
        }
        if (whole.sensor != specs[collider].sensor) {
            throw new IllegalArgumentException(
                    ref(collider)
                            + (whole.sensor ? " is no sensor" : " is a sensor")
                            + ", and stays so; remove it and add another one");
        }
        if (Surface.isMeshed(whole.shape()) != Surface.isMeshed(specs[collider].shape())) {
            throw new IllegalArgumentException(
                    ref(collider)
                            + " is "
                            + specs[collider].shape()
                            + " and cannot become "
                            + whole.shape()
                            + ", for contacts of surfaces are of another kind; remove it and add"
                            + " another one");
        }
        List<Collider> parts = parts(body);
        parts.set(placeOf(collider), whole);
        MassProperties mass = massNow(body, parts);
        boolean isOnly = collider == body;
        colliders.replace(collider, isOnly ? whole.placed : whole.solid());
        surface(collider, whole);
        contacts().renew(collider, colliders);
        settle(body, mass);
        table.changes.wakeAround(body);
    }

    /**
     * Replaces ground by the same ground with other heights; what is elsewhere is not touched.
     *
     * @return false if it is anything else
     */
    boolean edit(int collider, Collider whole) {
        Collider old = now(collider);
        HeightField after = GroundEdit.edited(old.placed, whole.placed);
        if (after == null || !old.isLike(whole)) {
            return false;
        }
        int body = colliders.body[collider];
        GroundEdit edit = GroundEdit.of(colliders, collider, after);
        colliders.replace(collider, collider == body ? whole.placed : whole.solid());
        specs[collider] = whole;
        if (edit != null) {
            edit.wake(table.sleepers);
            edit.renew(contacts());
        }
        colliders.measure(body);
        table.registry.changed(body);
        return true;
    }

    /** Where a collider is among the {@link #parts} of its body. */
    private int placeOf(int collider) {
        int place = 0;
        for (int c = first(colliders.body[collider]); c != collider; c = colliders.next[c]) {
            place += colliders.isWhole(c) ? 0 : 1;
        }
        return place;
    }

    /** What a body is made of, without the wholes. */
    List<Collider> parts(int body) {
        List<Collider> parts = new ArrayList<>();
        for (int c = first(body); c != ColliderStore.NONE; c = colliders.next[c]) {
            if (!colliders.isWhole(c)) {
                parts.add(specs[c]);
            }
        }
        return parts;
    }

    /** Throws before anything is changed. */
    MassProperties massNow(int body, List<Collider> parts) {
        return mass(body, parts, colliders.bodies.inverseMass[body] == 0);
    }

    /** The same for a body that nothing moves, or that is moved. */
    private MassProperties mass(int body, List<Collider> parts, boolean fixed) {
        MassProperties p = Collider.mass(parts, fixed, given.get(body));
        if (!fixed) {
            BodyMass.inverseInertia(p);
        }
        return p;
    }

    /** The only collider of a body becomes a child. */
    private void split(int body) {
        if (first(body) != body) {
            return;
        }
        ColliderRef ref = ref(body);
        broadPhase.remove(body);
        colliders.detach(body);
        refs.move(ref, child(body, now(body)));
    }

    /**
     * The only child of a body becomes its only collider, with the body's pose, unless the body's
     * centre is not that of its shape.
     */
    private void join(int body) {
        int c = first(body);
        if (colliders.next[c] != ColliderStore.NONE || given.get(body).hasCentre()) {
            return;
        }
        ColliderRef ref = ref(c);
        Collider part = now(c);
        takeOut(body, c);
        only(body, part);
        refs.move(ref, body);
    }

    private void takeOut(int body, int collider) {
        colliders.remove(body, collider);
        table.registry.leaveChild(collider);
        refs.end(collider);
    }

    /**
     * Mass, centre and radii of a body that is made of something else now. Its frame stays where it
     * is, and each of its points keeps its velocity.
     */
    void settle(int body, MassProperties p) {
        table.access.setMass(body, p);
        for (int c = first(body); c != ColliderStore.NONE && c != body; c = colliders.next[c]) {
            if (!colliders.isWhole(c)) {
                System.arraycopy(
                        local(body, specs[c]), 0, colliders.local, ColliderStore.LOCAL * c, 7);
            }
        }
        joinParts(body);
        colliders.measure(body);
        table.registry.changed(body);
    }

    /** Mass, centre and inertia of a body as it would be if it moved, or did not. */
    MassProperties massAs(int body, boolean fixed) {
        return mass(body, parts(body), fixed);
    }

    /** States something of the mass, the rest follows from the parts. */
    void state(int body, MassOverride wanted) {
        MassOverride old = given.get(body);
        given.set(body, wanted);
        MassProperties p;
        try {
            p = massNow(body, parts(body));
        } catch (IllegalArgumentException refusal) {
            given.set(body, old);
            throw refusal;
        }
        if (wanted.hasCentre()) {
            split(body);
        }
        if (rules.canMove(body) || !table.registry.isCentre(body, p)) {
            settle(body, p);
        } else {
            table.access.setMass(body, p); // concerns no other body
        }
    }

    /** What the user states of a body's mass. */
    MassOverride stated(int body) {
        return given.get(body);
    }

    /** As another world: its pairs are what they are, and are not asked anew. */
    void askAs(ColliderTable other) {
        choose(other.asked);
    }

    private void choose(@Nullable BiPredicate<ColliderRef, ColliderRef> test) {
        asked = test;
        pairFilter.ask(test == null ? null : (a, b) -> test.test(ref(a), ref(b)));
    }

    void ask(@Nullable BiPredicate<ColliderRef, ColliderRef> test) {
        choose(test);
        rules.renew();
    }
}
