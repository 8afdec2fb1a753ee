package dev.cairn.physics.internal;

/**
 * Where the edges of one kind of constraint come from: which bodies are bound in this tick.
 *
 * <p>Islands, sleep, batches and colours see constraints as edges between two bodies, and know
 * nothing else of them. Simulation thread; nothing allocates.
 */
public interface EdgeSource {
    /** How many edges there may be in this tick. */
    int edges();

    /**
     * How many edges there may be before the store grows: columns of as many edges grow with it.
     */
    int capacity();

    /**
     * Row of an edge in the kind's own store.
     *
     * @return names the edge as long as it exists
     */
    int edgeRow(int i);

    /**
     * Slot of the first body of an edge.
     *
     * @return the slot, or -1 if the edge is not solved in this tick
     */
    int edgeA(int i);

    /** Slot of the second body of an edge that is solved. */
    int edgeB(int i);

    /** Whether a surface runs along at an edge that is solved, so that its bodies do not rest. */
    default boolean runs(int i) {
        return false;
    }

    /** A body leaves, and its slot will be another's: edges to it end. */
    void leave(int slot);

    /** A body was put back to where it could be computed with: its edges start without impulses. */
    void forget(int slot);
}
