package dev.cairn.physics.solver;

import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.joint.Assemblies;
import dev.cairn.physics.solver.joint.Assembly;
import dev.cairn.physics.solver.joint.AssemblyFlight;
import dev.cairn.physics.solver.refresh.JacobianRefresh;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * What joints do between the passes of the rows, in a sub-step with contacts; each over a range of
 * assemblies.
 *
 * <p>Any worker; an assembly is one worker's at a time. Does not allocate.
 */
final class JointPasses {
    private final SolverContext tick;
    private final ConstraintRows rows;
    private final Assemblies assemblies;
    private final JacobianRefresh refresh;

    /**
     * Passes beside the rows of one precision.
     *
     * @param refresh knows which bodies it gives the root of their inertia
     */
    JointPasses(
            SolverContext tick,
            ConstraintRows rows,
            Assemblies assemblies,
            JacobianRefresh refresh) {
        this.tick = tick;
        this.rows = rows;
        this.assemblies = assemblies;
        this.refresh = refresh;
    }

    /** The begin of a tick, before impacts. */
    void meet(SubStep sub, int from, int to, WorkerScratch local) {
        for (int a = from; a < to; a++) {
            open(sub, a, local);
            local.joints.begin(sub);
        }
    }

    /**
     * Joints' impulses of the last sub-step, for contacts to be swept with.
     *
     * @param index of the sub-step
     * @param from first assembly
     */
    void begin(SubStep sub, int index, int from, int to, WorkerScratch local) {
        for (int a = from; a < to; a++) {
            open(sub, a, local);
            local.joints.account(sub);
            local.joints.warm(index == 0 ? sub.fillScale : 1);
            show(assemblies.at(a));
            local.joints.give(sub, true);
            local.joints.presses(false);
        }
    }

    /** Closes joints at the end of the bias pass. */
    void close(SubStep sub, int from, int to, WorkerScratch local) {
        for (int a = from; a < to; a++) {
            takeOver(assemblies.at(a));
            open(sub, a, local);
            local.joints.presses(true);
            if (assemblies.at(a).isTaut()) {
                local.joints.bear(sub, rows);
                local.swing.cross(tick, sub, assemblies.store, assemblies.at(a));
            } else {
                local.joints.position(sub, rows);
            }
            show(assemblies.at(a));
        }
    }

    /** After the drift: bodies of taut joints come to where smaller steps have led. */
    void place(int from, int to) {
        for (int a = from; a < to; a++) {
            AssemblyFlight.place(tick, assemblies.at(a));
            show(assemblies.at(a));
        }
    }

    /** Gives joints the derivatives of the new poses. */
    void turn(SubStep sub, int from, int to, WorkerScratch local) {
        for (int a = from; a < to; a++) {
            open(sub, a, local);
            local.joints.turn(refresh, sub.seconds);
            boolean counts = !assemblies.at(a).isTaut();
            local.joints.beginVelocity(counts);
            show(assemblies.at(a));
            local.joints.sweeps(false);
        }
    }

    /** Stops what joints do not allow, at the end of the relax pass. */
    void stop(SubStep sub, int from, int to, WorkerScratch local) {
        for (int a = from; a < to; a++) {
            takeOver(assemblies.at(a));
            open(sub, a, local);
            local.joints.sweeps(true);
            local.joints.velocity(sub, !assemblies.at(a).isTaut(), rows);
            local.joints.give(sub, false);
            local.joints.settle();
            show(assemblies.at(a));
        }
    }

    private void open(SubStep sub, int a, WorkerScratch local) {
        local.joints.open(tick, sub, assemblies.store, assemblies.at(a));
    }

    /** Shows the sweeps its bodies as they are now. */
    private void show(Assembly assembly) {
        for (int i : assembly.body) {
            if (rows.isSingle) {
                tick.body.round(i);
            }
        }
    }

    /** Takes over what the sweeps have done to its bodies. */
    private void takeOver(Assembly assembly) {
        for (int i : assembly.body) {
            if (rows.isSingle) {
                tick.body.add(i);
                tick.body.round(i);
            }
            hold(i);
        }
    }

    /** Sweeps do not know locked axes; joints would take what they did there for a movement. */
    private void hold(int i) {
        int locks = tick.bodies.motionFlags[i];
        int o = SolverBodies.offset(i);
        int w = (i + 1) * SolverBodies.HALF;
        for (int c = 0; c < 3; c++) {
            if ((locks >> c & 1) != 0) {
                tick.body.mark[w + c] -= tick.body.state[o + c];
                tick.body.state[o + c] = 0;
            }
        }
    }
}
