package dev.cairn.samples.sandbox;

import dev.cairn.samples.replay.Act;
import dev.cairn.samples.replay.Act.What;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * What was done to the world in the last minutes, in its order and without an object to each.
 * Simulation thread.
 */
final class Diary {
    private static final int STRIDE = 9;

    private long[] ticks = new long[256];
    private What[] whats = new What[256];
    private long[] entities = new long[256];
    private double[] numbers = new double[256 * STRIDE];

    /** Those before are forgotten. */
    private int first;

    private int count;
    private long next;
    private boolean isPast;

    /** Nothing yet; the next tick is the one after a tick. */
    void begin(long tick) {
        first = 0;
        count = 0;
        next = tick + 1;
        isPast = false;
    }

    /** A tick is done. */
    void ticked(long tick) {
        next = tick + 1;
    }

    /** The world is at a tick of the past, with an empty hand; what came after may come again. */
    void came(long tick) {
        next = tick + 1;
        isPast = true;
    }

    /** Something else is done: what came after did not happen. */
    private void goOn() {
        if (!isPast) {
            return;
        }
        isPast = false;
        while (count > first && ticks[count - 1] >= next) {
            count--;
        }
        if (holdsAfter(next - 1)) {
            add(What.RELEASE);
        }
    }

    /** Nobody goes back before a tick. */
    void forgetUpTo(long tick) {
        while (first < count && ticks[first] <= tick) {
            first++;
        }
        if (first > 128 && 2 * first > count) { // seldom, so that it costs nothing in most ticks
            int left = count - first;
            System.arraycopy(ticks, first, ticks, 0, left);
            System.arraycopy(whats, first, whats, 0, left);
            System.arraycopy(entities, first, entities, 0, left);
            System.arraycopy(numbers, first * STRIDE, numbers, 0, left * STRIDE);
            first = 0;
            count = left;
        }
    }

    /** Something without numbers. */
    void add(What what) {
        add(what, 0, 0, 0, 0);
    }

    /** Something with up to three numbers. */
    void add(What what, long entity, double x, double y, double z) {
        goOn();
        if (count == ticks.length) {
            ticks = Arrays.copyOf(ticks, 2 * count);
            whats = Arrays.copyOf(whats, 2 * count);
            entities = Arrays.copyOf(entities, 2 * count);
            numbers = Arrays.copyOf(numbers, 2 * count * STRIDE);
        }
        ticks[count] = next;
        whats[count] = what;
        entities[count] = entity;
        int at = STRIDE * count++;
        numbers[at] = x;
        numbers[at + 1] = y;
        numbers[at + 2] = z;
    }

    /** Something with many numbers. */
    void add(What what, List<Double> values) {
        add(what, 0, 0, 0, 0);
        for (int i = 0; i < values.size(); i++) {
            numbers[(count - 1) * STRIDE + i] = values.get(i);
        }
    }

    /** Whether something was in the hand after a tick. */
    boolean holdsAfter(long tick) {
        for (int i = count - 1; i >= first; i--) {
            if (ticks[i] <= tick && (whats[i] == What.GRAB || whats[i] == What.RELEASE)) {
                return whats[i] == What.GRAB;
            }
        }
        return false;
    }

    /** What was done between the tick before and this one. */
    List<Act> before(long tick) {
        List<Act> acts = new ArrayList<>();
        for (int i = first; i < count; i++) {
            if (ticks[i] == tick) {
                List<Double> own = new ArrayList<>();
                for (int k = 0; k < whats[i].count(); k++) {
                    own.add(numbers[i * STRIDE + k]);
                }
                acts.add(new Act(whats[i], entities[i], own));
            }
        }
        return acts;
    }
}
