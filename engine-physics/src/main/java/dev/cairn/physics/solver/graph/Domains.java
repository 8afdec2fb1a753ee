package dev.cairn.physics.solver.graph;

import dev.cairn.physics.island.Islands;
import dev.cairn.physics.solver.row.EdgeList;

/**
 * Cuts islands that are too large for a cache into domains: bodies that hang together, with the
 * contacts between them.
 *
 * <p>Problem: the rows of a large island stream through the caches twice in each sub-step, and all
 * workers wait for each other after each colour. A domain's own contacts share no body with those
 * of another, so a worker may take a domain through the relax pass of one sub-step and the bias
 * pass of the next while its rows are in the cache. Only the contacts between domains, some tenth
 * of all in a wall, some quarter in a heap, are still swept in lockstep.
 *
 * <p>A domain grows from the smallest slot of the island that has none, neighbours first, until it
 * has {@link #WANTED} rows; what is left over between domains is put together. So the cut is a
 * function of the island's contacts and the order of its slots alone, neither of workers nor of
 * other islands, as it must be: the order of solving follows from it. Simulation thread; allocates
 * only when a store has grown.
 *
 * <p>Source: the greedy growing of graph partitions, e.g. C. Farhat, "A simple and efficient
 * automatic FEM domain decomposer" (1988).
 */
public final class Domains {
    /**
     * Rows to a domain: some 700 bytes each in a cache of 512 KiB, beside their bodies; those of
     * floats are half as long, but twice as many in a domain would leave workers of heaps idle.
     */
    public static final int WANTED = 384;

    /** Number of domains. */
    int count;

    /** By domain: the body that it grew from. */
    int[] seed = {};

    /** By slot of a large island: its domain; below 0 while it has none. */
    int[] of = {};

    /** By slot: its contacts with static bodies. */
    private int[] held = {};

    /** By slot: where its neighbours start in {@link #neighbours}, then where they end. */
    private int[] first = {};

    private int[] last = {};
    private int[] neighbours = {};

    private int[] queue = {};

    /** By the smallest slot of an island: its domain that still grows, or -1; rows of that. */
    private int[] open = {};

    private int[] size = {};

    private void ensureCapacity(int slots, int rows) {
        if (of.length < slots) {
            int n = Math.max(slots, of.length + (of.length >> 1));
            of = new int[n];
            held = new int[n];
            first = new int[n];
            last = new int[n];
            queue = new int[n];
            open = new int[n];
            size = new int[n];
            seed = new int[n];
        }
        if (neighbours.length < 2 * rows) {
            neighbours = new int[Math.max(2 * rows, neighbours.length + (neighbours.length >> 1))];
        }
    }

    /**
     * Cuts the large islands.
     *
     * @param islands of the rows
     * @param root by row: the smallest slot of its island
     * @param tally by that slot: {@code large} if the island is to be cut
     * @param bound bodies with edges, ascending
     */
    void cut(
            EdgeList list,
            Islands islands,
            int[] root,
            int[] tally,
            int large,
            int[] bound,
            int boundCount) {
        ensureCapacity(tally.length, list.source.length);
        count = 0;
        for (int k = 0; k < boundCount; k++) {
            int i = bound[k];
            of[i] = -1;
            open[i] = -1;
            held[i] = 0;
            last[i] = 0;
        }
        link(list, root, tally, large, bound, boundCount);
        for (int k = 0; k < boundCount; k++) {
            int i = bound[k];
            int r = islands.root(i);
            if (tally[r] == large && of[i] < 0) {
                grow(i, r);
            }
        }
    }

    /** Lists the neighbours of each body. */
    private void link(
            EdgeList list, int[] root, int[] tally, int large, int[] bound, int boundCount) {
        for (int m = 0; m < list.count; m++) {
            if (tally[root[m]] == large) {
                if (list.isBetweenMovers(m)) {
                    last[list.slotA[m]]++;
                    last[list.slotB[m]]++;
                } else {
                    held[list.mover(m)]++;
                }
            }
        }
        int at = 0;
        for (int k = 0; k < boundCount; k++) {
            int i = bound[k];
            first[i] = at;
            at += last[i];
            last[i] = first[i];
        }
        for (int m = 0; m < list.count; m++) {
            if (tally[root[m]] == large && list.isBetweenMovers(m)) {
                int a = list.slotA[m];
                int b = list.slotB[m];
                neighbours[last[a]++] = b;
                neighbours[last[b]++] = a;
            }
        }
    }

    /** Grows a domain from a body on, breadth first. */
    private void grow(int from, int root) {
        int d = open[root];
        if (d < 0) {
            d = count++;
            open[root] = d;
            seed[d] = from;
            size[d] = 0;
        }
        int queued = -2 - d;
        int head = 0;
        int tail = 0;
        queue[tail++] = from;
        while (head < tail) {
            int x = queue[head++];
            of[x] = d;
            int n = held[x];
            for (int k = first[x]; k < last[x]; k++) {
                int y = neighbours[k];
                if (of[y] == d) {
                    n++;
                } else if (of[y] < 0 && of[y] != queued) {
                    of[y] = queued;
                    queue[tail++] = y;
                }
            }
            size[d] += n;
            if (size[d] >= WANTED) {
                open[root] = -1;
                return;
            }
        }
    }
}
