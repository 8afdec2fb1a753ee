package dev.cairn.physics.solver;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.Motion;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.graph.Batches;
import dev.cairn.physics.solver.graph.Collector;
import dev.cairn.physics.solver.graph.Colouring;
import dev.cairn.physics.solver.joint.Assemblies;
import dev.cairn.physics.solver.kernel.RowSweeps;
import dev.cairn.physics.solver.kernel.StoreRow;
import dev.cairn.physics.solver.kernel.Sweeps;
import dev.cairn.physics.solver.load.LoadSweep;
import dev.cairn.physics.solver.row.ConstraintKind;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.solver.row.RowWindow;
import dev.cairn.physics.solver.row.SoftnessStep;
import dev.cairn.physics.solver.row.SubStep;
import dev.cairn.physics.solver.wide.Lanes;
import dev.cairn.physics.solver.wide.WideSweeps;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import java.util.function.IntPredicate;

/**
 * Solves one tick of motion and contact: a sub-stepped soft contact solver, wide over the contacts
 * of a colour, in floats for large islands and in doubles for small ones.
 *
 * <p>Bodies, and the contacts of a colour, run as blocks on the job system; the result depends
 * neither on the number of workers nor on that of lanes. Simulation thread only; allocates only
 * when a store has grown. The package's documentation tells the method and its sources.
 */
public final class ContactSolver {
    private static final int BODIES_PER_BLOCK = 128;
    private static final int ROWS_PER_BLOCK = 256;

    /**
     * Contacts times ticks after which a scene is worth the wide sweeps' warm-up. A tick counts for
     * at most a tenth of it: a large scene's scalar code shall be compiled before, and is after ten
     * ticks of thousands of contacts.
     */
    private static final int WORTH_WIDE = 32_768;

    /**
     * A point touches up to a gap of this share of {@code g h²}: a body that has landed lies at a
     * gap of 0 but for rounding, and whether it is soft or hard there must not hang on that.
     */
    private static final double TOUCH = 1e-9;

    /** See {@link SubStep#closing}: share of what gravity adds to a speed in a tick. */
    private static final double CLOSING = 1e-12;

    /** By kind of rows, see {@link Batches}: the sweeps, the scalar ones, those of this tick. */
    private final Sweeps[] sweeps;

    private final Sweeps[] narrow = {RowSweeps.scalar(true), RowSweeps.scalar(false)};
    private final Sweeps[] chosen = narrow.clone();
    private final Passes[] passes = new Passes[2];
    private final Lockstep[] lockstep = new Lockstep[2];

    private final SubStep sub = new SubStep();
    private final SolverContext tick;
    private final EdgeList list;
    private final Colouring colouring = new Colouring();
    private final Batches batches = new Batches();
    private final Collector collector;
    private final Assemblies assemblies;
    private final SupportAnalysis supports;

    private final BlockJob begin = this::begin;
    private final BlockJob clearRows = this::clearRows;
    private final BlockJob batch = this::batch;
    private final IntPredicate turns = this::turns;

    private final IslandEnergy energy = new IslandEnergy();
    private final SoftnessStep softnessStep = new SoftnessStep();
    private int substepsBefore;

    /** By kind: rows that its wide sweeps would have taken, summed over ticks. */
    private final int[] wanted = new int[2];

    /** Of the batches that one worker has alone. */
    private int kind;

    private WorkerScratch[] locals = {};

    /**
     * A solver; one per world.
     *
     * @param settings the tunables
     * @param kinds of constraints beside contacts, in the order in which they are solved
     */
    public ContactSolver(Tuning settings, ConstraintKind... kinds) {
        this(
                settings,
                Lanes.sweeps(
                        settings.count(Tunable.LANES),
                        true,
                        settings.count(Tunable.FLOATS_FROM) == 0),
                Lanes.sweeps(
                        settings.count(Tunable.LANES),
                        false,
                        settings.count(Tunable.FLOATS_FROM) > 0),
                kinds);
    }

    ContactSolver(Tuning settings, Sweeps floats, Sweeps doubles, ConstraintKind... kinds) {
        sweeps = new Sweeps[] {floats, doubles};
        tick = new SolverContext(settings);
        boolean guides = settings.count(Tunable.LONE_SWEEPS) > 0;
        list =
                new EdgeList(
                        floats.lanes(),
                        group(floats.lanes(), settings),
                        doubles.lanes(),
                        group(doubles.lanes(), settings),
                        kinds);
        assemblies = new Assemblies(list);
        collector = new Collector(colouring, batches, assemblies, guides);
        supports = new SupportAnalysis(list, batches, collector);
        for (int k = 0; k < 2; k++) {
            passes[k] =
                    new Passes(
                            tick,
                            k == Batches.FLOATS ? list.floats : list.doubles,
                            collector.bouncing,
                            collector.sides,
                            supports,
                            assemblies);
            lockstep[k] = new Lockstep(passes[k], colouring, batches, narrow[k], k);
        }
    }

    private static int group(int lanes, Tuning settings) {
        return lanes == 1 ? 1 : Math.max(lanes, settings.count(Tunable.LANES));
    }

    /**
     * The tunables.
     *
     * @return as given
     */
    public Tuning settings() {
        return tick.settings;
    }

    /**
     * Changes the number of sub-steps from the next step on. Between steps.
     *
     * @param count 1 to 64
     */
    public void setSubsteps(int count) {
        tick.settings = tick.settings.with(Tunable.SUBSTEPS, count);
    }

    /**
     * Rows that are solved at once.
     *
     * @return 1 (scalar), 4, 8 or 16; those of floats, if all are
     */
    public int lanes() {
        return tick.settings.count(Tunable.FLOATS_FROM) == 0
                ? list.floats.group
                : list.doubles.group;
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
        tick.bodies = bodies;
        tick.contacts = contacts;
        tick.gravity[0] = gravityX;
        tick.gravity[1] = gravityY;
        tick.gravity[2] = gravityZ;
        timing(stepSeconds);
        tick.body.ensureCapacity(bodies.slotCount);
        ensureBenches(jobs.workers());
        collector.frames.enter(bodies, contacts, list);
        boolean stacked =
                collector.run(
                        bodies,
                        contacts,
                        list,
                        tick.body.guide,
                        jobs.workers(),
                        tick.settings.count(Tunable.FLOATS_FROM),
                        jobs);
        tick.order = batches.order;
        tick.hasLight = collector.hasLight();
        supports.find(tick, stacked, softnessStep.seconds(), locals, jobs);
        for (int k = Batches.FLOATS; k <= Batches.DOUBLES; k++) {
            if (list.count > 0 && batches.hasBodies(k)) {
                passes[k].ensureCapacity(bodies.slotCount);
            }
        }
        if (collector.sides.count() > 0) {
            tick.body.ensureCapacity(bodies.slotCount + collector.sides.count());
        }
        collector.sides.load(bodies, tick.body, contacts, list.source, list.contacts);
        jobs.run(begin, Blocks.count(bodies.slotCount, BODIES_PER_BLOCK));
        if (list.count > 0) {
            energy.find(tick, batches, list, collector.sides, turns);
            for (kind = Batches.FLOATS; kind <= Batches.DOUBLES; kind++) {
                choose();
                lockstep[kind].run(
                        sub, chosen[kind], supports.settles, supports.riders.found, locals, jobs);
                jobs.run(batch, batches.end(kind) - batches.alone(kind));
            }
        }
        jobs.run(clearRows, Blocks.count(contacts.activeCount, ROWS_PER_BLOCK));
        collector.frames.leave(stepSeconds);
    }

    private boolean turns(int slot) {
        boolean moves = tick.bodies.kind[slot] == BodyStore.DYNAMIC;
        return moves && passes[batches.kindOf(slot)].turns(slot);
    }

    /** A colour of one row is swept by the scalar twin. */
    private Sweeps sweeps(int colour) {
        return colouring.size[colour] > 1 ? chosen[kind] : narrow[kind];
    }

    /** The whole tick of a batch: its rows stay in the cache, and no worker waits. */
    private void batch(int block, int worker) {
        Passes p = passes[kind];
        WorkerScratch own = locals[worker];
        int b = batches.alone(kind) + block;
        if (batches.isSwinging(b)) {
            p.swing(sub, b, batches.firstBody[b], batches.firstBody[b + 1], own);
            return;
        }
        int first = colouring.firstColour[b];
        int last = colouring.firstColour[b + 1];
        int firstJoined = assemblies.first(b);
        int endJoined = assemblies.first(b + 1);
        int[] start = colouring.start;
        int[] end = colouring.end;
        int head = batches.firstBody[b];
        int tail = batches.firstBody[b + 1];
        int from = colouring.firstPlace[b];
        int to = colouring.endPlace[b];
        for (int c = first; c < last; c++) {
            p.prepare(colouring.kind[c], sweeps(c), sub, start[c], end[c], own);
        }
        boolean renewed = p.findRenewed(sub, head, tail, from, to, own);
        boolean small = batches.isSmall(b);
        if (small) {
            p.lookAtCores(from, to);
        }
        boolean bounces = collector.bouncing.to(b) > collector.bouncing.from(b);
        boolean balls = bounces && p.hasBalls(b);
        if (bounces) {
            p.limit(sub, head, tail);
        }
        p.joints.meet(sub, firstJoined, endJoined, own);
        for (int k = 0; k < sub.count; k++) {
            p.paceSides(sub, k, b);
            if (balls || (bounces && p.isFast(head, tail))) {
                p.impacts(sub, b, head, tail, from, to, own);
            }
            if (k == 0) {
                p.warmStarts.limit(head, tail, from, to, own.renew);
            }
            p.kick(sub, k, head, tail, own);
            if (supports.settles && k == 0) {
                p.settle(sub, from, to, own);
            }
            if (supports.riders.found) {
                p.ride(sub, k, from, to, own);
            }
            p.joints.begin(sub, k, firstJoined, endJoined, own);
            for (int c = first; c < last; c++) {
                p.bias(colouring.kind[c], sweeps(c), sub, start[c], end[c], own);
            }
            p.joints.close(sub, firstJoined, endJoined, own);
            for (int d = 0; d < supports.direct.openIn(b); d++) {
                p.direct(sub, b, d, true, own);
            }
            p.press(sub, head, tail, own);
            if (small) {
                p.guard(sub, from, to);
            }
            p.carry(sub, b, own);
            boolean paced = small && tick.body.boundsEnergy;
            if (paced) {
                energy.pace(tick, sub, assemblies, b, head, tail);
            }
            p.drift(sub, head, tail, paced);
            p.joints.place(firstJoined, endJoined);
            p.moveSides(sub, b);
            if (bounces && k + 1 < sub.count) {
                p.limit(sub, head, tail);
            }
            if (renewed) {
                p.keep(head, tail);
                p.renewBodies(sub, head, tail);
                p.renewRows(sub, k, from, to, own);
            }
            p.joints.turn(sub, firstJoined, endJoined, own);
            for (int c = first; c < last; c++) {
                p.relax(colouring.kind[c], sweeps(c), sub, start[c], end[c], own);
            }
            for (int d = 0; d < supports.direct.openIn(b); d++) {
                p.direct(sub, b, d, false, own);
            }
            p.joints.stop(sub, firstJoined, endJoined, own);
            p.finish(sub, head, tail, own);
            if (small && tick.body.boundsEnergy) {
                energy.bound(tick, assemblies, b, head, tail, own);
            }
        }
        p.storeBodies(head, tail);
        p.storeRows(chosen[kind], sub, renewed, from, to, own);
        for (int c = first; c < colouring.firstContact[b]; c++) {
            p.storeKind(colouring.kind[c], sub, start[c], end[c]);
        }
        own.impacts.report();
        for (int d = 0; d < supports.direct.openIn(b); d++) {
            p.learn(sub, b, d, own);
        }
    }

    /** Flies the bodies without contacts, loads the others. */
    private void begin(int block, int worker) {
        SolverContext t = tick;
        BodyStore b = t.bodies;
        double[] g = t.gravity;
        double weight = t.weight();
        int end = Blocks.end(block, BODIES_PER_BLOCK, b.slotCount);
        int substeps = t.settings.count(Tunable.SUBSTEPS);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            b.pressed[i] = 0;
            b.pressing[i] = 0;
            if (b.kind[i] != BodyStore.DYNAMIC) {
                continue;
            }
            if (!t.loaded) {
                LoadSweep.leave(b, i);
            }
            t.body.axes.update(b, i);
            if (t.body.guide[i] == SolverBodies.FREE) {
                Motion.fly(b, t.body, i, g[0], g[1], g[2], t.step, substeps);
            } else {
                passes[batches.kindOf(i)].load(i, weight);
            }
        }
    }

    /** Contacts without points have no impulses. */
    private void clearRows(int block, int worker) {
        ContactStore c = tick.contacts;
        int end = Blocks.end(block, ROWS_PER_BLOCK, c.activeCount);
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = c.active[i];
            if (c.pointCount[row] == 0) {
                c.forgetFriction(row);
            }
        }
    }

    /** Which sweeps are used has no influence on the result. */
    private void choose() {
        int k = kind;
        chosen[k] = sweeps[k];
        if (passes[k].rows.places > 0 && sweeps[k] instanceof WideSweeps wide && !wide.isWarm()) {
            chosen[k] = narrow[k];
            // Not places: how many there are depends on the lanes.
            wanted[k] += Math.min(WORTH_WIDE / 10, batches.rows(k));
            if (tick.settings.count(Tunable.LANES) != 0
                    && k == Batches.FLOATS
                    && settings().count(Tunable.FLOATS_FROM) > 0) {
                wide.finish();
                chosen[k] = wide;
            } else if (wanted[k] >= WORTH_WIDE) {
                wide.begin();
            }
        }
    }

    private void ensureBenches(int workers) {
        if (locals.length < workers) {
            locals = new WorkerScratch[workers];
            for (int i = 0; i < workers; i++) {
                locals[i] = new WorkerScratch();
            }
        }
    }

    /** Coefficients by the length of the step, with which the impulses of a sub-step scale. */
    private void timing(double stepSeconds) {
        Tuning settings = tick.settings;
        int substeps = settings.count(Tunable.SUBSTEPS);
        tick.softScale =
                softnessStep.next(stepSeconds / substeps, stepSeconds, substeps != substepsBefore);
        if (stepSeconds == tick.step && substeps == substepsBefore && tick.softScale == 1) {
            tick.impulseScale = 1;
        } else {
            double longer = (double) substepsBefore / substeps;
            tick.impulseScale = tick.step == 0 ? 1 : stepSeconds / tick.step * longer;
            substepsBefore = substeps;
            sub.set(stepSeconds, softnessStep.seconds(), settings);
            tick.step = stepSeconds;
            tick.subStep = sub.seconds;
        }
        if (tick.impulseScale != 1) {
            tick.contacts.beginUneven();
        }
        sub.fillScale = tick.impulseScale;
        sub.setUp(tick.gravity, tick.weight());
        sub.still = SupportAnalysis.STILL * tick.weight() * stepSeconds;
        sub.closing = CLOSING * tick.weight() * stepSeconds;
        sub.touch = TOUCH * tick.weight() * sub.seconds * sub.seconds;
    }

    /**
     * What lasts from tick to tick beside bodies and contacts. Between steps.
     *
     * @param s saves or restores
     * @param slots of bodies
     */
    public void state(StateVisitor s, int slots) {
        tick.body.state(s, slots);
        softnessStep.state(s);
        list.state(s);
        assemblies.state(s);
        collector.state(s);
        supports.state(s);
        s.section("solver", this);
        substepsBefore = s.value("substepsBefore", substepsBefore);
        tick.step = s.value("step", tick.step);
        tick.subStep = s.value("subStep", tick.subStep);
        if (s.isRestoring()) {
            if (tick.step > 0) {
                sub.set(tick.step, softnessStep.seconds(), tick.settings);
            }
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
            ConstraintRows rows = b < batches.divider ? list.floats : list.doubles;
            for (int c = colouring.firstContact[b]; c < colouring.firstColour[b + 1]; c++) {
                for (int place = colouring.start[c]; place < colouring.end[c]; place++) {
                    int l = place * ConstraintRows.LINK;
                    int row = rows.link[l + ConstraintRows.SOURCE];
                    if (rows.link[l + ConstraintRows.COUNT] > 0 && row < colourOfContact.length) {
                        colourOfContact[row] = c - colouring.firstContact[b];
                    }
                }
            }
        }
    }

    /**
     * Friction impulse of a contact over the last tick, for audits.
     *
     * @param m index among the contacts that have points
     * @param axis 0 to 2 for world x, y, z
     * @return impulse on B, N s
     */
    double totalFriction(int m, int axis) {
        RowWindow window = new RowWindow();
        ConstraintRows one = window.open(list.rows(m), list.place[m]);
        return StoreRow.tangent(
                one.doubles, one.base(window.place()), one.lanes, ConstraintRows.TOTAL, axis);
    }
}
