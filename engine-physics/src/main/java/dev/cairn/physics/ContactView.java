package dev.cairn.physics;

import dev.cairn.physics.contact.TouchEvents;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.ContactStore;

import org.joml.Vector3d;

import java.util.Arrays;
import java.util.Objects;

/** The façade of contact rows: those with points, found when somebody asks. */
final class ContactView implements Contacts {
    private final BodyTable table;
    private final ContactStore rows;
    private final EventList began = new EventList();
    private final EventList ended = new EventList();
    private int[] rowOf = {};
    private int count;
    private boolean stale;

    ContactView(BodyTable table, ContactStore rows) {
        this.table = table;
        this.rows = rows;
    }

    /** After a step. */
    void update(TouchEvents events) {
        stale = true;
        began.clear();
        for (int i = 0; i < events.beganCount(); i++) {
            began.add(table.refs[events.began(i, 0)], table.refs[events.began(i, 1)]);
        }
        ended.clear();
        for (int i = 0; i < events.endedCount(); i++) {
            ended.add(table.refs[events.ended(i, 0)], table.refs[events.ended(i, 1)]);
        }
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
    public Vector3d normal(int contact, Vector3d destination) {
        int row = row(contact);
        return Checks.notNull("destination", destination)
                .set(rows.normalX(row), rows.normalY(row), rows.normalZ(row));
    }

    @Override
    public Vector3d point(int contact, int point, Vector3d destination) {
        int at = at(contact, point);
        int a = rows.bodyA[row(contact)];
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

    /** Pairs of references; they outlive the bodies. */
    private static final class EventList implements Events {
        private BodyRef[] pairs = new BodyRef[32];
        private int size;

        void clear() {
            size = 0;
        }

        void add(BodyRef a, BodyRef b) {
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
            return pairs[2 * Objects.checkIndex(event, size)];
        }

        @Override
        public BodyRef bodyB(int event) {
            return pairs[2 * Objects.checkIndex(event, size) + 1];
        }
    }
}
