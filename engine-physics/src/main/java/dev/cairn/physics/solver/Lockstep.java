package dev.cairn.physics.solver;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.solver.graph.Batches;
import dev.cairn.physics.solver.graph.Colouring;
import dev.cairn.physics.solver.kernel.Sweeps;
import dev.cairn.physics.solver.row.SubStep;

/**
 * The tick of islands that are too large for one worker, by all at once: contacts between domains
 * colour after colour, those within them domain by domain, see {@link Domains}.
 *
 * <p>The bias pass goes over the domains first and over what is between them last, the relax pass
 * the other way round. So nothing comes between the relax pass of a domain and its next bias pass
 * but its own bodies: a worker does both while the rows are in its cache, and right before them
 * renews levers, unless joints look at rows in between. In both, contacts with static bodies have
 * the last word. Where something bounces, or has lost a load, the sub-step begins with work on all
 * of the scene, and the passes are apart.
 *
 * <p>Simulation thread, but for the blocks.
 */
final class Lockstep {
    private static final int BODIES_PER_BLOCK = 128;
    private static final int ROWS_PER_BLOCK = 256;

    private final Passes passes;
    private final Colouring colouring;
    private final Batches batches;
    private final Sweeps narrow;
    private final int kind;

    private final BlockJob prepare = this::prepare;
    private final BlockJob findRenewed = this::findRenewed;
    private final BlockJob within = this::within;
    private final BlockJob kick = this::kick;
    private final BlockJob biasWithin = this::biasWithin;
    private final BlockJob bias = this::bias;
    private final BlockJob drift = this::drift;
    private final BlockJob renewRows = this::renewRows;
    private final BlockJob renewWithin = this::renewWithin;
    private final BlockJob relax = this::relax;
    private final BlockJob storeRows = this::storeRows;
    private final BlockJob directSoft = this::directSoft;
    private final BlockJob directHard = this::directHard;
    private final BlockJob fixedWithin = this::fixedWithin;
    private final BlockJob lookBack = this::lookBack;
    private final BlockJob relaxWithin = this::relaxWithin;

    private Sweeps chosen;
    private WorkerScratch[] locals = {};
    private boolean renews;
    private boolean settles;
    private boolean rides;

    /** Whether light bodies touch heavy ones. */
    private boolean squeezes;

    private int domains;

    /** Whether a contact has restitution, one of two balls, and one may meet in this sub-step. */
    private boolean bounces, balls, meets;

    /** With bodies that joints hold together no passes run as one. */
    private final LockstepJoints joints;

    /** Whether the sub-step that comes begins with work on all rows. */
    private boolean apart;

    /** The batch in lockstep, and its sub-steps. */
    private int base;

    private SubStep pace = new SubStep();

    /** Sub-steps of which the relax pass is done or due. */
    private int substep;

    /** The colour in work: its kind of constraint, places and sweeps. */
    private int from;

    private int to;
    private int perBlock;
    private Sweeps sweep;
    private int rowKind;

    /**
     * Lockstep of the rows of one precision.
     *
     * @param kind of rows, see {@link Batches}
     */
    Lockstep(Passes passes, Colouring colouring, Batches batches, Sweeps narrow, int kind) {
        this.kind = kind;
        this.passes = passes;
        joints = new LockstepJoints(passes);
        this.colouring = colouring;
        this.batches = batches;
        this.narrow = narrow;
        chosen = narrow;
        sweep = narrow;
    }

    /**
     * Runs the tick of a batch in lockstep and of its domains.
     *
     * @param pace its sub-steps
     * @param chosen sweeps of this tick
     * @param settles whether warm starts are corrected first, see {@link Passes#settle}
     * @param rides whether some rows are of riders, see {@link Passes#ride}
     * @param locals by worker
     */
    void run(
            SubStep pace,
            Sweeps chosen,
            boolean settles,
            boolean rides,
            WorkerScratch[] locals,
            Jobs jobs) {
        this.pace = pace;
        this.chosen = chosen;
        this.locals = locals;
        this.settles = settles;
        this.rides = rides;
        base = batches.lockstep(kind);
        domains = batches.alone(kind) - base - 1;
        if (isEmpty()) {
            return;
        }
        joints.of(base, base + 1 + domains, pace, locals);
        int alone = batches.firstBody[base + 1] - batches.firstBody[base];
        int bodies = batches.firstBody[base + 1 + domains] - batches.firstBody[base];
        int bodyBlocks = Blocks.count(bodies, BODIES_PER_BLOCK);
        int parts = domains + Blocks.count(alone, BODIES_PER_BLOCK);
        renews = false;
        colours(prepare, jobs);
        jobs.run(findRenewed, Blocks.count(endPlace(-1) - firstPlace(-1), ROWS_PER_BLOCK));
        squeezes = passes.warmStarts.isNeeded(firstPlace(-1), endPlace(domains - 1));
        substep = 0;
        passes.paceSides(pace, substep, base);
        bounces = passes.bouncing.to(base) > passes.bouncing.from(base);
        balls = bounces && passes.hasBalls(base);
        if (bounces) {
            passes.limit(pace, firstBody(), endBody());
        }
        look();
        jobs.run(within, parts);
        while (substep < pace.count) {
            if (apart) {
                begin(bodyBlocks, jobs);
            }
            colours(bias, jobs);
            direct(true, jobs);
            if (joints.any()) {
                jobs.run(fixedWithin, domains);
                joints.close(jobs);
            }
            passes.carry(pace, base, locals[0]);
            passes.moveSides(pace, base);
            jobs.run(drift, parts);
            if (joints.any()) {
                joints.place(jobs);
                jobs.run(lookBack, bodyBlocks);
                if (renews) {
                    colours(renewRows, colouring.firstContact[base], jobs);
                    jobs.run(renewWithin, domains);
                }
            }
            joints.turn(jobs);
            colours(relax, jobs);
            direct(false, jobs);
            if (joints.any()) {
                jobs.run(relaxWithin, domains);
                joints.stop(jobs);
            }
            substep++;
            passes.paceSides(pace, substep, base);
            look();
            jobs.run(within, parts);
        }
        colours(storeRows, jobs);
        for (int d = 0; d < direct(); d++) {
            passes.learn(pace, base, d, locals[0]);
        }
        locals[0].impacts.report();
    }

    private boolean isEmpty() {
        return colouring.firstColour[base + 1 + domains] == colouring.firstColour[base];
    }

    /** Finds whether the next sub-step begins with work on all rows. */
    private void look() {
        meets = balls || (bounces && passes.isFast(firstBody(), endBody()));
        apart = meets || joints.any() || rides || (substep == 0 && (settles || squeezes));
    }

    private int firstBody() {
        return batches.firstBody[base];
    }

    private int endBody() {
        return batches.firstBody[base + 1 + domains];
    }

    private void begin(int bodyBlocks, Jobs jobs) {
        Passes p = passes;
        joints.meet(substep, jobs);
        int first = firstPlace(-1);
        int end = endPlace(domains - 1);
        if (meets) {
            p.impacts(pace, base, firstBody(), endBody(), first, end, locals[0]);
        }
        if (substep == 0) {
            p.warmStarts.limit(firstBody(), endBody(), first, end, locals[0].renew);
        }
        jobs.run(kick, bodyBlocks);
        if (settles && substep == 0) {
            p.settle(pace, first, end, locals[0]);
        }
        if (rides) {
            p.ride(pace, substep, first, end, locals[0]);
        }
        joints.begin(substep, jobs);
        jobs.run(biasWithin, domains);
    }

    /** Runs a job over the rows of one colour after the other, in blocks. */
    private void colours(BlockJob job, Jobs jobs) {
        colours(job, colouring.firstColour[base], jobs);
    }

    private void colours(BlockJob job, int first, Jobs jobs) {
        int last = colouring.firstColour[base + 1];
        for (int c = first; c < last; c++) {
            from = colouring.start[c];
            to = colouring.end[c];
            rowKind = colouring.kind[c];
            sweep = sweeps(c);
            int rowCount = to - from;
            perBlock = Colouring.perBlock(rowCount, jobs.workers());
            jobs.run(job, Blocks.count(rowCount, perBlock));
        }
    }

    /** The islands of the batch that are solved directly; none of them has domains. */
    private void direct(boolean soft, Jobs jobs) {
        int islands = direct();
        if (islands > 0) {
            jobs.run(soft ? directSoft : directHard, islands);
        }
    }

    /** How many there are of them. */
    private int direct() {
        return kind == Batches.DOUBLES ? passes.direct.openIn(base) : 0;
    }

    private void directSoft(int block, int worker) {
        passes.direct(pace, base, block, true, locals[worker]);
    }

    private void directHard(int block, int worker) {
        passes.direct(pace, base, block, false, locals[worker]);
    }

    /** A colour of one row is swept by the scalar twin. */
    private Sweeps sweeps(int colour) {
        return colouring.size[colour] > 1 ? chosen : narrow;
    }

    /** From the relax pass of one sub-step to the bias pass of the next: a domain, or bodies. */
    private void within(int block, int worker) {
        if (block >= domains) {
            alone(block - domains, worker);
            return;
        }
        Passes p = passes;
        WorkerScratch own = locals[worker];
        // to and fro: the domains of the end of the last pass are still in the third cache
        int domain = substep % 2 == 0 ? block : domains - 1 - block;
        int b = base + 1 + domain;
        int first = colouring.firstColour[b];
        int last = colouring.firstColour[b + 1];
        int[] start = colouring.start;
        int[] end = colouring.end;
        int head = batches.firstBody[b];
        int tail = batches.firstBody[b + 1];
        if (substep == 0) {
            for (int c = first; c < last; c++) {
                p.prepare(colouring.kind[c], sweeps(c), pace, start[c], end[c], own);
            }
            int from = firstPlace(domain);
            if (p.findRenewed(pace, head, tail, from, endPlace(domain), own)) {
                renews = true; // by whoever finds one
            }
        } else {
            if (!joints.any()) {
                if (renews) {
                    renew(firstPlace(domain), endPlace(domain), substep - 1, worker);
                }
                relaxWithin(domain, worker);
            }
            p.finish(pace, head, tail, own);
        }
        p.paceSides(pace, substep, b);
        if (substep == pace.count) {
            p.storeBodies(head, tail);
            p.storeRows(chosen, pace, renews, firstPlace(domain), endPlace(domain), own);
            storeKinds(b);
        } else if (!apart) {
            p.kick(pace, substep, head, tail, own);
            biasWithin(domain, worker);
        }
    }

    /** The same for bodies that are in no domain. */
    private void alone(int block, int worker) {
        int head = bodiesFrom(block);
        int tail = aloneTo(block);
        if (substep > 0) {
            passes.finish(pace, head, tail, locals[worker]);
        }
        if (substep == pace.count) {
            passes.storeBodies(head, tail);
        } else if (!apart) {
            passes.kick(pace, substep, head, tail, locals[worker]);
        }
    }

    /** What moves on what moves; the rest waits for the contacts between domains. */
    private void biasWithin(int block, int worker) {
        int b = base + 1 + block;
        for (int c = colouring.firstColour[b]; c < colouring.firstFixed[b]; c++) {
            bias(c, worker, passes);
        }
    }

    private void drift(int block, int worker) {
        if (block >= domains) {
            driftBodies(bodiesFrom(block - domains), aloneTo(block - domains));
            return;
        }
        int b = base + 1 + block;
        if (!joints.any()) {
            fixedWithin(block, worker);
        }
        passes.carry(pace, b, locals[worker]);
        driftBodies(batches.firstBody[b], batches.firstBody[b + 1]);
        passes.moveSides(pace, b);
    }

    private void fixedWithin(int block, int worker) {
        int b = base + 1 + block;
        for (int c = colouring.firstFixed[b]; c < colouring.firstColour[b + 1]; c++) {
            bias(c, worker, passes);
        }
    }

    private void relaxWithin(int block, int worker) {
        int b = base + 1 + block;
        for (int c = colouring.firstColour[b]; c < colouring.firstColour[b + 1]; c++) {
            passes.relax(
                    colouring.kind[c],
                    sweeps(c),
                    pace,
                    colouring.start[c],
                    colouring.end[c],
                    locals[worker]);
        }
    }

    private void driftBodies(int head, int tail) {
        passes.drift(pace, head, tail, false);
        if (!joints.any()) {
            lookBackAt(head, tail);
        }
    }

    private void lookBack(int block, int worker) {
        lookBackAt(bodiesFrom(block), bodiesTo(block));
    }

    private void lookBackAt(int head, int tail) {
        if (bounces) {
            passes.limit(pace, head, tail);
        }
        if (renews) {
            passes.keep(head, tail);
            passes.renewBodies(pace, head, tail);
        }
    }

    private void bias(int colour, int worker, Passes p) {
        p.bias(
                colouring.kind[colour],
                sweeps(colour),
                pace,
                colouring.start[colour],
                colouring.end[colour],
                locals[worker]);
    }

    private void storeKinds(int batch) {
        for (int c = colouring.firstColour[batch]; c < colouring.firstContact[batch]; c++) {
            passes.storeKind(colouring.kind[c], pace, colouring.start[c], colouring.end[c]);
        }
    }

    private int rowsFrom(int block) {
        return from + Blocks.begin(block, perBlock);
    }

    private int rowsTo(int block) {
        return from + Blocks.end(block, perBlock, to - from);
    }

    /** First body of a block, be it of all bodies or of those in no domain. */
    private int bodiesFrom(int block) {
        return firstBody() + Blocks.begin(block, BODIES_PER_BLOCK);
    }

    private int bodiesTo(int block) {
        return bodiesTo(block, endBody());
    }

    private int bodiesTo(int block, int end) {
        return firstBody() + Blocks.end(block, BODIES_PER_BLOCK, end - firstBody());
    }

    /** The same of bodies in no domain. */
    private int aloneTo(int block) {
        return bodiesTo(block, batches.firstBody[base + 1]);
    }

    /** Of the contacts of a domain; that of -1 is the batch in lockstep. */
    private int firstPlace(int domain) {
        return colouring.firstPlace[base + 1 + domain];
    }

    private int endPlace(int domain) {
        return colouring.endPlace[base + 1 + domain];
    }

    private void prepare(int block, int worker) {
        passes.prepare(rowKind, sweep, pace, rowsFrom(block), rowsTo(block), locals[worker]);
    }

    private void findRenewed(int block, int worker) {
        int first = firstPlace(-1);
        int end = first + Blocks.end(block, ROWS_PER_BLOCK, endPlace(-1) - first);
        int begin = first + Blocks.begin(block, ROWS_PER_BLOCK);
        if (passes.findRenewed(pace, begin, end, locals[worker])) {
            renews = true; // by whoever finds one
        }
    }

    private void kick(int block, int worker) {
        passes.kick(pace, substep, bodiesFrom(block), bodiesTo(block), locals[worker]);
    }

    private void bias(int block, int worker) {
        passes.bias(rowKind, sweep, pace, rowsFrom(block), rowsTo(block), locals[worker]);
    }

    private void relax(int block, int worker) {
        // while they are in the cache; joints look at them in between
        if (renews && rowKind == 0 && !joints.any()) {
            renewRows(block, worker);
        }
        passes.relax(rowKind, sweep, pace, rowsFrom(block), rowsTo(block), locals[worker]);
    }

    private void renewRows(int block, int worker) {
        renew(rowsFrom(block), rowsTo(block), substep, worker);
    }

    private void renewWithin(int block, int worker) {
        renew(firstPlace(block), endPlace(block), substep, worker);
    }

    private void renew(int first, int end, int ofSubstep, int worker) {
        assert ofSubstep < pace.count : ofSubstep;
        passes.renewRows(pace, ofSubstep, first, end, locals[worker]);
    }

    private void storeRows(int block, int worker) {
        if (rowKind > 0) {
            passes.storeKind(rowKind, pace, rowsFrom(block), rowsTo(block));
            return;
        }
        passes.storeRows(chosen, pace, renews, rowsFrom(block), rowsTo(block), locals[worker]);
    }
}
