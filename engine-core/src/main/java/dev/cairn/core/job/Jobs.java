package dev.cairn.core.job;

import org.jspecify.annotations.Nullable;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.lang.ref.Cleaner;
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
 * <p>Whoever makes a {@code Jobs} closes it. The threads of one that is dropped unclosed end some
 * time after the garbage collector has found it.
 */
// Threads and jobs are compared as the objects that they are; yields are part of the protocol.
@SuppressWarnings({"ReferenceEquality", "ThreadPriorityCheck"})
public final class Jobs implements AutoCloseable {

    /** Upper bound of the number of workers, the caller included. */
    public static final int MAX_WORKERS = 256;

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

    /** Ends the helpers of those that were dropped. */
    private static final Cleaner CLEANER = Cleaner.create();

    private final int workers;
    private final Stage stage;
    private final TickGate gate;
    private final Helper[] helpers;

    /** The caller's own: how many ticks are open, one inside the other. */
    private int tickDepth;

    private final Crew crew;

    /** The thread inside {@code run}, or null. */
    @SuppressWarnings("unused") // through RUNNER
    private @Nullable Thread runner;

    private Jobs(int workers, @Nullable Perturbation perturbation) {
        this.workers = workers;
        stage = new Stage(workers, perturbation);
        gate = new TickGate(workers);
        helpers = new Helper[workers - 1];
        crew = new Crew(stage, gate, helpers);
        crew.limit = workers;
        for (int worker = 1; worker < workers; worker++) {
            helpers[worker - 1] = new Helper(crew, worker);
        }
        if (workers > 1) {
            CLEANER.register(this, crew);
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
     * Lets fewer workers than there are take part, from the next tick on; the results are the same.
     * Simulation thread, between ticks.
     *
     * @param count the caller included, in {@code [1, workers()]}
     * @throws IllegalArgumentException if {@code count} is out of its range
     */
    public void limit(int count) {
        if (count < 1 || count > workers) {
            throw new IllegalArgumentException(
                    "limit is " + count + ", but must be in [1, " + workers + "], the workers");
        }
        crew.limit = count;
    }

    /**
     * How many workers take part. Any thread.
     *
     * @return at most {@link #workers()}
     */
    public int limit() {
        return crew.limit;
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
            gate.end();
            stage.forget();
        }
    }

    private void openTick() {
        gate.open();
        int taking = crew.limit;
        for (Helper helper : helpers) {
            if (helper.worker < taking && gate.takeParked(helper.worker)) {
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
            if (blocks <= 1 || crew.limit == 1) {
                stage.runBlocks(job, 0, blocks, 0);
            } else if (tickDepth > 0) {
                stage.run(job, blocks);
            } else {
                beginTick();
                stage.run(job, blocks);
                endTick();
            }
            ended = true;
        } finally {
            if (!ended) { // the stack ended between two blocks: refuse further stages, do not hang
                gate.close();
            }
            RUNNER.setRelease(this, null);
        }
        if (stage.failures().any()) {
            throw Jobs.<RuntimeException>asIs(stage.failures().take());
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
        if (gate.isClosed()) {
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
        return thread instanceof Helper helper && helper.crew == crew;
    }

    @SuppressWarnings({
        "unchecked",
        "TypeParameterUnusedInFormals"
    }) // erased: throws the very object, checked or not
    private static <T extends Throwable> T asIs(Throwable thrown) throws T {
        throw (T) thrown;
    }

    /**
     * Ends the helpers and waits for them, at most two seconds; a helper whose block does not end
     * is left behind as a daemon thread. A stage that another thread runs meanwhile is finished by
     * that thread. A second call does nothing. Any thread; also inside a block, where it does not
     * wait.
     */
    @Override
    public void close() {
        crew.run();
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

    /**
     * What the helpers share: nothing that leads back to the {@code Jobs}, else one that is dropped
     * would never be found.
     */
    private static final class Crew implements Runnable {
        final Stage stage;
        final TickGate gate;
        private final Helper[] helpers;

        /** Workers that take part; the helpers above it stay parked. */
        volatile int limit;

        Crew(Stage stage, TickGate gate, Helper[] helpers) {
            this.stage = stage;
            this.gate = gate;
            this.helpers = helpers;
        }

        /** Ends the helpers. */
        @Override
        public void run() {
            gate.close();
            for (Helper helper : helpers) {
                LockSupport.unpark(helper);
            }
        }
    }

    /** A helper: spins for stages within a tick, parks between ticks. */
    private static final class Helper extends Thread {

        final Crew crew;
        final int worker;

        Helper(Crew crew, int worker) {
            super("cairn-job-" + worker);
            this.crew = crew;
            this.worker = worker;
            setDaemon(true);
        }

        @Override
        public void run() {
            Stage stage = crew.stage;
            TickGate gate = crew.gate;
            long done = 0;
            int idle = 0;
            while (!gate.isClosed()) {
                long stageWord = stage.published();
                if (stageWord != done) {
                    if (worker < crew.limit) { // one that is not parked yet claims nothing
                        stage.claimUnits(stageWord, worker);
                    }
                    done = stageWord;
                    idle = 0;
                } else if (idle < HELPER_SPINS) {
                    idle++;
                    Thread.onSpinWait();
                } else if (idle < HELPER_SPINS + HELPER_YIELDS || gate.isOpen()) {
                    idle++;
                    Thread.yield();
                } else {
                    while (gate.mayPark(worker)) {
                        interrupted(); // a block may have left it set; park would return at once
                        LockSupport.park(gate);
                    }
                    gate.unparked(worker);
                    idle = 0;
                }
            }
        }
    }
}
