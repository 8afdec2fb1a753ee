package dev.cairn.physics.solver.graph;

import java.util.Arrays;

/**
 * The edges of one kind that are solved, by the slots of their bodies: first by A, then by B; of
 * two bodies by their colliders, and those with a surface of triangles by triangle.
 *
 * <p>Rows of contacts stand in the order in which their boxes met, and boxes lie along the world's
 * axes: in that order a scene would be solved differently when it is turned. Two counting sorts,
 * stable, of time linear in edges and slots. Simulation thread; allocates only when a store has
 * grown.
 */
final class PairOrder {
    /** Room from the first tick on, so that small scenes come to rest without growing. */
    private static final int LEAST = 1024;

    /** Numbers of the edges in their source, in order. */
    int[] index = {};

    int count;

    private int[] spare = {};
    private int[] begin = {};

    /**
     * Sorts a run of edges, but those that are not solved.
     *
     * @param facts which bodies they bind
     * @param from the first of them; their numbers count from there
     * @param n how many there are
     * @param slots of bodies
     */
    void sort(EdgeFacts facts, int from, int n, int slots) {
        if (index.length < n) {
            index = new int[Math.max(n, Math.max(LEAST, index.length + (index.length >> 1)))];
            spare = new int[index.length];
        }
        if (begin.length <= slots) {
            begin = new int[Math.max(slots + 1, begin.length + (begin.length >> 1))];
        }
        count = 0;
        begin(slots);
        for (int i = 0; i < n; i++) {
            if (facts.bodyA[from + i] >= 0) {
                spare[count++] = i;
                begin[facts.bodyB[from + i] + 1]++;
            }
        }
        sum(slots);
        for (int k = 0; k < count; k++) {
            index[begin[facts.bodyB[from + spare[k]]]++] = spare[k];
        }
        begin(slots);
        for (int k = 0; k < count; k++) {
            begin[facts.bodyA[from + index[k]] + 1]++;
        }
        sum(slots);
        for (int k = 0; k < count; k++) {
            spare[begin[facts.bodyA[from + index[k]]]++] = index[k];
        }
        int[] swap = index;
        index = spare;
        spare = swap;
        if (facts.hasParts) {
            sortParts(facts, from);
        }
    }

    /** Each edge goes to its place among those before it of the same two bodies. */
    private void sortParts(EdgeFacts facts, int from) {
        int first = 0;
        for (int k = 1; k < count; k++) {
            int edge = index[k];
            if (!isSamePair(facts, from + edge, from + index[k - 1])) {
                first = k;
            } else if (facts.part[from + edge] < facts.part[from + index[k - 1]]) {
                int at = place(facts, from, first, k);
                System.arraycopy(index, at, index, at + 1, k - at);
                index[at] = edge;
            }
        }
    }

    /** Between {@code first} and {@code k}: where those begin that come after edge {@code k}. */
    private int place(EdgeFacts facts, int from, int first, int k) {
        long part = facts.part[from + index[k]];
        int low = first;
        int high = k;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (part < facts.part[from + index[middle]]) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        return low;
    }

    private static boolean isSamePair(EdgeFacts facts, int i, int j) {
        return facts.bodyA[i] == facts.bodyA[j] && facts.bodyB[i] == facts.bodyB[j];
    }

    private void begin(int slots) {
        Arrays.fill(begin, 0, slots + 1, 0);
    }

    private void sum(int slots) {
        for (int s = 0; s < slots; s++) {
            begin[s + 1] += begin[s];
        }
    }
}
