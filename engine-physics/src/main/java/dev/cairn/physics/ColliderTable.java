package dev.cairn.physics;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.broadphase.PairFilter;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.internal.BodyMass;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.mesh.Meshed;
import dev.cairn.physics.state.GroundEdit;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiPredicate;

/**
 * The colliders as users know them, by slot: references, filters, who was taken apart. Simulation
 * thread, between steps.
 */
final class ColliderTable implements Stateful {
    final ColliderStore colliders;
    final PairFilter pairFilter;
    private final BodyTable table;
    private final BroadPhase broadPhase;

    private @Nullable BiPredicate<ColliderRef, ColliderRef> asked;

    /** By slot; that of a collider that is gone stays until the slot is used again. */
    private ColliderRef[] refs = {};

    /** Room to restore the references: those of the state, and those that there were. */
    private ColliderRef[] savedRefs = {}, before = {};

    /** What each collider was made of, with material; its filter may be another one by now. */
    private Collider[] specs = {};

    /** Where the references say that their colliders are; room to save them. */
    private int[] places = {};

    /** By body: mass and inertia that the user gave instead, or NaN. */
    private double[] kilograms = {}, inertiaXX = {}, inertiaYY = {}, inertiaZZ = {};

    ColliderTable(BodyTable table) {
        this.table = table;
        colliders = table.colliders;
        broadPhase = table.broadPhase;
        pairFilter = table.roster.pairFilter;
    }

    /** The reference to a collider, or to the last one in its slot. */
    ColliderRef ref(int collider) {
        return refs[collider];
    }

    /** What a collider is made of; its filter may be another one by now. */
    Collider spec(int collider) {
        return specs[collider];
    }

    /** The same with the filter that it has now. */
    Collider now(int collider) {
        return specs[collider].filter(colliders.filter[collider]);
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

    /**
     * A reference that the world has given stays the one to its collider, and one to none is dead.
     */
    @Override
    public void state(StateVisitor s) {
        s.section("colliderTable", this);
        ensureSlots();
        int slots = colliders.slotCount;
        if (places.length < slots) {
            places = new int[specs.length];
        }
        for (int c = 0; c < slots && !s.isRestoring(); c++) {
            places[c] = refs[c] == null ? -1 : refs[c].slot();
        }
        ColliderRef[] saved = s.array("refs", s.isRestoring() ? savedRefs : refs, slots);
        savedRefs = s.isRestoring() ? saved : savedRefs;
        places = s.array("places", places, slots);
        specs = s.array("specs", specs, slots);
        kilograms = s.array("kilograms", kilograms, slots);
        inertiaXX = s.array("inertiaXX", inertiaXX, slots);
        inertiaYY = s.array("inertiaYY", inertiaYY, slots);
        inertiaZZ = s.array("inertiaZZ", inertiaZZ, slots);
        if (s.isRestoring()) {
            own(saved);
        }
    }

    private void own(ColliderRef[] saved) {
        if (before.length < refs.length) {
            before = new ColliderRef[refs.length];
        }
        System.arraycopy(refs, 0, before, 0, refs.length);
        ColliderRef[] now = before;
        for (ColliderRef ref : refs) {
            if (ref != null) {
                ref.move(-1);
            }
        }
        Arrays.fill(refs, null);
        for (int c = 0; c < colliders.slotCount; c++) {
            ColliderRef ref = saved[c];
            if (ref == null) {
                continue;
            }
            if (!ref.isOf(this)) {
                BodyRef body = table.refs[ref.body().slot()];
                ref = now[c] != null && now[c].body() == body ? now[c] : null;
                ref = ref == null ? new ColliderRef(this, body, places[c]) : ref;
            }
            refs[c] = ref;
        }
        for (int c = 0; c < colliders.slotCount; c++) {
            if (refs[c] != null) {
                refs[c].move(places[c]);
            }
        }
    }

    // What a body is made of ---------------------------------------------------------------------

    /** Mass, centre and inertia of parts, or what the user gave instead. */
    static MassProperties mass(List<Collider> parts, Body body) {
        return mass(
                parts,
                body.type != BodyType.DYNAMIC,
                body.mass,
                body.inertiaXX,
                body.inertiaYY,
                body.inertiaZZ);
    }

    private static MassProperties mass(
            List<Collider> parts, boolean fixed, double mass, double xx, double yy, double zz) {
        for (Collider part : parts) {
            if (!fixed && isSurface(part.shape())) {
                throw new IllegalArgumentException(
                        part.shape()
                                + " is a surface without an inside, so its body cannot be dynamic;"
                                + " make the body fixed or kinematic, or take ConvexHull.of its"
                                + " vertices, or several hulls as colliders of one body");
            }
        }
        if (parts.size() == 1) {
            Collider only = parts.get(0);
            double density = only.material().density();
            return BodyMass.of(only.placed, density, fixed, mass, xx, yy, zz);
        }
        List<MassProperties> all = new ArrayList<>();
        boolean solid = false;
        for (Collider part : parts) {
            solid |= !part.sensor;
        }
        for (Collider part : parts) {
            if (!part.sensor || !solid) {
                all.add(part.placed.massProperties(part.material().density()));
            }
        }
        return BodyMass.of(parts, BodyMass.sum(all), fixed, mass, xx, yy, zz);
    }

    /** Gives a body that has none its colliders; its slot and pose are set. */
    void attach(int body, List<Collider> parts, Body given) {
        ensureSlots();
        kilograms[body] = given.mass;
        inertiaXX[body] = given.inertiaXX;
        inertiaYY[body] = given.inertiaYY;
        inertiaZZ[body] = given.inertiaZZ;
        colliders.bodies.collider[body] = ColliderStore.NONE;
        if (parts.size() == 1) {
            only(body, parts.get(0));
        } else {
            for (Collider part : parts) {
                child(body, part);
            }
        }
        measure(body);
    }

    private void only(int body, Collider part) {
        colliders.attach(body, part.placed);
        begin(body, part);
    }

    private int child(int body, Collider part) {
        int c = table.roster.takeChild();
        ensureSlots();
        contacts().beginCompounds();
        pairFilter.begin(); // parts of a body do not meet
        colliders.append(body, c, solid(part), local(body, part));
        begin(c, part);
        return c;
    }

    private static Shape solid(Collider part) {
        return part.placed instanceof Moved m ? m.inner() : part.placed;
    }

    /** Where a part is, from the body's centre of mass. */
    private double[] local(int body, Collider part) {
        MassProperties p = part.placed.massProperties(1);
        double[] pose = {
            p.comX() - table.roster.comX[body],
            p.comY() - table.roster.comY[body],
            p.comZ() - table.roster.comZ[body],
            0,
            0,
            0,
            1
        };
        if (part.placed instanceof Moved m) {
            pose[3] = m.rotationX();
            pose[4] = m.rotationY();
            pose[5] = m.rotationZ();
            pose[6] = m.rotationW();
        }
        return pose;
    }

    /** A collider that is new in its slot. */
    private void begin(int c, Collider part) {
        refs[c] = new ColliderRef(this, table.refs[colliders.body[c]], c);
        surface(c, part);
    }

    private void surface(int c, Collider part) {
        Material material = part.material();
        specs[c] = part;
        colliders.friction[c] = material.friction();
        colliders.restitution[c] = material.restitution();
        colliders.rollingArm[c] = material.rollingArm();
        colliders.mixing[c] =
                (byte)
                        (material.frictionMix().strength()
                                | material.restitutionMix().strength() << 4);
        colliders.userData[c] = part.userData;
        colliders.setBelt(c, part.beltX, part.beltY, part.beltZ);
        if (colliders.belts) {
            contacts().beginBelts();
        }
        colliders.sensor[c] = part.sensor;
        if (part.sensor) {
            colliders.sensors = true;
            pairFilter.begin(); // two sensors do not meet
        }
        if (material.rollingArm() > 0) {
            contacts().beginRolling();
        }
        setFilter(c, part.filter());
    }

    /** Another surface; contacts have it from the next step on. */
    void setMaterial(int c, Material material) {
        if (Checks.notNull("material", material).equals(specs[c].material())) {
            return;
        }
        surface(c, now(c).material(material));
        contacts().mixAll(c, colliders);
        table.roster.changed(colliders.body[c]);
        table.changes.wakeAround(colliders.body[c]);
    }

    /**
     * The balls about a body. A body of several parts may be hollow where its centre is: then the
     * smallest ball in a part says how small it is.
     */
    private void measure(int body) {
        BodyStore b = colliders.bodies;
        int first = b.collider[body];
        b.hasBelt[body] = false;
        for (int c = first; colliders.belts && c != ColliderStore.NONE; c = colliders.next[c]) {
            int u = 3 * c;
            b.hasBelt[body] |=
                    colliders.belt[u] != 0
                            || colliders.belt[u + 1] != 0
                            || colliders.belt[u + 2] != 0;
        }
        if (b.hasBelt[body] && b.belts == 0) {
            b.belts = 1;
            b.driven++;
        }
        if (first == body) {
            b.innerRadius[body] = colliders.innerRadius[body];
            b.outerRadius[body] = colliders.outerRadius[body];
            return;
        }
        double inner = 0;
        double least = Double.POSITIVE_INFINITY;
        double outer = 0;
        for (int c = first; c != ColliderStore.NONE; c = colliders.next[c]) {
            int l = ColliderStore.LOCAL * c;
            double x = colliders.local[l];
            double y = colliders.local[l + 1];
            double z = colliders.local[l + 2];
            double arm = Math.sqrt(x * x + y * y + z * z);
            inner = Math.max(inner, colliders.innerRadius[c] - arm);
            least = Math.min(least, colliders.innerRadius[c]);
            outer = Math.max(outer, colliders.outerRadius[c] + arm);
        }
        b.innerRadius[body] = Math.max(inner, least);
        b.outerRadius[body] = outer;
        colliders.compose(body);
    }

    private void ensureSlots() {
        int n = colliders.body.length;
        if (specs.length < n) {
            specs = Arrays.copyOf(specs, n);
            refs = Arrays.copyOf(refs, n);
            kilograms = Arrays.copyOf(kilograms, n);
            inertiaXX = Arrays.copyOf(inertiaXX, n);
            inertiaYY = Arrays.copyOf(inertiaYY, n);
            inertiaZZ = Arrays.copyOf(inertiaZZ, n);
        }
    }

    private ContactStore contacts() {
        return table.contacts;
    }

    // Live changes -------------------------------------------------------------------------------

    /** One more collider on a body. */
    ColliderRef add(int body, Collider part) {
        Collider whole =
                part.orElse(
                        specs[colliders.bodies.collider[body]].material(),
                        colliders.filter[colliders.bodies.collider[body]]);
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
        int at = 0;
        for (int c = colliders.bodies.collider[body]; c != collider; c = colliders.next[c]) {
            at++;
        }
        parts.remove(at);
        if (parts.isEmpty()) {
            throw new IllegalStateException(
                    ref(collider)
                            + " is the only one; a body has at least one collider: replace it, or"
                            + " remove the body");
        }
        MassProperties mass = massNow(body, parts);
        takeOut(body, collider);
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
        if (isSurface(whole.shape()) != isSurface(specs[collider].shape())) {
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
        int at = 0;
        for (int c = colliders.bodies.collider[body]; c != collider; c = colliders.next[c]) {
            at++;
        }
        parts.set(at, whole);
        MassProperties mass = massNow(body, parts);
        boolean isOnly = collider == body;
        colliders.replace(collider, isOnly ? whole.placed : solid(whole));
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
        GroundEdit.wake(colliders, table.sleepers, collider, after);
        colliders.replace(collider, collider == body ? whole.placed : solid(whole));
        specs[collider] = whole;
        measure(body);
        table.roster.changed(body);
        return true;
    }

    private static boolean isSurface(Shape shape) {
        return (shape instanceof Moved m ? m.inner() : shape) instanceof Meshed;
    }

    private List<Collider> parts(int body) {
        List<Collider> parts = new ArrayList<>();
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            parts.add(specs[c]);
        }
        return parts;
    }

    /** Throws before anything is changed. */
    private MassProperties massNow(int body, List<Collider> parts) {
        return mass(body, parts, colliders.bodies.inverseMass[body] == 0);
    }

    /** The same for a body that nothing moves, or that is moved. */
    private MassProperties mass(int body, List<Collider> parts, boolean fixed) {
        MassProperties p =
                mass(
                        parts,
                        fixed,
                        kilograms[body],
                        inertiaXX[body],
                        inertiaYY[body],
                        inertiaZZ[body]);
        if (!fixed) {
            BodyMass.inverseInertia(p);
        }
        return p;
    }

    /** The only collider of a body becomes a child. */
    private void split(int body) {
        if (colliders.bodies.collider[body] != body) {
            return;
        }
        ColliderRef ref = ref(body);
        broadPhase.remove(body);
        colliders.detach(body);
        move(ref, child(body, now(body)));
    }

    /** The only child of a body becomes its only collider. */
    private void join(int body) {
        int c = colliders.bodies.collider[body];
        if (colliders.next[c] != ColliderStore.NONE) {
            return;
        }
        ColliderRef ref = ref(c);
        Collider part = now(c);
        takeOut(body, c);
        only(body, part);
        move(ref, body);
    }

    private void takeOut(int body, int collider) {
        colliders.remove(body, collider);
        table.roster.leaveChild(collider);
        refs[collider].move(-1); // it stays here, for the events of its end
    }

    private void move(ColliderRef ref, int collider) {
        ref.move(collider);
        refs[collider] = ref;
    }

    /**
     * Mass, centre and radii of a body that is made of something else now. Its frame stays where it
     * is, and each of its points keeps its velocity.
     */
    private void settle(int body, MassProperties p) {
        table.access.setMass(body, p);
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE && c != body;
                c = colliders.next[c]) {
            System.arraycopy(local(body, specs[c]), 0, colliders.local, ColliderStore.LOCAL * c, 7);
        }
        measure(body);
        table.roster.changed(body);
    }

    /** Mass, centre and inertia of a body as it would be if it moved, or did not. */
    MassProperties massAs(int body, boolean fixed) {
        return mass(body, parts(body), fixed);
    }

    /** States mass and inertia; what is NaN follows from the parts. */
    private void state(int body, double mass, double xx, double yy, double zz) {
        double[] old = {kilograms[body], inertiaXX[body], inertiaYY[body], inertiaZZ[body]};
        set(body, mass, xx, yy, zz);
        MassProperties p;
        try {
            p = massNow(body, parts(body));
        } catch (IllegalArgumentException refusal) {
            set(body, old[0], old[1], old[2], old[3]);
            throw refusal;
        }
        if (canMove(body)) {
            settle(body, p);
        } else {
            table.access.setMass(body, p);
        }
    }

    private void set(int body, double mass, double xx, double yy, double zz) {
        kilograms[body] = mass;
        inertiaXX[body] = xx;
        inertiaYY[body] = yy;
        inertiaZZ[body] = zz;
    }

    double statedMass(int body) {
        return kilograms[body];
    }

    Vector3d statedInertia(int body, Vector3d d) {
        return d.set(inertiaXX[body], inertiaYY[body], inertiaZZ[body]);
    }

    void stateMass(int body, double mass) {
        state(body, mass, inertiaXX[body], inertiaYY[body], inertiaZZ[body]);
    }

    void stateInertia(int body, double xx, double yy, double zz) {
        state(body, kilograms[body], xx, yy, zz);
    }

    /** Whether all colliders of a body are of a material already. */
    boolean isMadeOf(int body, Material material) {
        boolean all = true;
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            all &= material.equals(specs[c].material());
        }
        return all;
    }

    /** Another surface of all colliders of a body, and the mass that follows from its density. */
    void setMaterials(int body, Material material) {
        List<Collider> parts = new ArrayList<>();
        for (Collider part : parts(body)) {
            parts.add(part.material(material));
        }
        MassProperties p = massNow(body, parts);
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            setMaterial(c, material);
        }
        settle(body, p);
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
        for (int c = 0; c < colliders.slotCount; c++) {
            broadPhase.refilter(c);
        }
    }

    /** The seam of joints: counted, since several may bind the same two bodies. */
    void apart(int bodyA, int bodyB) {
        if (pairFilter.apart(bodyA, bodyB)) {
            refilter(canMove(bodyA) ? bodyA : bodyB);
        }
    }

    /** Takes back one {@link #apart}; also for a body that is leaving. */
    void together(int bodyA, int bodyB) {
        if (pairFilter.together(bodyA, bodyB)) {
            if (canMove(bodyA) || !canMove(bodyB)) {
                refilter(bodyA);
            }
            if (canMove(bodyB) || !canMove(bodyA)) {
                refilter(bodyB);
            }
        }
    }

    /** Asking a floor anew would wake all that lies on it. */
    private boolean canMove(int body) {
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
