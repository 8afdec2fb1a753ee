package dev.cairn.physics.solver.kernel;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.row.ConstraintRows;

/** What contacts know, when the length of the sub-step changes. */
public final class Rescaling {
    private Rescaling() {}

    /**
     * Lets contacts hold what they held when the sub-step's length has changed. The stiffness, as a
     * force, goes with {@code 1 / h²}; so gap less offset goes with {@code h²}, and the offset
     * takes what is left over of the gap. Without it a stack that has just come to rest drops or is
     * thrown by the difference of its sags.
     *
     * @param ratio of the lengths, new to old
     */
    public static void carryOver(
            ConstraintRows rows, ContactStore contacts, double ratio, int from, int to) {
        int lanes = rows.lanes;
        double more = ratio * ratio - 1;
        for (int j = from; j < to; j++) {
            if (rows.settleMark[j] != 0) {
                continue;
            }
            int o = rows.base(j);
            int first =
                    ContactStore.POINTS
                            * rows.link[j * ConstraintRows.LINK + ConstraintRows.SOURCE];
            for (int i = 0; i < rows.points(j); i++) {
                if (contacts.normalImpulse[first + i] > 0) {
                    double separation = contacts.separation[first + i];
                    int q = o + (ConstraintRows.GAP + i) * lanes;
                    double gap = Math.min(separation, rows.get(q) + more * separation);
                    rows.put(q, gap);
                    int point = ConstraintRows.POINT + i * ConstraintRows.POINT_FIELDS;
                    rows.put(o + (point + ConstraintRows.SEPARATION) * lanes, gap);
                }
            }
        }
    }
}
