package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.contact.impact.ImpactStage;
import dev.cairn.physics.contact.impact.SurfacePlane;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.EdgeSource;
import dev.cairn.physics.internal.PerWorker;
import dev.cairn.physics.narrowphase.pair.Reach;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;
import java.util.Objects;

/**
 * Looks at contacts whose bodies are apart at the start of a tick and touch nothing else: along the
 * free motion of both, do they meet within the tick, and how?
 *
 * <p>A contact at a distance holds its bodies apart at the plane that separates them now. If one
 * passes the other, that plane is in its way though the other is not: those contacts are left out.
 * If they meet after a way longer than they are thick, the plane of that moment is what holds them
 * apart, and not that of the start, see {@link SweptPair}.
 *
 * <pre>
 *   sort  ─▶ rows: touching or slow; not closing within the tick; closing; in blocks of rows
 *   tie   ─▶ closing rows of bodies that touch others: these meet another body
 *   sweep ─▶ closing rows of bodies that touch nothing: first meeting, or none; or left open
 *   close ─▶ those that were left open, if the answer can change what is dropped
 *   drop  ─▶ those that do not meet, of bodies that meet no other: their motion is free
 * </pre>
 *
 * <p>A search for a meeting is dear, and in a falling heap most would be for nothing: a row is
 * dropped only if neither of its bodies meets another one. So one of a body that is known to meet
 * another is left open, and looked at only if the other body has a row that may be dropped unless
 * they meet. What is dropped does not hang on the order in which rows are looked at.
 *
 * <p>Between points and solve. Several workers may mark one body, all with the same mark.
 * Simulation thread; allocates only when something grows.
 */
public final class SweepStage {
    private static final int ROWS_PER_BLOCK = 256;

    /**
     * Of the smaller inner radius: a pair that moves past each other by less in a tick, as at rest,
     * is not looked at.
     */
    private static final double FAST = 0x1p-20;

    /**
     * The same: a pair that moves past each other by more is struck within the tick, see {@link
     * ImpactStage}.
     */
    private static final double VERY_FAST = 4;

    /** The same of balls, which touch in one point. */
    private static final double ROUND_FAST = 1;

    private static final byte TIED = 2;

    private static final byte TOUCHING = 0;
    static final byte HARMLESS = 1;
    private static final byte CLOSING = 2;
    private static final byte MISSING = 3;
    private static final byte LOST = 4;
    private static final byte SLOW = 5;
    private static final byte OPEN = 6;

    private final BlockJob tieJob = this::tieBlock;
    private final BlockJob closeJob = this::closeBlock;
    private final BlockJob sortJob = this::sortBlock;
    private final BlockJob sweepJob = this::sweepBlock;
    private final BlockJob dropJob = this::dropBlock;

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final BoundsStage bounds;
    private final EdgeSource[] edges;
    private final PointStore points;
    private final TunnellingGuard guard;

    /** By active row. */
    private byte[] state = {};

    /** How many rows of a block are closing. */
    private int[] closing = {};

    /** By active row: when its bodies meet, s after the start of the tick; infinite if never. */
    private double[] when = {};

    /**
     * By body: 0 if its motion is free, 1 if it touches another body, 2 if it is bound otherwise.
     */
    private byte[] bound = {};

    /** By body: it closes with another body within the tick, slower than what is looked at. */
    private boolean[] slow = {};

    /** By body: it meets another body within the tick. */
    private boolean[] meets = {};

    /** By body: it has a row that is dropped unless one of its bodies meets another. */
    private boolean[] misses = {};

    private final PerWorker<SweptPair> pairs;
    private final PerWorker<WayBound> ways;

    /** Once a body was fast. */
    private @Nullable ImpactStage impacts;

    private boolean any;
    private double step;
    private double reach;

    /**
     * A stage.
     *
     * @param colliders whose contacts these are
     * @param contacts the rows
     * @param bounds velocities at the end of the tick, and the margin
     * @param edges all that binds bodies, contacts first
     */
    public SweepStage(
            ColliderStore colliders,
            ContactStore contacts,
            BoundsStage bounds,
            EdgeSource[] edges) {
        this.colliders = colliders;
        this.contacts = contacts;
        this.bounds = bounds;
        this.edges = edges;
        points = new PointStore(colliders);
        pairs = new PerWorker<>(() -> new SweptPair(colliders, contacts, bounds, points));
        ways = new PerWorker<>(() -> new WayBound(colliders, bounds));
        guard = new TunnellingGuard(colliders, contacts, bounds, edges);
    }

    /**
     * Looks at all active rows.
     *
     * @param stepSeconds length of the tick, s
     */
    public void run(double stepSeconds, Jobs jobs) {
        guard.begin();
        step = stepSeconds;
        reach = stepSeconds * bounds.speculativeTime;
        int slots = colliders.bodies.slotCount;
        int count = contacts.activeCount;
        int blocks = Blocks.count(count, ROWS_PER_BLOCK);
        if (state.length < contacts.bodyA.length) {
            state = new byte[contacts.bodyA.length];
            when = new double[state.length];
            closing = new int[Blocks.count(state.length, ROWS_PER_BLOCK)];
        }
        if (bound.length < slots) {
            bound = new byte[slots + (slots >> 1)];
            meets = new boolean[bound.length];
            misses = new boolean[bound.length];
            slow = new boolean[bound.length];
        }
        Arrays.fill(bound, 0, slots, (byte) 0);
        Arrays.fill(slow, 0, slots, false);
        jobs.run(sortJob, blocks);
        any = false;
        for (int b = 0; b < blocks; b++) {
            any |= closing[b] > 0;
        }
        if (!any) {
            return;
        }
        Arrays.fill(meets, 0, slots, false);
        Arrays.fill(misses, 0, slots, false);
        bindOthers(slots);
        points.use(contacts);
        pairs.ensure(jobs.workers());
        ways.ensure(jobs.workers());
        for (int w = 0; w < pairs.count(); w++) {
            pairs.of(w).use(bound);
        }
        if (impacts == null) {
            impacts = newImpacts();
        }
        impacts.begin(bound, step, reach);
        jobs.run(tieJob, blocks);
        jobs.run(sweepJob, blocks);
        jobs.run(closeJob, blocks);
        jobs.run(dropJob, blocks);
    }

    /** Outside of what runs each tick, see {@link PerWorker}. */
    private ImpactStage newImpacts() {
        SweptPair own = new SweptPair(colliders, contacts, bounds, points);
        return new ImpactStage(colliders, contacts, own);
    }

    /** A body that is bound by more than contacts does not move freely. */
    private void bindOthers(int slots) {
        BodyStore s = colliders.bodies;
        for (int i = 0; i < slots; i++) {
            if (s.motionFlags[i] != 0) {
                bound[i] = TIED;
            }
        }
        for (int k = 1; k < edges.length; k++) {
            EdgeSource source = edges[k];
            for (int i = 0; i < source.edges(); i++) {
                int a = source.edgeA(i);
                if (a >= 0) {
                    bound[a] = TIED;
                    bound[source.edgeB(i)] = TIED;
                }
            }
        }
    }

    private void sortBlock(int block, int worker) {
        ContactStore c = contacts;
        int end = Blocks.end(block, ROWS_PER_BLOCK, c.activeCount);
        int count = 0;
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = c.active[i];
            state[i] = HARMLESS;
            if (!c.isSolved(row)) {
                continue;
            }
            state[i] = look(row);
            if (state[i] == TOUCHING) {
                bound[c.bodyA[row]] = 1;
                bound[c.bodyB[row]] = 1;
            } else if (state[i] == SLOW) {
                slow[c.bodyA[row]] = true;
                slow[c.bodyB[row]] = true;
            } else {
                count += state[i] == CLOSING ? 1 : 0;
            }
        }
        closing[block] = count;
    }

    /**
     * Strikes the impacts of fast bodies; before the solve.
     *
     * @param broadPhase boxes of the tick
     * @param bounceSpeed closing speed up to which nothing bounces, m/s
     * @param substeps of the solver
     * @param isHooked whether a hook may let bodies through
     */
    public void strike(BroadPhase broadPhase, double bounceSpeed, int substeps, boolean isHooked) {
        ImpactStage stage = impacts;
        if (stage == null) {
            return;
        }
        if (!any || isHooked) {
            stage.skip();
            return;
        }
        ContactStore c = contacts;
        boolean strikes = false;
        for (int i = 0; i < c.activeCount; i++) {
            if (when[i] < Double.POSITIVE_INFINITY) {
                stage.add(c.active[i], when[i], state[i] == LOST);
                strikes = true;
            }
        }
        if (strikes) {
            stage.run(broadPhase, bounds.start, bounceSpeed, substeps);
        }
    }

    /**
     * Looks at where fast bodies have gone; after the solve.
     *
     * @param dynamic slots of the dynamic bodies that were moved
     * @param count how many there are
     * @param broadPhase boxes of the tick
     * @param isAnyDriven whether a kinematic body moves
     * @param isHooked whether a hook may let bodies through
     */
    public void finish(
            int[] dynamic,
            int count,
            BroadPhase broadPhase,
            boolean isAnyDriven,
            boolean isHooked,
            Jobs jobs) {
        if (impacts != null) {
            impacts.report();
        }
        guard.run(dynamic, count, state, broadPhase, isAnyDriven, isHooked, impacts, step, jobs);
    }

    private byte look(int row) {
        ContactStore c = contacts;
        int first = ContactStore.POINTS * row;
        int end = first + c.pointCount[row];
        for (int p = first; p < end; p++) {
            if (c.separation[p] <= 0 || c.normalImpulse[p] > 0) {
                return TOUCHING;
            }
        }
        if (!SurfacePlane.fits(colliders, c.colliderA[row], c.colliderB[row])) {
            return TOUCHING;
        }
        double most = step * Math.max(closing(row, false), closing(row, true));
        for (int p = first; p < end; p++) {
            if (most >= c.separation[p]) {
                return isFast(row, FAST) ? CLOSING : SLOW;
            }
        }
        return HARMLESS;
    }

    /** Whether two bodies are struck within the tick. */
    private boolean isVeryFast(ImpactStage stage, int row) {
        ContactStore c = contacts;
        return Reach.fits(colliders.shape[c.colliderA[row]])
                && Reach.fits(colliders.shape[c.colliderB[row]])
                && isFast(row, ROUND_FAST)
                && (stage.isRound(row) || isFast(row, VERY_FAST));
    }

    /** Whether two bodies pass each other by a good part of the thinner one in a tick. */
    private boolean isFast(int row, double share) {
        ContactStore c = contacts;
        BodyStore s = colliders.bodies;
        int i = c.bodyA[row];
        int j = c.bodyB[row];
        int a = c.colliderA[row];
        int b = c.colliderB[row];
        double x = s.velocityX[i] - s.velocityX[j];
        double y = s.velocityY[i] - s.velocityY[j];
        double z = s.velocityZ[i] - s.velocityZ[j];
        double turn =
                bounds.ahead[BoundsStage.AHEAD * a + 3] + bounds.ahead[BoundsStage.AHEAD * b + 3];
        double way = step * Math.sqrt(x * x + y * y + z * z) + turn;
        return way > share * Math.min(colliders.innerRadius[a], colliders.innerRadius[b]);
    }

    /**
     * Speed at which surfaces close at most: with the velocities now, or with those of the tick's
     * end.
     */
    private double closing(int row, boolean atEnd) {
        ContactStore c = contacts;
        BodyStore s = colliders.bodies;
        int i = c.bodyA[row];
        int j = c.bodyB[row];
        double[] ahead = bounds.ahead;
        int a = BoundsStage.AHEAD * c.colliderA[row];
        int b = BoundsStage.AHEAD * c.colliderB[row];
        double vx = atEnd ? ahead[a] - ahead[b] : s.velocityX[i] - s.velocityX[j];
        double vy = atEnd ? ahead[a + 1] - ahead[b + 1] : s.velocityY[i] - s.velocityY[j];
        double vz = atEnd ? ahead[a + 2] - ahead[b + 2] : s.velocityZ[i] - s.velocityZ[j];
        double turn = ahead[a + 3] + ahead[b + 3];
        return vx * c.normalX(row) + vy * c.normalY(row) + vz * c.normalZ(row) + turn / step;
    }

    private void tieBlock(int block, int worker) {
        ContactStore c = contacts;
        int begin = Blocks.begin(block, ROWS_PER_BLOCK);
        int end = Blocks.end(block, ROWS_PER_BLOCK, c.activeCount);
        Arrays.fill(when, begin, end, Double.POSITIVE_INFINITY);
        if (closing[block] == 0) {
            return;
        }
        SweptPair pair = pairs.of(worker);
        ImpactStage stage = Objects.requireNonNull(impacts);
        for (int i = begin; i < end; i++) {
            int row = c.active[i];
            if (state[i] != CLOSING || (isFree(c.bodyA[row]) && isFree(c.bodyB[row]))) {
                continue;
            }
            state[i] = TOUCHING;
            setMeets(row);
            if (isVeryFast(stage, row) && stage.fits(row) && pair.meet(row, step)) {
                when[i] = pair.time();
            }
        }
    }

    private void sweepBlock(int block, int worker) {
        if (closing[block] == 0) {
            return;
        }
        ContactStore c = contacts;
        SweptPair pair = pairs.of(worker);
        ImpactStage stage = Objects.requireNonNull(impacts);
        int end = Blocks.end(block, ROWS_PER_BLOCK, c.activeCount);
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = c.active[i];
            if (state[i] != CLOSING) {
                continue;
            }
            boolean isVeryFast = isVeryFast(stage, row);
            if (!isVeryFast
                    && !areAlone(row)
                    && ways.of(worker).isShort(c.colliderA[row], c.colliderB[row], step)) {
                state[i] = OPEN;
            } else {
                sweep(i, row, isVeryFast, pair);
            }
        }
    }

    /** Looks at rows that were left open if one of their bodies has a row that may be dropped. */
    private void closeBlock(int block, int worker) {
        if (closing[block] == 0) {
            return;
        }
        ContactStore c = contacts;
        int end = Blocks.end(block, ROWS_PER_BLOCK, c.activeCount);
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = c.active[i];
            if (state[i] == OPEN && (isWaiting(c.bodyA[row]) || isWaiting(c.bodyB[row]))) {
                sweep(i, row, false, pairs.of(worker));
            }
        }
    }

    private void sweep(int i, int row, boolean isVeryFast, SweptPair pair) {
        if (pair.pass(row, step) || pair.passCorner(row)) {
            setMisses(i, row);
            return;
        }
        if (!isVeryFast && pair.meetSometime(row)) {
            state[i] = CLOSING;
            setMeets(row);
            return;
        }
        if (!isVeryFast && pair.goAround(row)) {
            setMisses(i, row);
            return;
        }
        boolean meet = pair.meet(row, step);
        if (meet || pair.isUndecided()) {
            when[i] = isVeryFast ? pair.time() : when[i];
            state[i] = meet ? CLOSING : LOST;
            setMeets(row);
            pair.collideThere(row, reach);
        } else {
            setMisses(i, row);
        }
    }

    private void setMeets(int row) {
        meets[contacts.bodyA[row]] = true;
        meets[contacts.bodyB[row]] = true;
    }

    private void setMisses(int i, int row) {
        state[i] = MISSING;
        if (areAlone(row)) {
            misses[contacts.bodyA[row]] = true;
            misses[contacts.bodyB[row]] = true;
        }
    }

    /** Whether the rows of a body that do not meet depend on whether it meets another body. */
    private boolean isWaiting(int body) {
        return colliders.bodies.kind[body] == BodyStore.DYNAMIC && !meets[body] && misses[body];
    }

    private boolean areAlone(int row) {
        return isAlone(contacts.bodyA[row]) && isAlone(contacts.bodyB[row]);
    }

    private void dropBlock(int block, int worker) {
        if (closing[block] == 0) {
            return;
        }
        ContactStore c = contacts;
        int end = Blocks.end(block, ROWS_PER_BLOCK, c.activeCount);
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = c.active[i];
            if (state[i] == MISSING && areAlone(row)) {
                c.disable(row);
            }
        }
    }

    /** A body that does not answer to contacts goes its way in any case. */
    private boolean isFree(int body) {
        return colliders.bodies.kind[body] != BodyStore.DYNAMIC
                || (bound[body] == 0 && !slow[body]);
    }

    private boolean isAlone(int body) {
        return colliders.bodies.kind[body] != BodyStore.DYNAMIC || !meets[body];
    }
}
