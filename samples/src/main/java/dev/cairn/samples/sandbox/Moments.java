package dev.cairn.samples.sandbox;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsWorld;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * States of the last minutes of a world, densely at the end and sparsely before, within a bound of
 * memory: each of the last ticks, and every n-th of those before. Beyond their number the oldest
 * go; where memory is short the one goes that leaves the smallest gap beside its age, so that the
 * past is the coarser the longer ago it is. Rooms of states that are forgotten are used again, so
 * that remembering takes no memory any more once the bound is reached: what {@code History}, which
 * reaches farther, cannot do, since each of its deltas is a new one. Simulation thread, between
 * steps.
 */
final class Moments {
    private final int dense;
    private final int stride;
    private final long mostBytes;
    private final @Nullable WorldState[] states;
    private final long[] ticks;

    private final @Nullable WorldState[] free;
    private int freeCount;
    private int count;
    private long bytes;

    /**
     * Without any.
     *
     * @param dense how many of the last ticks are all kept, at least 1
     * @param stride of those before, every so many-th is kept
     * @param sparse how many of these are kept at most
     * @param mostBytes that the numbers of all may take together; the newest is kept in any case
     */
    Moments(int dense, int stride, int sparse, long mostBytes) {
        this.dense = dense;
        this.stride = stride;
        this.mostBytes = mostBytes;
        int most = dense + sparse + 1;
        states = new WorldState[most];
        ticks = new long[most];
        free = new WorldState[most];
    }

    /** Forgets all, and the rooms too, since they hold objects of a world that may be closed. */
    void clear() {
        Arrays.fill(states, null);
        Arrays.fill(free, null);
        freeCount = 0;
        count = 0;
        bytes = 0;
    }

    int count() {
        return count;
    }

    long byteCount() {
        return bytes;
    }

    /** Tick of a moment, the oldest is 0. */
    long tick(int index) {
        return ticks[index];
    }

    WorldState state(int index) {
        WorldState state = states[index];
        if (state == null || index >= count) {
            throw new IllegalArgumentException(
                    "moment " + index + " is not remembered; there are " + count);
        }
        return state;
    }

    /** The last moment that is not later than a tick, or else the first. */
    int indexAt(long tick) {
        int low = 0;
        int high = count - 1;
        while (low < high) {
            int middle = (low + high + 1) >>> 1;
            if (ticks[middle] <= tick) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        return low;
    }

    /** Remembers the present as that of a tick after all that are remembered. */
    void add(PhysicsWorld world, long tick) {
        thin();
        if (count == states.length) {
            forget(0);
        }
        WorldState room = freeCount > 0 ? free[--freeCount] : new WorldState();
        if (room == null) {
            room = new WorldState();
        }
        world.save(room);
        states[count] = room;
        ticks[count] = tick;
        count++;
        bytes += room.byteCount();
        while (bytes > mostBytes && count > 1) {
            forget(leastMissed());
        }
    }

    /** The moment that leaves the smallest gap beside its age; never the last one. */
    private int leastMissed() {
        int best = 0; // there is none between the first and the last
        double least = Double.POSITIVE_INFINITY;
        long newest = ticks[count - 1];
        for (int i = 1; i < count - 1; i++) {
            double part = (double) (ticks[i + 1] - ticks[i - 1]) / (newest - ticks[i]);
            if (part < least) {
                least = part;
                best = i;
            }
        }
        return best;
    }

    /**
     * One moment has left the dense part; it stays only if it is far enough from the one before.
     */
    private void thin() {
        int leaving = count - dense;
        if (leaving >= 1 && ticks[leaving] - ticks[leaving - 1] < stride) {
            forget(leaving);
        }
    }

    /** Forgets all after one. */
    void forgetAfter(int index) {
        while (count > index + 1) {
            forget(count - 1);
        }
    }

    private void forget(int index) {
        WorldState room = state(index);
        bytes -= room.byteCount();
        int later = count - index - 1;
        System.arraycopy(states, index + 1, states, index, later);
        System.arraycopy(ticks, index + 1, ticks, index, later);
        states[--count] = null;
        if (bytes + room.byteCount() <= mostBytes) {
            free[freeCount++] = room;
        } else if (freeCount == 0) {
            free[freeCount++] = room; // for the next moment
        }
    }
}
