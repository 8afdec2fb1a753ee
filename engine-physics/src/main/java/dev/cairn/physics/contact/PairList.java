package dev.cairn.physics.contact;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;

import java.util.Arrays;

/**
 * Pairs of colliders to which something happened in a tick, in the order in which it was noted.
 * Simulation thread; allocates only when it grows.
 */
public final class PairList implements Stateful {
    private int[] pairs = new int[64];
    private int count;

    /** Without pairs. */
    PairList() {}

    void clear() {
        count = 0;
    }

    void add(int a, int b) {
        if (2 * count == pairs.length) {
            pairs = Arrays.copyOf(pairs, 2 * pairs.length);
        }
        pairs[2 * count] = a;
        pairs[2 * count + 1] = b;
        count++;
    }

    /** How many pairs there are. */
    public int count() {
        return count;
    }

    /**
     * One collider of a pair.
     *
     * @param event 0 to count - 1
     * @param side 0 or 1, as the list's owner tells
     */
    public int collider(int event, int side) {
        return pairs[2 * event + side];
    }

    @Override
    public void state(StateVisitor s) {
        s.section("pairs", this);
        count = s.count("count", count);
        pairs = s.array("pairs", pairs, 2 * count);
    }
}
