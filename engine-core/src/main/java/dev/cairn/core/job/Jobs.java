package dev.cairn.core.job;

import org.jspecify.annotations.Nullable;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.util.Objects;
import java.util.concurrent.locks.LockSupport;

/**
 * Runs the blocks of a stage on the calling thread and its helpers, and returns when all have
 * ended.
 *
 * <p>The caller is worker 0; {@code workers - 1} daemon threads help. With one worker a stage is a
 * plain loop in block order, without atomics. Between {@link #beginTick} and {@link #endTick} the
 * helpers stay awake, so that a stage costs well under a microsecond; between ticks they park and
 * cost nothing. See the package's essay for the protocol.
 *
 * <p><b>Threads.</b> {@link #run}, {@link #beginTick} and {@link #endTick} belong to one thread at
 * a time, the simulation thread; {@link #close} and {@link #workers} may be called by any.
 * <b>Memory.</b> Dispatch does not allocate. <b>Determinism.</b> Which worker runs which block is
 * left to timing; results must depend on the block only.
 *
 * <p>Whoever makes a {@code Jobs} closes it; one that is dropped unclosed keeps its parked threads.
 */
// Threads and jobs are compared as the objects that they are; yields are part of the protocol.
@SuppressWarnings({"ReferenceEquality", "ThreadPriorityCheck"})
public final class Jobs implements AutoCloseable {

    /** Upper bound of the number of workers, the caller included. */
    public static final int MAX_WORKERS = 256;

    /**
     * Claimable units per worker: stages of more blocks hand out runs of consecutive blocks. Box3D
     * measured 32 as the best bound for big parallel loops; it also bounds the claim slots to 4 KiB
     * per worker.
     */
    private static final int UNITS_PER_WORKER = 32;

    /**
     * The caller's spins (some 20 ns each) for a block in work, before it yields its core: 1-2 us.
     */
    private static final int CALLER_SPINS = 64;

    /** A helper's spins for the next stage before it starts to yield: a few microseconds. */
    private static final int HELPER_SPINS = 200;

    /** A helper's yields after the last tick before it parks. */
    private static final int HELPER_YIELDS = 20;

    /** How long {@link #close} waits for all helpers together. */
    private static final long CLOSE_MILLIS = 2_000;

    private static final VarHandle RUNNER;

    static {
        try {
            RUNNER = MethodHandles.lookup().findVarHandle(Jobs.class, "runner", Thread.class);
        } catch (ReflectiveOperationException missing) {
            throw new ExceptionInInitializerError(missing);
        }
    }

    /** Stands where no stage has run yet. */
    private static final BlockJob NOTHING = (block, worker) -> {};

    private final int workers;
    private final int maxUnits;
    private final long[] board;
    private final Helper[] helpers;
    private final Failures failures;
    private final @Nullable Perturbation perturbation;

    // Written by the caller between stages only; a helper reads it after a claim.
    private BlockJob job = NOTHING;

    // The caller's own.
    private long epoch;
    private long helperUnits;
    private int tickDepth;

    /** The thread inside {@code run}, or null. */
    @SuppressWarnings("unused") // through RUNNER
    private @Nullable Thread runner;

    private Jobs(int workers, @Nullable Perturbation perturbation) {
        this.workers = workers;
        this.perturbation = perturbation;
        maxUnits = UNITS_PER_WORKER * workers;
        board = Board.create(workers, maxUnits);
        failures = new Failures(workers);
        helpers = new Helper[workers - 1];
        for (int worker = 1; worker < workers; worker++) {
            helpers[worker - 1] = new Helper(this, worker);
        }
    }

    /**
     * Creates a job system. Starts its helper threads.
     *
     * @param workers number of workers, the caller included, in {@code [1, MAX_WORKERS]}; more than
     *     the processors of the machine is allowed, gives the same results and is slower
     * @return the job system
     * @throws IllegalArgumentException if {@code workers} is out of its range
     */
    public static Jobs of(int workers) {
        return start(new Jobs(checkWorkers(workers), null));
    }

    /**
     * Creates a job system that disturbs its own schedule, for tests: before each claim a worker
     * spins or yields for a time that is drawn from the seed, and units and blocks are taken in
     * reverse. Results that differ from those of {@link #of} depend on timing.
     *
     * @param workers number of workers, the caller included, in {@code [1, MAX_WORKERS]}
     * @param seed seed of the disturbance, any value
     * @return the job system
     * @throws IllegalArgumentException if {@code workers} is out of its range
     */
    public static Jobs perturbed(int workers, long seed) {
        return start(new Jobs(checkWorkers(workers), new Perturbation(workers, seed)));
    }

    /**
     * Number of workers that fits this machine.
     *
     * @return the available processors, at most {@link #MAX_WORKERS}
     */
    public static int defaultWorkers() {
        return Math.clamp(Runtime.getRuntime().availableProcessors(), 1, MAX_WORKERS);
    }

    private static int checkWorkers(int workers) {
        if (workers < 1 || workers > MAX_WORKERS) {
            throw new IllegalArgumentException(
                    "workers is "
                            + workers
                            + ", but must be in [1, "
                            + MAX_WORKERS
                            + "]; Jobs.defaultWorkers() fits this machine");
        }
        return workers;
    }

    private static Jobs start(Jobs jobs) {
        boolean started = false;
        try {
            for (Helper helper : jobs.helpers) {
                helper.start();
            }
            started = true;
        } finally {
            if (!started) { // the system refused a thread; let those that run end
                jobs.close();
            }
        }
        return jobs;
    }

    /**
     * Number of workers. Any thread.
     *
     * @return the number of workers, the caller included
     */
    public int workers() {
        return workers;
    }

    /**
     * Opens a tick: wakes the helpers that are parked, each at most once, and keeps all awake until
     * the matching {@link #endTick}. May be nested; only the outermost pair counts. Put {@code
     * endTick} into a {@code finally}, else the helpers stay awake. Simulation thread; does not
     * allocate.
     */
    public void beginTick() {
        if (tickDepth++ == 0) {
            openTick();
        }
    }

    /**
     * Ends a tick: the helpers park when nothing follows within some microseconds. Without a
     * matching {@link #beginTick} it does nothing. Simulation thread; does not allocate.
     */
    public void endTick() {
        if (tickDepth > 0 && --tickDepth == 0) {
            Board.WORD.setRelease(board, Board.TICK, 0L);
        }
    }

    private void openTick() {
        // Volatile store, then volatile loads: pairs with the reverse order in Helper.park.
        Board.WORD.setVolatile(board, Board.TICK, 1L);
        for (Helper helper : helpers) {
            if ((long) Board.WORD.getVolatile(board, Board.parked(helper.worker)) != 0L) {
                Board.WORD.setVolatile(board, Board.parked(helper.worker), 0L);
                LockSupport.unpark(helper);
            }
        }
    }

    /**
     * Runs every block of a stage exactly once and returns when all have ended.
     *
     * <p>What the caller wrote before is visible to every block, what the blocks wrote is visible
     * to the caller afterwards. At most one block, or one worker, means a plain loop on the caller.
     * The call works outside a tick too, but then wakes the helpers each time.
     *
     * <p><b>Failure.</b> All blocks run, whatever some of them throw. Then the throwable of the
     * lowest failing block is thrown as it is, the same object, with those of the other blocks
     * added as {@linkplain Throwable#addSuppressed suppressed} in block order. So what is thrown
     * does not depend on timing. The helpers live on, and the next stage runs.
     *
     * @param job the work; keep one instance per stage, since a capturing lambda allocates
     * @param blocks number of blocks, at least 0
     * @throws IllegalArgumentException if {@code blocks} is negative
     * @throws IllegalStateException if this job system is closed, if a block of it calls {@code
     *     run}, or if another thread is inside {@code run}
     */
    public void run(BlockJob job, int blocks) {
        Objects.requireNonNull(job, "job");
        if (blocks < 0) {
            throw new IllegalArgumentException("blocks is " + blocks + ", but must be at least 0");
        }
        enter();
        boolean ended = false;
        try {
            if (blocks <= 1 || workers == 1) {
                runBlocks(job, 0, blocks, 0);
            } else if (tickDepth > 0) {
                runStage(job, blocks);
            } else {
                beginTick();
                runStage(job, blocks);
                endTick();
            }
            ended = true;
        } finally {
            if (!ended) { // the stack ended between two blocks: refuse further stages, do not hang
                Board.WORD.setVolatile(board, Board.CLOSED, 1L);
            }
            RUNNER.setRelease(this, null);
        }
        if (failures.any()) {
            throw Jobs.<RuntimeException>asIs(failures.take());
        }
    }

    private void enter() {
        Thread caller = Thread.currentThread();
        if (workers == 1) { // no atomics: a second thread is still found, if not in every race
            if ((Thread) RUNNER.getAcquire(this) == null) {
                RUNNER.setRelease(this, caller);
            } else {
                throw refusal(caller);
            }
        } else if (!RUNNER.compareAndSet(this, null, caller)) {
            throw refusal(caller);
        }
        if (isClosed()) {
            RUNNER.setRelease(this, null);
            throw new IllegalStateException(
                    "this Jobs is closed; make a new one by Jobs.of(" + workers + ")");
        }
    }

    private IllegalStateException refusal(Thread caller) {
        Thread current = (Thread) RUNNER.getAcquire(this);
        if (caller == current || isHelper(caller)) {
            return new IllegalStateException(
                    "run was called inside a block; a stage cannot start another one: return from"
                        + " the block and run the next stage after this one, or use a plain loop");
        }
        return new IllegalStateException(
                "run was called by thread '"
                        + caller.getName()
                        + "' while thread '"
                        + (current == null ? "(just ended)" : current.getName())
                        + "' runs a stage; give each simulation thread a Jobs of its own");
    }

    private boolean isHelper(Thread thread) {
        return thread instanceof Helper helper && helper.jobs == this;
    }

    private void runStage(BlockJob stageJob, int blocks) {
        if (job != stageJob) { // iterations repeat the job; spare the garbage collector's barrier
            job = stageJob;
        }
        int units = Math.min(blocks, maxUnits);
        long stageWord = Board.stageWord(++epoch, units);
        board[Board.BLOCKS] = blocks;
        Board.WORD.setRelease(board, Board.STAGE, stageWord); // pairs with Helper.run's acquire
        int own = claimUnits(stageWord, 0);
        helperUnits += units - own;
        for (int spins = 0; completedByHelpers() != helperUnits; spins++) {
            if (spins < CALLER_SPINS) {
                Thread.onSpinWait();
            } else {
                Thread.yield(); // the helper may wait for this very core
            }
        }
    }

    private long completedByHelpers() {
        long sum = 0;
        for (int worker = 1; worker < workers; worker++) {
            // Pairs with the release in claimUnits.
            sum += (long) Board.WORD.getAcquire(board, Board.completed(worker));
        }
        return sum;
    }

    /** Claims and runs units until none is left; starts at the worker's share, for warm caches. */
    private int claimUnits(long stageWord, int worker) {
        long[] board = this.board;
        int workers = this.workers;
        int units = Board.units(stageWord);
        int first = worker * units / workers;
        int own = 0;
        for (int i = 0; i < units; i++) {
            int unit = first + i < units ? first + i : first + i - units;
            if (perturbation != null) {
                perturbation.disturb(worker);
                unit = units - 1 - unit;
            }
            int claim = Board.claim(workers, unit);
            long seen = (long) Board.WORD.getOpaque(board, claim);
            if (seen > stageWord) {
                break; // this worker was delayed: the stage is over
            }
            if (seen < stageWord && Board.WORD.compareAndSet(board, claim, seen, stageWord)) {
                runUnit(unit, units, worker);
                own++;
                if (worker > 0) { // one writer, so no read-modify-write
                    int completed = Board.completed(worker);
                    Board.WORD.setRelease(board, completed, board[completed] + 1);
                }
            }
        }
        return own;
    }

    /** Runs a claimed unit. The claim proves that the stage is on: plain reads are safe. */
    private void runUnit(int unit, int units, int worker) {
        int blocks = (int) board[Board.BLOCKS];
        BlockJob stageJob = job;
        if (units == blocks) {
            runBlocks(stageJob, unit, unit + 1, worker);
        } else {
            int begin = (int) ((long) unit * blocks / units);
            int end = (int) ((unit + 1L) * blocks / units);
            runBlocks(stageJob, begin, end, worker);
        }
    }

    private void runBlocks(BlockJob stageJob, int begin, int end, int worker) {
        boolean reversed = perturbation != null;
        for (int i = begin; i < end; i++) {
            int block = reversed ? begin + end - 1 - i : i;
            try {
                stageJob.run(block, worker);
            } catch (Throwable thrown) { // any: a stage always runs to its end
                failures.record(worker, block, thrown);
            }
        }
    }

    @SuppressWarnings({
        "unchecked",
        "TypeParameterUnusedInFormals"
    }) // erased: throws the very object, checked or not
    private static <T extends Throwable> T asIs(Throwable thrown) throws T {
        throw (T) thrown;
    }

    private boolean isClosed() {
        return (long) Board.WORD.getVolatile(board, Board.CLOSED) != 0L;
    }

    /**
     * Ends the helpers and waits for them, at most two seconds; a helper whose block does not end
     * is left behind as a daemon thread. A stage that another thread runs meanwhile is finished by
     * that thread. A second call does nothing. Any thread; also inside a block, where it does not
     * wait.
     */
    @Override
    public void close() {
        Board.WORD.setVolatile(board, Board.CLOSED, 1L);
        for (Helper helper : helpers) {
            LockSupport.unpark(helper);
        }
        Thread caller = Thread.currentThread();
        if ((Thread) RUNNER.getAcquire(this) == caller || isHelper(caller)) {
            return;
        }
        long deadline = System.nanoTime() + CLOSE_MILLIS * 1_000_000L;
        try {
            for (Helper helper : helpers) {
                long millis = (deadline - System.nanoTime()) / 1_000_000L;
                if (millis <= 0) {
                    return;
                }
                helper.join(millis);
            }
        } catch (InterruptedException interrupted) {
            caller.interrupt();
        }
    }

    /** A helper: spins for stages within a tick, parks between ticks. */
    private static final class Helper extends Thread {

        final Jobs jobs;
        final int worker;
        private final long[] board;

        Helper(Jobs jobs, int worker) {
            super("cairn-job-" + worker);
            this.jobs = jobs;
            this.worker = worker;
            board = jobs.board;
            setDaemon(true);
        }

        @Override
        public void run() {
            long done = 0;
            int idle = 0;
            while (!jobs.isClosed()) {
                long stageWord = (long) Board.WORD.getAcquire(board, Board.STAGE);
                if (stageWord != done) {
                    jobs.claimUnits(stageWord, worker);
                    done = stageWord;
                    idle = 0;
                } else if (idle < HELPER_SPINS) {
                    idle++;
                    Thread.onSpinWait();
                } else if (idle < HELPER_SPINS + HELPER_YIELDS || tickIsOpen()) {
                    idle++;
                    Thread.yield();
                } else {
                    park();
                    idle = 0;
                }
            }
        }

        private boolean tickIsOpen() {
            return (long) Board.WORD.getVolatile(board, Board.TICK) != 0L;
        }

        private void park() {
            // Volatile store, then volatile loads: pairs with the reverse order in openTick, close.
            // The flag is raised before every look, since the caller lowers it when it wakes us.
            Board.WORD.setVolatile(board, Board.parked(worker), 1L);
            while (!tickIsOpen() && !jobs.isClosed()) {
                interrupted(); // a block may have left it set, and park would return at once
                LockSupport.park(jobs);
                Board.WORD.setVolatile(board, Board.parked(worker), 1L);
            }
            Board.WORD.setVolatile(board, Board.parked(worker), 0L);
        }
    }
}
