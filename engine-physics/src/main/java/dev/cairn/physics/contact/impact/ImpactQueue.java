package dev.cairn.physics.contact.impact;

import java.util.Arrays;

/** Meetings to come, earliest first; of those at one time the one of the lowest colliders. */
final class ImpactQueue {
    private static final int INTS = 6;

    private double[] times = new double[64];
    private int[] meeting = new int[64 * INTS];
    private int size;

    /** The meeting of the last {@link #poll}: when, s; its colliders, the lower one first. */
    double time;

    int a, b;

    /** How often its bodies had been struck when it was found. */
    private int strikesA, strikesB;

    /** The row of the two, or -1. */
    int row;

    /** Whether it is no meeting: the motion from there on is unknown. */
    boolean isLost;

    void clear() {
        size = 0;
    }

    /** Makes room for so many meetings. */
    void reserve(int count) {
        if (times.length < count) {
            times = Arrays.copyOf(times, count);
            meeting = Arrays.copyOf(meeting, count * INTS);
        }
    }

    int size() {
        return size;
    }

    /** The lower collider of a meeting, in no order. */
    int first(int i) {
        return meeting[INTS * i];
    }

    /** The upper one. */
    int second(int i) {
        return meeting[INTS * i + 1];
    }

    void add(double t, int lower, int upper, int ofLower, int ofUpper, int contact, boolean lost) {
        if (size == times.length) {
            reserve(2 * size);
        }
        int i = size++;
        times[i] = t;
        int at = INTS * i;
        meeting[at] = lower;
        meeting[at + 1] = upper;
        meeting[at + 2] = ofLower;
        meeting[at + 3] = ofUpper;
        meeting[at + 4] = contact;
        meeting[at + 5] = lost ? 1 : 0;
        while (i > 0 && isBefore(i, (i - 1) / 2)) {
            swap(i, (i - 1) / 2);
            i = (i - 1) / 2;
        }
    }

    /** Takes the first one out. */
    boolean poll() {
        if (size == 0) {
            return false;
        }
        time = times[0];
        a = meeting[0];
        b = meeting[1];
        strikesA = meeting[2];
        strikesB = meeting[3];
        row = meeting[4];
        isLost = meeting[5] != 0;
        swap(0, --size);
        for (int i = 0, child = 1; child < size; child = 2 * i + 1) {
            if (child + 1 < size && isBefore(child + 1, child)) {
                child++;
            }
            if (!isBefore(child, i)) {
                break;
            }
            swap(i, child);
            i = child;
        }
        return true;
    }

    /** Whether neither body of the meeting has been struck since it was found. */
    boolean isFresh(int ofA, int ofB) {
        return strikesA == ofA && strikesB == ofB;
    }

    /** When the next one is. */
    double next() {
        return size > 0 ? times[0] : Double.POSITIVE_INFINITY;
    }

    private boolean isBefore(int i, int j) {
        if (times[i] != times[j]) {
            return times[i] < times[j];
        }
        int p = INTS * i;
        int q = INTS * j;
        return meeting[p] != meeting[q] ? meeting[p] < meeting[q] : meeting[p + 1] < meeting[q + 1];
    }

    private void swap(int i, int j) {
        double t = times[i];
        times[i] = times[j];
        times[j] = t;
        for (int k = 0; k < INTS; k++) {
            int m = meeting[INTS * i + k];
            meeting[INTS * i + k] = meeting[INTS * j + k];
            meeting[INTS * j + k] = m;
        }
    }
}
