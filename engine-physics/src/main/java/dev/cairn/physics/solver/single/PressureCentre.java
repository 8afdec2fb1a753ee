package dev.cairn.physics.solver.single;

import static dev.cairn.physics.solver.row.ConstraintRows.*;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.PrepareRow;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;

/**
 * Friction of a blow acts where the blow does: at the mean of the contact's points, weighted by
 * their normal impulses.
 *
 * <p>Problem: a row's friction acts at the mean of its points, whatever each of them bears. At rest
 * that is as good, and does not follow the noise of their loads. But where a body turns on one
 * corner and strikes with another, all of the blow is at the other, and its friction in the middle
 * turned the body by a wrong lever.
 *
 * <p>All is found from the row's own levers, which are those of the blow's pose. With L the root of
 * the inverse inertia, a point's normal lever {@code L^T (r x n)} gives {@code r x n}, and {@code n
 * x (r x n)} is r but for its height along n; that is the friction's own, from {@code (c x t1) .
 * t2}.
 *
 * <p>Only of a body on something that does not move: two bodies that move have to share the point,
 * or their friction makes angular momentum. One contact at a time, any worker. Does not allocate.
 */
final class PressureCentre {
    private static final int BLOCK_FIELDS = 3;

    /** Places of all points along the contact plane, from the centre of mass, m. */
    private final double[] place = new double[3 * ContactStore.POINTS];

    /** Height of the friction along the normal, from the centre of mass, m. */
    private double height;

    /** What the row had: levers, block, reaches. */
    private final double[] kept = new double[12 + BLOCK_FIELDS + ContactStore.POINTS];

    private final double[] world = new double[3];
    private final double[] centre = new double[3];

    private ConstraintRows rows = new EdgeList().doubles;
    private double[] d = {};
    private double[] root = {};
    private int o, lanes, points;

    /** The body that moves: its offset, and 0 for A, 1 for B. */
    private int body, side;

    private double share;

    /**
     * Turns to a row of doubles, whose levers are those of the blow.
     *
     * @param j place of the row
     * @return whether its friction can be moved: there are several points, one of the bodies does
     *     not move, and no turn of the other one is locked
     */
    boolean open(ConstraintRows row, SolverBodies bodies, ContactStore contacts, int j) {
        rows = row;
        d = rows.doubles;
        root = bodies.root;
        lanes = rows.lanes;
        o = rows.base(j);
        points = rows.points(j);
        boolean first = d[o + MASS_A * lanes] > 0;
        if (points < 2 || !(d[o + FRICTION * lanes] > 0) || first == d[o + MASS_B * lanes] > 0) {
            return false;
        }
        side = first ? 0 : 1;
        body = rows.link[j * LINK + side];
        int k = (body >> 4) * SolverBodies.ROOT + 9;
        if (!(root[k] > 0 && root[k + 1] > 0 && root[k + 2] > 0)) {
            return false;
        }
        share = PrepareRow.share(contacts, rows.link[j * LINK + SOURCE]);
        keep(kept, true);
        find();
        return true;
    }

    /** Puts the friction where the normal impulses are, if there are any. */
    void move() {
        double sum = 0;
        for (int p = 0; p < points; p++) {
            sum += impulse(p);
        }
        if (!(sum > 0)) {
            return;
        }
        for (int k = 0; k < 3; k++) {
            double mean = 0;
            for (int p = 0; p < points; p++) {
                mean += impulse(p) / sum * place[3 * p + k];
            }
            centre[k] = mean;
        }
        reach();
        for (int k = 0; k < 3; k++) {
            centre[k] += height * d[o + k * lanes];
        }
        lever(TANGENT1, LEVER + 6 * side);
        lever(TANGENT2, LEVER + 6 * side + 3);
        block();
    }

    /** Puts it back. */
    void restore() {
        keep(kept, false);
    }

    private double impulse(int p) {
        return d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes];
    }

    private void keep(double[] to, boolean out) {
        for (int f = 0; f < 12; f++) {
            copy(to, f, LEVER + f, out);
        }
        for (int f = 0; f < BLOCK_FIELDS; f++) {
            copy(to, 12 + f, BLOCK + f, out);
        }
        for (int p = 0; p < ContactStore.POINTS; p++) {
            copy(to, 12 + BLOCK_FIELDS + p, REACH + p, out);
        }
    }

    private void copy(double[] to, int i, int field, boolean out) {
        if (out) {
            to[i] = d[o + field * lanes];
        } else {
            d[o + field * lanes] = to[i];
        }
    }

    /** The places of the points. */
    private void find() {
        double nx = d[o];
        double ny = d[o + lanes];
        double nz = d[o + 2 * lanes];
        for (int p = 0; p < points; p++) {
            unweigh(POINT + p * POINT_FIELDS + (side == 0 ? ARM_A : ARM_B));
            int q = 3 * p;
            place[q] = ny * world[2] - nz * world[1];
            place[q + 1] = nz * world[0] - nx * world[2];
            place[q + 2] = nx * world[1] - ny * world[0];
        }
        // (c x t1) . t2 = c . (t1 x t2), and t1 x t2 is n or -n
        int i = o + TANGENT1 * lanes;
        int j = o + TANGENT2 * lanes;
        double cross = 0;
        for (int k = 0; k < 3; k++) {
            int l = (k + 1) % 3 * lanes;
            int m = (k + 2) % 3 * lanes;
            cross += d[o + k * lanes] * (d[i + l] * d[j + m] - d[i + m] * d[j + l]);
        }
        unweigh(LEVER + 6 * side);
        double along = world[0] * d[j] + world[1] * d[j + lanes] + world[2] * d[j + 2 * lanes];
        height = cross > 0 ? along : -along;
    }

    /** Into world: {@code L^-T u}, u the weighted lever at a field. */
    private void unweigh(int field) {
        int k = (body >> 4) * SolverBodies.ROOT;
        double x = root[k + 9] * d[o + field * lanes];
        double y = root[k + 10] * d[o + (field + 1) * lanes];
        double z = root[k + 11] * d[o + (field + 2) * lanes];
        for (int axis = 0; axis < 3; axis++) {
            int i = k + 3 * axis;
            world[axis] = root[i] * x + root[i + 1] * y + root[i + 2] * z;
        }
    }

    /** Writes {@code L^T (c x t)}. */
    private void lever(int tangent, int out) {
        double x = d[o + tangent * lanes];
        double y = d[o + (tangent + 1) * lanes];
        double z = d[o + (tangent + 2) * lanes];
        double u = centre[1] * z - centre[2] * y;
        double v = centre[2] * x - centre[0] * z;
        double w = centre[0] * y - centre[1] * x;
        int k = (body >> 4) * SolverBodies.ROOT;
        for (int c = 0; c < 3; c++) {
            d[o + (out + c) * lanes] = root[k + c] * u + root[k + 3 + c] * v + root[k + 6 + c] * w;
        }
    }

    /** How far friction acts at the points, as seen from a centre along the plane. */
    private void reach() {
        for (int p = 0; p < points; p++) {
            int q = 3 * p;
            double x = place[q] - centre[0];
            double y = place[q + 1] - centre[1];
            double z = place[q + 2] - centre[2];
            d[o + (REACH + p) * lanes] = Math.sqrt(x * x + y * y + z * z) * share;
        }
    }

    /** The inverse of the friction's 2 x 2 block, as {@link PrepareRow} has it. */
    private void block() {
        double masses = d[o + MASS_A * lanes] + d[o + MASS_B * lanes];
        double k11 = masses + dot(LEVER, LEVER) + dot(LEVER + 6, LEVER + 6);
        double k22 = masses + dot(LEVER + 3, LEVER + 3) + dot(LEVER + 9, LEVER + 9);
        double k12 = dot(LEVER, LEVER + 3) + dot(LEVER + 6, LEVER + 9);
        double one = 1 / (k11 * k22 - k12 * k12);
        d[o + BLOCK * lanes] = k22 * one;
        d[o + (BLOCK + 1) * lanes] = -k12 * one;
        d[o + (BLOCK + 2) * lanes] = k11 * one;
    }

    private double dot(int i, int j) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            sum += d[o + (i + k) * lanes] * d[o + (j + k) * lanes];
        }
        return sum;
    }
}
