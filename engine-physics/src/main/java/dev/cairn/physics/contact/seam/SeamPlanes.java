package dev.cairn.physics.contact.seam;

import dev.cairn.physics.contact.BoundsStage;
import dev.cairn.physics.contact.PointStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;

import java.util.Arrays;

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

    /** A row goes on where one of this cosine between their normals ended. */
    private static final double LIKE = 0.9;

    private final ContactStore contacts;
    private final SeamMembers members;
    private final JoinedRow joined;

    private SeamMemory memory = new SeamMemory();
    private int firstRecord, records;
    private int recordsLeft;

    /** See {@link #stand}. */
    private int common;

    private int size;

    /** By member: whether it is behind the plane that was chosen, or the one that is tried. */
    private boolean[] covered = {}, tried = {};

    private int[] raw = {};

    SeamPlanes(
            ColliderStore colliders, ContactStore contacts, BoundsStage bounds, PointStore points) {
        this.contacts = contacts;
        members = new SeamMembers(colliders, contacts);
        joined = new JoinedRow(colliders, contacts, bounds, points, members);
    }

    /** Makes room for groups of some size; between phases only. */
    void ensure(int most) {
        members.ensure(most);
        if (raw.length < most) {
            int n = Math.max(32, 2 * most);
            covered = new boolean[n];
            tried = new boolean[n];
            raw = new int[n];
        }
    }

    /** Chooses a collider and its contacts. */
    void begin(int collider, int[] list, int first, int number, double reachSeconds) {
        size = number;
        members.begin(collider, list, first, number);
        joined.within(reachSeconds);
    }

    /**
     * Chooses the neighbour that rows are told of where it stands still against the others: so rows
     * of parts of one body are solved in the order of the parts, whatever they touch.
     *
     * @param collider or {@link ColliderStore#NONE} for the one that a plane is of
     */
    void stand(int collider) {
        common = collider;
        joined.stand(collider);
    }

    /** Chooses what is known of the last tick: the first so many records. */
    void remember(SeamMemory records, int number) {
        memory = records;
        this.records = number;
        firstRecord = number > 0 ? records.first(members.m) : 0;
        recordsLeft = (1 << number) - 1;
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
            if (plane < 0) {
                plane = findRecorded(settled);
            }
            if (plane < 0) {
                break;
            }
            int end = gather(settled, plane);
            if (makeRow(target + made, settled, end)) {
                firstHeld[at + made] = settled;
                held[at + made] = end - settled;
                for (int i = settled; i < end; i++) {
                    contacts.pointCount[members.row(i)] = -contacts.pointCount[members.row(i)];
                }
                made++;
            } else {
                for (int i = settled; i < end; i++) {
                    if (!members.isSame(i, settled)) {
                        contacts.pointCount[members.row(i)] = -contacts.pointCount[members.row(i)];
                    }
                }
            }
            settled = end;
        }
        goOnAlone();
        return made;
    }

    /**
     * The member whose plane covers most of those that are left, itself included, which are then
     * {@link #covered}; -1 if none.
     */
    private int findPlane(int begin) {
        int best = -1;
        int most = 1;
        for (int j = begin; j < size; j++) {
            if (best >= 0 && members.isSame(j, best) && covered[j] && members.covers(j, best)) {
                continue;
            }
            int count = cover(begin, j);
            if (count > most
                    || (best >= 0
                            && count == most
                            && members.separation[j] > members.separation[best])) {
                best = j;
                most = count;
                boolean[] chosen = tried;
                tried = covered;
                covered = chosen;
            }
        }
        return best;
    }

    /** The first member whose row goes on as a joined one, though its plane covers no other. */
    private int findRecorded(int begin) {
        for (int i = begin; i < size; i++) {
            if (common >= 0 || findRecord(i) >= 0) {
                Arrays.fill(covered, begin, size, false);
                return i;
            }
        }
        return -1;
    }

    /** Finds what a member's plane covers, itself included; how many. */
    private int cover(int begin, int j) {
        int count = 0;
        for (int k = begin; k < size; k++) {
            tried[k] = k == j || members.covers(j, k);
            count += tried[k] ? 1 : 0;
        }
        return count;
    }

    /** Puts a member and those that it covers next to each other; returns their end. */
    private int gather(int begin, int plane) {
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
        members.swap(i, j);
        boolean is = covered[i];
        covered[i] = covered[j];
        covered[j] = is;
    }

    private boolean makeRow(int row, int leader, int end) {
        int record = findRecord(leader);
        boolean made = joined.make(row, leader, end, memory, record);
        if (made && record >= 0) {
            recordsLeft &= ~(1 << (record - firstRecord));
        }
        return made;
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
        return u[r] * members.normal[3 * i]
                + u[r + 1] * members.normal[3 * i + 1]
                + u[r + 2] * members.normal[3 * i + 2];
    }

    /** Rows that are solved by themselves again go on where the joined row ended. */
    private void goOnAlone() {
        for (int r = 0; r < records; r++) {
            if ((recordsLeft >> r & 1) == 0) {
                continue;
            }
            int alone = 0;
            for (int i = 0; i < size; i++) {
                if (contacts.pointCount[members.row(i)] > 0 && cosine(firstRecord + r, i) > LIKE) {
                    raw[alone++] = members.entry(i);
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
    void spread(SeamMemory ended, int record, int[] list, int first, int number) {
        int alone = 0;
        for (int i = first; i < first + number; i++) {
            if (isAlong(ended, record, list[i])) {
                raw[alone++] = list[i];
            } else {
                contacts.rest(list[i] >> 1);
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
