package dev.cairn.physics.solver.joint;

import java.util.Arrays;

/**
 * Numbers, the least of which leaves first: a binary heap (J. Williams 1964) without objects. A
 * queue of the library took two thirds of the first tick of 20 000 joints for comparing its boxes.
 */
final class KeyQueue {
    private long[] keys = new long[64];
    private int count;

    /** Takes all out, and their room. */
    void clear() {
        keys = new long[64];
        count = 0;
    }

    boolean isEmpty() {
        return count == 0;
    }

    void add(long key) {
        if (count == keys.length) {
            keys = Arrays.copyOf(keys, 2 * count);
        }
        int at = count++;
        while (at > 0 && keys[(at - 1) >> 1] > key) {
            keys[at] = keys[(at - 1) >> 1];
            at = (at - 1) >> 1;
        }
        keys[at] = key;
    }

    /** Takes the least number out; not of an empty queue. */
    long remove() {
        long least = keys[0];
        long key = keys[--count];
        int at = 0;
        for (int child = 1; child < count; child = 2 * at + 1) {
            if (child + 1 < count && keys[child + 1] < keys[child]) {
                child++;
            }
            if (keys[child] >= key) {
                break;
            }
            keys[at] = keys[child];
            at = child;
        }
        keys[at] = key;
        return least;
    }
}
