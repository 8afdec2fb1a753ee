package dev.cairn.physics.solver;

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
final class LoneContact {
    /** Change of an impulse over the largest one at which a contact agrees. */
    private static final double AGREES = 1e-12;

    /** Speed over what gravity adds to it in a sub-step, up to which a body is still. */
    private static final double STILL = 1e-7;

    private LoneContact() {}

    /**
     * Sweeps after the relax pass of a sub-step.
     *
     * @param gain what gravity adds to a speed in the sub-step, m/s
     * @param row the only one of body {@code i}
     */
    static void agree(
            ConstraintRows rows,
            double[] body,
            SubStep sub,
            double gain,
            int row,
            int i,
            double[] scratch) {
        if (!moves(body, SolverBodies.offset(i), STILL * gain)) {
            return;
        }
        int place = rows.place[row];
        for (int k = 0; k < sub.lone; k++) {
            double change = ScalarSweeps.again(rows, body, sub, place, scratch);
            double largest =
                    ScalarNormals.largest(
                            rows.row, rows.base(place), rows.lanes, rows.points(place));
            if (!(change > AGREES * largest)) {
                return;
            }
        }
    }

    /** {@code v² + w'²/m} above the square of a speed, w' weighted. */
    private static boolean moves(double[] body, int o, double still) {
        double v = body[o] * body[o] + body[o + 1] * body[o + 1] + body[o + 2] * body[o + 2];
        double w =
                body[o + 3] * body[o + 3] + body[o + 4] * body[o + 4] + body[o + 5] * body[o + 5];
        return v + w * body[o + SolverBodies.MASS] > still * still;
    }
}
