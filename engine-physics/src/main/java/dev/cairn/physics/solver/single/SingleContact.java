package dev.cairn.physics.solver.single;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.CommonStep;
import dev.cairn.physics.solver.kernel.RollingFriction;
import dev.cairn.physics.solver.kernel.RowArithmetic;
import dev.cairn.physics.solver.kernel.ScalarNormals;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.RollingRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

/**
 * The contact of a body that touches nothing but one that does not move, swept until its impulses
 * agree.
 *
 * <p>Problem: a pass sweeps each contact once, and what a sweep leaves undone is an error of the
 * next sub-steps: a block that begins to slide presses with a little more than its weight, because
 * one sweep over four points leaves their tilt, and is slowed by it. In a heap that error drowns in
 * others. Alone, a contact agrees with itself after a few sweeps, and then a slide, a stop or a tip
 * follows its closed form.
 *
 * <p>Only such contacts: where several share a body they agree slowly, and sweeps that end early
 * are worse than none (a stack whose load was taken off hopped by a millimetre). What rests is left
 * alone too: its impulses are right in the mean of bias and relax pass.
 *
 * <p>Any worker, one to a body. Does not allocate. Source: own study.
 */
final class SingleContact {
    /** Change of an impulse over the largest one at which a contact agrees. */
    private static final double AGREES = 1e-12;

    /** Speed over what gravity adds to it in a sub-step, up to which a body is still. */
    private static final double STILL = 1e-7;

    /** Turn in a sub-step, rad: of what turns farther, the bias pass must agree, too. */
    private static final double FAR = 0.01;

    private SingleContact() {}

    /**
     * Sweeps after the relax pass of a sub-step.
     *
     * @param gain what gravity adds to a speed in the sub-step, m/s
     * @param place of the only row of body {@code i}
     * @param at its place in {@code rolling}
     * @param mixing spares sweeps
     */
    static void agree(
            ConstraintRows rows,
            RollingRows rolling,
            double[] body,
            SubStep sub,
            double gain,
            int place,
            int at,
            int i,
            AndersonStep mixing,
            Scratch scratch) {
        if (!moves(body, SolverBodies.offset(i), STILL * gain)) {
            return;
        }
        // without it normals agree soon, and how four of them share a load is not for a leap to say
        boolean hasFriction = rows.get(rows.base(place) + ConstraintRows.FRICTION * rows.lanes) > 0;
        // what pressed in the bias pass, and nothing in the relax pass: friction has lifted it
        boolean isLost =
                body[SolverBodies.offset(i) + SolverBodies.LOADED] != 0
                        && RowArithmetic.sum(
                                        rows.doubles,
                                        rows.base(place),
                                        rows.lanes,
                                        rows.points(place))
                                == 0;
        mixing.begin();
        for (int k = 0; k < sub.lone; k++) {
            mixing.start(rows, place, rolling, at);
            double change = again(rows, body, sub, place, isLost, scratch.doubles);
            if (rolling.has(at)) {
                change = Math.max(change, RollingFriction.row(rows, place, body, rolling, at));
            }
            double largest =
                    RowArithmetic.largest(
                            rows.doubles, rows.base(place), rows.lanes, rows.points(place));
            if (!(change > AGREES * largest)) {
                return;
            }
            if (hasFriction) {
                mixing.leap(rows, place, rolling, at, body);
            }
        }
    }

    /**
     * Sweeps after the bias pass of a sub-step, where that turns a body far.
     *
     * @param place of the only row of body {@code i}
     */
    static void press(
            ConstraintRows rows, SolverBodies s, SubStep sub, int place, int i, double[] st) {
        int o = SolverBodies.offset(i);
        double x = s.world(i, o + 3, 0);
        double y = s.world(i, o + 3, 1);
        double z = s.world(i, o + 3, 2);
        double far = FAR * sub.inverse;
        int n = rows.points(place);
        if (n < 2 || !(x * x + y * y + z * z > far * far)) {
            return;
        }
        int a = rows.link[place * ConstraintRows.LINK];
        int b = rows.link[place * ConstraintRows.LINK + 1];
        int r = rows.base(place);
        double[] d = rows.doubles;
        for (int k = 0; k < sub.lone; k++) {
            ScalarNormals.soften(d, r, rows.lanes, n, true, sub, st);
            ScalarNormals.sweep(
                    d, r, rows.lanes, s.state, a, b, n, sub.sweeps, CommonStep.NONE, st);
            double worst = 0;
            for (int p = 0; p < n; p++) {
                worst = Math.max(worst, Math.abs(st[Scratch.CHANGE + p]));
            }
            if (!(worst > AGREES * RowArithmetic.largest(d, r, rows.lanes, n))) {
                break;
            }
        }
        s.state[o + SolverBodies.LOADED] = RowArithmetic.sum(d, r, rows.lanes, n) > 0 ? 1 : 0;
    }

    /**
     * One more sweep of the relax pass over a row; returns the largest change of an impulse.
     *
     * @param all whether points that do not press may begin to
     */
    private static double again(
            ConstraintRows rows, double[] body, SubStep sub, int j, boolean all, double[] st) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int l = j * ConstraintRows.LINK;
        int a = rows.link[l];
        int b = rows.link[l + 1];
        int n = rows.link[l + ConstraintRows.COUNT];
        int o = rows.base(j);
        if (all) {
            ScalarNormals.hardenAll(d, o, lanes, n, sub, st);
        } else {
            ScalarNormals.harden(d, o, lanes, n, sub, st);
        }
        ScalarNormals.sweep(d, o, lanes, body, a, b, n, sub.sweeps, CommonStep.HARD, st);
        double worst = 0;
        for (int p = 0; p < n; p++) {
            double change = st[Scratch.CHANGE + p];
            d[o + (ConstraintRows.SUM + p) * lanes] += change;
            worst = Math.max(worst, Math.abs(change));
        }
        if (d[o + ConstraintRows.FRICTION * lanes] > 0) {
            worst = Math.max(worst, RollingFriction.solve(d, o, lanes, body, a, b, n));
        }
        return worst;
    }

    /**
     * Whether a body turns.
     *
     * @param gain what gravity adds to a speed in the sub-step, m/s
     */
    static boolean turns(double[] body, int i, double gain) {
        double still = STILL * gain;
        return turn(body, SolverBodies.offset(i)) > still * still;
    }

    /** {@code v² + w'²/m} above the square of a speed. */
    private static boolean moves(double[] body, int o, double still) {
        double v = body[o] * body[o] + body[o + 1] * body[o + 1] + body[o + 2] * body[o + 2];
        return v + turn(body, o) > still * still;
    }

    /** {@code w'²/m}, w' weighted: the square of a speed. */
    private static double turn(double[] body, int o) {
        double w =
                body[o + 3] * body[o + 3] + body[o + 4] * body[o + 4] + body[o + 5] * body[o + 5];
        return w * body[o + SolverBodies.MASS];
    }
}
