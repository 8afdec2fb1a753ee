package dev.cairn.core.job;

import static dev.cairn.core.job.Lines.WORD;

import org.jspecify.annotations.Nullable;

/**
 * One stage after the other: publication, claims, completion. Knows nothing of threads that sleep.
 *
 * <pre>
 *   line                    word 0                         word 1    written by
 *   0                       stage word (epoch, units)      blocks    caller, every stage
 *   1 + worker              units completed, ever                    that helper
 *   1 + workers + unit      stage word of the last claim             whoever claims
 * </pre>
 *
 * The array is made once, never replaced and never reset; every word in it only grows, apart from
 * the number of blocks, which is read under a claim. See the package's essay for the invariants.
 */
final class Stage {

    /**
     * Claimable units per worker: stages of more blocks hand out runs of consecutive blocks. Box3D
     * measured 32 as the best bound for big parallel loops; it also bounds the claim slots to 4 KiB
     * per worker.
     */
    static final int UNITS_PER_WORKER = 32;

    /**
     * The caller's spins (some 20 ns each) for a block in work, before it yields its core: 1-2 us.
     */
    private static final int CALLER_SPINS = 64;

    private static final BlockJob NOTHING = (block, worker) -> {};

    /** Low bits of a stage word, for the number of units; the epoch's 50 bits last for years. */
    private static final int UNIT_BITS = 14;

    private static final int STAGE = Lines.line(0);
    private static final int BLOCKS = STAGE + 1;

    private final int workers;
    private final int maxUnits;
    private final long[] words;
    private final Failures failures;
    private final @Nullable Perturbation perturbation;

    /** Written by the caller between stages only; a helper reads it under a claim. */
    private BlockJob job = NOTHING;

    // The caller's own.
    private long epoch;
    private long helperUnits;

    Stage(int workers, @Nullable Perturbation perturbation) {
        this.workers = workers;
        this.perturbation = perturbation;
        maxUnits = UNITS_PER_WORKER * workers;
        words = Lines.create(1 + workers + maxUnits);
        failures = new Failures(workers);
    }

    private static int completed(int worker) {
        return Lines.line(1 + worker);
    }

    /** What the blocks of the last stage threw; for the caller, after the stage. */
    Failures failures() {
        return failures;
    }

    /** Runs a stage: the caller's whole part. */
    @SuppressWarnings("ThreadPriorityCheck") // the yield is part of the protocol
    void run(BlockJob stageJob, int blocks) {
        long stageWord = publish(stageJob, blocks);
        helperUnits += units(stageWord) - claimUnits(stageWord, 0);
        for (int spins = 0; completedByHelpers() != helperUnits; spins++) {
            if (spins < CALLER_SPINS) {
                Thread.onSpinWait();
            } else {
                Thread.yield(); // the helper may wait for this very core
            }
        }
    }

    @SuppressWarnings("ReferenceEquality") // the very object
    private long publish(BlockJob stageJob, int blocks) {
        if (job != stageJob) { // iterations repeat the job; spare the garbage collector's barrier
            job = stageJob;
        }
        long stageWord = ++epoch << UNIT_BITS | Math.min(blocks, maxUnits);
        words[BLOCKS] = blocks;
        WORD.setRelease(words, STAGE, stageWord); // pairs with published
        return stageWord;
    }

    /**
     * Lets go of the last job: the helpers' threads hold the stage, and a job leads to whoever made
     * it. Caller, between stages; a helper that is late claims nothing any more.
     */
    void forget() {
        job = NOTHING;
    }

    /** The stage word that was published last; what the caller wrote before it is visible. */
    long published() {
        return (long) WORD.getAcquire(words, STAGE); // pairs with publish
    }

    private static int units(long stageWord) {
        return (int) stageWord & (1 << UNIT_BITS) - 1;
    }

    private long completedByHelpers() {
        long sum = 0;
        for (int worker = 1; worker < workers; worker++) {
            sum += (long) WORD.getAcquire(words, completed(worker)); // pairs with claimUnits
        }
        return sum;
    }

    /**
     * Claims and runs units until none is left; starts at the worker's share, for warm caches.
     *
     * @param stageWord what {@link #published} gave, however long ago
     * @return number of units that this worker has run
     */
    int claimUnits(long stageWord, int worker) {
        int units = units(stageWord);
        int first = worker * units / workers;
        int own = 0;
        for (int i = 0; i < units; i++) {
            int unit = first + i < units ? first + i : first + i - units;
            if (perturbation != null) {
                perturbation.disturb(worker);
                unit = units - 1 - unit;
            }
            int claim = Lines.line(1 + workers + unit);
            long seen = (long) WORD.getOpaque(words, claim);
            if (seen > stageWord) {
                break; // this worker was delayed: the stage is over
            }
            if (seen < stageWord && WORD.compareAndSet(words, claim, seen, stageWord)) {
                runUnit(unit, units, worker);
                own++;
                if (worker > 0) { // one writer, so no read-modify-write
                    WORD.setRelease(words, completed(worker), words[completed(worker)] + 1);
                }
            }
        }
        return own;
    }

    /** Runs a claimed unit. The claim proves that the stage is on: plain reads are safe. */
    private void runUnit(int unit, int units, int worker) {
        int blocks = (int) words[BLOCKS];
        if (units == blocks) {
            runBlocks(job, unit, unit + 1, worker);
        } else {
            int begin = (int) ((long) unit * blocks / units);
            int end = (int) ((unit + 1L) * blocks / units);
            runBlocks(job, begin, end, worker);
        }
    }

    /** Runs consecutive blocks on this thread; all of them, whatever some throw. */
    void runBlocks(BlockJob stageJob, int begin, int end, int worker) {
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
}
