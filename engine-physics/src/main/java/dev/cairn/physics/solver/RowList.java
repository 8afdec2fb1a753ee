package dev.cairn.physics.solver;

import java.util.Arrays;

/**
 * The contacts of a tick that have points, in the order of the contact store, and where the row of
 * each is: among those of floats or those of doubles.
 *
 * <p>Simulation thread; read by all. Allocates only when the store has grown.
 */
final class RowList {
    final ConstraintRows floats;
    final ConstraintRows doubles;

    int count;

    /** By contact: its row in the store, and the place of its row. */
    int[] source = {};

    int[] place = {};

    /** Whether the row is one of {@link #floats}. */
    boolean[] isSingle = {};

    /** One row to a vector, which suits scalar sweeps and windows. */
    RowList() {
        this(1, 1, 1, 1);
    }

    /**
     * A list whose rows lie in groups.
     *
     * @param floatLanes of the rows of floats, see {@link ConstraintRows#lanes}
     * @param floatGroup see {@link ConstraintRows#group}
     * @param doubleLanes of the rows of doubles
     * @param doubleGroup of the rows of doubles
     */
    RowList(int floatLanes, int floatGroup, int doubleLanes, int doubleGroup) {
        floats = new ConstraintRows(floatLanes, floatGroup, true, this);
        doubles = new ConstraintRows(doubleLanes, doubleGroup, false, this);
    }

    /** The rows among which that of contact {@code m} is. */
    ConstraintRows rows(int m) {
        return isSingle[m] ? floats : doubles;
    }

    void ensureCapacity(int contacts) {
        if (contacts > source.length) {
            int n = Math.max(contacts, Math.max(64, source.length + (source.length >> 1)));
            source = Arrays.copyOf(source, n);
            place = Arrays.copyOf(place, n);
            isSingle = Arrays.copyOf(isSingle, n);
            floats.bouncer = new int[n];
            doubles.bouncer = new int[n];
        }
    }
}
