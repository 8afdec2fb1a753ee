package dev.cairn.physics.solver.load;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.island.Islands;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The tick in which a structure is put up: an island of bodies that are all new and at rest.
 *
 * <p>Its contacts know of no load yet. Sweeps that start from nothing hand the weight on from
 * contact to contact while the bodies already move, and soft contacts give until their offsets have
 * learnt of the load: a house of thin cards has fallen by then. So before anything moves, hard
 * normals and friction are swept until they agree, and the offsets begin with the load that was
 * found: the structure starts in balance, with springs that are neither too long nor too short.
 *
 * <p>Error falls by a constant share a sweep, and slowly: {@link SweepMixing} tells from the last
 * sweeps where all further ones would lead. A pyramid of 55 boxes takes 190 sweeps for it, ten
 * boxes on each other 170.
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
    double agrees = 1e-13;

    /**
     * Sweeps that the leaps of an island go by. With 16 a tower takes half of the sweeps, but where
     * friction may be one thing or another it comes out so that some riders slip later.
     */
    private static final int MEMORY = 8;

    /** Contacts of an island times sweeps, at most: up to a tenth of a second, once. */
    private static final int VISITS = 1 << 17;

    /** Contacts of all islands that start in a tick times sweeps, at most. */
    private static final int ALL_VISITS = 1 << 20;

    /** A larger island, which could be swept less often, starts as it is. */
    static final int FEWEST = 32;

    /** To a contact: four of points, two of friction and a twist. */
    static final int IMPULSES = 7;

    /** Speed over what gravity adds to it in a sub-step, up to which an island is in balance. */
    private static final double BALANCED = 1e-5;

    private final Islands islands = new Islands();

    /** Dynamic bodies, how many there are, and by slot: the smallest slot of the island. */
    int[] slots = {};

    int slotsUsed;

    int[] island = {};

    /** By smallest slot of an island, as what follows. */
    int[] sweepsLeft = {};

    /** By smallest slot of an island: velocity of all that carries it, and whether any does. */
    double[] frame = {};

    boolean[] framed = {};

    /** By smallest slot: rows and bodies of an island that is swept, and where its leaps are. */
    int[] rowsOf = {};

    int[] bodiesOf = {};
    private int[] leapsAt = {};

    /** One to an island that is swept in this tick; the first so many. */
    private final List<SweepLeaps> leapsOf = new ArrayList<>();

    private int islandsSwept;

    /** By slot: in the list that is made of an island's bodies. */
    private boolean[] taken = {};

    /** By smallest slot: swept in this pass. */
    boolean[] swept = {};

    /** Square of the speed at which an island is out of balance. */
    double loose;

    /** Whether there is such an island. */
    public boolean found;

    /** Nothing starts; gives the room of what did back. */
    public void clear() {
        found = false;
        leapsOf.clear();
    }

    /**
     * Marks the rows of islands that start, after {@link #clear}.
     *
     * @param still speed below which a body is at rest, m/s
     * @param gain what gravity adds to a speed in a sub-step, m/s
     * @param sweeps over an island, at most
     */
    public void find(
            BodyStore b, ContactStore c, EdgeList list, double still, double gain, int sweeps) {
        loose = BALANCED * BALANCED * gain * gain;
        if (!anyNew(b)) {
            return;
        }
        ensureCapacity(b);
        gather(b, list);
        Arrays.fill(swept, 0, b.slotCount, false);
        Arrays.fill(framed, 0, b.slotCount, false);
        Arrays.fill(frame, 0, 3 * b.slotCount, 0.0);
        for (int m = 0; m < list.count; m++) {
            int root = island[list.mover(m)];
            rowsOf[root]++;
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
        leaveAlone(b, c, list);
        int all = 0;
        for (int m = 0; m < list.contacts; m++) {
            int root = island[list.mover(m)];
            if (!swept[root] && !isTooLarge(root)) {
                list.rows(m).settleMark[list.place[m]] = MARK;
                all++;
                found = true;
            }
        }
        for (int k = 0; k < slotsUsed; k++) {
            int i = slots[k];
            if (rowsOf[i] > 0 && !swept[i] && !isTooLarge(i)) {
                int most = Math.min(VISITS / rowsOf[i], ALL_VISITS / all);
                sweepsLeft[i] = Math.min(sweeps, most);
                reserve(i);
            }
            swept[i] = false;
        }
    }

    /**
     * A body on what never moves is solved by itself, and is no start: in a world without piles
     * nobody looks for one.
     */
    private void leaveAlone(BodyStore b, ContactStore c, EdgeList list) {
        Arrays.fill(taken, 0, b.slotCount, false);
        for (int m = 0; m < list.contacts; m++) {
            int source = list.source[m];
            taken[island[list.mover(m)]] |= b.isPile(c.bodyA[source], c.bodyB[source]);
        }
        for (int k = 0; k < slotsUsed; k++) {
            swept[slots[k]] |= !taken[slots[k]];
            taken[slots[k]] = false;
        }
    }

    private boolean isTooLarge(int root) {
        return VISITS / rowsOf[root] < FEWEST;
    }

    /** Room for the sweeps over an island. */
    void reserve(int root) {
        if (islandsSwept == leapsOf.size()) {
            leapsOf.add(leaps());
        }
        leapsAt[root] = islandsSwept;
        leapsOf.get(islandsSwept++).begin(rowsOf[root], bodiesOf[root]);
    }

    /** Leaps for an island. */
    SweepLeaps leaps() {
        return new SweepMixing(MEMORY);
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
        slotsUsed = count;
        islandsSwept = 0;
        Arrays.fill(rowsOf, 0, b.slotCount, 0);
        Arrays.fill(bodiesOf, 0, b.slotCount, 0);
        for (int k = 0; k < count; k++) {
            int root = islands.root(slots[k]);
            island[slots[k]] = root;
            bodiesOf[root]++;
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

    void ensureCapacity(BodyStore b) {
        if (sweepsLeft.length < b.slotCount) {
            int n = b.kind.length;
            slots = new int[n];
            island = new int[n];
            sweepsLeft = new int[n];
            rowsOf = new int[n];
            bodiesOf = new int[n];
            leapsAt = new int[n];
            swept = new boolean[n];
            frame = new double[3 * n];
            framed = new boolean[n];
            taken = new boolean[n];
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

    /** Whether an island has not been swept in this pass; it counts as swept from here on. */
    boolean begins(int root) {
        boolean begins = !swept[root];
        swept[root] = true;
        return begins;
    }

    /** Sweeps of an island, at most. */
    int sweeps(int root) {
        return sweepsLeft[root];
    }

    SweepLeaps leaps(int root) {
        SweepLeaps leaps = leapsOf.get(leapsAt[root]);
        leaps.begin(rowsOf[root], bodiesOf[root]);
        return leaps;
    }

    /** Whether a body is not in the list yet; it is from here on. */
    boolean takes(int slot) {
        boolean takes = !taken[slot];
        taken[slot] = true;
        return takes;
    }

    void putBack(int slot) {
        taken[slot] = false;
    }

    /** Whether the largest square of a speed that is left means balance. */
    boolean isStill(double square) {
        return square < loose;
    }
}
