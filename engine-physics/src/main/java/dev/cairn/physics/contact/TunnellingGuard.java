package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.broadphase.AabbTree;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.broadphase.RayTraversal;
import dev.cairn.physics.contact.impact.Depenetration;
import dev.cairn.physics.contact.impact.ImpactStage;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.EdgeSource;
import dev.cairn.physics.internal.PerWorker;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.narrowphase.pair.Reach;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.query.Placement;
import dev.cairn.physics.query.ShapeQueries;

import org.jspecify.annotations.Nullable;

/**
 * The centre of a convex body, and that of each part of a body of several shapes, does not pass
 * what does not answer to it, however fast the body is and whatever its contacts did.
 *
 * <p>A contact has the points of one moment. A stick that strikes with a tip at a thousand metres a
 * second turns about it by many rounds within the tick, and its contacts know of none; and a body
 * that is struck within the tick goes where no contacts were looked for. So the way of the centre
 * over the whole tick is looked at afterwards; where it meets the other surface, the body stops
 * there, and loses the rest of the tick and the speed at which it went in.
 *
 * <pre>
 *   bodies ─▶ fast: covered more than a part of the inner radius; in blocks
 *   rows   ─▶ those of fast bodies with what does not answer; in blocks
 *   guard  ─▶ the way of the centre against each, in row order
 *   struck ─▶ fast bodies that left the box of which pairs were made: the static tree, along the way,
 *             and what has no end
 * </pre>
 *
 * <p>In almost all cases contacts have done it, and nothing is changed. What a {@link
 * dev.cairn.physics.collider.ContactHook} lets through is let through: while there is one, only
 * rows that were solved are looked at.
 */
final class TunnellingGuard {
    private static final int BODIES_PER_BLOCK = 256;
    private static final int ROWS_PER_BLOCK = 512;

    /** Of the inner radius: what covers less in a tick is not looked at. */
    private static final double FAST = 0.5;

    private static final int NONE = ColliderStore.NONE;

    /** Each body of an assembly that is put back takes the others with it: looks, at most. */
    private static final int MOST_PASSES = 8;

    /** Of the inner radius: how far the centre stays away. */
    private static final double AWAY = 0.25;

    private final BlockJob bodiesJob = this::bodiesBlock;
    private final BlockJob rowsJob = this::rowsBlock;

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final BoundsStage bounds;
    private final Depenetration depenetration;
    private final RayTraversal walk = new RayTraversal();
    private final ShapeQueries queries = new ShapeQueries();
    private final Placement surface = new Placement();
    private final Hit hit = new Hit();
    private final double[] box = new double[6];
    private final double[] start = new double[3], middle = new double[3];
    private final RotatingFrame frame;

    private final PerWorker<double[]> scratch = new PerWorker<>(() -> new double[3]);
    private int[] dynamic = {};
    private int dynamicCount;
    private double step;

    /** By body slot: it was fast in this tick. */
    private boolean[] fast = {};

    /** By block of bodies: how many are fast; by block of rows: how many are looked at. */
    private int[] fastCount = {}, rowCount = {};

    TunnellingGuard(
            ColliderStore colliders,
            ContactStore contacts,
            BoundsStage bounds,
            EdgeSource[] edges) {
        this.colliders = colliders;
        this.contacts = contacts;
        this.bounds = bounds;
        depenetration = new Depenetration(colliders, edges);
        frame = new RotatingFrame(colliders, bounds);
    }

    /** Keeps what is known of the start of the tick alone; before the solve. */
    void begin() {
        frame.begin();
    }

    /**
     * Looks at where bodies have gone; after the solve.
     *
     * @param bodies slots of the dynamic bodies that were moved
     * @param state by active row, what {@link SweepStage} saw in it before the solve
     * @param isAnyDriven whether a kinematic body moves
     * @param isHooked whether a hook may let bodies through
     * @param struck the bodies that were struck within the tick
     * @param stepSeconds length of the tick, s
     */
    void run(
            int[] bodies,
            int count,
            byte[] state,
            BroadPhase broadPhase,
            boolean isAnyDriven,
            boolean isHooked,
            @Nullable ImpactStage struck,
            double stepSeconds,
            Jobs jobs) {
        frame.use(struck, stepSeconds);
        dynamic = bodies;
        dynamicCount = count;
        step = stepSeconds;
        scratch.ensure(jobs.workers());
        int bodyBlocks = Blocks.count(count, BODIES_PER_BLOCK);
        int rowBlocks = Blocks.count(contacts.activeCount, ROWS_PER_BLOCK);
        ensure(bodyBlocks, rowBlocks);
        depenetration.ensureSlots();
        depenetration.weigh(bounds.gravityX, bounds.gravityY, bounds.gravityZ);
        jobs.run(bodiesJob, bodyBlocks);
        boolean any = isAnyDriven;
        for (int b = 0; b < bodyBlocks; b++) {
            any |= fastCount[b] > 0;
        }
        if (!any) {
            return;
        }
        depenetration.tie(dynamic, dynamicCount);
        composeMoved();
        jobs.run(rowsJob, rowBlocks);
        int moves = -1;
        for (int i = 0; i < MOST_PASSES && depenetration.moves() != moves; i++) {
            moves = depenetration.moves();
            guard(state, broadPhase, isHooked, bodyBlocks, rowBlocks);
        }
    }

    private void guard(
            byte[] state, BroadPhase broadPhase, boolean isHooked, int bodyBlocks, int rowBlocks) {
        for (int k = 0; k < 2 * rowBlocks; k++) {
            boolean last = k >= rowBlocks;
            if (rowCount[k % rowBlocks] > 0 || (last && depenetration.any())) {
                guardRows(k % rowBlocks, state, isHooked, last);
            }
        }
        for (int b = 0; b < bodyBlocks && !isHooked; b++) {
            if (fastCount[b] > 0) {
                guardStruck(b, broadPhase);
            }
        }
    }

    /** All bodies have moved already, and so have their parts, of slow bodies too. */
    private void composeMoved() {
        for (int i = 0; i < colliders.compoundCount; i++) {
            int body = colliders.compound[i];
            if (frame.moves(body)) {
                colliders.compose(body, scratch.of(0));
            }
        }
    }

    private void ensure(int bodyBlocks, int rowBlocks) {
        if (fast.length < colliders.slotCount) {
            fast = new boolean[colliders.poses.positionX.length];
        }
        if (fastCount.length < bodyBlocks) {
            fastCount = new int[Blocks.count(colliders.poses.positionX.length, BODIES_PER_BLOCK)];
        }
        if (rowCount.length < rowBlocks) {
            rowCount = new int[Blocks.count(contacts.bodyA.length, ROWS_PER_BLOCK)];
        }
    }

    private void bodiesBlock(int block, int worker) {
        int end = Blocks.end(block, BODIES_PER_BLOCK, dynamicCount);
        int count = 0;
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            int slot = dynamic[i];
            fast[slot] = isSingle(slot) ? isFast(slot) : isAnyFast(slot, scratch.of(worker));
            count += fast[slot] ? 1 : 0;
        }
        fastCount[block] = count;
    }

    private boolean isSingle(int body) {
        return colliders.bodies.collider[body] == body
                && colliders.next[body] == ColliderStore.NONE;
    }

    private boolean isFast(int c) {
        double x = frame.wayX(c);
        double y = frame.wayY(c);
        double z = frame.wayZ(c);
        double least = least(c);
        boolean isSolid = colliders.innerRadius[c] > 0 && !colliders.sensor[c];
        return x * x + y * y + z * z > least * least && isSolid && !colliders.isPart(c);
    }

    /**
     * A way that is looked at is longer than this, m; any is, of a body that was struck or put
     * back.
     */
    private double least(int c) {
        boolean any = frame.late(c) > 0 || depenetration.hasMoved(colliders.body[c]);
        return any ? 0 : FAST * colliders.innerRadius[c];
    }

    /**
     * Whether a part of a body was fast. The parts are put where the body is now, if one could have
     * been: by where it was to go, and by how fast it is.
     */
    private boolean isAnyFast(int body, double[] own) {
        BodyStore s = colliders.bodies;
        double x = s.velocityX[body];
        double y = s.velocityY[body];
        double z = s.velocityZ[body];
        double wx = s.angularVelocityX[body];
        double wy = s.angularVelocityY[body];
        double wz = s.angularVelocityZ[body];
        double now = length(x, y, z) + length(wx, wy, wz) * s.outerRadius[body];
        boolean maybe = false;
        for (int c = s.collider[body]; c != ColliderStore.NONE; c = colliders.next[c]) {
            double[] ahead = bounds.ahead;
            int at = BoundsStage.AHEAD * c;
            double way = step * length(ahead[at], ahead[at + 1], ahead[at + 2]) + ahead[at + 3];
            maybe |= Math.max(way, step * now) > FAST * colliders.innerRadius[c];
        }
        if (!maybe) {
            return false;
        }
        colliders.compose(body, own);
        boolean any = false;
        for (int c = s.collider[body]; c != ColliderStore.NONE; c = colliders.next[c]) {
            any |= isFast(c);
        }
        return any;
    }

    private void rowsBlock(int block, int worker) {
        int end = Blocks.end(block, ROWS_PER_BLOCK, contacts.activeCount);
        int count = 0;
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            count += looksAt(contacts.active[i]) ? 1 : 0;
        }
        rowCount[block] = count;
    }

    /** Whether one body of a row was fast, and moves. */
    private boolean looksAt(int row) {
        ContactStore c = contacts;
        return isFastMover(c.bodyA[row])
                || isFastMover(c.bodyB[row])
                || isDriven(c.colliderA[row], c.colliderB[row])
                || isDriven(c.colliderB[row], c.colliderA[row]);
    }

    /** Whether a driven collider was fast, as seen from another one. */
    private boolean isDriven(int driven, int part) {
        BodyStore s = colliders.bodies;
        int body = colliders.body[driven];
        if (!s.isMoved(body)) {
            return false;
        }
        Poses p = colliders.poses;
        double apart =
                length(p.apartX(part, driven), p.apartY(part, driven), p.apartZ(part, driven));
        double x = s.angularVelocityX[body];
        double y = s.angularVelocityY[body];
        double z = s.angularVelocityZ[body];
        return frame.way(driven) + step * length(x, y, z) * apart
                > FAST * colliders.innerRadius[part];
    }

    private boolean isDynamic(int body) {
        return colliders.bodies.kind[body] == BodyStore.DYNAMIC;
    }

    private boolean isFastMover(int body) {
        return isDynamic(body) && (fast[body] || depenetration.hasMoved(body));
    }

    /**
     * Rows of two bodies that answer come first, those with what does not answer last: a body that
     * is put back from the one is not left in the other.
     */
    private void guardRows(int block, byte[] state, boolean isHooked, boolean last) {
        ContactStore c = contacts;
        int end = Blocks.end(block, ROWS_PER_BLOCK, c.activeCount);
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = c.active[i];
            boolean answers = isDynamic(c.bodyA[row]) && isDynamic(c.bodyB[row]);
            if (answers == last || !looksAt(row) || (isHooked && !c.isSolved(row))) {
                continue;
            }
            boolean isSeen = state[i] != SweepStage.HARMLESS;
            guardRow(c.colliderA[row], c.colliderB[row], isSeen, isHooked);
            guardRow(c.colliderB[row], c.colliderA[row], isSeen, isHooked);
        }
    }

    /** Looks at the way of one collider of a row as seen from the other one. */
    private void guardRow(int part, int other, boolean isSeen, boolean isHooked) {
        int body = colliders.body[part];
        if (!isDynamic(body)
                || !(depenetration.isLoose(body) || isSeen)
                || isWider(part, other)
                || isCovered(part, other, isHooked)) {
            return;
        }
        keepOut(part, other);
    }

    /**
     * Whether a part's whole, which has a row too, is kept out in its place; a hook sees the rows
     * of parts. Behind what is thinner than the parts, one of them may be held off to the wrong
     * side.
     */
    private boolean isCovered(int part, int other, boolean isHooked) {
        boolean isThin =
                colliders.innerRadius[other] < colliders.innerRadius[part]
                        && Reach.fits(colliders.shape[other]);
        return colliders.isPart(part) && !isHooked && !isThin;
    }

    /**
     * Whether another one that answers is the smaller one, whose centre it is that passes: from a
     * ball that turns beside a wall, the middle of the wall seems to go round.
     */
    private boolean isWider(int part, int other) {
        return isDynamic(colliders.body[other])
                && colliders.outerRadius[part] > colliders.outerRadius[other];
    }

    /** A body that has left its box meets others that are in no pair with it. */
    private void guardStruck(int block, BroadPhase broadPhase) {
        int end = Blocks.end(block, BODIES_PER_BLOCK, dynamicCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            int slot = dynamic[i];
            int c =
                    fast[slot] && depenetration.isLoose(slot)
                            ? colliders.bodies.collider[slot]
                            : NONE;
            for (; c != NONE; c = colliders.next[c]) {
                if (isFast(c) && !isInBox(c, broadPhase.fatBoxes())) {
                    follow(c, broadPhase);
                }
            }
        }
    }

    private boolean isInBox(int slot, double[] fat) {
        Poses p = colliders.poses;
        return isBetween(fat, 6 * slot, p.positionX[slot])
                && isBetween(fat, 6 * slot + 1, p.positionY[slot])
                && isBetween(fat, 6 * slot + 2, p.positionZ[slot]);
    }

    private static boolean isBetween(double[] fat, int low, double centre) {
        return fat[low] <= centre && centre <= fat[low + 3];
    }

    private void follow(int slot, BroadPhase broadPhase) {
        double x = frame.wayX(slot);
        double y = frame.wayY(slot);
        double z = frame.wayZ(slot);
        double way = frame.way(slot);
        double reach = AWAY * colliders.innerRadius[slot];
        for (int axis = 0; axis < 3; axis++) {
            box[axis] = bounds.start[3 * slot + axis] - reach;
            box[axis + 3] = bounds.start[3 * slot + axis] + reach;
        }
        for (int tree = 0; tree < 2; tree++) {
            walk.start(
                    tree == 0 ? broadPhase.staticTree() : broadPhase.dynamicTree(),
                    box,
                    x / way,
                    y / way,
                    z / way);
            for (int other = walk.next(way);
                    other != AabbTree.NONE;
                    other = walk.next(frame.way(slot))) {
                meet(slot, other, broadPhase);
            }
        }
        // what has no end is in no tree
        for (int i = 0; i < broadPhase.endlessCount(); i++) {
            meet(slot, broadPhase.endless()[i], broadPhase);
        }
    }

    private void meet(int slot, int other, BroadPhase broadPhase) {
        if (colliders.body[other] != colliders.body[slot]
                && !colliders.sensor[other]
                && !broadPhase.isPair(slot, other)
                && broadPhase.admits(slot, other)) {
            keepOut(slot, other);
        }
    }

    private static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }

    /**
     * Looks at the way of a part's centre, as seen from the other collider's centre. Of a part that
     * goes round it is the chord: at its end the part is where it is.
     *
     * @param part a collider of a dynamic body
     * @param other a collider that is where it is at the end of the tick
     */
    private void keepOut(int part, int other) {
        Poses p = colliders.poses;
        if (!frame.see(part, other, start)) {
            return;
        }
        double wayX = p.apartX(part, other) - start[0];
        double wayY = p.apartY(part, other) - start[1];
        double wayZ = p.apartZ(part, other) - start[2];
        double least = least(part);
        double square = wayX * wayX + wayY * wayY + wayZ * wayZ;
        if (square > least * least) {
            surface.setCentre(
                    colliders.shape[other],
                    start[0],
                    start[1],
                    start[2],
                    p.orientationX[other],
                    p.orientationY[other],
                    p.orientationZ[other],
                    p.orientationW[other]);
            keepBefore(part, other, wayX, wayY, wayZ, Math.sqrt(square));
        }
    }

    /**
     * Whether what a part meets is between it and its whole's middle: then it is held off on the
     * wrong side, and comes back.
     *
     * @param height of the part's start over the plane of {@link #hit}, m
     */
    private boolean isBehind(int part, int other, double height) {
        if (!colliders.isPart(part) || !frame.see(colliders.standIn(part), other, middle)) {
            return false;
        }
        double x = hit.normalX() * (start[0] - middle[0]);
        double y = hit.normalY() * (start[1] - middle[1]);
        double z = hit.normalZ() * (start[2] - middle[2]);
        return height + (x + y + z) < 0;
    }

    /**
     * Follows the way as a ray, against {@link #surface}. What comes from the back of a one-sided
     * triangle passes.
     *
     * <p>Contacts push out what is in a solid but for its centre; a surface of triangles has no
     * inside, so the centre must not come too near either.
     */
    private void keepBefore(
            int part, int other, double wayX, double wayY, double wayZ, double way) {
        boolean isSolid = Reach.fits(colliders.shape[other]);
        double inner = colliders.innerRadius[part];
        double most = isSolid ? way : way + inner;
        if (!queries.rayCast(surface, 0, 0, 0, -wayX, -wayY, -wayZ, most, hit)
                || hit.startsInside()) {
            return;
        }
        double closing = hit.normalX() * wayX + hit.normalY() * wayY + hit.normalZ() * wayZ;
        double height = hit.distance() * closing / way;
        double away = Math.min(AWAY * inner, 0.5 * height);
        double rest = 1 - hit.distance() / way + away / closing;
        if (!(rest > 0) || isBehind(part, other, height)) {
            return;
        }
        depenetration.stop(
                colliders.body[part],
                colliders.body[other],
                rest * wayX,
                rest * wayY,
                rest * wayZ,
                -hit.normalX(),
                -hit.normalY(),
                -hit.normalZ());
    }
}
