package dev.cairn.core.ecs;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Jobs;

/**
 * Systems that may run at the same time: all chunk systems of one depth of the graph, as one stage
 * over the (system, chunk) pairs, or a single world system.
 */
final class Level implements BlockJob {
    private final SystemRunner[] systems;

    /** First block by system; one more entry for the end. */
    private final int[] starts;

    private final Tick[] ticks;
    private final SystemClock clock;
    private final boolean sequential;

    Level(SystemRunner[] systems, Tick[] ticks, SystemClock clock, boolean sequential) {
        this.systems = systems;
        this.starts = new int[systems.length + 1];
        this.ticks = ticks;
        this.clock = clock;
        this.sequential = sequential;
    }

    void run(Jobs jobs) {
        if (systems[0].worldSystem != null) {
            if (systems[0].active) {
                long start = clock.now();
                systems[0].runWorld(ticks[0].bind(systems[0], 0));
                clock.add(systems[0].index, 0, start);
                ticks[0].unbind();
            }
            return;
        }
        int total = 0;
        for (int i = 0; i < systems.length; i++) {
            starts[i] = total;
            total += systems[i].active ? systems[i].chunks.count() : 0;
        }
        starts[systems.length] = total;
        try {
            ticks[0].fork(true);
            if (sequential) {
                runInOrder(total);
            } else {
                jobs.run(this, total);
            }
        } finally {
            ticks[0].fork(false);
        }
    }

    private void runInOrder(int blocks) {
        SystemFailure first = null;
        for (int block = 0; block < blocks; block++) {
            try {
                run(block, 0);
            } catch (SystemFailure failure) {
                if (first == null) {
                    first = failure;
                } else {
                    first.addSuppressed(failure);
                }
            }
        }
        if (first != null) {
            throw first;
        }
    }

    @Override
    public void run(int block, int worker) {
        int i = 0;
        while (block >= starts[i + 1]) {
            i++;
        }
        SystemRunner system = systems[i];
        int chunk = block - starts[i];
        long start = clock.now();
        system.runChunk(chunk, ticks[worker].bind(system, chunk));
        clock.add(system.index, worker, start);
    }
}
