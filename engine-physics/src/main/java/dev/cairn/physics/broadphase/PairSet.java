package dev.cairn.physics.broadphase;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;

import java.util.Arrays;

/**
 * A set of unordered pairs of colliders: open addressing with linear probing, no tombstones. Asked
 * for membership only; it is never iterated, so its layout cannot reach any result.
 *
 * <p>One thread changes it; any number may ask between changes. Allocates only when it grows.
 */
public final class PairSet implements Stateful {
    /** As many bits as the first table has: of 8 kB, so that small scenes never grow it. */
    private static final int FIRST_BITS = 10;

    private long[] keys = new long[1 << FIRST_BITS];
    private int shift = 64 - FIRST_BITS;
    private int size;

    /** Room for the pairs of a state, smaller slots and larger ones. */
    private int[] lower = {};

    private int[] higher = {};

    /** An empty set. */
    public PairSet() {}

    /**
     * The key of a pair.
     *
     * @param a a slot, at least 0
     * @return the smaller slot in the upper half, the larger in the lower; never 0
     */
    public static long key(int a, int b) {
        return a < b ? (long) a << 32 | b : (long) b << 32 | a;
    }

    /** The number of pairs. */
    public int size() {
        return size;
    }

    /** Whether a pair is there. */
    public boolean contains(long key) {
        long[] table = keys;
        int mask = table.length - 1;
        int at = home(key);
        while (table[at] != 0) {
            if (table[at] == key) {
                return true;
            }
            at = at + 1 & mask;
        }
        return false;
    }

    /** Adds a pair. */
    public boolean add(long key) {
        if (2 * (size + 1) > keys.length) {
            grow();
        }
        int mask = keys.length - 1;
        int at = home(key);
        while (keys[at] != 0) {
            if (keys[at] == key) {
                return false;
            }
            at = at + 1 & mask;
        }
        keys[at] = key;
        size++;
        return true;
    }

    /** Takes a pair out. */
    public boolean remove(long key) {
        int mask = keys.length - 1;
        int at = home(key);
        while (keys[at] != key) {
            if (keys[at] == 0) {
                return false;
            }
            at = at + 1 & mask;
        }
        int hole = at;
        for (int next = hole + 1 & mask; keys[next] != 0; next = next + 1 & mask) {
            // A key may fill the hole if its home is not between the hole (exclusive) and its
            // place.
            if ((next - home(keys[next]) & mask) >= (next - hole & mask)) {
                keys[hole] = keys[next];
                hole = next;
            }
        }
        keys[hole] = 0;
        size--;
        return true;
    }

    /**
     * The pairs in the order of the table. That is the order of their products but for neighbours,
     * however long the table is: so few change places when it grows.
     */
    @Override
    public void state(StateVisitor s) {
        s.section("pairs", this);
        s.rows(size);
        int count = s.count("size", size);
        if (lower.length < count) {
            lower = new int[keys.length / 2 < count ? count : keys.length / 2];
            higher = new int[lower.length];
        }
        if (!s.isRestoring()) {
            int to = 0;
            for (long key : keys) {
                if (key != 0) {
                    lower[to] = (int) (key >>> 32);
                    higher[to++] = (int) key;
                }
            }
        }
        lower = s.array("lower", lower, 0, count, lower.length, false);
        higher = s.array("higher", higher, 0, count, higher.length, false);
        if (s.isRestoring()) {
            Arrays.fill(keys, 0);
            size = 0;
            for (int i = 0; i < count; i++) {
                add(key(lower[i], higher[i]));
            }
        }
    }

    private int home(long key) {
        return (int) ((key * 0x9E3779B97F4A7C15L) >>> shift);
    }

    private void grow() {
        long[] old = keys;
        if (old.length >= 1 << 30) {
            throw new IllegalStateException(
                    size + " pairs of shapes overlap; at most " + (1 << 29) + " are possible");
        }
        keys = new long[2 * old.length];
        shift--;
        size = 0;
        for (long key : old) {
            if (key != 0) {
                add(key);
            }
        }
    }
}
