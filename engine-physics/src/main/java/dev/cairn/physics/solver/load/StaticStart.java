package dev.cairn.physics.solver.load;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.island.Islands;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;

import java.util.Arrays;

/**
 * The tick in which a structure is put up: an island of bodies that are all new and at rest.
 *
 * <p>Its contacts know of no load yet. Sweeps that start from nothing hand the weight on from
 * contact to contact while the bodies already move, and soft contacts give until their offsets have
 * learnt of the load: a house of thin cards has fallen by then. So before anything moves, hard
 * normals and friction are swept until they agree, and the offsets begin with the load that was
 * found: the structure starts in balance, with springs that are neither too long nor too short.
 *
 * <p>Error falls by a constant share a sweep, and slowly. Two sweeps in a row tell the share, and
 * from it what all further ones would do: every fourth sweep impulses and velocities leap there
 * together (Aitken's extrapolation). A house of five levels takes 1/8 of the sweeps for it.
 *
 * <p>What is put up on a kinematic body, or on a belt, that moves evenly, and moves as that, is at
 * rest beside it, and starts in the same way: laws are the same in both frames.
 *
 * <p>If what is left moves, as in a scene that starts out of balance, or in one that is too large,
 * all is as if nothing had been done: half a balance is worse than none, since a tall column leans
 * on springs that are a little wrong. The number of sweeps follows from the islands that start
 * alone, so that neither workers nor batches change a bit. Found by the simulation thread; an
 * island is swept by the worker that has its batch. Allocates only when a store has grown. Source:
 * own study.
 */
public class StaticStart {
    /** Mark of a row, beside 1 for one that has lost a load. */
    static final byte MARK = 2;

    /** Change of an impulse over the largest one of the island at which it agrees. */
    double agrees = 1e-12;

    /** Contacts of an island times sweeps, at most: up to a tenth of a second, once. */
    private static final int VISITS = 1 << 17;

    /** Contacts of all islands that start in a tick times sweeps, at most. */
    private static final int ALL_VISITS = 1 << 20;

    /** A larger island, which could be swept less often, starts as it is. */
    static final int FEWEST = 32;

    /** Sweeps from leap to leap. */
    private static final int EVERY = 4;

    /** Of a leap, in changes of a sweep. */
    static final double LONGEST = 100;

    /** To a contact: four of points, two of friction and a twist. */
    static final int IMPULSES = 7;

    /** Speed over what gravity adds to it in a sub-step, up to which an island is in balance. */
    static final double BALANCED = 1e-4;

    private final Islands islands = new Islands();

    /** Dynamic bodies, and by slot: the smallest slot of the island. */
    int[] slots = {};

    int[] island = {};

    /** By smallest slot of an island, as what follows. */
    int[] sweepsLeft = {};

    double[] change = {};
    double[] largest = {};
    double[] before = {};

    /** By smallest slot of an island: velocity of all that carries it, and whether any does. */
    double[] frame = {};

    boolean[] framed = {};

    private double[] rate = {};

    /** Of its next leap, at most; and of its last one, in changes of a sweep. */
    double[] longest = {};

    double[] leapt = {};

    private double[] reach = {};

    /** By slot: the last leap that the body took part in, and its velocity before. */
    int[] taken = {};

    private double[] oldSpeed = {};

    /** By contact: impulses before a leap. */
    private double[] oldImpulse = {};

    boolean[] swept = {};

    /** Square of the speed at which an island is out of balance. */
    double loose;

    /** Whether there is such an island. */
    public boolean found;

    /**
     * Marks the rows of islands that start.
     *
     * @param still speed below which a body is at rest, m/s
     * @param gain what gravity adds to a speed in a sub-step, m/s
     * @param sweeps over an island, at most
     */
    public void find(
            BodyStore b, ContactStore c, EdgeList list, double still, double gain, int sweeps) {
        found = false;
        loose = BALANCED * BALANCED * gain * gain;
        if (!anyNew(b)) {
            return;
        }
        ensureCapacity(b, c);
        gather(b, list);
        Arrays.fill(sweepsLeft, 0, b.slotCount, 0);
        Arrays.fill(swept, 0, b.slotCount, false);
        Arrays.fill(framed, 0, b.slotCount, false);
        Arrays.fill(frame, 0, 3 * b.slotCount, 0.0);
        for (int m = 0; m < list.count; m++) {
            int root = island[list.mover(m)];
            sweepsLeft[root]++;
            // for now: whether the island is no start
            swept[root] |=
                    m >= list.contacts
                            || surges(b, c, list.source[m])
                            || !joinsFrame(b, c, list, m, root);
        }
        for (int m = 0; m < list.contacts; m++) {
            int root = island[list.mover(m)];
            int source = list.source[m];
            swept[root] |=
                    !starts(b, c.bodyA[source], root, still)
                            || !starts(b, c.bodyB[source], root, still);
        }
        int all = 0;
        for (int m = 0; m < list.contacts; m++) {
            int root = island[list.mover(m)];
            if (!swept[root] && VISITS / sweepsLeft[root] >= FEWEST) {
                list.rows(m).settleMark[list.place[m]] = MARK;
                all++;
                found = true;
            }
        }
        for (int i = 0; i < b.slotCount; i++) {
            int rows = sweepsLeft[i];
            int most =
                    rows == 0 || swept[i]
                            ? 0
                            : Math.min(VISITS / rows, ALL_VISITS / Math.max(1, all));
            sweepsLeft[i] = Math.min(sweeps, most);
            swept[i] = false;
            change[i] = 0;
            largest[i] = 0;
            before[i] = 0;
            longest[i] = LONGEST;
            taken[i] = -1;
        }
    }

    /** The load sweep knows every body that it has seen in a tick. */
    private static boolean anyNew(BodyStore b) {
        for (int i = 0; i < b.slotCount; i++) {
            if (b.kind[i] == BodyStore.DYNAMIC && !(b.inertiaScale[i] > 0)) {
                return true;
            }
        }
        return false;
    }

    void gather(BodyStore b, EdgeList list) {
        int count = 0;
        for (int i = 0; i < b.slotCount; i++) {
            if (b.kind[i] == BodyStore.DYNAMIC) {
                slots[count++] = i;
            }
        }
        islands.ensureSlots(island.length);
        islands.begin(slots, count);
        for (int m = 0; m < list.count; m++) {
            if (list.isBetweenMovers(m)) {
                islands.join(list.slotA[m], list.slotB[m]);
            }
        }
        for (int k = 0; k < count; k++) {
            island[slots[k]] = islands.root(slots[k]);
        }
    }

    /**
     * Whether what a contact is with is kinematic and speeds up: that is {@link CarriedIslands}'
     * matter.
     */
    static boolean surges(BodyStore b, ContactStore c, int row) {
        return b.surging
                && ((b.kind[c.bodyA[row]] == BodyStore.KINEMATIC && b.surges[c.bodyA[row]])
                        || (b.kind[c.bodyB[row]] == BodyStore.KINEMATIC && b.surges[c.bodyB[row]]));
    }

    /** Notes how fast what carries moves; false if it turns, or moves unlike another one. */
    boolean joinsFrame(BodyStore b, ContactStore c, EdgeList list, int m, int root) {
        if (list.isBetweenMovers(m)) {
            return true;
        }
        int k = list.carrier[m];
        double x = 0;
        double y = 0;
        double z = 0;
        if (k >= 0) {
            if (b.angularVelocityX[k] != 0
                    || b.angularVelocityY[k] != 0
                    || b.angularVelocityZ[k] != 0) {
                return false;
            }
            int row = 3 * list.source[m];
            x = b.velocityX[k] + (c.belts ? c.belt[row] : 0);
            y = b.velocityY[k] + (c.belts ? c.belt[row + 1] : 0);
            z = b.velocityZ[k] + (c.belts ? c.belt[row + 2] : 0);
        }
        int f = 3 * root;
        if (!framed[root]) {
            framed[root] = true;
            frame[f] = x;
            frame[f + 1] = y;
            frame[f + 2] = z;
        }
        return frame[f] == x && frame[f + 1] == y && frame[f + 2] == z;
    }

    private boolean starts(BodyStore b, int i, int root, double still) {
        if (b.kind[i] != BodyStore.DYNAMIC) {
            return true;
        }
        double x = b.velocityX[i] - frame[3 * root];
        double y = b.velocityY[i] - frame[3 * root + 1];
        double z = b.velocityZ[i] - frame[3 * root + 2];
        double turn =
                SolverBodies.norm(
                        b.angularVelocityX[i], b.angularVelocityY[i], b.angularVelocityZ[i]);
        return !(b.inertiaScale[i] > 0)
                && !(b.belts > 0 && b.hasBelt[i])
                && SolverBodies.norm(x, y, z) + turn * b.outerRadius[i] < still;
    }

    void ensureCapacity(BodyStore b, ContactStore c) {
        if (sweepsLeft.length < b.slotCount) {
            int n = b.kind.length;
            slots = new int[n];
            island = new int[n];
            sweepsLeft = new int[n];
            change = new double[n];
            largest = new double[n];
            swept = new boolean[n];
            before = new double[n];
            frame = new double[3 * n];
            framed = new boolean[n];
            rate = new double[n];
            longest = new double[n];
            leapt = new double[n];
            reach = new double[n];
            taken = new int[n];
            oldSpeed = new double[6 * n];
        }
        int rows = c.pointCount.length;
        if (oldImpulse.length < IMPULSES * rows) {
            oldImpulse = new double[IMPULSES * rows];
        }
    }

    /**
     * The island of a body that moves.
     *
     * @param offset of the body, see {@link SolverBodies}
     */
    int islandOf(int offset) {
        return island[SolverBodies.slot(offset)];
    }

    /**
     * Component of the velocity at which an island is at rest, m/s.
     *
     * @param at middle of the sub-step in the tick, -1/2 to 1/2
     */
    double frame(int root, int k, double at) {
        return frame[3 * root + k];
    }

    /** Whether a row is swept. */
    boolean has(ConstraintRows rows, int place) {
        return rows.settleMark[place] == MARK;
    }

    /** Before the sweeps of a sub-step over the rows from a place to another one. */
    void open(ConstraintRows rows, SolverBodies bodies, int from, int to) {}

    /** Remembers an impulse before the sweeps. */
    void keep(int contact, int k, double impulse) {}

    /** The sweeps have ended, with or without a balance. */
    void leave(ConstraintRows rows, int place, boolean isBalanced) {
        rows.settleMark[place] = 0;
    }

    /** An impulse before the sweeps. */
    double before(int contact, int k) {
        return 0;
    }

    /** The load that the offset of a point stood for before the sweeps. */
    double knew(ContactStore c, int point) {
        return 0;
    }

    boolean isOpen(int root) {
        return sweepsLeft[root] > 0;
    }

    /** A row of the island has been swept. */
    void note(int root, double rowChange, double rowLargest) {
        swept[root] = true;
        change[root] = Math.max(change[root], rowChange);
        largest[root] = Math.max(largest[root], rowLargest);
    }

    /** After a sweep, for each row; returns whether the island needs another one. */
    boolean goesOn(int root, int sweep) {
        if (swept[root]) {
            swept[root] = false;
            boolean isSame = !(change[root] > agrees * largest[root]);
            sweepsLeft[root] = isSame ? 0 : sweepsLeft[root] - 1;
            rate[root] = change[root] / before[root];
            if (leaps(sweep)) {
                beforeLeap(root, change[root]);
            }
            before[root] = change[root];
            change[root] = 0;
            largest[root] = 0;
        }
        return sweepsLeft[root] > 0;
    }

    /**
     * Before a leap.
     *
     * @param now largest change of an impulse in the sweep before it
     */
    void beforeLeap(int root, double now) {}

    /** Whether a sweep is one of two before a leap. */
    static boolean isLookedAt(int sweep) {
        return sweep % EVERY >= EVERY - 2;
    }

    /** Whether a leap follows a sweep. */
    static boolean leaps(int sweep) {
        return sweep % EVERY == EVERY - 1;
    }

    /** Bounds the leap of an island so that this normal impulse stays one. */
    void bound(int root, int contact, int k, double now) {
        double less = oldImpulse[IMPULSES * contact + k] - now;
        if (less > 0) {
            reach[root] = Math.min(reach[root], now / less);
        }
    }

    /**
     * How far an island leaps: if each sweep leaves the share q of an error, then what is left
     * after one is q/(1 - q) of what it did (Aitken 1926).
     */
    private double leap(int root) {
        double q = rate[root];
        return q < 1 ? Math.min(q / (1 - q), reach[root]) : 0;
    }

    /** An impulse after the leap, or, before it, as it is: then it is remembered. */
    double impulse(int root, int contact, int k, double now, boolean leaps) {
        int at = IMPULSES * contact + k;
        if (!leaps) {
            reach[root] = longest[root];
            oldImpulse[at] = now;
            return now;
        }
        leapt[root] = leap(root);
        return now + leapt[root] * (now - oldImpulse[at]);
    }

    /** The same for a component of a velocity. */
    double speed(int root, int slot, int k, double now, boolean leaps) {
        int at = 6 * slot + k;
        if (!leaps) {
            oldSpeed[at] = now;
            return now;
        }
        return now + leap(root) * (now - oldSpeed[at]);
    }

    /** Whether a body has not taken part in the look after this sweep yet. */
    boolean takes(int slot, int sweep) {
        boolean takes = taken[slot] != sweep;
        taken[slot] = sweep;
        return takes;
    }

    /** After the sweeps, for each row: the square of a speed that is left. */
    void moves(int root, double square) {
        largest[root] = Math.max(largest[root], square);
    }

    /** Whether the sweeps have found impulses that hold an island. */
    boolean isBalanced(int root) {
        return largest[root] < loose;
    }
}
