package dev.cairn.physics.solver.single;

import static dev.cairn.physics.solver.body.SolverBodies.MASS;
import static dev.cairn.physics.solver.body.SolverBodies.V;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.SUM;
import static dev.cairn.physics.solver.row.ConstraintRows.TOTAL;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.AxisLocks;
import dev.cairn.physics.solver.body.MotionRecord;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.RollingRows;

/**
 * A contact with a static body does no work: what it did to a body in a sub-step is cut back until
 * the body has no more energy than without the contact.
 *
 * <p>Problem: a body that turns far within a sub-step is stopped with levers of one pose, pushed
 * out with those, and let go with levers of another, so that the push is not taken back: a pencil
 * that was dropped left at 700 m/s. At rest, in a slide, a roll and a slow rocking the work is
 * below zero by what gravity adds in a sub-step, and nothing is cut.
 *
 * <p>With the velocity {@code v} of the sub-step's start and forces, and the change {@code c} by
 * the contact, in coordinates in which the kinetic energy is half a square: if {@code |v + c| >
 * |v|}, then the body goes on with {@code v + s c}, where {@code s = max(0, -v.c / c²)} is where it
 * has the least energy, and the impulses are s times what they were. So {@code |v + s c| <= |v|},
 * whatever the sweeps did. A sum of impulses is scaled, so momentum along what the contact cannot
 * touch stays.
 *
 * <p>Any worker, one to a body. Does not allocate. Source: own study.
 */
final class EnergyBound {
    /** Rounding of a square of velocities, over the square. */
    private static final double ROUNDING = 1e-13;

    private EnergyBound() {}

    /**
     * End of a sub-step, when the warm start has taken over what the contact did.
     *
     * @param i slot of the body
     * @param rows of doubles, with the body's only row at {@code place}
     * @param at place of the row in {@code rolling}
     */
    static void end(
            BodyStore b,
            SolverBodies s,
            int i,
            ConstraintRows rows,
            RollingRows rolling,
            int place,
            int at) {
        double[] v = s.state;
        double[] free = s.motion;
        int o = SolverBodies.offset(i) + V;
        int g = MotionRecord.STRIDE * i + MotionRecord.FREE;
        double mass = 1 / v[SolverBodies.offset(i) + MASS];
        double before = 0;
        double along = 0;
        double square = 0;
        for (int c = 0; c < 6; c++) {
            double weight = c < 3 ? mass : 1;
            double change = v[o + c] - free[g + c];
            before += weight * (free[g + c] * free[g + c]);
            along += weight * (free[g + c] * change);
            square += weight * (change * change);
        }
        // |v + c|² - |v|² = 2 v.c + c²
        if (!(2 * along + square > ROUNDING * before)) {
            return;
        }
        double share = Math.max(0, -along / square);
        int w = (i + 1) * SolverBodies.HALF;
        for (int c = 0; c < 6; c++) {
            v[o + c] = free[g + c] + share * (v[o + c] - free[g + c]);
            s.warm[w + c] *= share;
        }
        if (b.motionFlags[i] != 0) {
            AxisLocks.lock(b, v, SolverBodies.offset(i));
        }
        int r = rows.base(place);
        int lanes = rows.lanes;
        for (int p = 0; p < rows.points(place); p++) {
            int impulse = r + (POINT + p * POINT_FIELDS + IMPULSE) * lanes;
            cut(rows.doubles, impulse, r + (SUM + p) * lanes, share);
        }
        for (int k = 0; k < 3; k++) {
            cut(rows.doubles, r + (LAMBDA + k) * lanes, r + (TOTAL + k) * lanes, share);
        }
        if (rolling.has(at)) {
            rolling.scale(at, share);
        }
    }

    /** What is taken off an impulse is taken off the tick's sum, too. */
    private static void cut(double[] d, int impulse, int sum, double share) {
        d[sum] -= (1 - share) * d[impulse];
        d[impulse] *= share;
    }
}
