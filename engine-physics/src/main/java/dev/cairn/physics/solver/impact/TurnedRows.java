package dev.cairn.physics.solver.impact;

import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.SUM;
import static dev.cairn.physics.solver.row.ConstraintRows.TANGENT1;
import static dev.cairn.physics.solver.row.ConstraintRows.TANGENT2;
import static dev.cairn.physics.solver.row.ConstraintRows.TOTAL;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.kernel.RowArithmetic;
import dev.cairn.physics.solver.kernel.StoreRow;
import dev.cairn.physics.solver.row.ConstraintRows;

import java.util.Arrays;

/**
 * Rows whose normal turns within a tick after they have pressed, as that of two balls that meet
 * twice: what such a contact reports.
 *
 * <p>A contact reports its impulses of a tick along one normal. Each of several impacts has its
 * own, and only their vector sum is what the bodies got. So that sum is kept, and its direction
 * reported as the normal. Friction is turned to the new tangents; what they cannot hold of it is
 * added to the sum. The next warm start knows nothing of all this.
 *
 * <p>One thread. Does not allocate once it has grown.
 */
final class TurnedRows {
    private int[] row = new int[8];

    /** Of each: sum of its normal impulses before its normal was turned last, world, N s. */
    private double[] sum = new double[24];

    /** By row: 1 + its index here, or 0. */
    private int[] indexOf = {};

    private int count;

    /** Index of the row in work; its friction so far, world, N s. */
    private int at;

    private final double[] friction = new double[3];

    /**
     * Makes room for all rows, in the tick in which they get theirs: which bodies are turned shows
     * late.
     */
    void ensureCapacity(int rows) {
        if (indexOf.length < rows) {
            indexOf = Arrays.copyOf(indexOf, rows);
        }
    }

    /** Before the row, which lies at {@code d[o]}, is turned. */
    void takeOut(int turned, double[] d, int o, int lanes) {
        if (indexOf[turned] == 0) {
            if (count == row.length) {
                row = Arrays.copyOf(row, 2 * count);
                sum = Arrays.copyOf(sum, 6 * count);
            }
            Arrays.fill(sum, 3 * count, 3 * count + 3, 0.0);
            row[count] = turned;
            indexOf[turned] = ++count;
        }
        at = indexOf[turned] - 1;
        boolean hasFriction = d[o + FRICTION * lanes] > 0;
        for (int k = 0; k < 3; k++) {
            sum[3 * at + k] += d[o + SUM * lanes] * d[o + k * lanes];
            friction[k] = hasFriction ? StoreRow.tangent(d, o, lanes, TOTAL, k) : 0;
        }
        d[o + SUM * lanes] = 0;
    }

    /** After that. */
    void turnFriction(double[] d, int o, int lanes) {
        if (!(d[o + FRICTION * lanes] > 0)) {
            return;
        }
        double along = RowArithmetic.dot(d, o, lanes, friction, 0);
        for (int k = 0; k < 3; k++) {
            sum[3 * at + k] += along * d[o + k * lanes];
        }
        d[o + TOTAL * lanes] = RowArithmetic.dot(d, o + TANGENT1 * lanes, lanes, friction, 0);
        d[o + (TOTAL + 1) * lanes] = RowArithmetic.dot(d, o + TANGENT2 * lanes, lanes, friction, 0);
    }

    /** End of the tick: turns the normals that are reported, when the rows are stored. */
    void report(ConstraintRows rows, ContactStore contacts) {
        for (int i = 0; i < count; i++) {
            int source = rows.list.source[row[i]];
            int o = rows.base(rows.list.place[row[i]]);
            double last = rows.get(o + SUM * rows.lanes);
            double x = sum[3 * i] + last * rows.get(o);
            double y = sum[3 * i + 1] + last * rows.get(o + rows.lanes);
            double z = sum[3 * i + 2] + last * rows.get(o + 2 * rows.lanes);
            double size = Math.sqrt(x * x + y * y + z * z);
            if (size > 0) {
                contacts.setNormal(source, x / size, y / size, z / size);
                contacts.totalNormalImpulse[ContactStore.POINTS * source] = size;
            }
            indexOf[row[i]] = 0;
        }
        count = 0;
    }
}
