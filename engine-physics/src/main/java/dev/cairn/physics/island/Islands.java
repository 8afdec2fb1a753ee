package dev.cairn.physics.island;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.EdgeSource;

import java.util.Arrays;

/**
 * Which awake bodies hang together by constraints: a forest over slots, the smallest slot of a tree
 * is its root. Fixed bodies and bodies asleep connect nothing.
 *
 * <p>Union by slot number with path halving (Tarjan and van Leeuwen, J. ACM 31, 1984): the roots
 * are a function of the set of links, not of their order. Simulation thread; allocates only when
 * slots are added.
 */
public final class Islands {
    private int[] parent = {};
    private boolean[] touched = {};

    /** Without bodies. */
    public Islands() {}

    /**
     * Grows the columns; between phases only.
     *
     * @param slots number of slots of bodies
     */
    public void ensureSlots(int slots) {
        if (slots > parent.length) {
            parent = Arrays.copyOf(parent, slots);
            touched = Arrays.copyOf(touched, slots);
        }
    }

    /**
     * Finds the islands of the present edges.
     *
     * @param bodies their kinds
     * @param sources whose edges are links, if they are solved
     * @param slots the awake bodies
     * @param count how many there are
     */
    public void build(BodyStore bodies, EdgeSource[] sources, int[] slots, int count) {
        begin(slots, count);
        byte[] kind = bodies.kind;
        for (EdgeSource source : sources) {
            for (int i = 0; i < source.edges(); i++) {
                int a = source.edgeA(i);
                if (a < 0) {
                    continue;
                }
                int b = source.edgeB(i);
                touched[a] = true;
                touched[b] = true;
                if (kind[a] == BodyStore.DYNAMIC && kind[b] == BodyStore.DYNAMIC) {
                    join(a, b);
                }
            }
        }
    }

    /**
     * Each body is an island of its own.
     *
     * @param slots the awake bodies
     * @param count how many there are
     */
    public void begin(int[] slots, int count) {
        for (int i = 0; i < count; i++) {
            parent[slots[i]] = slots[i];
            touched[slots[i]] = false;
        }
    }

    /**
     * Joins the islands of two bodies that move.
     *
     * @param a slot of a body that was among those of {@link #begin}
     * @param b slot of another one
     */
    public void join(int a, int b) {
        int i = root(a);
        int j = root(b);
        if (i < j) {
            parent[j] = i;
        } else {
            parent[i] = j;
        }
    }

    /**
     * The name of a body's island. Valid until the next edge changes.
     *
     * @param slot of a body that was among the slots of {@link #build}
     * @return the smallest slot of the island
     */
    public int root(int slot) {
        int[] p = parent;
        int i = slot;
        while (p[i] != i) {
            p[i] = p[p[i]];
            i = p[i];
        }
        return i;
    }

    /**
     * Whether a body has an edge, be it to a fixed body.
     *
     * @param slot of a body that was among the slots of {@link #build}
     * @return true if so
     */
    public boolean touched(int slot) {
        return touched[slot];
    }
}
