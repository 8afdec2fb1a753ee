package dev.cairn.physics.solver;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

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
 * <p>The number of sweeps follows from the island alone, so that neither workers nor batches change
 * a bit. Found by the simulation thread; an island is swept by the worker that has its batch.
 * Allocates only when a store has grown. Source: own study.
 */
final class StaticStart {
    /** Mark of a row, beside 1 for one that has lost a load. */
    static final byte MARK = 2;

    /** Change of an impulse over the largest one of the island at which it agrees. */
    private static final double AGREES = 1e-9;

    /** Contacts of an island times sweeps, at most: some tens of milliseconds, once. */
    private static final int VISITS = 1 << 19;

    /** Speed over what gravity adds to it in a sub-step, up to which an island is in balance. */
    private static final double BALANCED = 0.01;

    /** By slot of the island's root. */
    private int[] sweepsLeft = {};

    private double[] change = {};
    private double[] largest = {};
    private boolean[] swept = {};
    private Batches batches = new Batches();

    /** Square of the speed at which an island is out of balance. */
    private double loose;

    /** Whether there is such an island. */
    boolean found;

    /**
     * Marks the rows of islands that start.
     *
     * @param islands batches of this tick
     * @param still speed below which a body is at rest, m/s
     * @param gain what gravity adds to a speed in a sub-step, m/s
     * @param sweeps over an island, at most
     */
    void find(
            BodyStore b,
            ContactStore c,
            RowList list,
            Batches islands,
            double still,
            double gain,
            int sweeps) {
        found = false;
        loose = BALANCED * BALANCED * gain * gain;
        if (!anyNew(b)) {
            return;
        }
        batches = islands;
        ensureCapacity(b);
        Arrays.fill(sweepsLeft, 0, b.slotCount, 0);
        Arrays.fill(swept, 0, b.slotCount, false);
        for (int m = 0; m < list.count; m++) {
            int i = c.bodyA[list.source[m]];
            int j = c.bodyB[list.source[m]];
            int root = islands.root(b.kind[i] == BodyStore.DYNAMIC ? i : j);
            sweepsLeft[root]++;
            // for now: whether the island is no start
            swept[root] |= !starts(b, i, still) || !starts(b, j, still);
        }
        for (int m = 0; m < list.count; m++) {
            int i = c.bodyA[list.source[m]];
            int root =
                    islands.root(b.kind[i] == BodyStore.DYNAMIC ? i : c.bodyB[list.source[m]]);
            if (!swept[root]) {
                list.rows(m).unloaded[list.place[m]] = MARK;
                found = true;
            }
        }
        for (int i = 0; i < b.slotCount; i++) {
            int rows = sweepsLeft[i];
            sweepsLeft[i] = rows == 0 || swept[i] ? 0 : Math.min(sweeps, VISITS / rows + 1);
            swept[i] = false;
            change[i] = 0;
            largest[i] = 0;
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

    private static boolean starts(BodyStore b, int i, double still) {
        if (b.kind[i] == BodyStore.DYNAMIC && b.inertiaScale[i] > 0) {
            return false;
        }
        double x = b.velocityX[i];
        double y = b.velocityY[i];
        double z = b.velocityZ[i];
        double u = b.angularVelocityX[i];
        double v = b.angularVelocityY[i];
        double w = b.angularVelocityZ[i];
        double turn = b.kind[i] == BodyStore.DYNAMIC ? b.outerRadius[i] : 1;
        return Math.sqrt(x * x + y * y + z * z) + Math.sqrt(u * u + v * v + w * w) * turn < still;
    }

    private void ensureCapacity(BodyStore b) {
        if (sweepsLeft.length < b.slotCount) {
            int n = b.kind.length;
            sweepsLeft = new int[n];
            change = new double[n];
            largest = new double[n];
            swept = new boolean[n];
        }
    }

    /**
     * The island of a body that moves.
     *
     * @param offset of the body, see {@link SolverBodies}
     */
    int islandOf(int offset) {
        return batches.root(SolverBodies.slot(offset));
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
    boolean goesOn(int root) {
        if (swept[root]) {
            swept[root] = false;
            boolean agrees = !(change[root] > AGREES * largest[root]);
            sweepsLeft[root] = agrees ? 0 : sweepsLeft[root] - 1;
            change[root] = 0;
            largest[root] = 0;
        }
        return sweepsLeft[root] > 0;
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
