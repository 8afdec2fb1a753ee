package dev.cairn.physics.contact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.narrowphase.pair.Manifold;

import java.util.Arrays;

/**
 * Writes a manifold into its row. A point keeps the impulse of the point of the last tick that has
 * its feature id; a new id takes over from an old point that was hardly elsewhere. The points come
 * by name and are stored in their {@link PointOrder}.
 */
public final class PointStore {
    /**
     * A point whose features are new is an old one within this share of the smaller inner radius.
     */
    private static final double NEAR = 0.1;

    private final ColliderStore colliders;
    private ContactStore contacts = new ContactStore();

    /** Of some colliders. */
    public PointStore(ColliderStore colliders) {
        this.colliders = colliders;
    }

    /** Chooses the columns. */
    public void use(ContactStore rows) {
        contacts = rows;
    }

    /** Writes one row, and orders the manifold as it; no other worker may touch it. */
    public void store(int row, Manifold m, Scratch own) {
        ContactStore c = contacts;
        if (m.pointCount == c.pointCount[row] && sameNames(row, m)) {
            c.setNormal(row, m.normalX, m.normalY, m.normalZ);
            own.order.arrange(m, c.order[row]);
            place(row, m);
        } else {
            int order = m.pointCount == c.pointCount[row] ? sameOrder(row, m, own) : -1;
            store(row, m, own, order >= 0 ? order : order(row, m, own.order));
        }
    }

    /**
     * The order in which each point is where the last tick's point was that it goes on from; -1 if
     * not each of these has one. Names change where another face holds the same points.
     */
    private int sameOrder(int row, Manifold m, Scratch own) {
        take(row, own, m.pointCount);
        double near = near(row);
        int order = 0;
        int places = 0;
        for (int p = 0; p < m.pointCount; p++) {
            int q = nearest(m, own, p, m.pointCount, near * near);
            if (q < 0 || (places >> q & 1) != 0) {
                return -1;
            }
            places |= 1 << q;
            order |= p << (2 * q);
        }
        return order | (PointOrder.ASCENDING & (-1 << (2 * m.pointCount)));
    }

    /** Points of two ticks that are nearer than this are one, m. */
    private double near(int row) {
        return NEAR
                * Math.min(
                        colliders.innerRadius[contacts.colliderA[row]],
                        colliders.innerRadius[contacts.colliderB[row]]);
    }

    /** Writes one row whose points have no order yet. */
    public void storeAnew(int row, Manifold m, Scratch own) {
        store(row, m, own, order(row, m, own.order));
    }

    private void store(int row, Manifold m, Scratch own, int order) {
        ContactStore c = contacts;
        c.setNormal(row, m.normalX, m.normalY, m.normalZ);
        c.order[row] = (byte) order;
        own.order.arrange(m, order);
        match(row, m, own);
        place(row, m);
    }

    /**
     * Whether points are places on B, as A does not answer. What slides or rolls over the ground
     * takes its points along, whichever of the two came first.
     */
    private boolean isOnB(int row) {
        return colliders.bodies.kind[contacts.bodyA[row]] != BodyStore.DYNAMIC;
    }

    /** Takes points of the last tick, and where those of now are on the body that moves. */
    private void take(int row, Scratch own, int count) {
        boolean onB = isOnB(row);
        own.take(contacts, row, count, onB ? ContactStore.ANCHORS / 2 : 0);
        Poses s = colliders.poses;
        int a = contacts.colliderA[row];
        int b = contacts.colliderB[row];
        own.fromX = onB ? s.apartX(a, b) : 0;
        own.fromY = onB ? s.apartY(a, b) : 0;
        own.fromZ = onB ? s.apartZ(a, b) : 0;
    }

    /** The order of a row's points on its first body that moves. */
    private int order(int row, Manifold m, PointOrder order) {
        Poses s = colliders.poses;
        int a = contacts.colliderA[row];
        int body = isOnB(row) ? contacts.bodyB[row] : contacts.bodyA[row];
        double x = s.apartX(a, body);
        double y = s.apartY(a, body);
        double z = s.apartZ(a, body);
        order.of(s, body);
        for (int p = 0; p < m.pointCount; p++) {
            order.put(p, m.separation[p], m.pointX[p] - x, m.pointY[p] - y, m.pointZ[p] - z);
        }
        return order.order(m.pointCount);
    }

    /**
     * The narrow phase tells points from the centres of colliders; the solver wants them from those
     * of bodies. After all points of some rows are written.
     */
    public void fromBodies(int[] rows, int begin, int end) {
        if (!contacts.compounds) {
            return;
        }
        for (int i = begin; i < end; i++) {
            int row = rows[i];
            boolean children = lever(contacts.colliderA[row], 6 * row);
            children |= lever(contacts.colliderB[row], 6 * row + 3);
            if (children) {
                shift(row);
            }
        }
    }

    /** Notes where a collider is on its body; whether it is elsewhere than its centre. */
    private boolean lever(int collider, int at) {
        double[] lever = contacts.lever;
        if (!colliders.isChild(collider)) {
            Arrays.fill(lever, at, at + 3, 0);
            return false;
        }
        Poses s = colliders.poses;
        int body = colliders.body[collider];
        lever[at] = s.apartX(body, collider);
        lever[at + 1] = s.apartY(body, collider);
        lever[at + 2] = s.apartZ(body, collider);
        return true;
    }

    private void shift(int row) {
        ContactStore c = contacts;
        int first = ContactStore.POINTS * row;
        for (int p = first; p < first + c.pointCount[row]; p++) {
            int at = ContactStore.anchor(p);
            for (int k = 0; k < 6; k++) {
                c.anchors[at + k] += c.lever[6 * row + k];
            }
        }
    }

    private boolean sameNames(int row, Manifold m) {
        int first = ContactStore.POINTS * row;
        int order = contacts.order[row];
        for (int p = 0; p < m.pointCount; p++, order >>= 2) {
            if (contacts.feature[first + p] != m.feature[order & 3]) {
                return false;
            }
        }
        return true;
    }

    private void place(int row, Manifold m) {
        ContactStore c = contacts;
        Poses s = colliders.poses;
        int a = c.colliderA[row];
        int b = c.colliderB[row];
        double dx = s.apartX(a, b);
        double dy = s.apartY(a, b);
        double dz = s.apartZ(a, b);
        c.patch[row] = m.patch;
        int at = ContactStore.POINTS * row;
        for (int p = 0; p < m.pointCount; p++, at++) {
            c.setAnchors(
                    at,
                    m.pointX[p],
                    m.pointY[p],
                    m.pointZ[p],
                    m.pointX[p] - dx,
                    m.pointY[p] - dy,
                    m.pointZ[p] - dz);
            c.separation[at] = m.separation[p];
        }
    }

    /** The names have changed: hands the impulses on. */
    private void match(int row, Manifold m, Scratch own) {
        ContactStore c = contacts;
        int first = ContactStore.POINTS * row;
        int before = c.pointCount[row];
        int points = m.pointCount;
        take(row, own, before);
        c.pointCount[row] = points;
        c.clearPoints(row, points, before);
        if (c.compounds) {
            c.rank[row] = 0;
        }
        boolean persists = false;
        for (int p = 0; p < points; p++) {
            int at = first + p;
            c.feature[at] = m.feature[p];
            c.normalImpulse[at] = 0;
            c.preload[at] = 0;
            c.totalNormalImpulse[at] = 0;
            own.unmatched[p] = true;
            for (int q = 0; q < before; q++) {
                if (own.feature[q] == m.feature[p] && !Double.isNaN(own.x[q])) {
                    inherit(own, first, p, q);
                    persists = true;
                    break;
                }
            }
        }
        if (before > 0) {
            double near = near(row);
            for (int p = 0; p < points; p++) {
                if (own.unmatched[p]) {
                    persists |= inheritNearest(m, own, first, p, before, near * near);
                }
            }
        }
        if (!persists) {
            c.forgetFriction(row);
        }
    }

    private void inherit(Scratch own, int first, int p, int q) {
        contacts.normalImpulse[first + p] = own.impulse[q];
        contacts.preload[first + p] = own.preload[q];
        if (contacts.compounds) {
            contacts.setRank(first + p, own.rank[q]);
        }
        own.unmatched[p] = false;
        own.x[q] = Double.NaN;
    }

    /**
     * Features swap where faces are equally good; the point is the same while it stays where it
     * was.
     */
    private boolean inheritNearest(
            Manifold m, Scratch own, int first, int p, int before, double limit) {
        int best = nearest(m, own, p, before, limit);
        if (best < 0) {
            return false;
        }
        inherit(own, first, p, best);
        return true;
    }

    /** The point of the last tick that is nearest to a new one, within a square; -1 if none. */
    private static int nearest(Manifold m, Scratch own, int p, int before, double limit) {
        int best = -1;
        double least = limit;
        for (int q = 0; q < before; q++) {
            double x = m.pointX[p] - own.fromX - own.x[q];
            double y = m.pointY[p] - own.fromY - own.y[q];
            double z = m.pointZ[p] - own.fromZ - own.z[q];
            double square = x * x + y * y + z * z;
            if (square < least) {
                least = square;
                best = q;
            }
        }
        return best;
    }

    /** The points of the last tick, of one worker. */
    public static final class Scratch {
        final int[] feature = new int[ContactStore.POINTS];
        final double[] impulse = new double[ContactStore.POINTS];
        final double[] preload = new double[ContactStore.POINTS];
        final int[] rank = new int[ContactStore.POINTS];
        final double[] x = new double[ContactStore.POINTS];
        final double[] y = new double[ContactStore.POINTS];
        final double[] z = new double[ContactStore.POINTS];
        final boolean[] unmatched = new boolean[ContactStore.POINTS];
        final PointOrder order = new PointOrder();

        /** From A's centre to that of the collider on which points are places. */
        double fromX, fromY, fromZ;

        /** Empty. */
        public Scratch() {}

        /**
         * @param part where the anchors of one body begin: those of A, or of B
         */
        void take(ContactStore c, int row, int count, int part) {
            int first = ContactStore.POINTS * row;
            for (int p = 0; p < count; p++) {
                feature[p] = c.feature[first + p];
                impulse[p] = c.normalImpulse[first + p];
                preload[p] = c.preload[first + p];
                int anchor = ContactStore.anchor(first + p) + part;
                x[p] = c.anchors[anchor];
                y[p] = c.anchors[anchor + 1];
                z[p] = c.anchors[anchor + 2];
                if (c.compounds) {
                    rank[p] = c.rank(first + p);
                    x[p] -= c.lever[6 * row + part];
                    y[p] -= c.lever[6 * row + part + 1];
                    z[p] -= c.lever[6 * row + part + 2];
                }
            }
        }
    }
}
