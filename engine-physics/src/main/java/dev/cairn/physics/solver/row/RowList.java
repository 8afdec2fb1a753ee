package dev.cairn.physics.solver.row;

import java.util.Arrays;

/**
 * The contacts of a tick that have points, in the order of the contact store, and where the row of
 * each is: among those of floats or those of doubles.
 *
 * <p>Simulation thread; read by all. Allocates only when the store has grown.
 */
public final class RowList {
    public final ConstraintRows floats;
    public final ConstraintRows doubles;

    public int count;

    /** By contact: its row in the store, and the place of its row. */
    public int[] source = {};

    public int[] place = {};

    /** Whether the row is one of {@link #floats}. */
    public boolean[] isSingle = {};

    /** One row to a vector, which suits scalar sweeps and windows. */
    public RowList() {
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
    public RowList(int floatLanes, int floatGroup, int doubleLanes, int doubleGroup) {
        floats = new ConstraintRows(floatLanes, floatGroup, true, this);
        doubles = new ConstraintRows(doubleLanes, doubleGroup, false, this);
    }

    /** The rows among which that of contact {@code m} is. */
    public ConstraintRows rows(int m) {
        return isSingle[m] ? floats : doubles;
    }

    public void ensureCapacity(int contacts) {
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
