package dev.cairn.physics.solver;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

/**
 * Solves one tick of motion and contact: a sub-stepped soft contact solver in double, wide over the
 * contacts of a colour.
 *
 * <p>Bodies, and the contacts of a colour, run as blocks on the job system; the result depends
 * neither on the number of workers nor on that of lanes. Simulation thread only; allocates only
 * when a store has grown. The package's documentation tells the method and its sources.
 */
public final class ContactSolver {
    private static final int BODIES_PER_BLOCK = 128;
    private static final int ROWS_PER_BLOCK = 256;

    /**
     * Rows of a colour to a block. All workers wait for the last block of each of some hundred
     * passes over colours: small, but some microseconds. A colour of two blocks is left to one.
     */
    private static final int COLOUR_ROWS_PER_BLOCK = 64;

    /** With fewer contacts the scalar sweeps are fast enough, and need no warm-up. */
    private static final int WIDE_FROM = 256;

    /** Contacts times ticks after which a smaller scene pays for the wide sweeps' warm-up. */
    private static final int WORTH_WIDE = 32_768;

    private final Sweeps sweeps;
    private final Sweeps narrow = new ScalarSweeps();
    private final Passes passes;
    private final SolverBodies body;
    private final ConstraintRows rows;
    private final Renewal renewal;
    private final Colouring colouring = new Colouring();
    private final Batches batches = new Batches();
    private final Collector collector = new Collector(colouring, batches);
    private final Impacts impacts = new Impacts();
    private final LoadSweep loads = new LoadSweep();
    private final Unloading unloading = new Unloading();

    private final BlockJob begin = this::begin;
    private final BlockJob prepare = this::prepare;
    private final BlockJob findRenewed = this::findRenewed;
    private final BlockJob kick = this::kick;
    private final BlockJob bias = this::bias;
    private final BlockJob drift = this::drift;
    private final BlockJob relax = this::relax;
    private final BlockJob finish = this::finish;
    private final BlockJob keepBodies = this::keepBodies;
    private final BlockJob takeOut = this::takeOut;
    private final BlockJob renewBodies = this::renewBodies;
    private final BlockJob renewRows = this::renewRows;
    private final BlockJob storeBodies = this::storeBodies;
    private final BlockJob storeRows = this::storeRows;
    private final BlockJob clearRows = this::clearRows;
    private final BlockJob batch = this::batch;

    private boolean renews;
    private boolean unloaded;
    private int substepsBefore;
    private int contactTicks;

    /** The colour in work in lockstep: its places; and the sub-step. */
    private int from;

    private int to;
    private int perBlock;
    private int substep;

    /** The sweeps of this tick, and of the colour in work. */
    private Sweeps chosen = narrow;

    private Sweeps sweep = narrow;
    private double[][] scratch = {};

    /**
     * A solver; one per world.
     *
     * @param settings the tunables
     */
    public ContactSolver(SolverSettings settings) {
        this(settings, Lanes.sweeps(settings.lanes()));
    }

    ContactSolver(SolverSettings settings, Sweeps sweeps) {
        this.sweeps = sweeps;
        passes = new Passes(settings, sweeps.lanes());
        body = passes.body;
        rows = passes.rows;
        renewal = passes.renewal;
    }

    /**
     * The tunables.
     *
     * @return as given
     */
    public SolverSettings settings() {
        return passes.settings;
    }

    /**
     * Changes the number of sub-steps from the next step on. Between steps.
     *
     * @param count 1 to 64
     */
    public void setSubsteps(int count) {
        passes.settings = passes.settings.withSubsteps(count);
    }

    /**
     * Rows that are solved at once.
     *
     * @return 1 (scalar), 4 or 8
     */
    public int lanes() {
        return rows.lanes;
    }

    /**
     * Moves all bodies by one tick.
     *
     * @param bodies poses and velocities, read and written; forces and torques are read
     * @param contacts rows of this tick; impulses are read as warm start and written
     * @param gravityX world, m/s²
     * @param gravityY world, m/s²
     * @param gravityZ world, m/s²
     * @param stepSeconds length of the tick, s, above 0
     * @param jobs runs the loops over bodies and contacts in blocks
     */
    public void step(
            BodyStore bodies,
            ContactStore contacts,
            double gravityX,
            double gravityY,
            double gravityZ,
            double stepSeconds,
            Jobs jobs) {
        Passes p = passes;
        SolverSettings settings = p.settings;
        p.bodies = bodies;
        p.contacts = contacts;
        p.gravity[0] = gravityX;
        p.gravity[1] = gravityY;
        p.gravity[2] = gravityZ;
        timing(stepSeconds);
        body.ensureCapacity(bodies.slotCount);
        boolean stacked = collector.run(bodies, contacts, rows, body.guide, jobs.workers());
        p.order = batches.order;
        unloaded =
                settings.unloadSweeps() > 0
                        && unloading.find(
                                bodies, contacts, rows, p.impulseScale / p.subStep, p.weight());
        p.loaded =
                (settings.loadInertia() > 0 || settings.unloadSweeps() > 0)
                        && loads.run(
                                bodies, contacts, rows, body, p.gravity, p.step, settings, stacked,
                                jobs);
        renewal.ensureCapacity(bodies.slotCount);
        run(begin, Blocks.count(bodies.slotCount, BODIES_PER_BLOCK), jobs);
        if (rows.count > 0) {
            renewal.ensurePlaces(rows);
            ensureScratch(jobs.workers());
            choose();
            if (colouring.firstColour[1] > 0) {
                lockstep(jobs);
            }
            run(batch, batches.count - 1, jobs);
        }
        run(clearRows, Blocks.count(contacts.activeCount, ROWS_PER_BLOCK), jobs);
    }

    /** One block needs no other worker, and no protocol. */
    static void run(BlockJob job, int blocks, Jobs jobs) {
        if (blocks == 1) {
            job.run(0, 0);
        } else {
            jobs.run(job, blocks);
        }
    }

    /** Batch 0: colour after colour, all workers at once. */
    private void lockstep(Jobs jobs) {
        int bodyBlocks = Blocks.count(batches.firstBody[1], BODIES_PER_BLOCK);
        int end = colouring.start[colouring.firstColour[1]];
        colours(prepare, jobs);
        renews = false;
        run(findRenewed, Blocks.count(end, ROWS_PER_BLOCK), jobs);
        for (int k = 0; k < passes.settings.substeps(); k++) {
            substep = k;
            if (rows.bouncing > 0
                    && impacts.run(
                            rows,
                            body,
                            passes.bodies,
                            passes.contacts,
                            passes.gravity,
                            passes.subStep,
                            passes.settings.restitutionThreshold())) {
                ScalarSweeps.separations(rows, body.state);
            }
            run(kick, bodyBlocks, jobs);
            if (unloaded && k == 0) {
                passes.settle(0, end, scratch[0]);
            }
            colours(bias, jobs);
            run(drift, bodyBlocks, jobs);
            if (renews) {
                run(keepBodies, bodyBlocks, jobs);
                colours(takeOut, jobs);
                run(renewBodies, bodyBlocks, jobs);
                colours(renewRows, jobs);
            }
            colours(relax, jobs);
            run(finish, bodyBlocks, jobs);
        }
        run(storeBodies, bodyBlocks, jobs);
        colours(storeRows, jobs);
    }

    /** Runs a job over the rows of one colour after the other, in blocks. */
    private void colours(BlockJob job, Jobs jobs) {
        for (int c = 0; c < colouring.firstColour[1]; c++) {
            from = colouring.start[c];
            to = colouring.start[c + 1];
            sweep = sweeps(c);
            int rowCount = to - from;
            perBlock = rowCount <= 2 * COLOUR_ROWS_PER_BLOCK ? rowCount : COLOUR_ROWS_PER_BLOCK;
            run(job, Blocks.count(rowCount, perBlock), jobs);
        }
    }

    /** A colour of one row is swept by the scalar twin. */
    private Sweeps sweeps(int colour) {
        return colouring.size[colour] > 1 ? chosen : narrow;
    }

    /** The whole tick of a batch: its rows stay in the cache, and nobody waits. */
    private void batch(int block, int worker) {
        Passes p = passes;
        double[] own = scratch[worker];
        int b = block + 1;
        int first = colouring.firstColour[b];
        int last = colouring.firstColour[b + 1];
        int[] start = colouring.start;
        int head = batches.firstBody[b];
        int tail = batches.firstBody[b + 1];
        for (int c = first; c < last; c++) {
            p.prepare(sweeps(c), start[c], start[c + 1], own);
        }
        boolean renewed = p.findRenewed(start[first], start[last]);
        for (int k = 0; k < p.settings.substeps(); k++) {
            p.kick(head, tail);
            if (unloaded && k == 0) {
                p.settle(start[first], start[last], own);
            }
            for (int c = first; c < last; c++) {
                p.bias(sweeps(c), start[c], start[c + 1], own);
            }
            p.drift(head, tail);
            if (renewed) {
                p.keep(head, tail);
                p.takeOut(start[first], start[last]);
                p.renewBodies(head, tail);
                p.renewRows(k, start[first], start[last]);
            }
            for (int c = first; c < last; c++) {
                p.relax(sweeps(c), start[c], start[c + 1], own);
            }
            p.finish(head, tail, own);
        }
        p.storeBodies(head, tail);
        p.storeRows(renewed, start[first], start[last], own);
    }

    private void begin(int block, int worker) {
        int first = Blocks.begin(block, BODIES_PER_BLOCK);
        passes.begin(first, Blocks.end(block, BODIES_PER_BLOCK, passes.bodies.slotCount));
    }

    private int rowsFrom(int block) {
        return from + Blocks.begin(block, perBlock);
    }

    private int rowsTo(int block) {
        return from + Blocks.end(block, perBlock, to - from);
    }

    private int bodiesTo(int block) {
        return Blocks.end(block, BODIES_PER_BLOCK, batches.firstBody[1]);
    }

    private void prepare(int block, int worker) {
        passes.prepare(sweep, rowsFrom(block), rowsTo(block), scratch[worker]);
    }

    private void findRenewed(int block, int worker) {
        int end = Blocks.end(block, ROWS_PER_BLOCK, colouring.start[colouring.firstColour[1]]);
        if (passes.findRenewed(Blocks.begin(block, ROWS_PER_BLOCK), end)) {
            renews = true; // by whoever finds one
        }
    }

    private void bias(int block, int worker) {
        passes.bias(sweep, rowsFrom(block), rowsTo(block), scratch[worker]);
    }

    private void relax(int block, int worker) {
        passes.relax(sweep, rowsFrom(block), rowsTo(block), scratch[worker]);
    }

    private void takeOut(int block, int worker) {
        passes.takeOut(rowsFrom(block), rowsTo(block));
    }

    private void renewRows(int block, int worker) {
        passes.renewRows(substep, rowsFrom(block), rowsTo(block));
    }

    private void storeRows(int block, int worker) {
        passes.storeRows(renews, rowsFrom(block), rowsTo(block), scratch[worker]);
    }

    private void kick(int block, int worker) {
        passes.kick(Blocks.begin(block, BODIES_PER_BLOCK), bodiesTo(block));
    }

    private void drift(int block, int worker) {
        passes.drift(Blocks.begin(block, BODIES_PER_BLOCK), bodiesTo(block));
    }

    private void keepBodies(int block, int worker) {
        passes.keep(Blocks.begin(block, BODIES_PER_BLOCK), bodiesTo(block));
    }

    private void renewBodies(int block, int worker) {
        passes.renewBodies(Blocks.begin(block, BODIES_PER_BLOCK), bodiesTo(block));
    }

    private void finish(int block, int worker) {
        passes.finish(Blocks.begin(block, BODIES_PER_BLOCK), bodiesTo(block), scratch[worker]);
    }

    private void storeBodies(int block, int worker) {
        passes.storeBodies(Blocks.begin(block, BODIES_PER_BLOCK), bodiesTo(block));
    }

    private void clearRows(int block, int worker) {
        int end = Blocks.end(block, ROWS_PER_BLOCK, passes.contacts.activeCount);
        passes.clearRows(Blocks.begin(block, ROWS_PER_BLOCK), end);
    }

    /** Which sweeps are used has no influence on the result. */
    private void choose() {
        chosen = sweeps;
        if (passes.settings.lanes() == 0 && sweeps instanceof WideSweeps wide && !wide.isWarm()) {
            chosen = narrow;
            contactTicks = Math.min(WORTH_WIDE, contactTicks + rows.count);
            if (rows.count >= WIDE_FROM || contactTicks == WORTH_WIDE) {
                wide.begin();
            }
        }
    }

    private void ensureScratch(int workers) {
        if (scratch.length < workers) {
            scratch = new double[workers][];
            for (int i = 0; i < workers; i++) {
                scratch[i] = Scratch.create();
            }
        }
    }

    /**
     * Coefficients that depend on the length of the step; the impulses of a sub-step scale with it.
     */
    private void timing(double stepSeconds) {
        SolverSettings settings = passes.settings;
        if (stepSeconds == passes.step && settings.substeps() == substepsBefore) {
            passes.impulseScale = 1;
            return;
        }
        double h = stepSeconds / settings.substeps();
        double longer = (double) substepsBefore / settings.substeps();
        passes.impulseScale = passes.step == 0 ? 1 : stepSeconds / passes.step * longer;
        substepsBefore = settings.substeps();
        double hertz = settings.hertzPerRate() / h;
        Softness soft = Softness.of(hertz, settings.dampingRatio(), h);
        Softness staticSoft =
                Softness.of(
                        hertz * settings.staticHertzScale(),
                        settings.dampingRatio() * settings.staticDampingScale(),
                        h);
        passes.sub.set(h, soft, staticSoft, settings);
        passes.step = stepSeconds;
        passes.subStep = h;
    }

    /**
     * Tells the colours of the last step, for drawing. Between steps.
     *
     * @param colourOfContact receives the colour of each contact that was solved, in the order in
     *     which colours are solved, at the contact's row; other entries stay as they are; at least
     *     as long as the store had rows
     */
    public void readColours(int[] colourOfContact) {
        for (int b = 0; b < batches.count; b++) {
            for (int c = colouring.firstColour[b]; c < colouring.firstColour[b + 1]; c++) {
                for (int place = colouring.start[c]; place < colouring.start[c + 1]; place++) {
                    int l = place * ConstraintRows.LINK;
                    int row = rows.link[l + ConstraintRows.SOURCE];
                    if (rows.link[l + ConstraintRows.COUNT] > 0 && row < colourOfContact.length) {
                        colourOfContact[row] = c - colouring.firstColour[b];
                    }
                }
            }
        }
    }

    /**
     * Friction impulse of a contact over the last tick, for audits.
     *
     * @param row index among the contacts that have points
     * @param axis 0 to 2 for world x, y, z
     * @return impulse on B, N s
     */
    double totalFriction(int row, int axis) {
        return passes.tangent(rows.base(rows.place[row]), ConstraintRows.TOTAL, axis);
    }
}
