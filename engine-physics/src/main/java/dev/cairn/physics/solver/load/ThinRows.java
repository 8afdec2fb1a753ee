package dev.cairn.physics.solver.load;

import static dev.cairn.physics.solver.row.ConstraintRows.COUNT;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;

import dev.cairn.physics.internal.Sag;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.kernel.ScalarPasses;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * The offsets of contacts of thin bodies, which learn faster: see {@link Sag}. Only of bodies that
 * touch nothing but one static body: where loads are handed on, what one tick has learnt of them
 * swings (ten cubes of 5 mm on each other fell within a minute). Any worker.
 */
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
        double sag = tick.weight() * sub.seconds / sub.stiffness(true);
        for (int j = from; j < to; j++) {
            int l = LINK * j;
            int slot = SolverBodies.slot(rows.link[l] != 0 ? rows.link[l] : rows.link[l + 1]);
            // what drives others may have a slot of the solver alone
            boolean isBody = rows.link[l + COUNT] > 0 && slot < tick.bodies.slotCount;
            if (isBody && tick.body.isAlone(slot)) {
                int times = Sag.times(sag, tick.bodies.innerRadius[slot]);
                if (times > 1) {
                    one.learn(rows, tick.body, tick.contacts, sub, j, times);
                }
            }
        }
    }
}
