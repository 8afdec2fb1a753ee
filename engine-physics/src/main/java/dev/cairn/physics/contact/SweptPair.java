package dev.cairn.physics.contact;

import dev.cairn.physics.contact.impact.MovingPair;
import dev.cairn.physics.contact.impact.PartingSearch;
import dev.cairn.physics.contact.impact.SurfacePlane;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.sweep.Flight;
import dev.cairn.physics.sweep.FreeRotationPath;
import dev.cairn.physics.sweep.TimeOfImpact;

/**
 * Two colliders along the motion of a tick: each body's centre on its parabola, turning about it
 * freely. When they meet is found by {@link TimeOfImpact}.
 *
 * <p>One instance per worker.
 */
final class SweptPair implements MovingPair {
    /** Steps; a pair that is near and has not been decided by then is taken to meet. */
    private static final int MOST_STEPS = 128;

    /** Steps; a pair that has not been decided by then is not swept. */
    private static final int MOST_IN_ALL = 512;

    /** Of the sizes: what is near then. */
    private static final double NEAR = 0x1p-16;

    /** Of the smaller size, and of the larger one: nearer counts as met. */
    private static final double MET = 0x1p-36, ROUNDING = 0x1p-48;

    /** The same of balls. */
    private static final double EXACT = 0x1p-46;

    /** Of a tick: times of meetings are multiples of it. */
    private static final double GRAIN = 0x1p-38, FINE = 0x1p-48;

    /** Of the inner radius. */
    private static final double MOST_DOUBT = 0.25;

    /** Of the smaller inner radius: points that far apart are of the meeting. */
    private static final double THERE = 0.02;

    /** In place of a fixed surface of triangles. */
    private static final HalfSpace GROUND = HalfSpace.of();

    /** The body that is turned, seen from far away. */
    private static final Sphere POINT = Sphere.of(0x1p-90);

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final BoundsStage bounds;
    private final NarrowPhase narrowPhase = new NarrowPhase();
    private final TimeOfImpact search =
            new TimeOfImpact(narrowPhase, MOST_STEPS, NEAR, MOST_IN_ALL);
    private final Manifold manifold = new Manifold();
    private final SurfacePlane plane;
    private final PartingSearch parting = new PartingSearch(MOST_IN_ALL);
    private final MeetingContact meeting;
    private final Flight a = new Flight(), b = new Flight();
    private final FreeRotationPath freeA = new FreeRotationPath(), freeB = new FreeRotationPath();
    private int slotA, slotB;
    private double step;

    /** Whether {@link #meetSometime} saw them apart at the end of the tick. */
    private boolean isSeenAtEnd;

    /** Of the last {@link #setUp}. */
    private double fromX, fromY, fromZ, met, exact, size, doubtA, doubtB;

    /** By body: 0 where nothing but gravity and the user's forces accelerates it. */
    private byte[] freedom = {};

    /** Whether the two of the last {@link #meetAgain} stay in touch. */
    private boolean stays;

    private double time;

    SweptPair(
            ColliderStore colliders, ContactStore contacts, BoundsStage bounds, PointStore points) {
        this.colliders = colliders;
        this.contacts = contacts;
        this.bounds = bounds;
        plane = new SurfacePlane(colliders, contacts);
        meeting = new MeetingContact(contacts, points, plane);
    }

    @Override
    public void use(byte[] free) {
        freedom = free;
    }

    /** Whether the colliders of a row meet within a tick. */
    boolean meet(int row, double stepSeconds) {
        setUp(row, stepSeconds);
        return find(0) && !(met > exact && isOutOfReach());
    }

    /**
     * Whether the colliders of a row surely pass each other within a tick: a plane across its
     * normal stays between them, or turns with one of them. False says nothing.
     */
    boolean pass(int row, double stepSeconds) {
        setUp(row, stepSeconds);
        return search(met)
                .arePassing(
                        step, contacts.normalX(row), contacts.normalY(row), contacts.normalZ(row));
    }

    /** After {@link #pass} said no: whether the colliders of a row pass each other at a corner. */
    boolean passCorner(int row) {
        boolean isFirst = plane.isFirst();
        if (!isFirst && !plane.isSecond()) {
            return false;
        }
        boolean passes =
                plane.isPassed(
                        row,
                        isFirst ? b : a,
                        colliders.outerRadius[isFirst ? slotB : slotA],
                        step,
                        met,
                        search);
        search(met); // other questions about the two follow
        return passes;
    }

    /** Whether those looked at last go less far than they are thick; see {@link #collideThere}. */
    boolean isShort() {
        return search.fastest() * step <= inner();
    }

    /**
     * After {@link #pass} said no: whether the colliders of a row, which are apart, surely meet
     * within the tick at a time that need not be known: they overlap at its end, and their way
     * {@link #isShort}. False says nothing.
     */
    boolean meetSometime(int row) {
        ContactStore c = contacts;
        boolean haveMet =
                met == exact
                        && search.haveMet(step, c.normalX(row), c.normalY(row), c.normalZ(row));
        isSeenAtEnd = met == exact && !haveMet;
        return haveMet && isShort();
    }

    /** After {@link #meetSometime} said no: {@link #pass}, by an axis that turns. */
    boolean goAround(int row) {
        ContactStore c = contacts;
        return isSeenAtEnd && search.areHeldApart(c.normalX(row), c.normalY(row), c.normalZ(row));
    }

    @Override
    public boolean meet(int first, int second, double from, double stepSeconds) {
        plane.clear();
        setUp(first, second, stepSeconds);
        if (from > 0) {
            met = exact;
        }
        return find(from) && !(met > exact && isOutOfReach());
    }

    /**
     * Whether two that a torque turns, and may have met but for what is not known of their turning,
     * do not come near however they lie: a ball about each of those is as large as it at most.
     */
    private boolean isOutOfReach() {
        if (colliders.isChild(slotA) || colliders.isChild(slotB)) {
            return false;
        }
        double until = time;
        double around = exact + shrink(a, doubtA, slotA) + shrink(b, doubtB, slotB);
        boolean meet = search(around).find(0, step, size);
        boolean isFar = !meet && !search.isUndecided;
        setUp(slotA, slotB, step);
        stand();
        time = until;
        a.move(time);
        b.move(time);
        search.isUndecided = false;
        return isFar;
    }

    /** Makes a point of a shape that was turned; returns how far it reaches, m. */
    private double shrink(Flight f, double doubt, int slot) {
        if (doubt == 0) {
            return 0;
        }
        f.shape = POINT;
        f.begin(0, true);
        return colliders.outerRadius[slot];
    }

    /** Whether both are balls, whose distance is a formula. */
    private boolean isRound() {
        return a.shape instanceof Sphere && b.shape instanceof Sphere;
    }

    /** The colliders of a row; the row's plane in place of a surface of triangles. */
    private void setUp(int row, double stepSeconds) {
        setUp(contacts.colliderA[row], contacts.colliderB[row], stepSeconds);
        plane.find(row);
        stand();
    }

    private void stand() {
        if (plane.isFirst()) {
            stand(a);
            from(-1, slotB);
        } else if (plane.isSecond()) {
            stand(b);
            from(1, slotA);
        }
    }

    private void stand(Flight f) {
        f.shape = GROUND;
        f.turned(plane.qx, plane.qy, plane.qz, plane.qw);
        f.lever(plane.x, plane.y, plane.z);
        f.begin(Double.POSITIVE_INFINITY, false);
    }

    /** The way from the first to the second ends elsewhere; the sizes are those of the solid. */
    private void from(double sign, int solid) {
        fromX += sign * plane.fromOriginX();
        fromY += sign * plane.fromOriginY();
        fromZ += sign * plane.fromOriginZ();
        size = colliders.outerRadius[solid];
        exact = (MET + ROUNDING) * size;
        met = exact + doubtA + doubtB;
    }

    private void setUp(int first, int second, double stepSeconds) {
        slotA = first;
        slotB = second;
        step = stepSeconds;
        doubtA = set(a, freeA, first);
        doubtB = set(b, freeB, second);
        Poses p = colliders.poses;
        fromX = p.apartX(first, second);
        fromY = p.apartY(first, second);
        fromZ = p.apartZ(first, second);
        size = Math.min(size(first, second), size(second, first));
        exact =
                (isRound() ? EXACT : MET) * size
                        + ROUNDING * Math.max(size(first, second), size(second, first));
        met = exact + doubtA + doubtB;
    }

    /** For the two of the last {@link #setUp}. */
    private TimeOfImpact search(double nearer) {
        return search.of(a, b, fromX, fromY, fromZ, nearer);
    }

    private boolean find(double from) {
        boolean meet = search(met).find(from, step, size);
        // distances have no mirrored bits, so a mirrored scene would strike at another time
        double grain = step * (isRound() ? FINE : GRAIN);
        time = Math.max(from, Math.floor(search.time / grain) * grain);
        a.move(time);
        b.move(time);
        return meet;
    }

    @Override
    public boolean meetAgain(int first, int second, double from, double stepSeconds) {
        plane.clear();
        setUp(first, second, stepSeconds);
        met = exact;
        stays = false;
        if (!find(from)) {
            return false;
        }
        if (time > from) {
            return true;
        }
        return part();
    }

    /**
     * From a meeting on: they part, and may meet again; or sink into each other, which is the next
     * meeting; or neither, until the tick ends.
     */
    private boolean part() {
        PartingSearch.End end = parting.run(search, time, step, met, inner());
        if (end == PartingSearch.End.PARTS) {
            return parting.time < step && find(parting.time);
        }
        stays = end == PartingSearch.End.STAYS;
        if (!stays) {
            time = parting.time;
            a.move(time);
            b.move(time);
        }
        return !stays;
    }

    @Override
    public Manifold across() {
        double gap =
                narrowPhase.distance(
                        a.shape, b.shape, a.qx, a.qy, a.qz, a.qw, b.qx, b.qy, b.qz, b.qw, apartX(),
                        apartY(), apartZ());
        collide(Math.max(0, gap) + met + THERE * inner());
        return manifold;
    }

    @Override
    public boolean stays() {
        return stays;
    }

    @Override
    public boolean isUndecided() {
        return search.isUndecided;
    }

    @Override
    public void place(int first, int second, double seconds, double stepSeconds) {
        plane.clear();
        setUp(first, second, stepSeconds);
        time = seconds;
        a.move(time);
        b.move(time);
    }

    @Override
    public double time() {
        return time;
    }

    @Override
    public double bend(int body) {
        double x = acceleration(body, bounds.gravityX, colliders.bodies.forceX);
        double y = acceleration(body, bounds.gravityY, colliders.bodies.forceY);
        double z = acceleration(body, bounds.gravityZ, colliders.bodies.forceZ);
        return 0.5 * Math.sqrt(x * x + y * y + z * z);
    }

    @Override
    public Manifold there() {
        collide(met + THERE * inner());
        return manifold;
    }

    /** Of the thinner one, m. */
    private double inner() {
        return Math.min(colliders.innerRadius[slotA], colliders.innerRadius[slotB]);
    }

    private void collide(double margin) {
        narrowPhase.collide(
                a.shape, b.shape, a.qx, a.qy, a.qz, a.qw, b.qx, b.qy, b.qz, b.qw, apartX(),
                apartY(), apartZ(), margin, 0, manifold);
    }

    @Override
    public Flight first() {
        return a;
    }

    @Override
    public Flight second() {
        return b;
    }

    @Override
    public double apartX() {
        return fromX + b.x - a.x;
    }

    @Override
    public double apartY() {
        return fromY + b.y - a.y;
    }

    @Override
    public double apartZ() {
        return fromZ + b.z - a.z;
    }

    private double size(int slot, int other) {
        double outer = colliders.outerRadius[slot];
        return outer < Double.POSITIVE_INFINITY ? outer : colliders.outerRadius[other];
    }

    /**
     * Puts the contact of the meeting into a row, told of the start of the tick: its points are
     * where they are on the bodies, and as far apart as they approach until then. Only after a way
     * that is longer than the bodies are thick.
     *
     * @param reach of the margin, s
     */
    void collideThere(int row, double reach) {
        double wayX = b.x - a.x;
        double wayY = b.y - a.y;
        double wayZ = b.z - a.z;
        double thin = inner();
        double way = wayX * wayX + wayY * wayY + wayZ * wayZ;
        double turned = (a.rim() + b.rim()) * time;
        boolean balls =
                colliders.bodies.isBall[colliders.body[slotA]]
                        && colliders.bodies.isBall[colliders.body[slotB]];
        if ((way <= thin * thin && turned <= thin) || balls) {
            return;
        }
        tell(row, reach);
    }

    @Override
    public Manifold tell(int row, double reach) {
        collide(bounds.margin(slotA, slotB, reach, inner()));
        meeting.tell(row, manifold, a, b, apartX(), apartY(), apartZ(), inner());
        return manifold;
    }

    /**
     * Sets the way of a collider.
     *
     * @return what its turning is uncertain by, m
     */
    private double set(Flight f, FreeRotationPath free, int slot) {
        BodyStore s = colliders.bodies;
        int body = colliders.body[slot];
        f.shape = colliders.shape[slot];
        f.vx = s.velocityX[body];
        f.vy = s.velocityY[body];
        f.vz = s.velocityZ[body];
        f.wx = s.angularVelocityX[body];
        f.wy = s.angularVelocityY[body];
        f.wz = s.angularVelocityZ[body];
        boolean isDynamic = s.kind[body] == BodyStore.DYNAMIC;
        boolean flies = isDynamic && freedom[body] == 0;
        f.ax = flies ? acceleration(body, bounds.gravityX, colliders.bodies.forceX) : 0;
        f.ay = flies ? acceleration(body, bounds.gravityY, colliders.bodies.forceY) : 0;
        f.az = flies ? acceleration(body, bounds.gravityZ, colliders.bodies.forceZ) : 0;
        f.turned(
                s.orientationX[slot],
                s.orientationY[slot],
                s.orientationZ[slot],
                s.orientationW[slot]);
        boolean isChild = colliders.isChild(slot);
        f.lever(
                isChild ? s.apartX(body, slot) : 0,
                isChild ? s.apartY(body, slot) : 0,
                isChild ? s.apartZ(body, slot) : 0);
        f.begin(colliders.outerRadius[slot], f.shape instanceof Sphere);
        if (isDynamic && f.rim() > 0 && free.begin(s, body, step)) {
            f.tumbles(free, step);
        }
        double most = MOST_DOUBT * colliders.innerRadius[slot];
        double doubt =
                isDynamic ? FreeRotationPath.doubt(s, body, step, colliders.outerRadius[slot]) : 0;
        return Math.min(doubt, most);
    }

    /** Acceleration of a body that flies along an axis, m/s². */
    private double acceleration(int body, double gravity, double[] force) {
        BodyStore s = colliders.bodies;
        return s.gravityScale[body] * gravity + s.inverseMass[body] * force[body];
    }

    @Override
    public void back(int body, double seconds, double[] state) {
        freeA.back(colliders.bodies, body, step, seconds, state);
    }
}
