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

    /** With fewer contacts the scalar sweeps are fast enough, and need no warm-up. */
    private static final int WIDE_FROM = 256;

    /** Contacts times ticks after which a smaller scene pays for the wide sweeps' warm-up. */
    private static final int WORTH_WIDE = 32_768;

    /**
     * A point rests while it moves slower than gravity makes a body fall in this share of a tick.
     */
    private static final double STILL = 0.125;

    private final Sweeps sweeps;
    private final Sweeps narrow;
    private final Passes passes;

    /** By effort. */
    private final SubStep[] paces;

    private final SolverBodies body;
    private final ConstraintRows rows;
    private final Renewal renewal;
    private final Colouring colouring = new Colouring();
    private final Batches batches = new Batches();
    private final Collector collector = new Collector(colouring, batches);
    private final Lockstep lockstep;
    private final LoadSweep loads = new LoadSweep();
    private final Unloading unloading = new Unloading();

    private final BlockJob begin = this::begin;
    private final BlockJob clearRows = this::clearRows;
    private final BlockJob batch = this::batch;

    private boolean unloaded;
    private int substepsBefore;
    private int contactTicks;

    /** The sweeps of this tick. */
    private Sweeps chosen;

    private Scratch[] scratch = {};

    /**
     * A solver; one per world.
     *
     * @param settings the tunables
     */
    public ContactSolver(SolverSettings settings) {
        this(settings, Lanes.sweeps(settings.lanes(), settings.single()));
    }

    ContactSolver(SolverSettings settings, Sweeps sweeps) {
        this.sweeps = sweeps;
        narrow = RowSweeps.scalar(settings.single());
        chosen = narrow;
        int lanes = sweeps.lanes();
        passes = new Passes(settings, lanes, lanes == 1 ? 1 : Math.max(lanes, settings.lanes()));
        paces = new SubStep[settings.effort() + 1];
        for (int e = 0; e < paces.length; e++) {
            paces[e] = new SubStep();
        }
        body = passes.body;
        rows = passes.rows;
        renewal = passes.renewal;
        lockstep = new Lockstep(passes, colouring, batches, narrow);
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
     * @return 1 (scalar), 4, 8 or 16
     */
    public int lanes() {
        return rows.group;
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
        boolean stacked =
                collector.run(
                        bodies,
                        contacts,
                        rows,
                        body.guide,
                        jobs.workers(),
                        paces.length - 1,
                        paces[0].sag(p.weight()),
                        jobs);
        p.order = batches.order;
        unloaded =
                settings.unloadSweeps() > 0
                        && unloading.find(
                                bodies,
                                contacts,
                                rows,
                                p.impulseScale / p.subStep,
                                p.weight(),
                                collector.isSame());
        p.loaded =
                (settings.loadInertia() > 0 || settings.unloadSweeps() > 0)
                        && loads.run(
                                bodies,
                                contacts,
                                rows,
                                body,
                                p.gravity,
                                p.step,
                                settings,
                                stacked,
                                collector.isSame(),
                                jobs);
        renewal.ensureCapacity(bodies.slotCount);
        run(begin, Blocks.count(bodies.slotCount, BODIES_PER_BLOCK), jobs);
        if (rows.count > 0) {
            renewal.ensurePlaces(rows);
            ensureScratch(jobs.workers());
            choose();
            for (int e = 0; e < paces.length; e++) {
                int first = colouring.firstColour[batches.lockstep[e]];
                if (colouring.firstColour[batches.lockstep[e + 1]] > first) {
                    lockstep.run(e, paces[e], chosen, unloaded, scratch, jobs);
                }
            }
            run(batch, batches.count - batches.lockstep[paces.length], jobs);
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

    /** A colour of one row is swept by the scalar twin. */
    private Sweeps sweeps(int colour) {
        return colouring.size[colour] > 1 ? chosen : narrow;
    }

    /** The whole tick of a batch: its rows stay in the cache, and nobody waits. */
    private void batch(int block, int worker) {
        Passes p = passes;
        Scratch own = scratch[worker];
        int b = batches.lockstep[paces.length] + block;
        SubStep sub = paces[batches.effort[b]];
        int first = colouring.firstColour[b];
        int last = colouring.firstColour[b + 1];
        int[] start = colouring.start;
        int head = batches.firstBody[b];
        int tail = batches.firstBody[b + 1];
        for (int c = first; c < last; c++) {
            p.prepare(sweeps(c), sub, start[c], start[c + 1], own);
        }
        boolean renewed = p.findRenewed(start[first], start[last]);
        for (int k = 0; k < sub.count; k++) {
            p.kick(sub, head, tail);
            if (unloaded && k == 0) {
                p.settle(sub, start[first], start[last], own);
            }
            for (int c = first; c < last; c++) {
                p.bias(sweeps(c), sub, start[c], start[c + 1], own);
            }
            p.drift(sub, head, tail);
            if (renewed) {
                p.keep(head, tail);
                p.takeOut(start[first], start[last], own);
                p.renewBodies(head, tail);
                p.renewRows(sub, k, start[first], start[last], own);
            }
            for (int c = first; c < last; c++) {
                p.relax(sweeps(c), sub, start[c], start[c + 1], own);
            }
            p.finish(sub, head, tail, own);
        }
        p.storeBodies(head, tail);
        p.storeRows(chosen, sub, renewed, start[first], start[last], own);
    }

    private void begin(int block, int worker) {
        int first = Blocks.begin(block, BODIES_PER_BLOCK);
        passes.begin(first, Blocks.end(block, BODIES_PER_BLOCK, passes.bodies.slotCount));
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
            scratch = new Scratch[workers];
            for (int i = 0; i < workers; i++) {
                scratch[i] = new Scratch(rows.isSingle);
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
        } else {
            double longer = (double) substepsBefore / settings.substeps();
            passes.impulseScale = passes.step == 0 ? 1 : stepSeconds / passes.step * longer;
            substepsBefore = settings.substeps();
            for (int e = 0; e < paces.length; e++) {
                paces[e].set(stepSeconds, e, settings);
            }
            passes.step = stepSeconds;
            passes.subStep = paces[0].seconds;
        }
        for (SubStep sub : paces) {
            sub.fillScale = passes.impulseScale / sub.keepScale;
            sub.still = STILL * passes.weight() * stepSeconds;
        }
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
        RowWindow window = new RowWindow();
        ConstraintRows one = window.open(rows, rows.place[row]);
        return StoreRow.tangent(
                one.doubles, one.base(window.place()), one.lanes, ConstraintRows.TOTAL, axis);
    }
}
