package dev.cairn.physics.solver.graph;

import dev.cairn.physics.internal.ContactStore;

import java.util.Arrays;

/**
 * The contacts that have points, by the slots of their bodies: first by A, then by B.
 *
 * <p>Rows of the store stand in the order in which their boxes met, and boxes lie along the world's
 * axes: in that order a scene would be solved differently when it is turned. Two counting sorts,
 * stable, of time linear in contacts and slots. Simulation thread; allocates only when a store has
 * grown.
 */
final class PairOrder {
    /** Entries of {@link ContactStore#active}: those with points, in order. */
    int[] index = {};

    int count;

    private int[] spare = {};
    private int[] begin = {};

    /** Sorts the contacts of this tick. */
    void sort(ContactStore c, int slots) {
        if (index.length < c.activeCount) {
            index = new int[c.active.length];
            spare = new int[c.active.length];
        }
        if (begin.length <= slots) {
            begin = new int[Math.max(slots + 1, begin.length + (begin.length >> 1))];
        }
        count = 0;
        for (int i = 0; i < c.activeCount; i++) {
            if (c.pointCount[c.active[i]] > 0) {
                spare[count++] = i;
            }
        }
        pass(c.active, c.bodyB, slots, spare, index);
        pass(c.active, c.bodyA, slots, index, spare);
        int[] swap = index;
        index = spare;
        spare = swap;
    }

    private void pass(int[] active, int[] slot, int slots, int[] from, int[] to) {
        Arrays.fill(begin, 0, slots + 1, 0);
        for (int k = 0; k < count; k++) {
            begin[slot[active[from[k]]] + 1]++;
        }
        for (int s = 0; s < slots; s++) {
            begin[s + 1] += begin[s];
        }
        for (int k = 0; k < count; k++) {
            to[begin[slot[active[from[k]]]]++] = from[k];
        }
    }
}
