package dev.cairn.physics.solver.graph;

import dev.cairn.physics.island.Islands;
import dev.cairn.physics.solver.row.EdgeList;

import java.util.Arrays;

/**
 * The contacts with restitution, by batch, and in the order of the list; those of domains are with
 * the batch in lockstep that they belong to.
 *
 * <p>Simulation thread; allocates only when there were never so many.
 */
public final class BouncingContacts {
    /** Room from the first tick on, so that small scenes come to rest without growing. */
    private static final int LEAST = 1024;

    /** Impacts of a contact in a sub-step, at most; of few contacts together so many as these. */
    private static final int FEWEST = 16;

    private static final int VISITS = 16384;

    /** Contacts of the list, by batch. */
    public int[] row = {};

    /** By batch: where its contacts start; one more for the end of the last. */
    private int[] first = new int[2];

    /**
     * By entry: impacts that the contact may have in a sub-step. Contacts of small islands may have
     * more: two blocks and a wall make thousands, while a heap would take too long. Told by the
     * island, not by the batch, so that the cut changes no bit.
     */
    public int[] impactLimits = {};

    private int[] bouncing = {};
    private int count;

    /** By smallest slot of an island: its contacts with restitution. */
    private int[] tally = {};

    void begin(int contacts) {
        count = 0;
        if (bouncing.length < contacts) {
            bouncing =
                    new int
                            [Math.max(
                                    contacts,
                                    Math.max(LEAST, bouncing.length + (bouncing.length >> 1)))];
            row = new int[bouncing.length];
            impactLimits = new int[bouncing.length];
        }
    }

    /** Contact {@code m} of the list bounces; in ascending order. */
    void add(int m) {
        bouncing[count++] = m;
    }

    /** Sorts them by batch. */
    void sort(EdgeList list, Batches batches) {
        if (first.length <= batches.count) {
            first = new int[batches.firstRow.length];
        }
        Arrays.fill(first, 0, batches.count + 1, 0);
        for (int k = 0; k < count; k++) {
            first[batches.groupOfRow(bouncing[k]) + 1]++;
        }
        for (int b = 0; b < batches.count; b++) {
            first[b + 1] += first[b];
        }
        for (int k = 0; k < count; k++) {
            row[first[batches.groupOfRow(bouncing[k])]++] = bouncing[k];
        }
        System.arraycopy(first, 0, first, 1, batches.count);
        first[0] = 0;
        share(list, batches);
    }

    private void share(EdgeList list, Batches batches) {
        if (count == 0) {
            return;
        }
        Islands islands = batches.islands(list);
        if (tally.length < batches.order.length) {
            tally = new int[batches.order.length];
        }
        for (int k = 0; k < count; k++) {
            tally[islands.root(list.mover(row[k]))] = 0;
        }
        for (int k = 0; k < count; k++) {
            tally[islands.root(list.mover(row[k]))]++;
        }
        for (int k = 0; k < count; k++) {
            impactLimits[k] = Math.max(FEWEST, VISITS / tally[islands.root(list.mover(row[k]))]);
        }
    }

    /**
     * Where the contacts of a batch start in {@link #row}.
     *
     * @param batch one that a worker has alone, or one in lockstep, which counts for its domains
     */
    public int from(int batch) {
        return count == 0 ? 0 : first[batch];
    }

    /** Where they end. */
    public int to(int batch) {
        return count == 0 ? 0 : first[batch + 1];
    }
}
