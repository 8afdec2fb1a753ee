package dev.cairn.physics.contact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactMaterials;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Reach;
import dev.cairn.physics.shape.HalfSpace;

/**
 * The contacts of one collider M with neighbours that do not move against each other.
 *
 * <p>A contact with the neighbour j has a normal u, towards M. All of j is behind the plane that it
 * touches along u, and the contact keeps M before that plane. A neighbour k is <em>covered</em> by
 * j if it is behind that plane, too:
 *
 * <pre>
 *   h_k(u) &lt;= h_j(u),      h(u) = largest u . p over the points p of a neighbour
 * </pre>
 *
 * <p>Then M cannot meet k without meeting the plane first, so k may not push along any other
 * normal: what the narrow phase found there (the side of the next tile, an edge between two) is
 * inside of the joined surface. That is geometry, without a threshold: a tile that stands out of
 * the plane is not covered, and stops what runs against it.
 *
 * <p>If each point with which M stands on the plane is over one of the covered neighbours, the
 * plane's contact is that of the joined surface, and one row is solved with it: as on a slab. If
 * one is not, the surface ends there; contacts along the plane's normal stay as they are.
 *
 * <p>One instance per worker.
 */
final class SeamPlanes {
    /** More planes than these are not joined for one collider. */
    static final int MOST = 4;

    /** Of M's inner radius: surfaces that are nearer to one plane are flush. */
    private static final double FLUSH = 0x1p-15;

    /** Rounding of a reach, of the lengths that it is the sum of. */
    private static final double ROUNDING = 0x1p-46;

    /** Square of the distance of unit vectors that are the same normal. */
    private static final double SAME = 1e-18;

    /** A row goes on where one of this cosine between their normals ended. */
    private static final double LIKE = 0.9;

    private static final HalfSpace PLANE = HalfSpace.of();

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final BoundsStage bounds;
    private final PointStore points;
    private final PointStore.Scratch scratch = new PointStore.Scratch();
    private final NarrowPhase narrowPhase = new NarrowPhase();
    private final Manifold manifold = new Manifold();
    private final Reach shape = new Reach();
    private final int[] one = new int[1];

    private SeamMemory memory = new SeamMemory();
    private int firstRecord, records;
    private int recordsLeft;

    private int m;

    /** See {@link #stand}; the neighbour that the row is of, and from M's centre to its. */
    private int common, base;

    private double baseX, baseY, baseZ;

    /** Whether M is the second of the row. */
    private boolean isSecond;

    private int size;
    private double reach;
    private int[] member = {};
    private int from;

    /** By member: normal towards M; from M's centre to the neighbour's; least separation. */
    private double[] normal = {}, apart = {}, separation = {};

    private boolean[] covered = {};
    private int[] raw = {};

    SeamPlanes(
            ColliderStore colliders, ContactStore contacts, BoundsStage bounds, PointStore points) {
        this.colliders = colliders;
        this.contacts = contacts;
        this.bounds = bounds;
        this.points = points;
    }

    /** Makes room for groups of some size; between phases only. */
    void ensure(int most) {
        if (raw.length < most) {
            int n = Math.max(32, 2 * most);
            normal = new double[3 * n];
            apart = new double[3 * n];
            separation = new double[n];
            covered = new boolean[n];
            raw = new int[n];
        }
    }

    /** Chooses a collider and its contacts. */
    void begin(int collider, int[] members, int first, int number, double reachSeconds) {
        m = collider;
        member = members;
        from = first;
        size = number;
        reach = reachSeconds;
        ContactStore c = contacts;
        Poses s = colliders.poses;
        for (int i = 0; i < size; i++) {
            int row = row(i);
            double sign = isSecond(i) ? 1 : -1;
            normal[3 * i] = sign * c.normalX(row);
            normal[3 * i + 1] = sign * c.normalY(row);
            normal[3 * i + 2] = sign * c.normalZ(row);
            int k = neighbour(i);
            apart[3 * i] = s.apartX(m, k);
            apart[3 * i + 1] = s.apartY(m, k);
            apart[3 * i + 2] = s.apartZ(m, k);
            double least = Double.POSITIVE_INFINITY;
            for (int p = 0; p < c.pointCount[row]; p++) {
                least = Math.min(least, c.separation[ContactStore.POINTS * row + p]);
            }
            separation[i] = least;
            snap(i);
        }
    }

    /**
     * Takes the normal of the neighbour's face, where that separates as well as the contact's: the
     * narrow phase may have chosen a face of M, which is tilted against the surface.
     */
    private void snap(int i) {
        take(neighbour(i));
        double cosine = shape.findFace(normal[3 * i], normal[3 * i + 1], normal[3 * i + 2]);
        if (cosine < ContactTolerances.NEARLY_PARALLEL) {
            return;
        }
        double x = shape.faceX;
        double y = shape.faceY;
        double z = shape.faceZ;
        double plane =
                shape.along(x, y, z)
                        + x * apart[3 * i]
                        + y * apart[3 * i + 1]
                        + z * apart[3 * i + 2];
        take(m);
        double lowest = -shape.along(-x, -y, -z);
        double held = 2 * ContactTolerances.HYSTERESIS * colliders.innerRadius[m];
        if (lowest - plane >= separation[i] - held) {
            normal[3 * i] = x;
            normal[3 * i + 1] = y;
            normal[3 * i + 2] = z;
        }
    }

    private void take(int collider) {
        Poses s = colliders.poses;
        shape.set(
                colliders.shape[collider],
                s.orientationX[collider],
                s.orientationY[collider],
                s.orientationZ[collider],
                s.orientationW[collider]);
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

    /** Chooses what is known of the last tick: the first so many records. */
    void remember(SeamMemory records, int number) {
        memory = records;
        this.records = number;
        firstRecord = number > 0 ? records.first(m) : 0;
        recordsLeft = (1 << number) - 1;
    }

    private int row(int i) {
        return member[from + i] >> 1;
    }

    private boolean isSecond(int i) {
        return (member[from + i] & 1) != 0;
    }

    private int neighbour(int i) {
        return isSecond(i) ? contacts.colliderA[row(i)] : contacts.colliderB[row(i)];
    }

    /**
     * Finds the planes, one after the other, and joins their contacts. What was a joined row in the
     * last tick goes on as one if M has one neighbour on that plane now, so that nothing changes
     * while M crosses the middle of a tile. Of a body with parts all rows are joined ones if one
     * is.
     *
     * @param target the first row that is free
     * @param at the same, counted from the end of the store's rows
     * @param firstHeld receives, for each row made, where the members begin that it stands for: the
     *     group's members are put in that order
     * @param held receives how many
     * @return how many rows were made
     */
    int join(int target, int at, int[] firstHeld, int[] held) {
        int made = 0;
        int settled = 0;
        while (settled < size && made < MOST) {
            int plane = findPlane(settled);
            for (int i = settled; plane < 0 && i < size; i++) {
                plane = common >= 0 || findRecord(i) >= 0 ? i : -1;
            }
            if (plane < 0) {
                break;
            }
            int end = gather(settled, plane);
            if (makeRow(target + made, settled, end)) {
                firstHeld[at + made] = settled;
                held[at + made] = end - settled;
                for (int i = settled; i < end; i++) {
                    contacts.pointCount[row(i)] = -contacts.pointCount[row(i)];
                }
                made++;
            } else {
                for (int i = settled; i < end; i++) {
                    if (!isSame(i, settled)) {
                        contacts.pointCount[row(i)] = -contacts.pointCount[row(i)];
                    }
                }
            }
            settled = end;
        }
        goOnAlone();
        return made;
    }

    /** The member whose plane covers most of those that are left, itself included; -1 if none. */
    private int findPlane(int begin) {
        int best = -1;
        int most = 1;
        for (int j = begin; j < size; j++) {
            if (best >= 0 && isSame(j, best) && covers(best, j) && covers(j, best)) {
                continue;
            }
            int count = 1;
            for (int k = begin; k < size; k++) {
                count += k != j && covers(j, k) ? 1 : 0;
            }
            if (count > most || (best >= 0 && count == most && separation[j] > separation[best])) {
                best = j;
                most = count;
            }
        }
        return best;
    }

    /** Puts a member and those that it covers next to each other; returns their end. */
    private int gather(int begin, int plane) {
        for (int k = begin; k < size; k++) {
            covered[k] = k != plane && covers(plane, k);
        }
        swap(begin, plane);
        int end = begin + 1;
        for (int k = end; k < size; k++) {
            if (covered[k]) {
                swap(end++, k);
            }
        }
        return end;
    }

    private void swap(int i, int j) {
        if (i == j) {
            return;
        }
        int entry = member[from + i];
        member[from + i] = member[from + j];
        member[from + j] = entry;
        for (int axis = 0; axis < 3; axis++) {
            double number = normal[3 * i + axis];
            normal[3 * i + axis] = normal[3 * j + axis];
            normal[3 * j + axis] = number;
            number = apart[3 * i + axis];
            apart[3 * i + axis] = apart[3 * j + axis];
            apart[3 * j + axis] = number;
        }
        double least = separation[i];
        separation[i] = separation[j];
        separation[j] = least;
        boolean is = covered[i];
        covered[i] = covered[j];
        covered[j] = is;
    }

    /** Whether a neighbour is behind the plane that another one touches along its normal. */
    private boolean covers(int j, int k) {
        if (!movesTogether(neighbour(j), neighbour(k))) {
            return false;
        }
        double plane = height(j, j);
        double most = height(j, k);
        // a half-space reaches for ever along all but one: no rounding of that is a distance
        return most <= plane + slack(j) + Math.min(slack(j), ROUNDING * Math.abs(most));
    }

    /** How far neighbour k reaches along the normal of contact j, from M's centre. */
    private double height(int j, int k) {
        int other = neighbour(k);
        double x = normal[3 * j];
        double y = normal[3 * j + 1];
        double z = normal[3 * j + 2];
        take(other);
        return shape.along(x, y, z)
                + (x * apart[3 * k] + y * apart[3 * k + 1] + z * apart[3 * k + 2]);
    }

    private double slack(int j) {
        double size =
                Math.abs(apart[3 * j]) + Math.abs(apart[3 * j + 1]) + Math.abs(apart[3 * j + 2]);
        return FLUSH * colliders.innerRadius[m] + ROUNDING * size;
    }

    private boolean movesTogether(int j, int k) {
        return colliders.bodies.movesWith(colliders.body[j], colliders.body[k]);
    }

    /** Whether two members have the same normal. */
    private boolean isSame(int i, int j) {
        double x = normal[3 * i] - normal[3 * j];
        double y = normal[3 * i + 1] - normal[3 * j + 1];
        double z = normal[3 * i + 2] - normal[3 * j + 2];
        return x * x + y * y + z * z <= SAME;
    }

    /** Makes the row of a plane, if M stands on it with nothing but what is over its members. */
    private boolean makeRow(int row, int leader, int end) {
        chooseBase(leader);
        long key = 0;
        int record = findRecord(leader);
        if (record >= 0 && memory.isSecond(record) == isSecond) {
            key = memory.key(record);
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
        int like = row(leader);
        ContactMaterials.join(c, row, colliders, isSecond ? base : m, isSecond ? m : base);
        ContactMaterials.rubLike(c, row, like);
        c.cache[row] = key;
        boolean isKnown = record >= 0;
        if (isKnown) {
            memory.load(record, c, row, isSecond, colliders.poses);
            recordsLeft &= ~(1 << (record - firstRecord));
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

    private void chooseBase(int leader) {
        base = neighbour(leader);
        BodyStore s = colliders.bodies;
        if (common != ColliderStore.NONE
                && s.kind[colliders.body[base]] != BodyStore.DYNAMIC
                && movesTogether(common, base)) {
            base = common;
        }
        isSecond = base < m;
        Poses p = colliders.poses;
        baseX = p.apartX(m, base);
        baseY = p.apartY(m, base);
        baseZ = p.apartZ(m, base);
    }

    /** The contact of M with the plane of a member, as of the row to be. */
    private long collide(int leader, long key) {
        Poses s = colliders.poses;
        int i = 3 * leader;
        double x = normal[i];
        double y = normal[i + 1];
        double z = normal[i + 2];
        double h = height(leader, leader);
        // the shortest turn of the y axis to the normal, by way of its opposite if that is nearer
        boolean up = y >= 0;
        double px = up ? z : 1 - y;
        double py = up ? 0 : x;
        double pz = up ? -x : 0;
        double pw = up ? 1 + y : z;
        int other = neighbour(leader);
        double margin = bounds.margin(m, other, reach, colliders.innerRadius[m]);
        double sign = isSecond ? -1 : 1;
        double dx = sign * h * x;
        double dy = sign * h * y;
        double dz = sign * h * z;
        double qx = s.orientationX[m];
        double qy = s.orientationY[m];
        double qz = s.orientationZ[m];
        double qw = s.orientationW[m];
        if (!isSecond) {
            return narrowPhase.collide(
                    colliders.shape[m],
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
                        colliders.shape[m],
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
        double x = manifold.pointX[p] - half * normal[i] + (isSecond ? baseX : 0);
        double y = manifold.pointY[p] - half * normal[i + 1] + (isSecond ? baseY : 0);
        double z = manifold.pointZ[p] - half * normal[i + 2] + (isSecond ? baseZ : 0);
        for (int k = leader; k < end; k++) {
            int other = neighbour(k);
            take(other);
            boolean holds =
                    shape.holds(
                            x - apart[3 * k],
                            y - apart[3 * k + 1],
                            z - apart[3 * k + 2],
                            2 * slack(k));
            if (holds && ContactMaterials.isAlike(contacts, row(k), row(leader))) {
                return true;
            }
        }
        return false;
    }

    /** The record of the last tick whose normal is most like a member's, or -1. */
    private int findRecord(int i) {
        int best = -1;
        double most = LIKE;
        for (int r = 0; r < records; r++) {
            if ((recordsLeft >> r & 1) != 0) {
                double cosine = cosine(firstRecord + r, i);
                if (cosine > most) {
                    most = cosine;
                    best = firstRecord + r;
                }
            }
        }
        return best;
    }

    private double cosine(int record, int i) {
        double[] u = memory.normal;
        int r = 3 * record;
        return u[r] * normal[3 * i] + u[r + 1] * normal[3 * i + 1] + u[r + 2] * normal[3 * i + 2];
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
        int sources = 0;
        for (int pass = 0; pass < 2; pass++) {
            for (int k = leader; k < end; k++) {
                int before = c.pointCount[row];
                if (isSame(k, leader)) {
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
        int like = row(k);
        boolean flips = isSecond(k) != isSecond;
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
        int side = isSecond(k) ? 3 : 0;
        int from = ContactStore.anchor(p) + side;
        int lever = 6 * row(k) + side;
        double x = c.anchors[from] - (c.compounds ? c.lever[lever] : 0);
        double y = c.anchors[from + 1] - (c.compounds ? c.lever[lever + 1] : 0);
        double z = c.anchors[from + 2] - (c.compounds ? c.lever[lever + 2] : 0);
        if (isSecond) {
            c.setAnchors(to, x - baseX, y - baseY, z - baseZ, x, y, z);
        } else {
            c.setAnchors(to, x, y, z, x - baseX, y - baseY, z - baseZ);
        }
    }

    /** Rows that are solved by themselves again go on where the joined row ended. */
    private void goOnAlone() {
        for (int r = 0; r < records; r++) {
            if ((recordsLeft >> r & 1) == 0) {
                continue;
            }
            int alone = 0;
            for (int i = 0; i < size; i++) {
                if (contacts.pointCount[row(i)] > 0 && cosine(firstRecord + r, i) > LIKE) {
                    raw[alone++] = member[from + i];
                }
            }
            if (alone > 0) {
                memory.spread(firstRecord + r, contacts, raw, alone);
                if (alone == 1) {
                    memory.arrange(firstRecord + r, contacts, raw[0]);
                }
            }
        }
    }

    /**
     * Gives the rows that a joined row stood for what it ended with.
     *
     * @param record of the joined row, in {@code ended}
     */
    void spread(SeamMemory ended, int record, int[] members, int first, int number) {
        int alone = 0;
        for (int i = first; i < first + number; i++) {
            if (isAlong(ended, record, members[i])) {
                raw[alone++] = members[i];
            } else {
                contacts.rest(members[i] >> 1);
            }
        }
        ended.spread(record, contacts, raw, alone);
    }

    private boolean isAlong(SeamMemory ended, int record, int entry) {
        double sign = (entry & 1) != 0 ? 1 : -1;
        int row = entry >> 1;
        double cosine =
                contacts.normalX(row) * ended.normal[3 * record]
                        + contacts.normalY(row) * ended.normal[3 * record + 1]
                        + contacts.normalZ(row) * ended.normal[3 * record + 2];
        return sign * cosine >= ContactTolerances.NEARLY_PARALLEL;
    }
}
