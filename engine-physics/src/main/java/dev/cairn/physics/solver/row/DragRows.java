package dev.cairn.physics.solver.row;

import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;
import static dev.cairn.physics.solver.row.ConstraintRows.TANGENT1;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;

/**
 * Friction between two bodies that move, of which a surface runs along: it drags the slip to {@code
 * v_B - v_A = -u} rather than to 0, u being by how much B's surface runs faster than A's.
 *
 * <p>Such contacts are few, and the row of a contact is long already. So the sweeps take these rows
 * for rows without friction: coefficient and impulses are kept here, beside them, and are put into
 * the row for readers. Drag is solved row by row at the end of a relax pass; the impulse on A is
 * the negative of that on B, so no momentum is made. Belts on what impulses do not move need none
 * of this, see {@code DrivenSides}.
 *
 * <p>Doubles, for rows of either precision. By place; only once a surface that runs along has been
 * in the world. Does not allocate but for that.
 */
public final class DragRows {
    /** Coulomb coefficient; 0 of all other rows, and then nothing else is current. */
    private static final int COEFFICIENT = 0;

    /** Friction impulses of the sub-step, as in the row: along the tangents, twist. */
    private static final int IMPULSE = 1;

    /** u, world, m/s. */
    private static final int SPEED = 4;

    private static final int STRIDE = 7;

    /** Whether there is any. */
    public boolean isUsed;

    private double[] data = {};

    /** Before a tick. */
    public void begin(boolean used, int places) {
        isUsed = used;
        if (used && data.length < STRIDE * places) {
            data = new double[STRIDE * places];
        }
    }

    /** Whether the row at a place is dragged. */
    public boolean has(int place) {
        return isUsed && data[STRIDE * place] > 0;
    }

    /** Finds the rows of a range that are dragged, after they were filled, and hides their own. */
    public void fill(ConstraintRows rows, SolverBodies bodies, ContactStore c, int from, int to) {
        for (int j = from; j < to; j++) {
            int k = STRIDE * j;
            data[k] = 0;
            int l = j * LINK;
            if (rows.points(j) == 0
                    || !bodies.isMoved(rows.link[l])
                    || !bodies.isMoved(rows.link[l + 1])) {
                continue;
            }
            int u = 3 * rows.link[l + ConstraintRows.SOURCE];
            if (c.belt[u] != 0 || c.belt[u + 1] != 0 || c.belt[u + 2] != 0) {
                System.arraycopy(c.belt, u, data, k + SPEED, 3);
                take(rows, j);
            }
        }
    }

    /** What the rows of a range hold of their friction is theirs again. */
    public void show(ConstraintRows rows, int from, int to) {
        for (int j = from; j < to; j++) {
            if (has(j)) {
                int o = rows.base(j);
                rows.put(o + FRICTION * rows.lanes, data[STRIDE * j + COEFFICIENT]);
                showImpulses(rows, j);
            }
        }
    }

    /** The same but for the coefficient: the contact learns impulses, and no slip. */
    public void showImpulses(ConstraintRows rows, int from, int to) {
        for (int j = from; j < to; j++) {
            if (has(j)) {
                showImpulses(rows, j);
            }
        }
    }

    private void showImpulses(ConstraintRows rows, int j) {
        for (int n = 0; n < 3; n++) {
            int at = rows.base(j) + (LAMBDA + n) * rows.lanes;
            rows.put(at, data[STRIDE * j + IMPULSE + n]);
        }
    }

    /** Takes it out of them. */
    public void hide(ConstraintRows rows, int from, int to) {
        for (int j = from; j < to; j++) {
            if (has(j)) {
                take(rows, j);
            }
        }
    }

    private void take(ConstraintRows rows, int j) {
        int o = rows.base(j);
        int k = STRIDE * j;
        if (!(rows.get(o + FRICTION * rows.lanes) > 0)) {
            return;
        }
        data[k + COEFFICIENT] = rows.get(o + FRICTION * rows.lanes);
        rows.put(o + FRICTION * rows.lanes, 0);
        for (int n = 0; n < 3; n++) {
            int at = o + (LAMBDA + n) * rows.lanes;
            data[k + IMPULSE + n] = rows.get(at);
            rows.put(at, 0);
        }
    }

    /**
     * Gives the impulses of a row away, to the stage that takes them out of the warm start.
     *
     * @param look has the row at {@code place}
     * @param at its place here
     */
    public void give(ConstraintRows look, int place, int at) {
        if (has(at)) {
            for (int n = 0; n < 3; n++) {
                int k = STRIDE * at + IMPULSE + n;
                look.put(look.base(place) + (LAMBDA + n) * look.lanes, data[k]);
                data[k] = 0;
            }
        }
    }

    /**
     * By how much B's surface runs faster than A's along a tangent of the row, m/s.
     *
     * @param tangent 0 or 1
     */
    public double speed(ConstraintRows rows, int place, int tangent) {
        int u = STRIDE * place + SPEED;
        int t = rows.base(place) + (TANGENT1 + 3 * tangent) * rows.lanes;
        return data[u] * rows.get(t)
                + data[u + 1] * rows.get(t + rows.lanes)
                + data[u + 2] * rows.get(t + 2 * rows.lanes);
    }
}
