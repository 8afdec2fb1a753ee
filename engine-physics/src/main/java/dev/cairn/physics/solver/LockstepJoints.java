package dev.cairn.physics.solver;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.solver.row.SubStep;

/**
 * The assemblies of bodies and joints in a batch that runs in lockstep, each by one worker. They
 * are solved between the passes of the rows, in which they are one body each, as it were.
 *
 * <p>Simulation thread, but for the blocks.
 */
final class LockstepJoints {
    private final Passes passes;
    private final BlockJob meet = this::meet;
    private final BlockJob begin = this::begin;
    private final BlockJob close = this::close;
    private final BlockJob place = this::place;
    private final BlockJob turn = this::turn;
    private final BlockJob stop = this::stop;

    private SubStep pace = new SubStep();
    private WorkerScratch[] locals = {};
    private int first;
    private int count;
    private int substep;

    LockstepJoints(Passes passes) {
        this.passes = passes;
    }

    /**
     * Those of a tick.
     *
     * @param from the first batch
     * @param to the batch after the last
     * @param pace the sub-steps
     * @param locals by worker
     */
    void of(int from, int to, SubStep pace, WorkerScratch[] locals) {
        this.pace = pace;
        this.locals = locals;
        first = passes.assemblies.first(from);
        count = passes.assemblies.first(to) - first;
    }

    boolean any() {
        return count > 0;
    }

    /** The begin of a tick, before impacts. */
    void meet(int substep, Jobs jobs) {
        if (substep == 0) {
            jobs.run(meet, count);
        }
    }

    /** Before the bias pass of a sub-step. */
    void begin(int ofSubstep, Jobs jobs) {
        substep = ofSubstep;
        jobs.run(begin, count);
    }

    /** After the bias pass. */
    void close(Jobs jobs) {
        jobs.run(close, count);
    }

    /** After the bodies have moved. */
    void place(Jobs jobs) {
        jobs.run(place, count);
    }

    /** Before the relax pass. */
    void turn(Jobs jobs) {
        jobs.run(turn, count);
    }

    /** After the relax pass. */
    void stop(Jobs jobs) {
        jobs.run(stop, count);
    }

    private void begin(int block, int worker) {
        int a = first + block;
        passes.joints.begin(pace, substep, a, a + 1, locals[worker]);
    }

    private void meet(int block, int worker) {
        int a = first + block;
        passes.joints.meet(pace, a, a + 1, locals[worker]);
    }

    private void close(int block, int worker) {
        int a = first + block;
        passes.joints.close(pace, a, a + 1, locals[worker]);
    }

    private void place(int block, int worker) {
        passes.joints.place(first + block, first + block + 1);
    }

    private void turn(int block, int worker) {
        int a = first + block;
        passes.joints.turn(pace, a, a + 1, locals[worker]);
    }

    private void stop(int block, int worker) {
        int a = first + block;
        passes.joints.stop(pace, a, a + 1, locals[worker]);
    }
}
