package dev.cairn.physics.solver.single;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;

import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/** Sweeps that come nearer by fixed shares in two directions end where they would have ended. */
class AndersonStepTest {
    private static final int SIZE = 7;
    private static final int BODY = 64;
    private static final double[] SHARES = {0.6, 0.3};

    private final SplittableRandom random = new SplittableRandom(11);
    private final ConstraintRows rows = new EdgeList().doubles;
    private double[] row = {};
    private final double[] body = new double[128];
    private final double[] end = new double[SIZE];

    /** Two directions at right angles, unit; the twist has another unit and stays out of it. */
    private final double[][] directions = {
        {0.5, 0.5, -0.5, -0.5, 0, 0, 0}, {0, 0, 0, 0, 0.6, 0.8, 0}
    };

    /** Where a field of the row is. */
    private int in(int field) {
        return rows.base(0) + field * rows.lanes;
    }

    private int at(int unknown) {
        return in(field(unknown));
    }

    private static int field(int unknown) {
        return unknown < 4
                ? ConstraintRows.POINT
                        + unknown * ConstraintRows.POINT_FIELDS
                        + ConstraintRows.IMPULSE
                : ConstraintRows.LAMBDA + unknown - 4;
    }

    private void begin() {
        rows.ensurePlaces(1);
        rows.link[ConstraintRows.BODY_B] = BODY;
        rows.link[ConstraintRows.COUNT] = 4;
        row = rows.doubles;
        for (int i = 0; i < ConstraintRows.FIELDS; i++) {
            row[in(i)] = random.nextDouble() - 0.5;
        }
        body[BODY + SolverBodies.MASS] = 0.3;
        for (int i = 0; i < SIZE; i++) {
            end[i] = 2 + random.nextDouble();
            row[at(i)] = end[i];
            for (double[] direction : directions) {
                row[at(i)] += 0.5 * direction[i];
            }
        }
    }

    /** What is left of the way to the end along each direction, after a sweep. */
    private void sweep(double... shares) {
        for (int k = 0; k < 2; k++) {
            double off = 0;
            for (int i = 0; i < SIZE; i++) {
                off += directions[k][i] * (row[at(i)] - end[i]);
            }
            for (int i = 0; i < SIZE; i++) {
                row[at(i)] += (shares[k] - 1) * off * directions[k][i];
            }
        }
    }

    private double error() {
        double worst = 0;
        for (int i = 0; i < SIZE; i++) {
            worst = Math.max(worst, Math.abs(row[at(i)] - end[i]));
        }
        return worst;
    }

    @Test
    void threeSweepsAreEnoughForTwoDirections() {
        begin();
        AndersonStep mixing = new AndersonStep();
        mixing.begin();
        for (int k = 0; k < 3; k++) {
            mixing.start(rows, 0, rows.rolling, 0);
            sweep(SHARES);
            assertTrue(k == 2 || error() > 1e-3, "there too early, sweep " + k);
            mixing.leap(rows, 0, rows.rolling, 0, body);
        }
        assertEquals(0, error(), 1e-12, "where three sweeps end");
    }

    /** What does not press at all has no say in where the others lead. */
    @Test
    void aPointThatIsOpenAllAlongDoesNotMatter() {
        for (double[] direction : directions) {
            direction[3] = 0;
        }
        begin();
        end[3] = 0;
        row[at(3)] = 0;
        AndersonStep mixing = new AndersonStep();
        mixing.begin();
        for (int k = 0; k < 3; k++) {
            mixing.start(rows, 0, rows.rolling, 0);
            sweep(SHARES);
            mixing.leap(rows, 0, rows.rolling, 0, body);
        }
        assertEquals(0, error(), 1e-12, "where three sweeps end");
    }

    /** A body is pushed by what its impulses became, J^T l, and the sums of the tick know it. */
    @Test
    void whatIsLeaptIsGivenToTheBody() {
        begin();
        AndersonStep mixing = new AndersonStep();
        mixing.begin();
        double[] given = new double[SIZE];
        double[] sums = new double[SIZE];
        for (int i = 0; i < SIZE; i++) {
            sums[i] = row[sum(i)];
        }
        for (int k = 0; k < 3; k++) {
            mixing.start(rows, 0, rows.rolling, 0);
            sweep(SHARES);
            for (int i = 0; i < SIZE; i++) {
                given[i] -= row[at(i)];
            }
            mixing.leap(rows, 0, rows.rolling, 0, body);
            for (int i = 0; i < SIZE; i++) {
                given[i] += row[at(i)];
            }
        }
        for (int axis = 0; axis < 3; axis++) {
            double push = 0;
            double turn = given[6] * row[in(ConstraintRows.TWIST + 3 + axis)];
            for (int p = 0; p < 4; p++) {
                push += given[p] * row[in(axis)];
                int point = ConstraintRows.POINT + p * ConstraintRows.POINT_FIELDS;
                turn += given[p] * row[in(point + ConstraintRows.ARM_B + axis)];
            }
            for (int f = 0; f < 2; f++) {
                push += given[4 + f] * row[in(ConstraintRows.TANGENT1 + 3 * f + axis)];
                turn += given[4 + f] * row[in(ConstraintRows.LEVER + 6 + 3 * f + axis)];
            }
            assertEquals(0.3 * push, body[BODY + axis], 1e-14, "velocity, axis " + axis);
            assertEquals(turn, body[BODY + 3 + axis], 1e-14, "spin, axis " + axis);
        }
        for (int i = 0; i < SIZE; i++) {
            assertEquals(given[i], row[sum(i)] - sums[i], 1e-14, "sum of unknown " + i);
        }
    }

    private int sum(int unknown) {
        return in(unknown < 4 ? ConstraintRows.SUM + unknown : ConstraintRows.TOTAL + unknown - 4);
    }

    /** Where one sweep leads away nothing is leapt. */
    @Test
    void nothingIsLeaptWhereASweepLeadsAway() {
        begin();
        AndersonStep mixing = new AndersonStep();
        mixing.begin();
        for (int k = 0; k < 2; k++) {
            mixing.start(rows, 0, rows.rolling, 0);
            for (int i = 0; i < SIZE; i++) {
                row[at(i)] += (k + 1) * 0.1;
            }
            double[] before = row.clone();
            mixing.leap(rows, 0, rows.rolling, 0, body);
            for (int i = 0; i < row.length; i++) {
                assertEquals(before[i], row[i], 0.0, "field " + i + ", sweep " + k);
            }
        }
    }

    /** Each sweep ends 1.2 times as far beyond the end as it began before it. */
    @Test
    void sweepsThatLeadAwayAreTurnedBack() {
        begin();
        AndersonStep mixing = new AndersonStep();
        mixing.begin();
        for (int k = 0; k < 3; k++) {
            mixing.start(rows, 0, rows.rolling, 0);
            sweep(-1.2, 0);
            assertTrue(error() > 0.1, "there too early, sweep " + k);
            mixing.leap(rows, 0, rows.rolling, 0, body);
        }
        assertEquals(0, error(), 1e-12, "where the third sweep ends");
    }
}
