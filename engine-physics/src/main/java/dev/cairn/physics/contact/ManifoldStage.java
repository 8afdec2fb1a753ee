package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.PerWorker;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.box.BoxContacts;
import dev.cairn.physics.narrowphase.hull.PairMemory;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.round.RoundContacts;
import dev.cairn.physics.narrowphase.wide.BoxBatch;
import dev.cairn.physics.narrowphase.wide.BoxWarmUp;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Moved;

/**
 * The narrow phase over all active rows, sorted by the kind of pair, in blocks of one kind, one
 * writer to a row. Points that were there in the last tick, by feature id, keep their impulse.
 *
 * <p>Simulation thread; allocates only when the number of workers or rows grows.
 */
public final class ManifoldStage {
    /** A batch of boxes, about 5 microseconds. */
    private static final int BOXES_PER_BLOCK = BoxBatch.CAPACITY;

    /** Fewer pairs of boxes go without lanes, whose kernels would stay uncompiled for long. */
    private static final int PAIRS_FOR_LANES = 512;

    /** At rest few pairs of a batch have moved; lanes would be empty. */
    private static final int MOVED_FOR_LANES = 8;

    /** Some 40 nanoseconds each. */
    private static final int ROUND_PER_BLOCK = 128;

    /** Other pairs cost from some hundred nanoseconds to some microseconds. */
    private static final int OTHERS_PER_BLOCK = 32;

    private final BlockJob job = this::block;
    private final PairKinds kinds;
    private final PointStore points;
    private final PolyhedronRecycler recycler;
    private final SurfaceStage surfaces;
    private final PerWorker<Scratch> scratch = new PerWorker<>(Scratch::new);

    private final ColliderStore colliders;
    private ContactStore contacts = new ContactStore();
    private final BoundsStage bounds;
    private double reach;
    private int boxBlocks, roundBlocks;

    /** Ticks in which lanes were wanted, and whether they are used in this one. */
    private int boxTicks;

    private boolean boxesInLanes;

    /**
     * A stage.
     *
     * @param colliders with their poses at the start of the tick
     * @param bounds the margin rule, and where the bodies may go within the tick
     */
    public ManifoldStage(ColliderStore colliders, BoundsStage bounds) {
        this(colliders, bounds, new PairGroups());
    }

    /**
     * A stage.
     *
     * @param colliders with their poses at the start of the tick
     * @param bounds the margin rule, and where the bodies may go within the tick
     * @param rows knows the pairs with several contacts
     */
    public ManifoldStage(ColliderStore colliders, BoundsStage bounds, ContactRows rows) {
        this(colliders, bounds, rows.groups);
    }

    private ManifoldStage(ColliderStore colliders, BoundsStage bounds, PairGroups groups) {
        this.colliders = colliders;
        kinds = new PairKinds(colliders, bounds);
        points = new PointStore(colliders);
        recycler = new PolyhedronRecycler(colliders);
        this.bounds = bounds;
        surfaces = new SurfaceStage(colliders, bounds, points, groups);
    }

    /**
     * Collides all active rows.
     *
     * @param stepSeconds length of the tick, s
     */
    public void run(ContactStore rows, double stepSeconds, Jobs jobs) {
        showWholes(rows, 1);
        collide(rows, stepSeconds, jobs);
        showWholes(rows, -1);
    }

    /**
     * Rows of wholes have the negative of their number of points but here and while {@code
     * WholeStage} has them solved: no other stage sees them.
     */
    private void showWholes(ContactStore rows, int sign) {
        for (int i = 0; colliders.wholes && i < rows.activeCount; i++) {
            int row = rows.active[i];
            if (colliders.isWhole(rows.colliderA[row]) || colliders.isWhole(rows.colliderB[row])) {
                rows.pointCount[row] = sign * Math.abs(rows.pointCount[row]);
            }
        }
    }

    private void collide(ContactStore rows, double stepSeconds, Jobs jobs) {
        contacts = rows;
        reach = stepSeconds * bounds.speculativeTime;
        scratch.ensure(jobs.workers());
        points.use(rows);
        recycler.use(rows, stepSeconds);
        if (rows.grouped) {
            surfaces.run(rows, stepSeconds, reach, jobs);
        }
        kinds.sort(rows, reach, jobs);
        int round = kinds.begin(PairKinds.ROUND);
        int others = kinds.begin(PairKinds.OTHERS);
        boxesInLanes = round >= PAIRS_FOR_LANES && BoxWarmUp.ready(++boxTicks);
        boxBlocks = Blocks.count(round, BOXES_PER_BLOCK);
        roundBlocks = Blocks.count(others - round, ROUND_PER_BLOCK);
        int rest = Blocks.count(kinds.count() - others, OTHERS_PER_BLOCK);
        if (rest > 0) {
            rows.beginMemory(PairMemory.SIZE);
        }
        jobs.run(job, boxBlocks + roundBlocks + rest);
    }

    private void block(int block, int worker) {
        Scratch own = scratch.of(worker);
        int round = kinds.begin(PairKinds.ROUND);
        int others = kinds.begin(PairKinds.OTHERS);
        if (block < boxBlocks) {
            int begin = Blocks.begin(block, BOXES_PER_BLOCK);
            int end = Blocks.end(block, BOXES_PER_BLOCK, round);
            boxes(begin, end - begin, own);
            points.fromBodies(kinds.order(), begin, end);
            return;
        }
        int b = block - boxBlocks;
        if (b < roundBlocks) {
            int begin = round + Blocks.begin(b, ROUND_PER_BLOCK);
            int end = round + Blocks.end(b, ROUND_PER_BLOCK, others - round);
            round(begin, end, own);
            points.fromBodies(kinds.order(), begin, end);
            return;
        }
        b -= roundBlocks;
        int[] order = kinds.order();
        int end = others + Blocks.end(b, OTHERS_PER_BLOCK, kinds.count() - others);
        int begin = others + Blocks.begin(b, OTHERS_PER_BLOCK);
        for (int i = begin; i < end; i++) {
            collide(order[i], own);
        }
        points.fromBodies(order, begin, end);
    }

    private void round(int begin, int end, Scratch own) {
        Poses s = colliders.poses;
        ContactStore c = contacts;
        int[] order = kinds.order();
        for (int i = begin; i < end; i++) {
            int row = order[i];
            int a = c.colliderA[row];
            int b = c.colliderB[row];
            boolean done =
                    own.round.collide(
                            colliders.shape[a],
                            colliders.shape[b],
                            s.orientationX[a],
                            s.orientationY[a],
                            s.orientationZ[a],
                            s.orientationW[a],
                            s.orientationX[b],
                            s.orientationY[b],
                            s.orientationZ[b],
                            s.orientationW[b],
                            s.apartX(a, b),
                            s.apartY(a, b),
                            s.apartZ(a, b),
                            margin(a, b),
                            own.manifold);
            if (done) {
                c.cache[row] = own.round.key();
                points.store(row, own.manifold, own.points);
            } else {
                collide(row, own);
            }
        }
    }

    private void boxes(int begin, int count, Scratch own) {
        int moved = renew(begin, count, own);
        BoxContacts batch = own.boxes;
        batch.useLanes(boxesInLanes && moved >= MOVED_FOR_LANES);
        batch.run(moved);
        for (int i = 0; i < moved; i++) {
            int row = own.row[i];
            if (!same(i, row, own)) {
                Box a = (Box) colliders.shape[contacts.colliderA[row]];
                Box b = (Box) colliders.shape[contacts.colliderB[row]];
                contacts.cache[row] = batch.take(i, a, b, own.manifold);
                points.store(row, own.manifold, own.points);
                recycler.keep(row, own.manifold, batch.leftOut(i), own.margin[i]);
            }
        }
    }

    /**
     * Four points of a pair that moves, with the names of the last tick, go straight into the row.
     */
    private boolean same(int i, int row, Scratch own) {
        ContactStore c = contacts;
        BoxContacts batch = own.boxes;
        int first = ContactStore.POINTS * row;
        if (c.pointCount[row] != 4
                || !batch.sameAligned(i, c.feature, first, c.order[row])
                || recycler.stays(row, false, batch.leftOut(i), own.margin[i])) {
            return false;
        }
        c.keeps[row] = false;
        c.patch[row] = 0;
        c.cache[row] =
                batch.write(
                        i,
                        c.order[row],
                        c.head,
                        ContactStore.head(row),
                        c.anchors,
                        ContactStore.anchor(first),
                        c.separation,
                        first);
        return true;
    }

    /** Renews what has hardly moved, and puts the rest into the batch; returns how many. */
    private int renew(int begin, int count, Scratch own) {
        ContactStore c = contacts;
        int[] order = kinds.order();
        int moved = 0;
        for (int i = begin; i < begin + count; i++) {
            int row = order[i];
            double margin = margin(c.colliderA[row], c.colliderB[row]);
            if (!recycler.renew(row, margin)) {
                put(moved++, row, margin, own);
            }
        }
        return moved;
    }

    private void put(int i, int row, double margin, Scratch own) {
        Poses s = colliders.poses;
        ContactStore c = contacts;
        int a = c.colliderA[row];
        int b = c.colliderB[row];
        own.row[i] = row;
        own.margin[i] = margin;
        own.boxes.put(
                i,
                (Box) colliders.shape[a],
                (Box) colliders.shape[b],
                s.orientationX[a],
                s.orientationY[a],
                s.orientationZ[a],
                s.orientationW[a],
                s.orientationX[b],
                s.orientationY[b],
                s.orientationZ[b],
                s.orientationW[b],
                s.apartX(a, b),
                s.apartY(a, b),
                s.apartZ(a, b),
                Math.min(colliders.innerRadius[a], colliders.innerRadius[b]),
                margin,
                c.cache[row]);
    }

    private void collide(int row, Scratch own) {
        Poses s = colliders.poses;
        ContactStore c = contacts;
        if (c.grouped && c.group[row] != 0) {
            return; // a surface has collided it
        }
        int a = c.colliderA[row];
        int b = c.colliderB[row];
        double margin = margin(a, b);
        boolean flat =
                PolyhedronRecycler.fits(colliders.shape[a])
                        && PolyhedronRecycler.fits(colliders.shape[b]);
        if (flat && recycler.renew(row, margin)) {
            return;
        }
        if (!flat && isFar(a, b, margin)) {
            // as the narrow phase leaves a pair with a round side that is apart
            c.cache[row] = 0;
            own.manifold.pointCount = 0;
            own.manifold.patch = 0;
            points.store(row, own.manifold, own.points);
            return;
        }
        if (flat) {
            own.narrowPhase.remember(c.memory, PairMemory.SIZE * row);
        }
        c.cache[row] =
                own.narrowPhase.collide(
                        colliders.shape[a],
                        colliders.shape[b],
                        s.orientationX[a],
                        s.orientationY[a],
                        s.orientationZ[a],
                        s.orientationW[a],
                        s.orientationX[b],
                        s.orientationY[b],
                        s.orientationZ[b],
                        s.orientationW[b],
                        s.apartX(a, b),
                        s.apartY(a, b),
                        s.apartZ(a, b),
                        margin,
                        c.cache[row],
                        own.manifold);
        points.store(row, own.manifold, own.points);
        if (flat) {
            recycler.keep(row, own.manifold, own.narrowPhase.leftOut(), margin);
        }
    }

    /**
     * Whether the balls around two colliders are further apart than the margin. In a heap every
     * other pair with a round side is: its boxes overlap at their corners. A moved shape may be
     * without a round side, and then remembers what separates it.
     */
    private boolean isFar(int a, int b, double margin) {
        Poses s = colliders.poses;
        if (colliders.shape[a] instanceof Moved || colliders.shape[b] instanceof Moved) {
            return false;
        }
        double x = s.apartX(a, b);
        double y = s.apartY(a, b);
        double z = s.apartZ(a, b);
        double reaches =
                (colliders.outerRadius[a] + colliders.outerRadius[b] + margin) * (1 + 0x1p-40);
        return x * x + y * y + z * z > reaches * reaches;
    }

    /** The speculative margin of a pair; see the package's essay. */
    private double margin(int a, int b) {
        return margin(a, b, Math.min(colliders.innerRadius[a], colliders.innerRadius[b]));
    }

    /** With the smaller inner radius. */
    private double margin(int a, int b, double smaller) {
        return bounds.margin(a, b, reach, smaller);
    }

    /** What one worker needs. */
    private static final class Scratch {
        final NarrowPhase narrowPhase = new NarrowPhase();
        final BoxContacts boxes = new BoxContacts(narrowPhase);
        final RoundContacts round = new RoundContacts();
        final int[] row = new int[BOXES_PER_BLOCK];
        final double[] margin = new double[BOXES_PER_BLOCK];
        final Manifold manifold = new Manifold();
        final PointStore.Scratch points = new PointStore.Scratch();
    }
}
