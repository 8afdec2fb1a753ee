package dev.cairn.physics.solver.graph;

import java.util.Arrays;

/**
 * The contacts with restitution, by batch, and in the order of the list; those of domains are with
 * the batch in lockstep that they belong to.
 *
 * <p>Simulation thread; allocates only when there were never so many.
 */
public final class Bouncers {
    /** Contacts of the list, by batch. */
    public int[] row = {};

    /** By batch: where its contacts start; one more for the end of the last. */
    private int[] first = new int[2];

    private int[] bouncing = {};
    private int count;

    void begin(int contacts) {
        count = 0;
        if (bouncing.length < contacts) {
            bouncing = new int[Math.max(contacts, bouncing.length + (bouncing.length >> 1))];
            row = new int[bouncing.length];
        }
    }

    /** Contact {@code m} of the list bounces; in ascending order. */
    void add(int m) {
        bouncing[count++] = m;
    }

    /** Sorts them by batch. */
    void sort(Batches batches) {
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
