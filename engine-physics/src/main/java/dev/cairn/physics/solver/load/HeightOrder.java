package dev.cairn.physics.solver.load;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.SolverBodies;

import java.util.Arrays;

/**
 * The bodies with contacts from the highest to the lowest, ties by slot.
 *
 * <p>Kept from tick to tick and merged from the runs that are in order already: most ticks change
 * nothing, and pay for one look. What comes out is a function of the heights alone. Simulation
 * thread; allocates only when a store has grown.
 */
final class HeightOrder {
    /** Along the loads, m; by slot, as the caller measures it. */
    double[] height = {};

    /** Slots in their order, and how many there are. */
    int[] body = {};

    int count;

    private int[] spare = {};
    private boolean[] listed = {};

    void ensureCapacity(int slots) {
        if (height.length < slots) {
            height = Arrays.copyOf(height, slots);
            body = Arrays.copyOf(body, slots);
            listed = Arrays.copyOf(listed, slots);
            spare = new int[slots];
        }
    }

    /**
     * Brings the order up to date.
     *
     * @param guide tells which bodies have contacts
     * @param same whether these are the bodies of the last call
     */
    void update(BodyStore bodies, int[] guide, boolean same) {
        if (!same) {
            list(bodies, guide);
        }
        boolean sorted = false;
        while (!sorted) {
            sorted = mergeRuns();
        }
    }

    private void list(BodyStore bodies, int[] guide) {
        int kept = 0;
        for (int k = 0; k < count; k++) {
            int i = body[k];
            boolean stays = i < bodies.slotCount && isBound(bodies, guide, i);
            listed[i] = stays;
            if (stays) {
                body[kept++] = i;
            }
        }
        for (int i = 0; i < bodies.slotCount; i++) {
            if (!listed[i] && isBound(bodies, guide, i)) {
                listed[i] = true;
                body[kept++] = i;
            }
        }
        count = kept;
    }

    private static boolean isBound(BodyStore bodies, int[] guide, int i) {
        return bodies.kind[i] == BodyStore.DYNAMIC && guide[i] != SolverBodies.FREE;
    }

    /** Merges neighbouring runs pairwise; true if there was one run only. */
    private boolean mergeRuns() {
        int out = 0;
        int at = 0;
        boolean sorted = true;
        while (at < count) {
            int middle = runEnd(at);
            if (middle == count && at == 0) {
                return true;
            }
            int end = middle < count ? runEnd(middle) : middle;
            int l = at;
            int r = middle;
            while (l < middle && r < end) {
                spare[out++] = isBefore(body[l], body[r]) ? body[l++] : body[r++];
            }
            while (l < middle) {
                spare[out++] = body[l++];
            }
            while (r < end) {
                spare[out++] = body[r++];
            }
            sorted = at == 0 && end == count;
            at = end;
        }
        int[] swap = body;
        body = spare;
        spare = swap;
        return sorted;
    }

    private int runEnd(int from) {
        int k = from + 1;
        while (k < count && isBefore(body[k - 1], body[k])) {
            k++;
        }
        return k;
    }

    /** Whether a body comes before another. */
    boolean isBefore(int i, int j) {
        return height[i] > height[j] || (height[i] == height[j] && i < j);
    }
}
