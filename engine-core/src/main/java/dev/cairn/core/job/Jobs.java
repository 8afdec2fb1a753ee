package dev.cairn.core.job;

/**
 * Fork-join over blocks. The caller is worker 0. First form: every stage runs on the caller.
 */
public final class Jobs implements AutoCloseable {

    /** Upper bound of the number of workers. */
    public static final int MAX_WORKERS = 256;

    private final int workers;
    private boolean running;
    private boolean closed;

    private Jobs(int workers) {
        if (workers < 1 || workers > MAX_WORKERS) {
            throw new IllegalArgumentException(
                    "workers is " + workers + ", but must be in [1, " + MAX_WORKERS + "]");
        }
        this.workers = workers;
    }

    /**
     * Creates a job system.
     *
     * @param workers number of workers, the caller included, in {@code [1, MAX_WORKERS]}
     * @return the job system
     */
    public static Jobs of(int workers) {
        return new Jobs(workers);
    }

    /**
     * Creates a job system that disturbs its own schedule, for tests.
     *
     * @param workers number of workers, the caller included, in {@code [1, MAX_WORKERS]}
     * @param seed seed of the disturbance
     * @return the job system
     */
    public static Jobs perturbed(int workers, long seed) {
        return new Jobs(workers);
    }

    /**
     * Number of workers that fits this machine.
     *
     * @return available processors, at most {@link #MAX_WORKERS}
     */
    public static int defaultWorkers() {
        return Math.clamp(Runtime.getRuntime().availableProcessors(), 1, MAX_WORKERS);
    }

    /**
     * Number of workers.
     *
     * @return workers, the caller included
     */
    public int workers() {
        return workers;
    }

    /** Wakes the helpers for a tick. */
    public void beginTick() {}

    /** Lets the helpers park. */
    public void endTick() {}

    /**
     * Runs every block once and returns when all have ended.
     *
     * @param job the work
     * @param blocks number of blocks, at least 0
     */
    public void run(BlockJob job, int blocks) {
        if (blocks < 0) {
            throw new IllegalArgumentException("blocks is " + blocks + ", but must be at least 0");
        }
        if (closed) {
            throw new IllegalStateException("Jobs is closed");
        }
        if (running) {
            throw new IllegalStateException("run was called inside a block");
        }
        running = true;
        try {
            for (int block = 0; block < blocks; block++) {
                job.run(block, 0);
            }
        } finally {
            running = false;
        }
    }

    @Override
    public void close() {
        closed = true;
    }
}
