package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.narrowphase.Manifold;
import dev.cairn.physics.narrowphase.NarrowPhase;

import java.util.Arrays;

/**
 * The narrow phase over all rows, in blocks, one writer to a row. Points that were there in the
 * last tick, by feature id, keep their impulse.
 *
 * <p>Simulation thread; allocates only when the number of workers grows.
 */
public final class ManifoldStage {
    /**
     * A point whose features are new is an old one within this share of the smaller inner radius.
     */
    private static final double NEAR = 0.1;

    /** A pair costs from some hundred nanoseconds to some microseconds. */
    private static final int ROWS_PER_BLOCK = 32;

    private final PhysicsSettings settings;
    private final BlockJob job = this::block;
    private Scratch[] scratch = {};

    private BodyStore bodies = new BodyStore();
    private ContactStore contacts = new ContactStore();
    private BoundsStage bounds;
    private double reach;

    /**
     * A stage.
     *
     * @param settings the margin rule
     */
    public ManifoldStage(PhysicsSettings settings) {
        this.settings = settings;
        this.bounds = new BoundsStage(settings);
    }

    /**
     * Collides all rows.
     *
     * @param bodyStore poses at the start of the tick
     * @param rows the rows, whose points are written
     * @param motion where the bodies may go within the tick
     * @param stepSeconds length of the tick, s
     * @param jobs runs the blocks
     */
    public void run(
            BodyStore bodyStore,
            ContactStore rows,
            BoundsStage motion,
            double stepSeconds,
            Jobs jobs) {
        bodies = bodyStore;
        contacts = rows;
        bounds = motion;
        reach = stepSeconds * settings.speculativeTime();
        if (scratch.length < jobs.workers()) {
            int old = scratch.length;
            scratch = Arrays.copyOf(scratch, jobs.workers());
            for (int w = old; w < scratch.length; w++) {
                scratch[w] = new Scratch();
            }
        }
        jobs.run(job, Blocks.count(rows.activeCount, ROWS_PER_BLOCK));
    }

    private void block(int block, int worker) {
        int end = Blocks.end(block, ROWS_PER_BLOCK, contacts.activeCount);
        Scratch own = scratch[worker];
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            collide(contacts.active[i], own);
        }
    }

    private void collide(int row, Scratch own) {
        BodyStore s = bodies;
        ContactStore c = contacts;
        int a = c.bodyA[row];
        int b = c.bodyB[row];
        double dx = s.positionX[b] - s.positionX[a];
        double dy = s.positionY[b] - s.positionY[a];
        double dz = s.positionZ[b] - s.positionZ[a];
        c.cache[row] =
                own.narrowPhase.collide(
                        s.shape[a],
                        s.shape[b],
                        s.orientationX[a],
                        s.orientationY[a],
                        s.orientationZ[a],
                        s.orientationW[a],
                        s.orientationX[b],
                        s.orientationY[b],
                        s.orientationZ[b],
                        s.orientationW[b],
                        dx,
                        dy,
                        dz,
                        margin(a, b),
                        c.cache[row],
                        own.manifold);
        store(row, own, dx, dy, dz);
    }

    /** The speculative margin of a pair; see the package's essay. */
    private double margin(int a, int b) {
        double vx = bounds.aheadX[b] - bounds.aheadX[a];
        double vy = bounds.aheadY[b] - bounds.aheadY[a];
        double vz = bounds.aheadZ[b] - bounds.aheadZ[a];
        double smaller = Math.min(bodies.innerRadius[a], bodies.innerRadius[b]);
        return reach * Math.sqrt(vx * vx + vy * vy + vz * vz)
                + bounds.turn[a]
                + bounds.turn[b]
                + settings.speculativeFraction() * smaller;
    }

    private void store(int row, Scratch own, double dx, double dy, double dz) {
        ContactStore c = contacts;
        Manifold m = own.manifold;
        int first = ContactStore.POINTS * row;
        int before = c.pointCount[row];
        System.arraycopy(c.feature, first, own.feature, 0, before);
        System.arraycopy(c.normalImpulse, first, own.impulse, 0, before);
        System.arraycopy(c.preload, first, own.preload, 0, before);
        System.arraycopy(c.anchorAX, first, own.x, 0, before);
        System.arraycopy(c.anchorAY, first, own.y, 0, before);
        System.arraycopy(c.anchorAZ, first, own.z, 0, before);
        int points = m.pointCount;
        boolean persists = false;
        c.pointCount[row] = points;
        c.normalX[row] = m.normalX;
        c.normalY[row] = m.normalY;
        c.normalZ[row] = m.normalZ;
        for (int p = 0; p < points; p++) {
            int at = first + p;
            c.anchorAX[at] = m.pointX[p];
            c.anchorAY[at] = m.pointY[p];
            c.anchorAZ[at] = m.pointZ[p];
            c.anchorBX[at] = m.pointX[p] - dx;
            c.anchorBY[at] = m.pointY[p] - dy;
            c.anchorBZ[at] = m.pointZ[p] - dz;
            c.separation[at] = m.separation[p];
            c.feature[at] = m.feature[p];
            c.totalNormalImpulse[at] = 0;
            c.normalImpulse[at] = 0;
            c.preload[at] = 0;
            own.unmatched[p] = true;
            for (int q = 0; q < before; q++) {
                if (own.feature[q] == m.feature[p] && !Double.isNaN(own.x[q])) {
                    inherit(own, first, p, q);
                    persists = true;
                    break;
                }
            }
        }
        if (before > 0) {
            double near =
                    NEAR
                            * Math.min(
                                    bodies.innerRadius[c.bodyA[row]],
                                    bodies.innerRadius[c.bodyB[row]]);
            for (int p = 0; p < points; p++) {
                if (own.unmatched[p]) {
                    persists |= inheritNearest(own, first, p, before, near * near);
                }
            }
        }
        if (!persists) {
            c.frictionImpulseX[row] = 0;
            c.frictionImpulseY[row] = 0;
            c.frictionImpulseZ[row] = 0;
            c.twistImpulse[row] = 0;
        }
    }

    private void inherit(Scratch own, int first, int p, int q) {
        contacts.normalImpulse[first + p] = own.impulse[q];
        contacts.preload[first + p] = own.preload[q];
        own.unmatched[p] = false;
        own.x[q] = Double.NaN;
    }

    /**
     * Features swap where faces are equally good; the point is the same while it stays where it
     * was.
     */
    private boolean inheritNearest(Scratch own, int first, int p, int before, double limit) {
        int best = -1;
        double least = limit;
        for (int q = 0; q < before; q++) {
            double x = contacts.anchorAX[first + p] - own.x[q];
            double y = contacts.anchorAY[first + p] - own.y[q];
            double z = contacts.anchorAZ[first + p] - own.z[q];
            double square = x * x + y * y + z * z;
            if (square < least) {
                least = square;
                best = q;
            }
        }
        if (best < 0) {
            return false;
        }
        inherit(own, first, p, best);
        return true;
    }

    /** What one worker needs. */
    private static final class Scratch {
        final NarrowPhase narrowPhase = new NarrowPhase();
        final Manifold manifold = new Manifold();
        final int[] feature = new int[ContactStore.POINTS];
        final double[] impulse = new double[ContactStore.POINTS];
        final double[] preload = new double[ContactStore.POINTS];
        final double[] x = new double[ContactStore.POINTS];
        final double[] y = new double[ContactStore.POINTS];
        final double[] z = new double[ContactStore.POINTS];
        final boolean[] unmatched = new boolean[ContactStore.POINTS];
    }
}
