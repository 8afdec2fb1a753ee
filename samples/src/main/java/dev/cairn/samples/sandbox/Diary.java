package dev.cairn.samples.sandbox;

import dev.cairn.render.input.Control;
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

    /** Ticks whose digests are known, a power of two. */
    private static final int SEEN = 1024;

    private long[] ticks = new long[256];
    private What[] whats = new What[256];
    private long[] entities = new long[256];
    private double[] numbers = new double[256 * STRIDE];

    private long[] seenTicks = new long[SEEN];
    private long[] digests = new long[SEEN];
    private boolean keepsAll;

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
        Arrays.fill(seenTicks, -1);
    }

    /** From now on nothing is forgotten before another beginning. */
    void keepAll() {
        keepsAll = true;
    }

    /** A tick is done, and the world has that digest. */
    void ticked(long tick, long digest) {
        next = tick + 1;
        if (keepsAll && seenTicks[at(tick)] >= 0 && !hasSeen(tick)) {
            longer();
        }
        seenTicks[at(tick)] = tick;
        digests[at(tick)] = digest;
    }

    private int at(long tick) {
        return (int) (tick & (seenTicks.length - 1));
    }

    private void longer() {
        long[] ticksBefore = seenTicks;
        long[] digestsBefore = digests;
        seenTicks = new long[2 * ticksBefore.length];
        digests = new long[2 * ticksBefore.length];
        Arrays.fill(seenTicks, -1);
        for (int i = 0; i < ticksBefore.length; i++) {
            if (ticksBefore[i] >= 0) {
                seenTicks[at(ticksBefore[i])] = ticksBefore[i];
                digests[at(ticksBefore[i])] = digestsBefore[i];
            }
        }
    }

    /** Whether the digest after a tick was seen, not too long ago. */
    boolean hasSeen(long tick) {
        return tick >= 0 && seenTicks[at(tick)] == tick;
    }

    /** The digest of the world as it was seen after a tick. */
    long digest(long tick) {
        return digests[at(tick)];
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
        if (keepsAll) {
            return;
        }
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

    /** A key or a button drives something. */
    void drive(long entity, Control.Effect effect, double x, double y, double z, double seconds) {
        What what =
                switch (effect) {
                    case PUSH -> What.PUSH;
                    case TURN -> What.TURN;
                    case KICK -> What.KICK;
                };
        add(what, entity, x, y, z);
        numbers[(count - 1) * STRIDE + 3] = seconds;
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
