package dev.cairn.physics.contact.seam;

import dev.cairn.physics.contact.BoundsStage;
import dev.cairn.physics.contact.PointOrder;
import dev.cairn.physics.contact.PointStore;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactMaterials;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.curved.PlaneContact;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.HalfSpace;

import java.util.Arrays;

/**
 * The row of M and a joined surface: M's contact with the plane of it, if each point of that is
 * over a member of the surface. It goes on where a row of the last tick ended, or where the rows
 * did that it stands for.
 *
 * <p>One instance per worker.
 */
final class JoinedRow {
    private static final HalfSpace PLANE = HalfSpace.of();

    /** Of the inner radius: places of a point on two bodies that are farther apart are two. */
    private static final double APART = 0x1p-20;

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final BoundsStage bounds;
    private final PointStore points;
    private final SeamMembers members;
    private final PointStore.Scratch scratch = new PointStore.Scratch();
    private final NarrowPhase narrowPhase = new NarrowPhase();
    private final Manifold manifold = new Manifold();
    private final int[] one = new int[1];

    private double reach;

    /** See {@link #stand}; the neighbour that the row is of, and from M's centre to its. */
    private int common, base;

    private double baseX, baseY, baseZ;

    /** Whether M is the second of the row. */
    private boolean isSecond;

    JoinedRow(
            ColliderStore colliders,
            ContactStore contacts,
            BoundsStage bounds,
            PointStore points,
            SeamMembers members) {
        this.colliders = colliders;
        this.contacts = contacts;
        this.bounds = bounds;
        this.points = points;
        this.members = members;
    }

    /** Chooses the share of the tick in which relative motion counts, s. */
    void within(double reachSeconds) {
        reach = reachSeconds;
    }

    /**
     * Chooses the neighbour that rows are told of where it stands still against the others: so rows
     * of parts of one body are solved in the order of the parts, whatever they touch.
     *
     * @param collider or {@link ColliderStore#NONE} for the one that a plane is of
     */
    void stand(int collider) {
        common = collider;
    }

    /**
     * Makes the row of a plane, if M stands on it with nothing but what is over its members.
     *
     * @param leader the member whose plane it is; those up to {@code end} are behind it
     * @param record in the memory, where the row goes on; -1 for none
     * @return whether it was made
     */
    boolean make(int row, int leader, int end, SeamMemory memory, int record) {
        if (isOfMeeting(members.row(leader)) && isOnly(leader, end)) {
            return false;
        }
        chooseBase(leader);
        long key;
        if (record >= 0 && memory.isSecond(record) == isSecond) {
            key = memory.key(record);
        } else {
            key = PlaneContact.key(record >= 0 ? memory.names(record) : names(leader, end));
        }
        key = collide(leader, key);
        for (int p = 0; p < manifold.pointCount; p++) {
            if (!isSupported(p, leader, end)) {
                return false;
            }
        }
        if (manifold.pointCount == 0) {
            return false;
        }
        ContactStore c = contacts;
        int like = members.row(leader);
        ContactMaterials.join(
                c, row, colliders, isSecond ? base : members.m, isSecond ? members.m : base);
        ContactMaterials.frictionOf(c, row, like);
        c.cache[row] = key;
        boolean isKnown = record >= 0;
        if (isKnown) {
            memory.load(record, c, row, isSecond, colliders.poses);
        } else {
            isKnown = loadMembers(row, leader, end);
        }
        if (isKnown) {
            points.store(row, manifold, scratch);
        } else {
            points.storeAnew(row, manifold, scratch);
        }
        one[0] = row;
        points.fromBodies(one, 0, 1);
        return true;
    }

    /**
     * Whether a row is of the moment in which its bodies meet within the tick: then its points are
     * at two places now, one on each body. What the plane would be at the tick's start says less.
     */
    private boolean isOfMeeting(int row) {
        ContactStore c = contacts;
        Poses s = colliders.poses;
        int a = c.bodyA[row];
        int b = c.bodyB[row];
        int p = ContactStore.POINTS * row;
        double x = c.anchorAX(p) - c.anchorBX(p) - s.apartX(a, b);
        double y = c.anchorAY(p) - c.anchorBY(p) - s.apartY(a, b);
        double z = c.anchorAZ(p) - c.anchorBZ(p) - s.apartZ(a, b);
        double least = APART * colliders.innerRadius[members.m];
        return x * x + y * y + z * z > least * least;
    }

    /** Whether no other member touches along the plane's normal. */
    private boolean isOnly(int leader, int end) {
        for (int k = leader + 1; k < end; k++) {
            if (members.isSame(k, leader)) {
                return false;
            }
        }
        return true;
    }

    private void chooseBase(int leader) {
        base = members.neighbour(leader);
        BodyStore s = colliders.bodies;
        if (common != ColliderStore.NONE
                && s.kind[colliders.body[base]] != BodyStore.DYNAMIC
                && members.movesTogether(common, base)) {
            base = common;
        }
        isSecond = base < members.m;
        Poses p = colliders.poses;
        baseX = p.apartX(members.m, base);
        baseY = p.apartY(members.m, base);
        baseZ = p.apartZ(members.m, base);
    }

    /**
     * The names of the corners with which M stands on the members, as {@link FeatureIds} sums them
     * up: of a rim that has no corners of its own the plane shall choose the same points.
     */
    private int names(int leader, int end) {
        ContactStore c = contacts;
        int own = isSecond ? FeatureIds.VERTEX_B : FeatureIds.VERTEX_A;
        int names = 0;
        int known = 0;
        for (int k = leader; k < end; k++) {
            if (!members.isSame(k, leader)) {
                continue;
            }
            int like = members.row(k);
            int flip = members.isSecond(k) != isSecond ? FeatureIds.VERTEX_B : 0;
            for (int p = 0; p < c.pointCount[like]; p++) {
                int name = c.feature[ContactStore.POINTS * like + p] ^ flip;
                if ((name & FeatureIds.CLOSEST) == own
                        && known < ContactStore.POINTS
                        && !FeatureIds.contains(names, name)) {
                    names |= FeatureIds.hash(name) << (8 * known++);
                }
            }
        }
        return names;
    }

    /** The contact of M with the plane of a member, as of the row to be. */
    private long collide(int leader, long key) {
        Poses s = colliders.poses;
        int i = 3 * leader;
        double x = members.normal[i];
        double y = members.normal[i + 1];
        double z = members.normal[i + 2];
        double h = members.plane[leader];
        // the shortest turn of the y axis to the normal, by way of its opposite if that is nearer
        boolean up = y >= 0;
        double px = up ? z : 1 - y;
        double py = up ? 0 : x;
        double pz = up ? -x : 0;
        double pw = up ? 1 + y : z;
        int other = members.neighbour(leader);
        double margin = bounds.margin(members.m, other, reach, colliders.innerRadius[members.m]);
        double sign = isSecond ? -1 : 1;
        double dx = sign * h * x;
        double dy = sign * h * y;
        double dz = sign * h * z;
        double qx = s.orientationX[members.m];
        double qy = s.orientationY[members.m];
        double qz = s.orientationZ[members.m];
        double qw = s.orientationW[members.m];
        if (!isSecond) {
            return narrowPhase.collide(
                    colliders.shape[members.m],
                    PLANE,
                    qx,
                    qy,
                    qz,
                    qw,
                    px,
                    py,
                    pz,
                    pw,
                    dx,
                    dy,
                    dz,
                    margin,
                    key,
                    manifold);
        }
        long next =
                narrowPhase.collide(
                        PLANE,
                        colliders.shape[members.m],
                        px,
                        py,
                        pz,
                        pw,
                        qx,
                        qy,
                        qz,
                        qw,
                        dx,
                        dy,
                        dz,
                        margin,
                        key,
                        manifold);
        // from a point of the plane to the centre of A
        for (int p = 0; p < manifold.pointCount; p++) {
            manifold.pointX[p] += h * x - baseX;
            manifold.pointY[p] += h * y - baseY;
            manifold.pointZ[p] += h * z - baseZ;
        }
        return next;
    }

    /** Whether a point of the plane is over a member whose surface is like the leader's. */
    private boolean isSupported(int p, int leader, int end) {
        double half = manifold.separation[p] / 2;
        int i = 3 * leader;
        double x = manifold.pointX[p] - half * members.normal[i] + (isSecond ? baseX : 0);
        double y = manifold.pointY[p] - half * members.normal[i + 1] + (isSecond ? baseY : 0);
        double z = manifold.pointZ[p] - half * members.normal[i + 2] + (isSecond ? baseZ : 0);
        for (int k = leader; k < end; k++) {
            if (members.holds(k, x, y, z)
                    && ContactMaterials.isAlike(contacts, members.row(k), members.row(leader))) {
                return true;
            }
        }
        return false;
    }

    /**
     * Makes a row what its members are: each vertex of M once, then other points of theirs.
     *
     * @return whether all are of one member, whose order the row then has
     */
    private boolean loadMembers(int row, int leader, int end) {
        ContactStore c = contacts;
        c.pointCount[row] = 0;
        c.forgetFriction(row);
        if (c.compounds) {
            // points are told from the centres of colliders
            Arrays.fill(c.lever, 6 * row, 6 * row + 6, 0.0);
        }
        int sources = 0;
        for (int pass = 0; pass < 2; pass++) {
            for (int k = leader; k < end; k++) {
                int before = c.pointCount[row];
                if (members.isSame(k, leader)) {
                    loadMember(row, k, pass == 0);
                    sources += c.pointCount[row] > before ? 1 : 0;
                }
            }
        }
        int first = ContactStore.POINTS * row;
        c.order[row] = (byte) PointOrder.of(c.feature, first, c.pointCount[row]);
        return sources == 1;
    }

    private void loadMember(int row, int k, boolean vertices) {
        ContactStore c = contacts;
        int like = members.row(k);
        boolean flips = members.isSecond(k) != isSecond;
        int own = isSecond ? FeatureIds.VERTEX_B : FeatureIds.VERTEX_A;
        for (int p = ContactStore.POINTS * like;
                p < ContactStore.POINTS * like + c.pointCount[like];
                p++) {
            int kind = c.feature[p] & FeatureIds.CLOSEST;
            int name = flips ? c.feature[p] ^ FeatureIds.VERTEX_B : c.feature[p];
            boolean isVertex = kind == FeatureIds.CLOSEST || (name & FeatureIds.CLOSEST) == own;
            if (isVertex != vertices) {
                continue;
            }
            int to = ContactStore.POINTS * row;
            int end = to + c.pointCount[row];
            while (to < end && c.feature[to] != name) {
                to++;
            }
            if (to == end) {
                if (c.pointCount[row] == ContactStore.POINTS) {
                    continue;
                }
                c.pointCount[row]++;
                c.feature[to] = name;
                c.normalImpulse[to] = 0;
                c.preload[to] = 0;
                place(to, p, k);
            }
            c.normalImpulse[to] += c.normalImpulse[p];
            c.preload[to] += c.preload[p];
            if (c.compounds && c.rank(to) == 0) {
                c.setRank(to, c.rank(p));
            }
        }
        if (vertices) {
            c.addFriction(row, like, flips ? -1 : 1);
        }
    }

    /** Where a point of a member is, from the centre of collider A of the row to be. */
    private void place(int to, int p, int k) {
        ContactStore c = contacts;
        int side = members.isSecond(k) ? 3 : 0;
        int from = ContactStore.anchor(p) + side;
        int lever = 6 * members.row(k) + side;
        double x = c.anchors[from] - (c.compounds ? c.lever[lever] : 0);
        double y = c.anchors[from + 1] - (c.compounds ? c.lever[lever + 1] : 0);
        double z = c.anchors[from + 2] - (c.compounds ? c.lever[lever + 2] : 0);
        if (isSecond) {
            c.setAnchors(to, x - baseX, y - baseY, z - baseZ, x, y, z);
        } else {
            c.setAnchors(to, x, y, z, x - baseX, y - baseY, z - baseZ);
        }
    }
}
