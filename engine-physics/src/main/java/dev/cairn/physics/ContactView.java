package dev.cairn.physics;

import dev.cairn.physics.contact.BodyTouches;
import dev.cairn.physics.contact.PairList;
import dev.cairn.physics.contact.SensorStage;
import dev.cairn.physics.contact.TouchEvents;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.ContactStore;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** The façade of contact rows: those with points, found when somebody asks. */
final class ContactView implements Contacts {
    private final BodyTable table;
    private final ContactStore rows;
    private final TouchEvents events;
    private final BodyTouches touches;
    private final SensorStage sensors;
    private final EventList began = new EventList();
    private final EventList ended = new EventList();
    private final EventList bodiesBegan = new EventList();
    private final EventList bodiesEnded = new EventList();
    private final EventList entered = new EventList();
    private final EventList left = new EventList();
    private final HitList hits = new HitList(false);
    private final HitList bodiesHit = new HitList(true);
    private final List<ContactListener> listeners = new ArrayList<>();
    private int[] rowOf = {};
    private int count;
    private boolean stale;

    ContactView(
            BodyTable table,
            ContactStore rows,
            TouchEvents events,
            BodyTouches touches,
            SensorStage sensors) {
        this.touches = touches;
        this.table = table;
        this.rows = rows;
        this.events = events;
        this.sensors = sensors;
    }

    /** After a step. */
    void update() {
        stale = true;
        ColliderTable refs = table.collision;
        began.take(refs, events.began);
        ended.take(refs, events.ended);
        bodiesBegan.take(refs, touches.began);
        bodiesEnded.take(refs, touches.ended);
        entered.take(refs, sensors.entered);
        left.take(refs, sensors.left);
        cancel(sensors.dropped());
        hits.take(refs);
        bodiesHit.take(refs);
    }

    /** Visitors whose row went and came again within the tick were in all the time. */
    private void cancel(int dropped) {
        int rest = dropped;
        for (int i = 0; i < entered.size && rest > 0; i++) {
            int same = left.find(entered.pairs[2 * i], entered.pairs[2 * i + 1], rest);
            if (same >= 0) {
                entered.remove(i--);
                left.remove(same);
                rest--;
            }
        }
    }

    /** Between steps: what a listener does may change the world. */
    void tell() {
        for (int k = 0; k < listeners.size(); k++) {
            ContactListener listener = listeners.get(k);
            for (int i = 0; i < ended.count(); i++) {
                listener.ended(ended.colliderA(i), ended.colliderB(i));
            }
            for (int i = 0; i < bodiesEnded.count(); i++) {
                listener.bodiesEnded(bodiesEnded.bodyA(i), bodiesEnded.bodyB(i));
            }
            for (int i = 0; i < bodiesBegan.count(); i++) {
                listener.bodiesBegan(bodiesBegan.bodyA(i), bodiesBegan.bodyB(i));
            }
            for (int i = 0; i < began.count(); i++) {
                listener.began(began.colliderA(i), began.colliderB(i));
            }
            for (int i = 0; i < hits.count(); i++) {
                listener.hit(hits, i);
            }
            for (int i = 0; i < bodiesHit.count(); i++) {
                listener.bodiesHit(bodiesHit, i);
            }
            for (int i = 0; i < entered.count(); i++) {
                listener.entered(entered.colliderA(i), entered.colliderB(i));
            }
            for (int i = 0; i < left.count(); i++) {
                listener.left(left.colliderA(i), left.colliderB(i));
            }
        }
    }

    /** The numbers of a body's contacts. */
    int[] of(int body) {
        int[] all = new int[count()];
        int found = 0;
        for (int i = 0; i < all.length; i++) {
            if (rows.bodyA[rowOf[i]] == body || rows.bodyB[rowOf[i]] == body) {
                all[found++] = i;
            }
        }
        return Arrays.copyOf(all, found);
    }

    @Override
    public void setHitSpeed(double metresPerSecond) {
        Checks.between("hit speed", metresPerSecond, 0, Double.POSITIVE_INFINITY);
        events.setHitSpeed(rows, metresPerSecond);
    }

    @Override
    public void listen(ContactListener listener) {
        listeners.add(Checks.notNull("listener", listener));
    }

    @Override
    public void unlisten(ContactListener listener) {
        listeners.remove(listener);
    }

    @Override
    public Hits hits() {
        return hits;
    }

    @Override
    public Hits bodiesHit() {
        return bodiesHit;
    }

    @Override
    public Events entered() {
        return entered;
    }

    @Override
    public Events left() {
        return left;
    }

    @Override
    public ColliderRef colliderA(int contact) {
        return table.collision.ref(rows.colliderA[row(contact)]);
    }

    @Override
    public ColliderRef colliderB(int contact) {
        return table.collision.ref(rows.colliderB[row(contact)]);
    }

    private int row(int contact) {
        // count() may replace rowOf, and Java reads an array before its index
        int index = Objects.checkIndex(contact, count());
        return rowOf[index];
    }

    private int at(int contact, int point) {
        int row = row(contact);
        return ContactStore.POINTS * row + Objects.checkIndex(point, rows.pointCount[row]);
    }

    @Override
    public int count() {
        if (stale) {
            if (rowOf.length < rows.count) {
                rowOf = new int[rows.bodyA.length];
            }
            count = 0;
            for (int row = 0; row < rows.count; row++) {
                if (rows.isSolved(row)) {
                    rowOf[count++] = row;
                }
            }
            stale = false;
        }
        return count;
    }

    @Override
    public BodyRef bodyA(int contact) {
        return table.refs[rows.bodyA[row(contact)]];
    }

    @Override
    public BodyRef bodyB(int contact) {
        return table.refs[rows.bodyB[row(contact)]];
    }

    @Override
    public int pointCount(int contact) {
        return rows.pointCount[row(contact)];
    }

    @Override
    public int triangle(int contact) {
        return rows.triangle(row(contact));
    }

    @Override
    public Vector3d normal(int contact, Vector3d destination) {
        int row = row(contact);
        return Checks.notNull("destination", destination)
                .set(rows.normalX(row), rows.normalY(row), rows.normalZ(row));
    }

    @Override
    public Vector3d point(int contact, int point, Vector3d destination) {
        return place(row(contact), at(contact, point), destination);
    }

    private Vector3d place(int row, int at, Vector3d destination) {
        int a = rows.bodyA[row];
        BodyStore b = table.bodies;
        return Checks.notNull("destination", destination)
                .set(
                        b.positionX[a] + rows.anchorAX(at),
                        b.positionY[a] + rows.anchorAY(at),
                        b.positionZ[a] + rows.anchorAZ(at));
    }

    @Override
    public double separation(int contact, int point) {
        return rows.separation[at(contact, point)];
    }

    @Override
    public double normalImpulse(int contact, int point) {
        return rows.totalNormalImpulse[at(contact, point)];
    }

    @Override
    public boolean touching(int contact) {
        return rows.touching[row(contact)] != 0;
    }

    @Override
    public Events began() {
        return began;
    }

    @Override
    public Events ended() {
        return ended;
    }

    @Override
    public Events bodiesBegan() {
        return bodiesBegan;
    }

    @Override
    public Events bodiesEnded() {
        return bodiesEnded;
    }

    /** Pairs of references; they outlive the bodies. */
    private static class EventList implements Events {
        private ColliderRef[] pairs = new ColliderRef[32];
        private int size;

        final void clear() {
            size = 0;
        }

        final void take(ColliderTable refs, PairList list) {
            clear();
            for (int i = 0; i < list.count(); i++) {
                add(refs.ref(list.collider(i, 0)), refs.ref(list.collider(i, 1)));
            }
        }

        /** Where a pair is among the first ones, or -1. */
        final int find(ColliderRef a, ColliderRef b, int among) {
            for (int i = 0; i < among; i++) {
                if (pairs[2 * i] == a && pairs[2 * i + 1] == b) {
                    return i;
                }
            }
            return -1;
        }

        final void remove(int event) {
            size--;
            System.arraycopy(pairs, 2 * event + 2, pairs, 2 * event, 2 * (size - event));
        }

        final void add(ColliderRef a, ColliderRef b) {
            if (2 * size == pairs.length) {
                pairs = Arrays.copyOf(pairs, 4 * size);
            }
            pairs[2 * size] = a;
            pairs[2 * size + 1] = b;
            size++;
        }

        @Override
        public int count() {
            return size;
        }

        @Override
        public BodyRef bodyA(int event) {
            return colliderA(event).body();
        }

        @Override
        public BodyRef bodyB(int event) {
            return colliderB(event).body();
        }

        @Override
        public ColliderRef colliderA(int event) {
            return pairs[2 * Objects.checkIndex(event, size)];
        }

        @Override
        public ColliderRef colliderB(int event) {
            return pairs[2 * Objects.checkIndex(event, size) + 1];
        }
    }

    /** Hits of the last step, by the rows of it. */
    private final class HitList extends EventList implements Hits {
        /** Whether each pair of bodies is told once, the one of the lower slot as A. */
        private final boolean byBodies;

        HitList(boolean byBodies) {
            this.byBodies = byBodies;
        }

        void take(ColliderTable refs) {
            clear();
            for (int i = 0; i < (byBodies ? touches.hitCount() : events.hitCount()); i++) {
                int row = rowAt(i);
                ColliderRef a = refs.ref(rows.colliderA[row]);
                ColliderRef b = refs.ref(rows.colliderB[row]);
                add(isSwapped(row) ? b : a, isSwapped(row) ? a : b);
            }
        }

        private int rowAt(int hit) {
            return byBodies ? touches.hit(hit) : events.hit(hit);
        }

        private boolean isSwapped(int row) {
            return byBodies && rows.bodyA[row] > rows.bodyB[row];
        }

        private int row(int hit) {
            return rowAt(Objects.checkIndex(hit, count()));
        }

        @Override
        public Vector3d point(int hit, Vector3d destination) {
            int row = row(hit);
            int best = ContactStore.POINTS * row;
            for (int p = best; p < ContactStore.POINTS * row + rows.pointCount[row]; p++) {
                best = rows.totalNormalImpulse[p] > rows.totalNormalImpulse[best] ? p : best;
            }
            return ContactView.this.place(row, best, destination);
        }

        @Override
        public int triangle(int hit) {
            return rows.triangle(row(hit));
        }

        @Override
        public Vector3d normal(int hit, Vector3d destination) {
            int row = row(hit);
            Checks.notNull("destination", destination)
                    .set(rows.normalX(row), rows.normalY(row), rows.normalZ(row));
            return isSwapped(row) ? destination.negate() : destination;
        }

        @Override
        public double approachSpeed(int hit) {
            return rows.approach[row(hit)];
        }

        @Override
        public double impulse(int hit) {
            return rows.normalImpulse(row(hit));
        }
    }
}
