package dev.cairn.physics.contact.seam;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.contact.PointOrder;
import dev.cairn.physics.internal.Columns;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.narrowphase.pair.FeatureIds;

import java.util.Arrays;

/**
 * What the rows of {@link SeamStage} ended a tick with: a record for each, by the collider that
 * touches the joined surface. A record does not say which neighbour the row was of: the next one
 * goes on where it ended.
 *
 * <p>A point is told from the centre of the touching collider, and impulses are those on its body.
 */
final class SeamMemory {
    private static final int POINTS = ContactStore.POINTS;

    /** A vertex of the other side has this bit the other way round. */
    private static final int SIDE = 1 << 30;

    /** By collider: its first record, how many, and the tick of them. */
    private int[] first = {}, count = {};

    private long[] stamp = {};

    private int[] points = {};
    private byte[] order = {};
    private int[] rank = {};
    private boolean[] second = {};
    private long[] key = {};

    /** Of a record: unit normal towards the touching collider, world. */
    double[] normal = {};

    int[] feature = {};
    double[] position = {}, impulse = {}, preload = {}, total = {};
    private double[] friction = {}, rolling = {}, load = {};
    private final Columns.Kept kept = new Columns.Kept();
    private final Columns.Clear clear = new Columns.Clear();

    /** Records in use, with some that are empty. */
    private int records;

    /** Makes room; between phases only. */
    void ensure(int colliders, int records) {
        if (first.length < colliders) {
            int n = colliders + (colliders >> 1);
            first = Arrays.copyOf(first, n);
            count = Arrays.copyOf(count, n);
            stamp = Arrays.copyOf(stamp, n);
        }
        if (points.length < records) {
            columns(new Columns.Growth(records));
        }
    }

    private void columns(Columns c) {
        points = c.column("points", points);
        order = c.column("order", order);
        rank = c.column("rank", rank);
        second = c.column("second", second);
        key = c.column("key", key);
        normal = c.column("normal", normal, 3);
        feature = c.column("feature", feature, POINTS);
        position = c.column("position", position, 3 * POINTS);
        impulse = c.column("impulse", impulse, POINTS);
        preload = c.column("preload", preload, POINTS);
        total = c.column("total", total, POINTS);
        friction = c.column("friction", friction, 4);
        rolling = c.column("rolling", rolling, 3);
        load = c.column("load", load, 4);
    }

    /** Saves or restores what is of a tick; what is older is never read. */
    void state(StateVisitor s, long tick) {
        s.section("seamMemory", this);
        int known = 0;
        for (int c = 0; c < stamp.length; c++) {
            if (stamp[c] == tick) {
                known = c + 1;
            } else {
                first[c] = 0;
                count[c] = 0;
                stamp[c] = 0;
            }
        }
        known = s.value("known", known);
        first = s.array("first", first, known);
        count = s.array("count", count, known);
        stamp = s.array("stamp", stamp, known);
        records = s.count("records", known > 0 ? records : 0);
        if (records > points.length) {
            columns(new Columns.Growth(records));
        }
        columns(kept.of(s, records, points.length, false));
    }

    /** Says how many records there are, and empties them; they are written in any order. */
    void begin(int number) {
        records = number;
        columns(clear.rows(0, number));
    }

    /** How many records a collider has of a tick. */
    int count(int collider, long tick) {
        return collider < stamp.length && stamp[collider] == tick ? count[collider] : 0;
    }

    /** The first of them. */
    int first(int collider) {
        return first[collider];
    }

    /** Says which records a collider has. */
    void put(int collider, long tick, int from, int number) {
        first[collider] = from;
        count[collider] = number;
        stamp[collider] = tick;
    }

    /** How many points a record has. */
    int points(int r) {
        return points[r];
    }

    /** The narrow phase's key of a record. */
    long key(int r) {
        return key[r];
    }

    /**
     * The names of a record's points, for a row of which the touching collider is the other one.
     */
    int names(int r) {
        int names = 0;
        for (int k = 0; k < points[r]; k++) {
            names |= FeatureIds.hash(feature[POINTS * r + k] ^ SIDE) << (8 * k);
        }
        return names;
    }

    /** Whether the touching collider was the second of the row. */
    boolean isSecond(int r) {
        return second[r];
    }

    /**
     * Takes over a row.
     *
     * @param isSecond whether the touching collider is B
     */
    void save(int r, ContactStore c, int row, boolean isSecond) {
        double sign = isSecond ? 1 : -1;
        normal[3 * r] = sign * c.normalX(row);
        normal[3 * r + 1] = sign * c.normalY(row);
        normal[3 * r + 2] = sign * c.normalZ(row);
        points[r] = c.pointCount[row];
        order[r] = c.order[row];
        rank[r] = c.compounds ? c.rank[row] : 0;
        second[r] = isSecond;
        key[r] = c.cache[row];
        int side = isSecond ? 3 : 0;
        for (int k = 0; k < points[r]; k++) {
            int p = POINTS * row + k;
            int q = POINTS * r + k;
            feature[q] = c.feature[p];
            impulse[q] = c.normalImpulse[p];
            preload[q] = c.preload[p];
            total[q] = c.totalNormalImpulse[p];
            for (int axis = 0; axis < 3; axis++) {
                double lever = c.compounds ? c.lever[6 * row + side + axis] : 0;
                position[3 * q + axis] = c.anchors[ContactStore.anchor(p) + side + axis] - lever;
            }
        }
        int head = ContactStore.head(row) + ContactStore.FRICTION_IMPULSE;
        for (int axis = 0; axis < 3; axis++) {
            friction[4 * r + axis] = sign * c.head[head + axis];
            rolling[3 * r + axis] = c.rolls ? sign * c.rollingImpulse[3 * row + axis] : 0;
            load[4 * r + axis] = c.uneven ? sign * c.frictionLoad[4 * row + axis] : 0;
        }
        friction[4 * r + 3] = c.twistImpulse(row);
        load[4 * r + 3] = c.uneven ? c.frictionLoad[4 * row + 3] : 0;
    }

    /** Makes a row what it would be if it had been solved in the last tick. */
    void load(int r, ContactStore c, int row, boolean isSecond, Poses s) {
        c.pointCount[row] = points[r];
        c.order[row] = order[r];
        if (c.compounds) {
            c.rank[row] = rank[r];
        }
        int a = c.colliderA[row];
        int b = c.colliderB[row];
        double x = s.apartX(a, b);
        double y = s.apartY(a, b);
        double z = s.apartZ(a, b);
        if (c.compounds) {
            // points are told from the centres of colliders
            Arrays.fill(c.lever, 6 * row, 6 * row + 6, 0.0);
        }
        int flip = isSecond == second[r] ? 0 : SIDE;
        for (int k = 0; k < points[r]; k++) {
            int p = POINTS * row + k;
            int q = POINTS * r + k;
            c.feature[p] = feature[q] ^ flip;
            c.normalImpulse[p] = impulse[q];
            c.preload[p] = preload[q];
            double px = position[3 * q];
            double py = position[3 * q + 1];
            double pz = position[3 * q + 2];
            if (isSecond) {
                c.setAnchors(p, px + x, py + y, pz + z, px, py, pz);
            } else {
                c.setAnchors(p, px, py, pz, px - x, py - y, pz - z);
            }
        }
        loadFriction(r, c, row, isSecond);
    }

    /** Hands on the friction and rolling impulses of a record. */
    void loadFriction(int r, ContactStore c, int row, boolean isSecond) {
        double sign = isSecond ? 1 : -1;
        c.setFrictionImpulse(
                row,
                sign * friction[4 * r],
                sign * friction[4 * r + 1],
                sign * friction[4 * r + 2],
                friction[4 * r + 3]);
        if (c.rolls) {
            c.setRollingImpulse(
                    row,
                    sign * rolling[3 * r],
                    sign * rolling[3 * r + 1],
                    sign * rolling[3 * r + 2]);
        }
        if (c.uneven) {
            for (int axis = 0; axis < 3; axis++) {
                c.frictionLoad[4 * row + axis] = sign * load[4 * r + axis];
            }
            c.frictionLoad[4 * row + 3] = load[4 * r + 3];
        }
    }

    /**
     * Gives each point of a record to the point of some rows that is the same vertex, or else the
     * nearest; what the rows had is forgotten.
     *
     * @param members rows, twice their number, plus 1 where the touching collider is B
     */
    void spread(int r, ContactStore c, int[] members, int size) {
        for (int i = 0; i < size; i++) {
            c.rest(members[i] >> 1);
        }
        int most = -1;
        double pressed = -1;
        for (int k = 0; k < points[r]; k++) {
            int q = POINTS * r + k;
            int best = nearest(q, second[r], c, members, size);
            if (best < 0) {
                continue;
            }
            int p = POINTS * (members[best >> 2] >> 1) + (best & 3);
            c.normalImpulse[p] += impulse[q];
            c.preload[p] += preload[q];
            c.totalNormalImpulse[p] += total[q];
            if (c.compounds && c.rank(p) == 0) {
                c.setRank(p, rank[r] >> (4 * k) & 15);
            }
            if (c.normalImpulse[p] > pressed) {
                pressed = c.normalImpulse[p];
                most = members[best >> 2];
            }
        }
        if (most >= 0) {
            loadFriction(r, c, most >> 1, (most & 1) != 0);
        }
    }

    /**
     * Gives a row's points the order of a record's if they are the same, so that they are swept as
     * before.
     *
     * @param entry twice the row, plus 1 where the touching collider is B
     */
    void arrange(int r, ContactStore c, int entry) {
        int row = entry >> 1;
        int n = points[r];
        if (c.pointCount[row] != n) {
            return;
        }
        int flip = ((entry & 1) != 0) == second[r] ? 0 : SIDE;
        int first = POINTS * row;
        for (int k = 0; k < n; k++) {
            int at = k;
            while (at < n && c.feature[first + at] != (feature[POINTS * r + k] ^ flip)) {
                at++;
            }
            if (at == n) {
                break;
            }
            if (at != k) {
                c.swapPoints(first + k, first + at);
                c.keeps[row] = false;
            }
        }
        c.order[row] = (byte) PointOrder.of(c.feature, first, n);
    }

    /** Four times the place among the members, plus the point; -1 if there are no points. */
    private int nearest(int q, boolean wasSecond, ContactStore c, int[] members, int size) {
        for (int i = 0; i < size; i++) {
            int name = feature[q] ^ (((members[i] & 1) != 0) == wasSecond ? 0 : SIDE);
            int row = members[i] >> 1;
            for (int k = 0; k < Math.abs(c.pointCount[row]); k++) {
                if (c.feature[POINTS * row + k] == name) {
                    return 4 * i + k;
                }
            }
        }
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < size; i++) {
            int row = members[i] >> 1;
            int side = (members[i] & 1) != 0 ? 3 : 0;
            for (int k = 0; k < Math.abs(c.pointCount[row]); k++) {
                int p = POINTS * row + k;
                double square = 0;
                for (int axis = 0; axis < 3; axis++) {
                    double lever = c.compounds ? c.lever[6 * row + side + axis] : 0;
                    double at = c.anchors[ContactStore.anchor(p) + side + axis] - lever;
                    double d = at - position[3 * q + axis];
                    square += d * d;
                }
                if (square < least) {
                    least = square;
                    best = 4 * i + k;
                }
            }
        }
        return best;
    }
}
