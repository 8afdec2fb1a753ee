package dev.cairn.physics.contact.impact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.narrowphase.pair.Reach;
import dev.cairn.physics.sweep.Flight;

import java.util.Arrays;

/** Bodies in a tick with impacts: which may be struck, which were, and the rows of each. */
final class StruckBodies {
    private final ColliderStore colliders;
    private final ContactStore contacts;

    /** By body: 0 if it is free, 1 if it touches another body, 2 if it is bound otherwise. */
    byte[] free = {};

    /** By body: impacts in this tick, and meetings without an impact. */
    int[] impacts = {}, idle = {};

    /** By body: it is the solver's. */
    boolean[] closed = {};

    /** By body: share of the tick at its last impact. */
    double[] late = {};

    /** By body: orientation and angular velocity at its last impact. */
    double[] last = {};

    private final double[] turn = new double[4];

    /** By body: the first of its rows; by row and side: the next one. */
    int[] head = {}, next = {};

    /** Those that were struck. */
    int[] list = {};

    int count;

    /** Those that move and may be struck, once each. */
    int[] marked = {};

    int markedCount;
    private boolean[] isMarked = {};

    StruckBodies(ColliderStore colliders, ContactStore contacts) {
        this.colliders = colliders;
        this.contacts = contacts;
    }

    void begin(byte[] freedom) {
        free = freedom;
        int slots = colliders.bodies.slotCount;
        if (impacts.length < slots) {
            impacts = new int[slots + (slots >> 1)];
            closed = new boolean[impacts.length];
            idle = new int[impacts.length];
            late = new double[impacts.length];
            last = new double[7 * impacts.length];
            head = new int[impacts.length];
            list = new int[impacts.length];
            marked = new int[impacts.length];
            isMarked = new boolean[impacts.length];
            markedCount = 0;
        }
        Arrays.fill(impacts, 0, slots, 0);
        Arrays.fill(closed, 0, slots, false);
        Arrays.fill(idle, 0, slots, 0);
        Arrays.fill(late, 0, slots, 0.0);
        count = 0;
    }

    /** Keeps how a body lies at an impact, and how it turns after it: {@code w} from {@code at}. */
    void keep(int body, Flight f, double[] w, int at) {
        int q = 7 * body;
        last[q] = f.qx;
        last[q + 1] = f.qy;
        last[q + 2] = f.qz;
        last[q + 3] = f.qw;
        System.arraycopy(w, at, last, q + 4, 3);
    }

    /** How a body lies so many seconds after its last impact: a unit quaternion. */
    void lay(int body, double seconds, double[] out) {
        int q = 7 * body;
        double wx = last[q + 4];
        double wy = last[q + 5];
        double wz = last[q + 6];
        double spin = Math.sqrt(wx * wx + wy * wy + wz * wz);
        System.arraycopy(last, q, out, 0, 4);
        // a closed body ends the tick in its present orientation
        if (spin > 0 && seconds > 0 && !closed[body]) {
            Rotations.turn(wx, wy, wz, spin, seconds, turn);
            Rotations.multiply(turn, last, q, out);
        }
    }

    void clearMarks() {
        for (int i = 0; i < markedCount; i++) {
            isMarked[marked[i]] = false;
        }
        markedCount = 0;
    }

    void mark(int body) {
        if (colliders.bodies.kind[body] == BodyStore.DYNAMIC && !isMarked[body]) {
            isMarked[body] = true;
            marked[markedCount++] = body;
        }
    }

    /** Whether all meetings of a body are looked at within the tick. */
    boolean isFollowed(int body) {
        return colliders.bodies.kind[body] != BodyStore.DYNAMIC
                || (isMarked[body] && !closed[body] && free[body] == 0);
    }

    /** Whether a body that moves touches others. */
    boolean isBound(int body) {
        return colliders.bodies.kind[body] == BodyStore.DYNAMIC && free[body] != 0;
    }

    /** Whether a body of a row touches others. */
    boolean isHeld(int row) {
        return isBound(contacts.bodyA[row]) || isBound(contacts.bodyB[row]);
    }

    /** Whether what moves of a row are balls, which touch in one point. */
    boolean isRound(int row) {
        return isRoundOrStays(contacts.bodyA[row]) && isRoundOrStays(contacts.bodyB[row]);
    }

    private boolean isRoundOrStays(int body) {
        return colliders.bodies.isBall[body] || colliders.bodies.kind[body] != BodyStore.DYNAMIC;
    }

    /** Whether a body may be stopped. */
    boolean isLoose(int body) {
        return colliders.bodies.kind[body] == BodyStore.DYNAMIC && free[body] == 0;
    }

    /** Whether the other body of a row goes another way than the row was told of. */
    boolean isStruckElsewhere(int row, int body) {
        int other = contacts.bodyA[row] == body ? contacts.bodyB[row] : contacts.bodyA[row];
        return colliders.bodies.kind[other] == BodyStore.DYNAMIC && impacts[other] > 0;
    }

    /** Whether two bodies of a row may be struck. */
    boolean fits(int row) {
        ContactStore c = contacts;
        int u = 3 * row;
        return (!c.belts || (c.belt[u] == 0 && c.belt[u + 1] == 0 && c.belt[u + 2] == 0))
                && fits(c.colliderA[row], c.colliderB[row]);
    }

    /** Whether two colliders may be struck. */
    boolean fits(int a, int b) {
        return (isFree(a) || isFree(b))
                && answersAlone(a)
                && answersAlone(b)
                && isPlain(a)
                && isPlain(b);
    }

    /** A body of one shape that is dynamic, and neither bound nor in touch. */
    private boolean isFree(int collider) {
        int body = colliders.body[collider];
        return colliders.bodies.kind[body] == BodyStore.DYNAMIC
                && free[body] == 0
                && isSingle(collider);
    }

    private boolean isSingle(int collider) {
        return colliders.bodies.collider[colliders.body[collider]] == collider
                && !colliders.isChild(collider)
                && colliders.next[collider] == ColliderStore.NONE;
    }

    /** Whether a body that answers is bound by nothing but contacts. */
    private boolean answersAlone(int collider) {
        int body = colliders.body[collider];
        byte kind = colliders.bodies.kind[body];
        return kind == BodyStore.STATIC
                || kind == BodyStore.KINEMATIC
                || (kind == BodyStore.DYNAMIC && free[body] < 2 && isSingle(collider));
    }

    /** Whether a collider is convex, and the one that its rows are solved for and told of. */
    boolean isPlain(int collider) {
        return Reach.fits(colliders.shape[collider])
                && !colliders.isPart(collider)
                && !colliders.isWhole(collider);
    }

    /** Lists the rows of each body. */
    void link() {
        Arrays.fill(head, 0, colliders.bodies.slotCount, -1);
        if (next.length < 2 * contacts.count) {
            next = new int[2 * contacts.bodyA.length];
        }
        for (int i = contacts.activeCount - 1; i >= 0; i--) {
            int row = contacts.active[i];
            int a = contacts.bodyA[row];
            int b = contacts.bodyB[row];
            if (!isPlain(contacts.colliderA[row]) || !isPlain(contacts.colliderB[row])) {
                // near triangles, or parts that make one shape, contacts and the guard do it
                closed[a] = colliders.bodies.kind[a] == BodyStore.DYNAMIC;
                closed[b] = colliders.bodies.kind[b] == BodyStore.DYNAMIC;
            }
            next[2 * row] = head[a];
            head[a] = 2 * row;
            next[2 * row + 1] = head[b];
            head[b] = 2 * row + 1;
        }
    }

    /** The row of two colliders, the lower one first, or -1. */
    int row(int body, int a, int b) {
        for (int link = head[body]; link >= 0; link = next[link]) {
            int row = link >> 1;
            if (contacts.colliderA[row] == a && contacts.colliderB[row] == b) {
                return row;
            }
        }
        return -1;
    }
}
