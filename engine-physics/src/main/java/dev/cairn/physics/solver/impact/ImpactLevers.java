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
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.internal.Surface;
import dev.cairn.physics.solver.body.Rotation;
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
    /**
     * How far beside a body's middle a point may be, over its outer radius: what is beyond is no
     * place of an impact, but a guess at the end of a way of many turns.
     */
    private static final double REACH = 1.1;

    private final double[] kept = new double[FIELDS];

    /** From the middle of A, of B, at the time of the impact: a point, the middle of all, m. */
    private final double[] arms = new double[6], centre = new double[6];

    /** From the middle of A to that of B at the time of the impact, m. */
    private final double[] apart = new double[3];

    /** Turns of A's points, of B's, until the impact, as quaternions, w last. */
    private final double[] turns = new double[8];

    private final double[] axis = new double[3];

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
        turn(store, contacts, bodies, source, slotA, 0, time);
        turn(store, contacts, bodies, source, slotB, 1, time);
        double reachA = REACH * store.outerRadius[slotA];
        double reachB = REACH * store.outerRadius[slotB];
        Arrays.fill(centre, 0.0);
        int touching = 0;
        for (int p = 0; p < points; p++) {
            place(contacts, ContactStore.POINTS * source + p);
            if (!(isWithin(0, reachA) && isWithin(3, reachB))) {
                close();
                return false;
            }
            PrepareRow.point(rows, bodies, place, p, arms);
            if (!Double.isNaN(goal[p])) {
                touching++;
                for (int k = 0; k < 6; k++) {
                    centre[k] += arms[k];
                }
            }
        }
        if (touching > 0 && d[o + FRICTION * lanes] > 0) {
            for (int k = 0; k < 6; k++) {
                centre[k] /= touching;
            }
            double[] m = centre;
            boolean wide = kept[TWIST_MASS] > 0;
            PrepareRow.block(rows, bodies, place, o, m[0], m[1], m[2], m[3], m[4], m[5], wide);
        }
        return true;
    }

    /**
     * How far a body's points turn until the impact: corners with the body, those of a round side
     * with its axis, those of a ball not at all.
     */
    private void turn(
            BodyStore store,
            ContactStore contacts,
            SolverBodies bodies,
            int source,
            int slot,
            int side,
            double time) {
        int w = SolverBodies.offset(slot) + SolverBodies.V + 3;
        double x = time * bodies.world(slot, w, 0);
        double y = time * bodies.world(slot, w, 1);
        double z = time * bodies.world(slot, w, 2);
        byte surface = side == 0 ? contacts.surfaceA[source] : contacts.surfaceB[source];
        int collider = side == 0 ? contacts.colliderA[source] : contacts.colliderB[source];
        if (surface != Surface.CORNERED) {
            int r = BodyStore.REVOLUTION * collider;
            Rotations.rotate(
                    store.orientationX[slot],
                    store.orientationY[slot],
                    store.orientationZ[slot],
                    store.orientationW[slot],
                    store.revolution[r],
                    store.revolution[r + 1],
                    store.revolution[r + 2],
                    axis);
            double about = x * axis[0] + y * axis[1] + z * axis[2];
            x -= about * axis[0];
            y -= about * axis[1];
            z -= about * axis[2];
        }
        double square = store.isBall[slot] ? 0 : 0.25 * (x * x + y * y + z * z);
        double k = square > 0 ? Rotation.halfSine(square) : 0;
        turns[4 * side] = k * x;
        turns[4 * side + 1] = k * y;
        turns[4 * side + 2] = k * z;
        turns[4 * side + 3] = Rotation.halfCosine(square);
    }

    /** Where both bodies take the impulse of a point. */
    private void place(ContactStore c, int point) {
        int q = ContactStore.anchor(point);
        for (int side = 0; side < 2; side++) {
            int t = 4 * side;
            int from = q + 3 * side;
            Rotations.rotate(
                    turns[t],
                    turns[t + 1],
                    turns[t + 2],
                    turns[t + 3],
                    c.anchors[from],
                    c.anchors[from + 1],
                    c.anchors[from + 2],
                    axis);
            System.arraycopy(axis, 0, arms, 3 * side, 3);
        }
        double along = 0;
        for (int k = 0; k < 3; k++) {
            along += (apart[k] + arms[3 + k] - arms[k]) * d[o + k * lanes];
        }
        for (int k = 0; k < 3; k++) {
            double normal = along * d[o + k * lanes];
            double aside = apart[k] + arms[3 + k] - arms[k] - normal;
            arms[k] += share * aside + 0.5 * normal;
            arms[3 + k] -= (1 - share) * aside + 0.5 * normal;
        }
    }

    /** Whether the lever of the normal is no longer than a body reaches. */
    private boolean isWithin(int part, double reach) {
        double square = 0;
        double along = 0;
        for (int k = 0; k < 3; k++) {
            square += arms[part + k] * arms[part + k];
            along += arms[part + k] * d[o + k * lanes];
        }
        return square - along * along <= reach * reach;
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
