package dev.cairn.physics.solver.single;

import dev.cairn.physics.solver.body.Motion;
import dev.cairn.physics.solver.body.MotionRecord;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.refresh.JacobianRefresh;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.RowWindow;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;
import dev.cairn.physics.tuning.Tunable;

import java.util.Arrays;

/**
 * The door of this package: what a sub-step does besides sweeping for a body whose only contact is
 * with a static body. The passes call it at two places and know nothing of what is behind.
 *
 * <p>Switched off by {@link Tunable#LONE_SWEEPS} of 0: then no body has a {@link
 * SolverBodies#guide}, and neither method is called. One to a worker. Does not allocate.
 */
public final class SingleBody {
    private final RowWindow window = new RowWindow();
    private final InelasticImpact impact = new InelasticImpact();
    private final PinnedCorner corner = new PinnedCorner();
    private final RollingRim rim = new RollingRim();
    private final AndersonStep mixing = new AndersonStep();

    /**
     * Start of a sub-step, before its kick: points that land in it, and the corner that the body
     * turns on.
     *
     * @param refresh tells whether the body's Jacobian is that of this sub-step
     * @param gain what gravity adds to a speed in the sub-step, m/s
     * @param i slot of a body with a guide
     */
    public void begin(
            SolverContext tick,
            ConstraintRows rows,
            SubStep sub,
            JacobianRefresh refresh,
            double gain,
            int i) {
        SolverBodies bodies = tick.body;
        int row = rows.list.place[bodies.guide[i]];
        MotionRecord.start(bodies, i);
        int lands = MotionRecord.STRIDE * i + MotionRecord.LANDS;
        bodies.motion[lands] = MotionRecord.NEVER;
        if (refresh.hasRenewedRow(i) && rim.begin(tick, rows, row, i, sub, refresh)) {
            return;
        }
        bodies.motion[lands] =
                TrapezoidalCorrection.landing(rows, row, bodies, i, sub.seconds, gain);
        if (SingleContact.turns(bodies.state, i, gain) && InelasticImpact.isAwaited(rows, row)) {
            ConstraintRows guide = window.open(rows, row);
            int place = window.place();
            if (impact.run(tick, guide, rows.rolling, place, row, i, sub.seconds, sub.lone)) {
                window.close(rows, row);
                bodies.motion[lands] = MotionRecord.NEVER;
            }
        }
        if (refresh.hasRenewedRow(i)) {
            PinnedCorner.begin(tick.bodies, bodies, i, rows, row, sub.touch);
        }
    }

    /**
     * After the bias pass of a sub-step, before the body moves: its points agree on what presses
     * it.
     *
     * @param i slot of a body with a guide
     */
    public void press(
            SolverContext tick, ConstraintRows rows, SubStep sub, int i, Scratch scratch) {
        int row = rows.list.place[tick.body.guide[i]];
        ConstraintRows guide = window.open(rows, row);
        SingleContact.press(guide, tick.body, sub, window.place(), i, scratch.doubles);
        window.close(rows, row);
    }

    /**
     * End of a sub-step, after its relax pass: the body is put where its closed form leads.
     *
     * @param refresh has the corner's lever
     * @param gain as in {@link #begin}
     * @param i slot of a body with a guide
     */
    public void end(
            SolverContext tick,
            ConstraintRows rows,
            SubStep sub,
            JacobianRefresh refresh,
            double gain,
            int i,
            Scratch scratch) {
        SolverBodies bodies = tick.body;
        int row = rows.list.place[bodies.guide[i]];
        ConstraintRows guide = window.open(rows, row);
        int place = window.place();
        if (refresh.hasRenewedRow(i)
                && (corner.run(tick, guide, rows.rolling, place, i, sub, refresh, row)
                        || rim.run(tick, guide, place, i, sub, refresh, row))) {
            window.close(rows, row);
            return;
        }
        SingleContact.agree(
                guide, rows.rolling, bodies.state, sub, gain, place, row, i, mixing, scratch);
        Motion.keep(tick.bodies, bodies, i);
        EnergyBound.end(tick.bodies, bodies, i, guide, rows.rolling, place, row);
        TrapezoidalCorrection.end(tick.bodies, bodies, i, guide, rows.rolling, place, row, sub);
        if (MotionRecord.hasLanded(bodies, i)) {
            // what a blow has given is no load that goes on
            guide.forget(place);
            Arrays.fill(bodies.warm, (i + 1) * SolverBodies.HALF, (i + 2) * SolverBodies.HALF, 0.0);
            if (rows.rolling.has(row)) {
                rows.rolling.scale(row, 0);
            }
        }
        window.close(rows, row);
    }
}
