package dev.cairn.physics.solver.impact;

import static dev.cairn.physics.solver.row.ConstraintRows.BLOCK;
import static dev.cairn.physics.solver.row.ConstraintRows.FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.SOURCE;
import static dev.cairn.physics.solver.row.ConstraintRows.TOTAL;
import static dev.cairn.physics.solver.row.ConstraintRows.TWIST_MASS;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.PrepareRow;
import dev.cairn.physics.solver.row.ConstraintRows;

import java.util.Arrays;

/**
 * The levers of an impact of two bodies that both move. Those of a row are of its sub-step's start,
 * where the points that meet at the time t are apart by what the bodies pass each other until then.
 * Impulses {@code J} and {@code -J} at points that are {@code d} apart make the angular momentum
 * {@code d x J} of nothing. So both bodies take them at one point: half-way between the two at the
 * time t, or at a ball's own, since on a ball a lever off its normal would lift.
 *
 * <p>One thread. Does not allocate.
 */
final class ImpactLevers {
    private final double[] kept = new double[FIELDS];

    /** From the middle of A, of B, at the time of the impact: a point, the middle of all, m. */
    private final double[] arms = new double[6], centre = new double[6];

    /** From the middle of A to that of B at the time of the impact, m. */
    private final double[] apart = new double[3];

    /** Share of the way between the two points that A's goes to B's. */
    private double share;

    private double[] d = {};
    private int o;
    private int lanes;
    private int points;

    /**
     * Gives a row the levers of an impact, if both its bodies can be moved.
     *
     * @param goal NaN for points that do not touch then
     * @param time of the impact, from the sub-step's start, s
     * @param acceleration of A, of B, until then, m/s²
     * @return whether it has them now, and is to be {@link #close closed}
     */
    boolean open(
            ConstraintRows rows,
            int place,
            BodyStore store,
            ContactStore contacts,
            SolverBodies bodies,
            double[] goal,
            double time,
            double[] acceleration) {
        int a = rows.link[place * LINK];
        int b = rows.link[place * LINK + 1];
        double[] body = bodies.state;
        if (!(body[a + SolverBodies.MASS] > 0 && body[b + SolverBodies.MASS] > 0)) {
            return false;
        }
        d = rows.doubles;
        o = rows.base(place);
        lanes = rows.lanes;
        points = rows.points(place);
        for (int f = 0; f < FIELDS; f++) {
            kept[f] = d[o + f * lanes];
        }
        int slotA = SolverBodies.slot(a);
        int slotB = SolverBodies.slot(b);
        share = store.isBall[slotA] ? 0 : store.isBall[slotB] ? 1 : 0.5;
        apart[0] = store.positionX[slotB] - store.positionX[slotA];
        apart[1] = store.positionY[slotB] - store.positionY[slotA];
        apart[2] = store.positionZ[slotB] - store.positionZ[slotA];
        for (int k = 0; k < 3; k++) {
            double speed = body[b + k] - body[a + k];
            double half = 0.5 * time * (acceleration[3 + k] - acceleration[k]);
            apart[k] += body[b + SolverBodies.P + k] - body[a + SolverBodies.P + k];
            apart[k] += time * (speed + half);
        }
        int source = rows.link[place * LINK + SOURCE];
        Arrays.fill(centre, 0.0);
        int touching = 0;
        for (int p = 0; p < points; p++) {
            place(contacts, ContactStore.POINTS * source + p);
            PrepareRow.point(rows, bodies, place, p, arms);
            if (!Double.isNaN(goal[p])) {
                touching++;
                for (int k = 0; k < 6; k++) {
                    centre[k] += arms[k];
                }
            }
        }
        if (d[o + FRICTION * lanes] > 0) {
            for (int k = 0; k < 6; k++) {
                centre[k] /= touching;
            }
            PrepareRow.centre(rows, bodies, place, centre, kept[TWIST_MASS] > 0);
        }
        return true;
    }

    /** Where both bodies take the impulse of a point. */
    private void place(ContactStore c, int point) {
        int q = ContactStore.anchor(point);
        for (int k = 0; k < 3; k++) {
            double a = c.anchors[q + k];
            double b = c.anchors[q + 3 + k];
            double way = apart[k] + b - a;
            arms[k] = a + share * way;
            arms[3 + k] = b - (1 - share) * way;
        }
    }

    /** Gives the row the levers of the sub-step's start back, after the impact. */
    void close() {
        for (int p = 0; p < points; p++) {
            put(POINT + p * POINT_FIELDS, POINT + p * POINT_FIELDS + IMPULSE);
        }
        put(BLOCK, LAMBDA);
        put(TWIST_MASS, TOTAL);
    }

    private void put(int from, int to) {
        for (int f = from; f < to; f++) {
            d[o + f * lanes] = kept[f];
        }
    }
}
