package dev.cairn.physics.solver;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.island.Islands;

import java.util.Arrays;

/**
 * Cuts the contacts of a tick into batches that share no body that moves, so that a worker takes a
 * batch through the whole tick on its own.
 *
 * <p>Problem: in lockstep all contacts of a scene stream through the caches in each of the passes,
 * and the workers wait for each other after each colour of each pass. Islands do not see each
 * other; the rows of one that fits the cache stay there for all sub-steps, and nobody waits. So
 * islands are gathered into batches, in the order of their smallest slot, up to {@link #WANTED}
 * rows; what one worker should not have alone goes to batch 0, which all workers solve in lockstep.
 * Islands of more than {@link #LARGEST} rows are cut into {@link Domains}, a batch each, with the
 * contacts between these in batch 0.
 *
 * <p>The order in which the contacts of an island are solved is the same in both, and so are the
 * bits: the cut may depend on the number of workers. Simulation thread; allocates only when a store
 * has grown.
 */
final class Batches {
    /**
     * Rows up to which small islands are put together: some 700 bytes each in a cache of 512 KiB.
     */
    static final int WANTED = 320;

    /** A larger island is cut into domains. */
    private static final int LARGEST = 1024;

    /** In {@link #tally}: the island is cut into domains. */
    private static final int CUT = -1;

    private final Islands islands = new Islands();

    /** The domains of large islands are the batches from 1 to {@code domains.count}. */
    final Domains domains = new Domains();

    /** Batches, the one in lockstep and the domains included. */
    int count;

    /** Bodies with contacts, by batch and then by slot; where those of each batch start. */
    int[] order = {};

    int[] firstBody = new int[2];
    private int[] bound = {};
    private int boundCount;

    /** By slot: rows of the island whose smallest slot it is, then its batch. */
    private int[] tally = {};

    /** By row: its batch; by batch: where its rows start in {@link #byBatch}. */
    private int[] batchOf = {};

    int[] firstRow = new int[2];

    /** Rows by batch, in their order. */
    int[] byBatch = {};

    private void ensureCapacity(int slots, int rows) {
        if (order.length < slots) {
            int n = Math.max(slots, order.length + (order.length >> 1));
            order = new int[n];
            bound = new int[n];
            tally = new int[n];
        }
        islands.ensureSlots(order.length);
        if (byBatch.length < rows) {
            int n = Math.max(rows, Math.max(64, byBatch.length + (byBatch.length >> 1)));
            byBatch = new int[n];
            batchOf = new int[n];
        }
        int most = Math.max(order.length, byBatch.length) + 3;
        if (firstBody.length < most) {
            firstBody = new int[most];
            firstRow = new int[most];
        }
    }

    /**
     * Cuts the rows.
     *
     * @param guide tells who has contacts
     * @param together whether all are to be solved in lockstep
     * @param workers that take part
     */
    void cut(
            BodyStore bodies,
            ContactStore contacts,
            ConstraintRows rows,
            int[] guide,
            boolean together,
            int workers) {
        ensureCapacity(bodies.slotCount, rows.source.length);
        boundCount = 0;
        for (int i = 0; i < bodies.slotCount; i++) {
            if (guide[i] != SolverBodies.FREE) {
                bound[boundCount++] = i;
            }
        }
        domains.count = 0;
        if (rows.count <= (together ? LARGEST : WANTED)) {
            whole(rows, together ? 0 : 1);
            return;
        }
        islands.build(bodies, contacts, bound, boundCount);
        assign(bodies, contacts, rows, together, workers);
        sortRows(rows);
        sortBodies();
    }

    /** All in one batch. */
    private void whole(ConstraintRows rows, int batch) {
        count = batch + 1;
        System.arraycopy(bound, 0, order, 0, boundCount);
        for (int m = 0; m < rows.count; m++) {
            byBatch[m] = m;
            batchOf[m] = batch;
        }
        firstRow[0] = 0;
        firstBody[0] = 0;
        firstRow[1] = batch == 0 ? rows.count : 0;
        firstBody[1] = batch == 0 ? boundCount : 0;
        firstRow[count] = rows.count;
        firstBody[count] = boundCount;
    }

    private void assign(
            BodyStore bodies,
            ContactStore contacts,
            ConstraintRows rows,
            boolean together,
            int workers) {
        for (int k = 0; k < boundCount; k++) {
            tally[bound[k]] = 0;
        }
        for (int m = 0; m < rows.count; m++) {
            int c = rows.source[m];
            int a = contacts.bodyA[c];
            int root = islands.root(bodies.kind[a] == BodyStore.DYNAMIC ? a : contacts.bodyB[c]);
            batchOf[m] = root;
            tally[root]++;
        }
        boolean cuts = false;
        for (int k = 0; k < boundCount; k++) {
            if (tally[bound[k]] > LARGEST) {
                tally[bound[k]] = CUT;
                cuts = true;
            }
        }
        if (cuts) {
            domains.cut(bodies, contacts, rows, islands, batchOf, tally, CUT, bound, boundCount);
        }
        // an island that would keep one worker busy while the others wait is for all
        int share = workers == 1 ? LARGEST : rows.count / (2 * workers);
        int largest = Math.max(WANTED, Math.min(LARGEST, share));
        int size = WANTED;
        count = 1 + domains.count;
        for (int k = 0; k < boundCount; k++) {
            int i = bound[k];
            if (islands.root(i) != i || tally[i] == CUT) {
                continue;
            }
            int n = tally[i];
            if (together || n > largest) {
                tally[i] = 0;
                continue;
            }
            if (size + n > WANTED) {
                count++;
                size = 0;
            }
            size += n;
            tally[i] = count - 1;
        }
        for (int m = 0; m < rows.count; m++) {
            int batch = tally[batchOf[m]];
            batchOf[m] = batch == CUT ? domain(bodies, contacts, rows.source[m]) : batch;
        }
    }

    /** The batch of a contact within a domain; 0 for one between two of them. */
    private int domain(BodyStore bodies, ContactStore contacts, int c) {
        int a = contacts.bodyA[c];
        int b = contacts.bodyB[c];
        if (bodies.kind[a] != BodyStore.DYNAMIC) {
            return 1 + domains.of[b];
        }
        if (bodies.kind[b] != BodyStore.DYNAMIC) {
            return 1 + domains.of[a];
        }
        return domains.of[a] == domains.of[b] ? 1 + domains.of[a] : 0;
    }

    private void sortRows(ConstraintRows rows) {
        Arrays.fill(firstRow, 0, count + 1, 0);
        for (int m = 0; m < rows.count; m++) {
            firstRow[batchOf[m] + 1]++;
        }
        for (int b = 0; b < count; b++) {
            firstRow[b + 1] += firstRow[b];
        }
        for (int m = 0; m < rows.count; m++) {
            byBatch[firstRow[batchOf[m]]++] = m;
        }
        shift(firstRow);
    }

    private void sortBodies() {
        Arrays.fill(firstBody, 0, count + 1, 0);
        for (int k = 0; k < boundCount; k++) {
            firstBody[batchOfBody(bound[k]) + 1]++;
        }
        for (int b = 0; b < count; b++) {
            firstBody[b + 1] += firstBody[b];
        }
        for (int k = 0; k < boundCount; k++) {
            order[firstBody[batchOfBody(bound[k])]++] = bound[k];
        }
        shift(firstBody);
    }

    private int batchOfBody(int slot) {
        int batch = tally[islands.root(slot)];
        return batch == CUT ? 1 + domains.of[slot] : batch;
    }

    /** Whether a row is in batch 0. */
    boolean isLockstep(int m) {
        return batchOf[m] == 0;
    }

    /** Ends become starts again. */
    private void shift(int[] first) {
        System.arraycopy(first, 0, first, 1, count);
        first[0] = 0;
    }
}
