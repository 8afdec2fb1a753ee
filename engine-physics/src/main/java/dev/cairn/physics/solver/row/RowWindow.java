package dev.cairn.physics.solver.row;

import static dev.cairn.physics.solver.row.ConstraintRows.FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;

/**
 * A look at one row in double precision: a row of doubles itself, or a copy of a row of floats,
 * which {@link #close} brings back. So all that is done to single rows now and then is written
 * once, in double.
 *
 * <p>One thread at a time. Allocates when it is made.
 */
public final class RowWindow {
    private final ConstraintRows copy = new EdgeList().doubles;
    private int place;

    public RowWindow() {
        copy.ensurePlaces(1);
    }

    /** Where the row at place {@code j} of {@code rows} is to be found, at {@link #place}. */
    public ConstraintRows open(ConstraintRows rows, int j) {
        place = j;
        if (!rows.isSingle) {
            return rows;
        }
        place = 0;
        System.arraycopy(rows.link, j * LINK, copy.link, 0, LINK);
        copy.settleMark[0] = rows.settleMark[j];
        int i = rows.base(j);
        int o = copy.base(0);
        for (int f = 0; f < FIELDS; f++) {
            copy.doubles[o + f] = rows.floats[i + f * rows.lanes];
        }
        return copy;
    }

    /** Place there. */
    public int place() {
        return place;
    }

    /** Brings what was written to the row at place {@code j} back. */
    public void close(ConstraintRows rows, int j) {
        if (rows.isSingle) {
            int i = rows.base(j);
            int o = copy.base(0);
            for (int f = 0; f < FIELDS; f++) {
                rows.floats[i + f * rows.lanes] = (float) copy.doubles[o + f];
            }
        }
    }
}
