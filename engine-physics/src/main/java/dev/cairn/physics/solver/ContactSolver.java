package dev.cairn.physics.solver;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

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

    /**
     * A point rests while it moves slower than gravity makes a body fall in this share of a tick.
     */
    private static final double STILL = 0.125;

    private SolverSettings settings;
    private final Sweeps sweeps;
    private final Sweeps narrow = new ScalarSweeps();
    private final SolverBodies body = new SolverBodies();
    private final ConstraintRows rows;
    private final Colouring colouring = new Colouring();
    private final SubStep sub = new SubStep();
    private final Impacts impacts = new Impacts();
    private final LoadSweep loads = new LoadSweep();
    private final Unloading unloading = new Unloading();
    private final Renewal renewal = new Renewal();
    private final double[] gravity = new double[3];

    private final BlockJob begin = this::begin;
    private final BlockJob prepare = this::prepare;
    private final BlockJob kick = this::kick;
    private final BlockJob bias = this::bias;
    private final BlockJob drift = this::drift;
    private final BlockJob relax = this::relax;
    private final BlockJob finish = this::finish;
    private final BlockJob keepBodies = this::keepBodies;
    private final BlockJob takeOut = this::takeOut;
    private final BlockJob renewBodies = this::renewBodies;
    private final BlockJob renewRows = this::renewRows;
    private final BlockJob restoreRows = this::restoreRows;
    private final BlockJob storeBodies = this::storeBodies;
    private final BlockJob clearRows = this::clearRows;
    private final BlockJob storeRows = this::storeRows;

    private double step;
    private boolean stacked;
    private boolean loaded;
    private boolean renews;
    private double preloadScale = 1;
    private double subStep;
    private int substepsBefore;
    private double impulseScale = 1;
    private double still;

    /** The colour in work: its places. */
    private int from;

    private int to;

    /** The sweeps of this tick, and of the colour in work. */
    private Sweeps chosen = narrow;

    private Sweeps sweep = narrow;
    private double[][] scratch = {};
    private @Nullable BodyStore bodyStore;
    private @Nullable ContactStore contactStore;

    /**
     * A solver; one per world.
     *
     * @param settings the tunables
     */
    public ContactSolver(SolverSettings settings) {
        this.settings = settings;
        sweeps = Lanes.sweeps(settings.lanes());
        rows = new ConstraintRows(sweeps.lanes());
    }

    /**
     * The tunables.
     *
     * @return as given
     */
    public SolverSettings settings() {
        return settings;
    }

    /**
     * Changes the number of sub-steps from the next step on. Between steps.
     *
     * @param count 1 to 64
     */
    public void setSubsteps(int count) {
        settings = settings.withSubsteps(count);
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
        bodyStore = bodies;
        contactStore = contacts;
        gravity[0] = gravityX;
        gravity[1] = gravityY;
        gravity[2] = gravityZ;
        timing(stepSeconds);
        collect(bodies, contacts);
        int bodyBlocks = Blocks.count(bodies.slotCount, BODIES_PER_BLOCK);
        boolean unloaded =
                settings.unloadSweeps() > 0
                        && unloading.find(bodies, contacts, rows, impulseScale / subStep, weight());
        loaded =
                (settings.loadInertia() > 0 || settings.unloadSweeps() > 0)
                        && loads.run(
                                bodies, contacts, rows, body, gravity, step, settings, stacked);
        renewal.ensureCapacity(bodies.slotCount);
        jobs.run(begin, bodyBlocks);
        if (rows.count > 0) {
            ensureScratch(jobs.workers());
            choose();
            colours(prepare, jobs);
            renews = renewal.list(rows, contacts, bodies, weight());
            preloadScale = impulseScale;
            for (int k = 0; k < settings.substeps(); k++) {
                subStep(bodies, contacts, unloaded && k == 0, bodyBlocks, jobs);
            }
        }
        store(bodies, contacts, bodyBlocks, jobs);
        bodyStore = null;
        contactStore = null;
    }

    /** Levers of what turns or passes by, as they are now. */
    private void renew(int bodyBlocks, Jobs jobs) {
        jobs.run(keepBodies, bodyBlocks);
        colours(takeOut, jobs);
        jobs.run(renewBodies, bodyBlocks);
        colours(renewRows, jobs);
        preloadScale = 1;
    }

    private void keepBodies(int block, int worker) {
        int end = Blocks.end(block, BODIES_PER_BLOCK, stored(bodyStore).slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            if (body.guide[i] != SolverBodies.FREE) {
                Motion.keep(stored(bodyStore), body, i);
            }
        }
    }

    private void takeOut(int block, int worker) {
        int first = from + Blocks.begin(block, ROWS_PER_BLOCK);
        int end = from + Blocks.end(block, ROWS_PER_BLOCK, to - from);
        renewal.unload(rows, body.warm, first, end);
    }

    private void renewBodies(int block, int worker) {
        BodyStore b = stored(bodyStore);
        int end = Blocks.end(block, BODIES_PER_BLOCK, b.slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            if (body.guide[i] != SolverBodies.FREE) {
                renewal.body(body, b, i);
            }
        }
    }

    private void renewRows(int block, int worker) {
        int first = from + Blocks.begin(block, ROWS_PER_BLOCK);
        int end = from + Blocks.end(block, ROWS_PER_BLOCK, to - from);
        renewal.rows(
                rows, body, stored(bodyStore), stored(contactStore), sub, preloadScale, first, end);
    }

    private void restoreRows(int block, int worker) {
        int first = Blocks.begin(block, ROWS_PER_BLOCK);
        int end = Blocks.end(block, ROWS_PER_BLOCK, rows.places);
        renewal.restore(rows, stored(contactStore), first, end);
    }

    private void subStep(
            BodyStore bodies, ContactStore contacts, boolean unloaded, int bodyBlocks, Jobs jobs) {
        if (rows.bouncing > 0
                && impacts.run(
                        rows,
                        body,
                        bodies,
                        contacts,
                        gravity,
                        subStep,
                        settings.restitutionThreshold())) {
            ScalarSweeps.separations(rows, body.state);
        }
        jobs.run(kick, bodyBlocks);
        if (unloaded) {
            ScalarSweeps.settle(rows, body.state, sub, settings.unloadSweeps(), scratch[0]);
        }
        colours(bias, jobs);
        jobs.run(drift, bodyBlocks);
        if (renews) {
            renew(bodyBlocks, jobs);
        }
        colours(relax, jobs);
        jobs.run(finish, bodyBlocks);
    }

    /** Runs a job over the rows of one colour after the other, in blocks. */
    private void colours(BlockJob job, Jobs jobs) {
        for (int c = 0; c < colouring.colours; c++) {
            from = colouring.start[c];
            to = colouring.start[c + 1];
            sweep = to - from > rows.lanes ? chosen : narrow;
            jobs.run(job, Blocks.count(to - from, ROWS_PER_BLOCK));
        }
    }

    /** Which sweeps are used has no influence on the result. */
    private void choose() {
        chosen = sweeps;
        if (settings.lanes() == 0 && sweeps instanceof WideSweeps wide) {
            if (rows.count < WIDE_FROM) {
                chosen = narrow;
            } else if (!wide.isWarm()) {
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
        if (stepSeconds == step && settings.substeps() == substepsBefore) {
            impulseScale = 1;
            return;
        }
        double h = stepSeconds / settings.substeps();
        double longer = (double) substepsBefore / settings.substeps();
        impulseScale = step == 0 ? 1 : stepSeconds / step * longer;
        substepsBefore = settings.substeps();
        double hertz = settings.hertzPerRate() / h;
        Softness soft = Softness.of(hertz, settings.dampingRatio(), h);
        Softness staticSoft =
                Softness.of(
                        hertz * settings.staticHertzScale(),
                        settings.dampingRatio() * settings.staticDampingScale(),
                        h);
        sub.set(h, soft, staticSoft, settings);
        step = stepSeconds;
        subStep = h;
    }

    /**
     * Lists the contacts that have points, gives them colours, and finds which bodies they bind.
     */
    private void collect(BodyStore bodies, ContactStore contacts) {
        body.ensureCapacity(bodies.slotCount);
        rows.ensureRows(contacts.activeCount);
        colouring.begin(bodies.slotCount, contacts.activeCount);
        int[] guide = body.guide;
        Arrays.fill(guide, 0, bodies.slotCount, SolverBodies.FREE);
        int n = 0;
        int bouncing = 0;
        stacked = false;
        for (int i = 0; i < contacts.activeCount; i++) {
            int c = contacts.active[i];
            if (contacts.pointCount[c] == 0) {
                continue;
            }
            int a = contacts.bodyA[c];
            int b = contacts.bodyB[c];
            rows.source[n] = c;
            if (bodies.kind[a] != BodyStore.DYNAMIC) {
                colouring.addFixed(n, b);
                guide[b] = guide[b] == SolverBodies.FREE ? n : SolverBodies.BOUND;
            } else if (bodies.kind[b] != BodyStore.DYNAMIC) {
                colouring.addFixed(n, a);
                guide[a] = guide[a] == SolverBodies.FREE ? n : SolverBodies.BOUND;
            } else {
                colouring.add(n, a, b, isCold(contacts, c));
                guide[a] = SolverBodies.BOUND;
                guide[b] = SolverBodies.BOUND;
                stacked = true;
            }
            if (contacts.restitution[c] > 0) {
                rows.bouncer[bouncing++] = n;
            }
            n++;
        }
        rows.count = n;
        rows.bouncing = bouncing;
        colouring.finish(rows);
        for (int m = 0; m < n; m++) {
            int c = rows.source[m];
            int l = rows.place[m] * ConstraintRows.LINK;
            int a = contacts.bodyA[c];
            int b = contacts.bodyB[c];
            rows.link[l] = bodies.kind[a] == BodyStore.DYNAMIC ? SolverBodies.offset(a) : 0;
            rows.link[l + 1] = bodies.kind[b] == BodyStore.DYNAMIC ? SolverBodies.offset(b) : 0;
            rows.link[l + ConstraintRows.COUNT] = contacts.pointCount[c];
            rows.link[l + ConstraintRows.SOURCE] = c;
            rows.unloaded[rows.place[m]] = 0;
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
        for (int c = 0; c < colouring.colours; c++) {
            for (int place = colouring.start[c]; place < colouring.start[c + 1]; place++) {
                int l = place * ConstraintRows.LINK;
                int row = rows.link[l + ConstraintRows.SOURCE];
                if (rows.link[l + ConstraintRows.COUNT] > 0 && row < colourOfContact.length) {
                    colourOfContact[row] = c;
                }
            }
        }
    }

    /** Whether a contact had no impulse at the end of the last tick; most such have a gap. */
    private static boolean isCold(ContactStore c, int row) {
        int p = ContactStore.POINTS * row;
        double sum = 0;
        for (int end = p + c.pointCount[row]; p < end; p++) {
            sum += c.normalImpulse[p];
        }
        return sum == 0;
    }

    /** Flies the bodies without contacts, loads the others. */
    private void begin(int block, int worker) {
        BodyStore b = stored(bodyStore);
        int end = Blocks.end(block, BODIES_PER_BLOCK, b.slotCount);
        double weight = weight();
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            if (b.kind[i] != BodyStore.DYNAMIC) {
                continue;
            }
            body.axes.update(b, i);
            if (body.guide[i] == SolverBodies.FREE) {
                Motion.fly(
                        b, body, i, gravity[0], gravity[1], gravity[2], step, settings.substeps());
            } else {
                renewal.look(b, i, weight);
                body.loadBound(b, i, loaded ? b.inertiaScale[i] : 1);
            }
        }
    }

    private void prepare(int block, int worker) {
        int first = from + Blocks.begin(block, ROWS_PER_BLOCK);
        int end = from + Blocks.end(block, ROWS_PER_BLOCK, to - from);
        sweep.fill(
                rows, body, stored(contactStore), sub, impulseScale, first, end, scratch[worker]);
    }

    private void bias(int block, int worker) {
        int first = from + Blocks.begin(block, ROWS_PER_BLOCK);
        int end = from + Blocks.end(block, ROWS_PER_BLOCK, to - from);
        for (int j = first; j < end; j += ConstraintRows.CHUNK) {
            int last = Math.min(end, j + ConstraintRows.CHUNK);
            sweep.bias(rows, body.state, sub, j, last, scratch[worker]);
        }
    }

    private void relax(int block, int worker) {
        int first = from + Blocks.begin(block, ROWS_PER_BLOCK);
        int end = from + Blocks.end(block, ROWS_PER_BLOCK, to - from);
        for (int j = first; j < end; j += ConstraintRows.CHUNK) {
            int last = Math.min(end, j + ConstraintRows.CHUNK);
            sweep.relax(rows, body.state, sub, j, last, scratch[worker]);
        }
    }

    private void kick(int block, int worker) {
        BodyStore b = stored(bodyStore);
        int end = Blocks.end(block, BODIES_PER_BLOCK, b.slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            if (body.guide[i] != SolverBodies.FREE) {
                Motion.kick(b, body, i, gravity[0], gravity[1], gravity[2], subStep);
            }
        }
    }

    private void drift(int block, int worker) {
        BodyStore b = stored(bodyStore);
        int end = Blocks.end(block, BODIES_PER_BLOCK, b.slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            if (body.guide[i] != SolverBodies.FREE) {
                Motion.drift(b, body, i, gravity[0], gravity[1], gravity[2], subStep);
            }
        }
    }

    private void finish(int block, int worker) {
        int end = Blocks.end(block, BODIES_PER_BLOCK, stored(bodyStore).slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            if (body.guide[i] != SolverBodies.FREE) {
                Motion.keep(stored(bodyStore), body, i);
                if (body.guide[i] >= 0) {
                    Motion.glide(body, i, rows, subStep);
                }
            }
        }
    }

    /** Writes the bodies and the impulses back. */
    private void store(BodyStore bodies, ContactStore contacts, int bodyBlocks, Jobs jobs) {
        still = STILL * weight() * step;
        jobs.run(storeBodies, bodyBlocks);
        jobs.run(clearRows, Blocks.count(contacts.activeCount, ROWS_PER_BLOCK));
        jobs.run(storeRows, Blocks.count(rows.places, ROWS_PER_BLOCK));
        if (renews) {
            jobs.run(restoreRows, Blocks.count(rows.places, ROWS_PER_BLOCK));
            renews = false;
        }
        if (settings.unloadSweeps() > 0) {
            for (int m = 0; m < rows.count; m++) {
                Unloading.press(bodies, contacts, rows.source[m], 1 / subStep);
            }
        }
    }

    private void storeBodies(int block, int worker) {
        BodyStore b = stored(bodyStore);
        int end = Blocks.end(block, BODIES_PER_BLOCK, b.slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            if (body.guide[i] != SolverBodies.FREE) {
                body.store(b, i);
            }
            b.pressed[i] = 0;
            b.pressing[i] = 0;
        }
    }

    /** Contacts without points have no impulses. */
    private void clearRows(int block, int worker) {
        ContactStore c = stored(contactStore);
        int end = Blocks.end(block, ROWS_PER_BLOCK, c.activeCount);
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = c.active[i];
            if (c.pointCount[row] == 0) {
                c.frictionImpulseX[row] = 0;
                c.frictionImpulseY[row] = 0;
                c.frictionImpulseZ[row] = 0;
                c.twistImpulse[row] = 0;
            }
        }
    }

    private void storeRows(int block, int worker) {
        ContactStore c = stored(contactStore);
        int end = Blocks.end(block, ROWS_PER_BLOCK, rows.places);
        for (int j = Blocks.begin(block, ROWS_PER_BLOCK); j < end; j++) {
            if (rows.link[j * ConstraintRows.LINK + ConstraintRows.COUNT] > 0) {
                storeRow(c, j, rows.link[j * ConstraintRows.LINK + ConstraintRows.SOURCE]);
            }
        }
    }

    private void storeRow(ContactStore contacts, int j, int c) {
        double[] d = rows.row;
        int lanes = rows.lanes;
        int o = rows.base(j);
        contacts.frictionImpulseX[c] = tangent(o, ConstraintRows.LAMBDA, 0);
        contacts.frictionImpulseY[c] = tangent(o, ConstraintRows.LAMBDA, 1);
        contacts.frictionImpulseZ[c] = tangent(o, ConstraintRows.LAMBDA, 2);
        contacts.twistImpulse[c] = d[o + (ConstraintRows.LAMBDA + 2) * lanes];
        for (int k = 0; k < contacts.pointCount[c]; k++) {
            int p = ContactStore.POINTS * c + k;
            int q = ConstraintRows.POINT + k * ConstraintRows.POINT_FIELDS;
            contacts.normalImpulse[p] = d[o + (q + ConstraintRows.IMPULSE) * lanes];
            contacts.totalNormalImpulse[p] = d[o + (ConstraintRows.SUM + k) * lanes];
        }
        if (settings.offsetGain() > 0) {
            Offsets.update(rows, body.state, contacts, c, j, sub, settings.offsetGain(), still);
        }
    }

    /** World component of a pair of tangent impulses. */
    private double tangent(int o, int field, int axis) {
        double[] d = rows.row;
        int lanes = rows.lanes;
        return d[o + field * lanes] * d[o + (ConstraintRows.TANGENT1 + axis) * lanes]
                + d[o + (field + 1) * lanes] * d[o + (ConstraintRows.TANGENT2 + axis) * lanes];
    }

    /**
     * Friction impulse of a contact over the last tick, for audits.
     *
     * @param row index among the contacts that have points
     * @param axis 0 to 2 for world x, y, z
     * @return impulse on B, N s
     */
    double totalFriction(int row, int axis) {
        return tangent(rows.base(rows.place[row]), ConstraintRows.TOTAL, axis);
    }

    /** Size of gravity, m/s². */
    private double weight() {
        return Math.sqrt(
                gravity[0] * gravity[0] + gravity[1] * gravity[1] + gravity[2] * gravity[2]);
    }

    private static <T> T stored(@Nullable T value) {
        if (value == null) {
            throw new IllegalStateException("a block of the solver ran outside of step");
        }
        return value;
    }
}
