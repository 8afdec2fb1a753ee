package dev.cairn.physics.solver;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * Solves one tick of motion and contact: a sub-stepped, sequential, soft contact solver in double.
 *
 * <p>Loops over bodies run as blocks on the job system, sweeps over contacts in row order on the
 * calling thread, so the result does not depend on the number of workers. Simulation thread only;
 * allocates only when a store has grown. The package's documentation tells the method and its
 * sources.
 */
public final class ContactSolver {
    private static final int BODIES_PER_BLOCK = 128;
    private static final int ROWS_PER_BLOCK = 64;

    /**
     * A point rests while it moves slower than gravity makes a body fall in this share of a tick.
     */
    private static final double STILL = 0.125;

    private final SolverSettings settings;
    private final SolverBodies body = new SolverBodies();
    private final ConstraintRows rows = new ConstraintRows();
    private final Impacts impacts = new Impacts();
    private final LoadSweep loads = new LoadSweep();
    private final Unloading unloading = new Unloading();
    private final double[] gravity = new double[3];

    private final BlockJob begin = this::begin;
    private final BlockJob prepare = this::prepare;
    private final BlockJob kick = this::kick;
    private final BlockJob drift = this::drift;
    private final BlockJob finish = this::finish;

    private double step;
    private boolean stacked;
    private boolean loaded;
    private double subStep;
    private Softness soft = new Softness(0, 1, 0);
    private Softness staticSoft = soft;
    private double impulseScale = 1;
    private @Nullable BodyStore bodyStore;
    private @Nullable ContactStore contactStore;

    /**
     * A solver; one per world.
     *
     * @param settings the tunables
     */
    public ContactSolver(SolverSettings settings) {
        this.settings = settings;
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
     * Moves all bodies by one tick.
     *
     * @param bodies poses and velocities, read and written; forces and torques are read
     * @param contacts rows of this tick; impulses are read as warm start and written
     * @param gravityX world, m/s²
     * @param gravityY world, m/s²
     * @param gravityZ world, m/s²
     * @param stepSeconds length of the tick, s, above 0
     * @param jobs runs the loops over bodies in blocks
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
        jobs.run(begin, bodyBlocks);
        if (rows.count > 0) {
            jobs.run(prepare, Blocks.count(rows.count, ROWS_PER_BLOCK));
            for (int k = 0; k < settings.substeps(); k++) {
                impacts.run(rows, body, bodies, gravity, subStep, settings.restitutionThreshold());
                jobs.run(kick, bodyBlocks);
                RowKernels.warmStart(rows, body.state);
                if (unloaded && k == 0) {
                    unloading.settle(rows, body.state, subStep, settings);
                }
                RowKernels.bias(
                        rows,
                        body.state,
                        subStep,
                        settings.pushSpeed(),
                        settings.innerSweeps(),
                        settings.coldSweeps());
                jobs.run(drift, bodyBlocks);
                RowKernels.relax(
                        rows,
                        body.state,
                        subStep,
                        settings.pushSpeed(),
                        settings.innerSweeps(),
                        settings.coldSweeps());
                jobs.run(finish, bodyBlocks);
            }
        }
        store(bodies, contacts);
        bodyStore = null;
        contactStore = null;
    }

    /**
     * Coefficients that depend on the length of the step; the impulses of a sub-step scale with it.
     */
    private void timing(double stepSeconds) {
        if (stepSeconds == step) {
            impulseScale = 1;
            return;
        }
        double h = stepSeconds / settings.substeps();
        impulseScale = step == 0 ? 1 : stepSeconds / step;
        double hertz = settings.hertzPerRate() / h;
        soft = Softness.of(hertz, settings.dampingRatio(), h);
        staticSoft =
                Softness.of(
                        hertz * settings.staticHertzScale(),
                        settings.dampingRatio() * settings.staticDampingScale(),
                        h);
        step = stepSeconds;
        subStep = h;
    }

    /** Lists the contacts that have points, and which bodies they bind. */
    private void collect(BodyStore bodies, ContactStore contacts) {
        body.ensureCapacity(bodies.slotCount);
        rows.ensureCapacity(contacts.count);
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
            int l = n * ConstraintRows.LINK;
            rows.link[l + ConstraintRows.BODY_A] = a * SolverBodies.STRIDE;
            rows.link[l + ConstraintRows.BODY_B] = b * SolverBodies.STRIDE;
            rows.link[l + ConstraintRows.COUNT] = contacts.pointCount[c];
            rows.link[l + ConstraintRows.SOURCE] = c;
            boolean still =
                    bodies.kind[a] != BodyStore.DYNAMIC || bodies.kind[b] != BodyStore.DYNAMIC;
            stacked |= !still;
            guide[a] = guide[a] == SolverBodies.FREE && still ? n : SolverBodies.BOUND;
            guide[b] = guide[b] == SolverBodies.FREE && still ? n : SolverBodies.BOUND;
            if (contacts.restitution[c] > 0) {
                rows.bouncer[bouncing++] = n;
            }
            n++;
        }
        rows.count = n;
        rows.bouncing = bouncing;
    }

    /** Flies the bodies without contacts, loads the others. */
    private void begin(int block, int worker) {
        BodyStore b = stored(bodyStore);
        int end = Blocks.end(block, BODIES_PER_BLOCK, b.slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            boolean dynamic = b.kind[i] == BodyStore.DYNAMIC;
            if (dynamic) {
                body.axes.update(b, i);
            }
            if (body.guide[i] == SolverBodies.FREE) {
                if (dynamic) {
                    Motion.fly(
                            b,
                            body,
                            i,
                            gravity[0],
                            gravity[1],
                            gravity[2],
                            step,
                            settings.substeps());
                }
            } else if (dynamic) {
                body.loadBound(b, i, loaded ? b.inertiaScale[i] : 1);
            } else {
                body.loadStatic(i);
            }
        }
    }

    private void prepare(int block, int worker) {
        ContactStore c = stored(contactStore);
        int end = Blocks.end(block, ROWS_PER_BLOCK, rows.count);
        for (int m = Blocks.begin(block, ROWS_PER_BLOCK); m < end; m++) {
            PrepareRow.run(rows, body, c, m, soft, staticSoft, impulseScale);
        }
    }

    private void kick(int block, int worker) {
        BodyStore b = stored(bodyStore);
        int end = Blocks.end(block, BODIES_PER_BLOCK, b.slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            if (body.guide[i] != SolverBodies.FREE && b.kind[i] == BodyStore.DYNAMIC) {
                Motion.kick(b, body, i, gravity[0], gravity[1], gravity[2], subStep);
            }
        }
    }

    private void drift(int block, int worker) {
        BodyStore b = stored(bodyStore);
        int end = Blocks.end(block, BODIES_PER_BLOCK, b.slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            if (body.guide[i] != SolverBodies.FREE && b.kind[i] == BodyStore.DYNAMIC) {
                Motion.drift(b, body, i, gravity[0], gravity[1], gravity[2], subStep);
            }
        }
    }

    private void finish(int block, int worker) {
        BodyStore b = stored(bodyStore);
        int end = Blocks.end(block, BODIES_PER_BLOCK, b.slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            if (body.guide[i] >= 0 && b.kind[i] == BodyStore.DYNAMIC) {
                Motion.glide(body, i, rows.row, subStep);
            }
        }
    }

    /** Writes the bodies and the impulses back. */
    private void store(BodyStore bodies, ContactStore contacts) {
        for (int i = 0; i < bodies.slotCount; i++) {
            if (body.guide[i] != SolverBodies.FREE && bodies.kind[i] == BodyStore.DYNAMIC) {
                body.store(bodies, i);
            }
        }
        double still = STILL * weight() * step;
        Arrays.fill(bodies.pressed, 0, bodies.slotCount, 0.0);
        Arrays.fill(bodies.pressing, 0, bodies.slotCount, 0);
        int m = 0;
        for (int i = 0; i < contacts.activeCount; i++) {
            int c = contacts.active[i];
            contacts.frictionImpulseX[c] = 0;
            contacts.frictionImpulseY[c] = 0;
            contacts.frictionImpulseZ[c] = 0;
            contacts.twistImpulse[c] = 0;
            if (contacts.pointCount[c] > 0) {
                storeRow(contacts, c, m);
                if (settings.unloadSweeps() > 0) {
                    Unloading.press(bodies, contacts, c, 1 / subStep);
                }
                if (settings.offsetGain() > 0) {
                    Offsets.update(rows, body, contacts, c, m, settings.offsetGain(), still);
                }
                m++;
            }
        }
    }

    private void storeRow(ContactStore contacts, int c, int m) {
        double[] d = rows.row;
        int r = m * ConstraintRows.ROW;
        double f1 = d[r + ConstraintRows.LAMBDA];
        double f2 = d[r + ConstraintRows.LAMBDA + 1];
        int t1 = r + ConstraintRows.TANGENT1;
        int t2 = r + ConstraintRows.TANGENT2;
        contacts.frictionImpulseX[c] = f1 * d[t1] + f2 * d[t2];
        contacts.frictionImpulseY[c] = f1 * d[t1 + 1] + f2 * d[t2 + 1];
        contacts.frictionImpulseZ[c] = f1 * d[t1 + 2] + f2 * d[t2 + 2];
        contacts.twistImpulse[c] = d[r + ConstraintRows.LAMBDA + 2];
        for (int k = 0; k < contacts.pointCount[c]; k++) {
            int o = (ContactStore.POINTS * m + k) * ConstraintRows.POINT;
            contacts.normalImpulse[ContactStore.POINTS * c + k] =
                    rows.point[o + ConstraintRows.IMPULSE];
            contacts.totalNormalImpulse[ContactStore.POINTS * c + k] =
                    rows.point[o + ConstraintRows.SUM];
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
        double[] d = rows.row;
        int r = row * ConstraintRows.ROW;
        return d[r + ConstraintRows.TOTAL] * d[r + ConstraintRows.TANGENT1 + axis]
                + d[r + ConstraintRows.TOTAL + 1] * d[r + ConstraintRows.TANGENT2 + axis];
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
