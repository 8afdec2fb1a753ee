package dev.cairn.physics.solver.load;

import static dev.cairn.physics.solver.row.ConstraintRows.COUNT;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Sag;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.kernel.ScalarPasses;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/** The offsets of contacts of thin bodies, which learn faster: see {@link Sag}. Any worker. */
public final class ThinRows {
    private ThinRows() {}

    /**
     * Learns anew, after rows have been stored.
     *
     * @param one rows one by one
     * @param from the first of a range of places
     * @param to behind the last one
     */
    public static void learn(
            SolverContext tick,
            ConstraintRows rows,
            ScalarPasses one,
            SubStep sub,
            int from,
            int to) {
        if (!(sub.offsetGain > 0)) {
            return;
        }
        BodyStore b = tick.bodies;
        double sag = tick.weight() * sub.seconds / sub.stiffness(true);
        for (int j = from; j < to; j++) {
            int l = LINK * j;
            int first = rows.link[l];
            int second = rows.link[l + 1];
            double r = Math.min(inner(b, first), inner(b, second));
            int times = rows.link[l + COUNT] > 0 ? Sag.times(sag, r) : 1;
            if (times > 1) {
                one.learn(rows, tick.body, tick.contacts, sub, j, times);
            }
        }
    }

    /** Of a body that does not answer, which may have a slot of the solver alone: infinite. */
    private static double inner(BodyStore b, int offset) {
        int slot = SolverBodies.slot(offset);
        return offset == 0 || slot >= b.slotCount ? Double.POSITIVE_INFINITY : b.innerRadius[slot];
    }
}
