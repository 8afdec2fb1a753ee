package dev.cairn.physics.island;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

import java.util.Arrays;

/**
 * Which awake bodies hang together by contacts: a forest over slots, the smallest slot of a tree is
 * its root. Fixed bodies and bodies asleep connect nothing.
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
     * Finds the islands of the present contacts.
     *
     * @param bodies their kinds
     * @param contacts those that are active and have points are links
     * @param slots the awake bodies
     * @param count how many there are
     */
    public void build(BodyStore bodies, ContactStore contacts, int[] slots, int count) {
        for (int i = 0; i < count; i++) {
            parent[slots[i]] = slots[i];
            touched[slots[i]] = false;
        }
        byte[] kind = bodies.kind;
        for (int i = 0; i < contacts.activeCount; i++) {
            int row = contacts.active[i];
            if (!contacts.isSolved(row)) {
                continue;
            }
            int a = contacts.bodyA[row];
            int b = contacts.bodyB[row];
            touched[a] = true;
            touched[b] = true;
            if (kind[a] == BodyStore.DYNAMIC && kind[b] == BodyStore.DYNAMIC) {
                join(a, b);
            }
        }
    }

    private void join(int a, int b) {
        int i = root(a);
        int j = root(b);
        if (i < j) {
            parent[j] = i;
        } else {
            parent[i] = j;
        }
    }

    /**
     * The name of a body's island. Valid until the next contact changes.
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
     * Whether a body has a contact with points, be it with a fixed body.
     *
     * @param slot of a body that was among the slots of {@link #build}
     * @return true if so
     */
    public boolean touched(int slot) {
        return touched[slot];
    }
}
