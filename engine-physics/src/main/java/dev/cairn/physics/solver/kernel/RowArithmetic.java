package dev.cairn.physics.solver.kernel;

import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.REACH;

/** Sums and products over the fields of one row. */
public final class RowArithmetic {
    private RowArithmetic() {}

    /** The normal impulses of a contact added up. */
    public static double sum(double[] d, int o, int lanes, int points) {
        double sum = 0;
        for (int p = 0; p < points; p++) {
            sum += d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes];
        }
        return sum;
    }

    /** The largest impulse of a point. */
    public static double largest(double[] d, int o, int lanes, int points) {
        double largest = 0;
        for (int p = 0; p < points; p++) {
            largest = Math.max(largest, d[o + (POINT + p * POINT_FIELDS + IMPULSE) * lanes]);
        }
        return largest;
    }

    /** {@code v.f} of the vector field f that begins at {@code o}. */
    public static double dot(double[] d, int o, int lanes, double[] v, int i) {
        return d[o] * v[i] + d[o + lanes] * v[i + 1] + d[o + 2 * lanes] * v[i + 2];
    }

    /**
     * Radius of the patch of a row, m; 0 without friction, since then only a group of lanes that
     * holds a row with friction knows it, and the result must not hang on what else is in the
     * group.
     */
    public static double reach(double[] d, int o, int lanes, int points) {
        double radius = 0;
        if (d[o + FRICTION * lanes] > 0) {
            for (int p = 0; p < points; p++) {
                radius = Math.max(radius, d[o + (REACH + p) * lanes]);
            }
        }
        return radius;
    }
}
