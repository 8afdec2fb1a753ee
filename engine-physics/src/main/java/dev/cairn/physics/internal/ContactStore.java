package dev.cairn.physics.internal;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;

import java.util.Arrays;

/**
 * All contacts of this tick as a structure of arrays; a contact is a row in {@code [0, count)}, one
 * row per pair of colliders whose fat bounds overlap, and further ones for a pair with a surface of
 * triangles, see {@link #group}. Only some of them are solved, see {@link #isSolved}.
 */
public final class ContactStore extends ContactColumns implements EdgeSource, Stateful {
    /** Makes an empty store. */
    public ContactStore() {}

    /** Rows in use. */
    public int count;

    /** Rows that take part in this tick: entries of {@link #active} in use. */
    public int activeCount;

    /**
     * The rows that take part in this tick, ascending. Rows of bodies that sleep are not among
     * them: their points and impulses stay as they are.
     */
    public int[] active = {};

    private static final double[] NO_DOUBLES = {};
    private static final long[] NO_LONGS = {};
    private static final int[] NO_INTS = {};

    private int remembered;

    /** Rows behind {@link #count} that last for a tick. */
    private int lent;

    private final Columns.Move move = new Columns.Move();
    private final Columns.Clear clear = new Columns.Clear();
    private final Columns.Kept rows = new Columns.Kept();

    /** Forgets what a row rubbed and rolled with. */
    public void forgetFriction(int row) {
        setFrictionImpulse(row, 0, 0, 0, 0);
        if (rolls) {
            setRollingImpulse(row, 0, 0, 0);
        }
        if (uneven) {
            Arrays.fill(frictionLoad, 4 * row, 4 * row + 4, 0.0);
        }
    }

    /** Makes room for what contacts learn when ticks change their length; between phases only. */
    public void beginUneven() {
        if (!uneven) {
            uneven = true;
            grow();
        }
    }

    /** Makes room for colliders that are not about their bodies' centres; between phases only. */
    public void beginCompounds() {
        if (!compounds) {
            compounds = true;
            grow();
        }
    }

    /** Makes room for surfaces that move along; between phases only. */
    public void beginBelts() {
        if (!belts) {
            belts = true;
            grow();
        }
    }

    /** Makes room for pairs with several rows; between phases only. */
    public void beginGroups() {
        if (!grouped) {
            grouped = true;
            grow();
        }
    }

    /**
     * Whether a row is not the first one of its pair.
     *
     * @return false for the row that stays as long as its pair
     */
    public boolean isFurther(int row) {
        return grouped && group[row] < 0;
    }

    /** Makes room for speeds of approach; between phases only. */
    public void beginHits() {
        if (!hits) {
            hits = true;
            grow();
        }
    }

    /** Makes room for what sleepers carry of those that move beside them; between phases only. */
    public void beginLeaning() {
        if (!leans) {
            leans = true;
            grow();
        }
    }

    /** Makes room for what a user's hook remembers; between phases only. */
    public void beginHooks() {
        if (!hooked) {
            hooked = true;
            grow();
        }
    }

    /**
     * Takes a row's points away, as if its surfaces were apart; what else is remembered of it holds
     * only together with them.
     */
    public void disable(int row) {
        clearPoints(row, 0, pointCount[row]);
        pointCount[row] = 0;
        keeps[row] = false;
        cache[row] = 0;
        forgetFriction(row);
    }

    /** Empties points that a row has no longer, so that a state does not hold them. */
    public void clearPoints(int row, int from, int to) {
        if (from < to) {
            int p = POINTS * row + from;
            int end = POINTS * row + to;
            Arrays.fill(anchors, anchor(p), anchor(end), 0);
            Arrays.fill(separation, p, end, 0);
            Arrays.fill(feature, p, end, 0);
            Arrays.fill(normalImpulse, p, end, 0);
            Arrays.fill(preload, p, end, 0);
            Arrays.fill(totalNormalImpulse, p, end, 0);
        }
    }

    /** Makes room for rolling friction; between phases only. */
    public void beginRolling() {
        if (!rolls) {
            rolls = true;
            grow();
        }
    }

    /**
     * Makes room for what the narrow phase remembers of pairs; between phases only.
     *
     * @param numbers to a row, above 0; the same in each call
     */
    public void beginMemory(int numbers) {
        if (remembered == 0) {
            remembered = numbers;
            grow();
        }
    }

    /**
     * Whether a row is solved: its surfaces are within the margin of each other, and no other row
     * stands for it, which is so from {@code SeamStage} to the end of the solve.
     *
     * @return false for a pair that is only near
     */
    public boolean isSolved(int row) {
        return pointCount[row] > 0;
    }

    /**
     * With what a row's bodies pushed each other in the last tick.
     *
     * @return N s along the normal, summed over points, at least 0
     */
    public double normalImpulse(int row) {
        double sum = 0;
        int first = POINTS * row;
        for (int p = first; p < first + pointCount[row]; p++) {
            sum += totalNormalImpulse[p];
        }
        return sum;
    }

    @Override
    public int edges() {
        return activeCount;
    }

    @Override
    public int capacity() {
        return active.length;
    }

    @Override
    public int edgeRow(int i) {
        return active[i];
    }

    @Override
    public int edgeA(int i) {
        return isSolved(active[i]) ? bodyA[active[i]] : -1;
    }

    @Override
    public int edgeB(int i) {
        return bodyB[active[i]];
    }

    @Override
    public boolean runs(int i) {
        int u = 3 * active[i];
        return belts && (belt[u] != 0 || belt[u + 1] != 0 || belt[u + 2] != 0);
    }

    /** Nothing: rows leave with their pairs, when the boxes have parted. */
    @Override
    public void leave(int slot) {}

    @Override
    public void forget(int slot) {
        for (int row = 0; row < count; row++) {
            if (bodyA[row] != slot && bodyB[row] != slot) {
                continue;
            }
            rest(row);
        }
    }

    /** Makes every row take part. */
    public void activateAll() {
        for (int row = 0; row < count; row++) {
            active[row] = row;
        }
        activeCount = count;
    }

    /** Gives columns that are wanted from now on their room. */
    private void grow() {
        columns(new Columns.Growth(bodyA.length));
    }

    /** Grows every column to at least {@code capacity} rows; between phases only. */
    public void ensureCapacity(int capacity) {
        if (capacity <= bodyA.length) {
            return;
        }
        int n = Math.max(capacity, Math.max(64, 2 * bodyA.length));
        columns(new Columns.Growth(n));
    }

    /** Declares the columns. */
    public void columns(Columns c) {
        active = c.room("active", active);
        colliderA = c.column("colliderA", colliderA);
        colliderB = c.column("colliderB", colliderB);
        surfaceA = c.column("surfaceA", surfaceA);
        surfaceB = c.column("surfaceB", surfaceB);
        bodyA = c.column("bodyA", bodyA);
        bodyB = c.column("bodyB", bodyB);
        pointCount = c.column("pointCount", pointCount);
        order = c.column("order", order);
        patch = c.column("patch", patch);
        head = c.column("head", head, START, HEAD);
        restitution = c.column("restitution", restitution);
        if (grouped) {
            group = c.column("group", group);
            triangle = c.column("triangle", triangle);
            ground = c.column("ground", ground, GROUND);
        }
        if (rolls) {
            rollingArm = c.column("rollingArm", rollingArm);
            rollingImpulse = c.column("rollingImpulse", rollingImpulse, 3);
        }
        if (belts) {
            belt = c.column("belt", belt, 3);
        }
        if (hits) {
            approach = c.column("approach", approach);
        }
        if (leans) {
            lean = c.column("lean", lean);
        }
        if (hooked) {
            hookMemory = c.column("hookMemory", hookMemory);
        }
        if (compounds) {
            lever = c.column("lever", lever, 6);
            rank = c.column("rank", rank);
        }
        if (uneven) {
            frictionLoad = c.column("frictionLoad", frictionLoad, 4);
        }
        touching = c.column("touching", touching);
        cache = c.column("cache", cache);
        if (remembered > 0) {
            memory = c.column("memory", memory, remembered);
        }
        kept = c.column("kept", kept, START, KEPT);
        keeps = c.column("keeps", keeps);
        anchors = c.column("anchors", anchors, START, ANCHORS * POINTS);
        separation = c.column("separation", separation, POINTS);
        feature = c.column("feature", feature, POINTS);
        normalImpulse = c.column("normalImpulse", normalImpulse, POINTS);
        preload = c.column("preload", preload, POINTS);
        totalNormalImpulse = c.column("totalNormalImpulse", totalNormalImpulse, POINTS);
    }

    /**
     * Columns that the state does not have are as if they had never been: begun anew they are 0.
     */
    private void dropUnused() {
        group = grouped ? group : NO_INTS;
        triangle = grouped ? triangle : NO_INTS;
        ground = grouped ? ground : NO_DOUBLES;
        rollingArm = rolls ? rollingArm : NO_DOUBLES;
        rollingImpulse = rolls ? rollingImpulse : NO_DOUBLES;
        belt = belts ? belt : NO_DOUBLES;
        approach = hits ? approach : NO_DOUBLES;
        lean = leans ? lean : NO_DOUBLES;
        hookMemory = hooked ? hookMemory : NO_INTS;
        lever = compounds ? lever : NO_DOUBLES;
        rank = compounds ? rank : NO_INTS;
        frictionLoad = uneven ? frictionLoad : NO_DOUBLES;
        memory = remembered > 0 ? memory : NO_LONGS;
    }

    @Override
    public void state(StateVisitor s) {
        s.section("contacts", this);
        s.rows(count);
        count = s.count("count", count);
        remembered = s.value("remembered", remembered);
        rolls = s.value("rolls", rolls);
        uneven = s.value("uneven", uneven);
        belts = s.value("belts", belts);
        hits = s.value("hits", hits);
        hooked = s.value("hooked", hooked);
        compounds = s.value("compounds", compounds);
        grouped = s.value("grouped", grouped);
        leans = s.value("leans", leans);
        if (s.isRestoring()) {
            dropUnused();
        }
        ensureCapacity(count);
        columns(rows.of(s, count, bodyA.length, false));
        activeCount = s.value("activeCount", activeCount);
        active = s.array("active", active, 0, activeCount, bodyA.length, false);
    }

    /**
     * Moves rows to the places of others that are not needed.
     *
     * @param to as many places; none of them is in {@code from}
     */
    public void move(int[] from, int[] to, int number) {
        if (number > 0) {
            columns(move.rows(from, to, number));
            assert colliderA[to[0]] == colliderA[from[0]] && bodyB[to[0]] == bodyB[from[0]]
                    : "columns of row " + from[0] + " stayed";
        }
    }

    /** Adds empty rows at the end; they are active. */
    public void append(int number) {
        ensureCapacity(count + number);
        columns(clear.rows(count, count + number));
        for (int i = 0; i < number; i++) {
            active[activeCount++] = count++;
        }
    }

    /**
     * Makes room for rows behind all others that last for a tick, empty; between phases only.
     *
     * @param number how many
     * @return the first of them
     */
    public int lend(int number) {
        int first = count + lent;
        ensureCapacity(first + number);
        columns(clear.rows(first, first + number));
        lent += number;
        return first;
    }

    /** The rows of {@link #lend} are free again. */
    public void endLoans() {
        lent = 0;
    }

    /**
     * The rank of a point among the corners of its patch.
     *
     * @param point place of a point
     * @return 0 if it is none; see {@link #rank}
     */
    public int rank(int point) {
        return rank[point / POINTS] >> (4 * (point % POINTS)) & 15;
    }

    /** Sets what {@link #rank(int)} tells; it was 0. */
    public void setRank(int point, int number) {
        rank[point / POINTS] |= number << (4 * (point % POINTS));
    }

    /**
     * Adds what a row rubbed and rolled with to what another one did.
     *
     * @param row to add to
     * @param like to take from
     * @param sign -1 if the two have their bodies the other way round
     */
    public void addFriction(int row, int like, double sign) {
        setFrictionImpulse(
                row,
                frictionImpulseX(row) + sign * frictionImpulseX(like),
                frictionImpulseY(row) + sign * frictionImpulseY(like),
                frictionImpulseZ(row) + sign * frictionImpulseZ(like),
                twistImpulse(row) + twistImpulse(like));
        for (int axis = 0; axis < 3; axis++) {
            if (rolls) {
                rollingImpulse[3 * row + axis] += sign * rollingImpulse[3 * like + axis];
            }
            if (uneven) {
                frictionLoad[4 * row + axis] += sign * frictionLoad[4 * like + axis];
            }
        }
        if (uneven) {
            frictionLoad[4 * row + 3] += frictionLoad[4 * like + 3];
        }
    }

    /**
     * Two points of a row change places; what the narrow phase keeps of the row holds no more.
     *
     * @param p place of a point
     * @param q place of another one
     */
    public void swapPoints(int p, int q) {
        int i = anchor(p);
        int j = anchor(q);
        for (int k = 0; k < ANCHORS; k++) {
            double coordinate = anchors[i + k];
            anchors[i + k] = anchors[j + k];
            anchors[j + k] = coordinate;
        }
        int name = feature[p];
        feature[p] = feature[q];
        feature[q] = name;
        swap(separation, p, q);
        swap(normalImpulse, p, q);
        swap(preload, p, q);
        swap(totalNormalImpulse, p, q);
    }

    private static void swap(double[] column, int p, int q) {
        double number = column[p];
        column[p] = column[q];
        column[q] = number;
    }

    /**
     * Forgets with what a row pressed and rubbed.
     *
     * @param row any
     */
    public void rest(int row) {
        forgetFriction(row);
        if (compounds) {
            rank[row] = 0;
        }
        Arrays.fill(normalImpulse, POINTS * row, POINTS * row + POINTS, 0);
        Arrays.fill(preload, POINTS * row, POINTS * row + POINTS, 0);
        Arrays.fill(totalNormalImpulse, POINTS * row, POINTS * row + POINTS, 0);
    }

    /**
     * A collider's shape is another one: what its rows remember of the old one is forgotten, but
     * that they touch, and where and with what impulses; between steps.
     */
    public void renew(int collider, ColliderStore colliders) {
        for (int row = 0; row < count; row++) {
            if (colliderA[row] == collider || colliderB[row] == collider) {
                renewRow(row, colliders);
            }
        }
    }

    /** The same of one row. */
    public void renewRow(int row, ColliderStore colliders) {
        ContactMaterials.join(this, row, colliders, colliderA[row], colliderB[row]);
        cache[row] = 0;
        keeps[row] = false;
        Arrays.fill(memory, remembered * row, remembered * row + remembered, 0);
    }
}
