package dev.cairn.physics.solver.kernel;

import static dev.cairn.physics.solver.row.ConstraintRows.*;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

/** Empties constraint rows one by one: what the wide stores are held to, bit by bit. */
public final class StoreRow implements RowStore {
    @Override
    public void store(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        for (int j = from; j < to; j++) {
            int l = j * LINK;
            if (rows.link[l + COUNT] > 0) {
                int source = rows.link[l + SOURCE];
                impulses(rows, contacts, j, source);
                if (sub.offsetGain > 0) {
                    Offsets.update(rows, bodies, contacts, source, j, sub, 1);
                }
            }
        }
    }

    private static void impulses(ConstraintRows rows, ContactStore contacts, int j, int source) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int o = rows.base(j);
        contacts.setFrictionImpulse(
                source,
                tangent(d, o, lanes, LAMBDA, 0),
                tangent(d, o, lanes, LAMBDA, 1),
                tangent(d, o, lanes, LAMBDA, 2),
                d[o + (LAMBDA + 2) * lanes]);
        for (int k = 0; k < rows.link[j * LINK + COUNT]; k++) {
            int p = ContactStore.POINTS * source + k;
            int q = POINT + k * POINT_FIELDS;
            contacts.normalImpulse[p] = d[o + (q + IMPULSE) * lanes];
            // what was taken back leaves a rounding of either sign
            contacts.totalNormalImpulse[p] = Math.max(0, d[o + (SUM + k) * lanes]);
        }
    }

    /** World component of a pair of tangent impulses. */
    public static double tangent(double[] d, int o, int lanes, int field, int axis) {
        return d[o + field * lanes] * d[o + (TANGENT1 + axis) * lanes]
                + d[o + (field + 1) * lanes] * d[o + (TANGENT2 + axis) * lanes];
    }
}
