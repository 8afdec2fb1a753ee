package dev.cairn.physics.contact.seam;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.contact.BoundsStage;
import dev.cairn.physics.contact.PointStore;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.PerWorker;
import dev.cairn.physics.narrowphase.pair.Reach;

/**
 * Sees all contacts of a collider with static bodies against each other: fixed bodies, the parts of
 * one body, kinematic bodies of one velocity. Where one plane holds the collider off several of
 * these, one row is solved instead of theirs, see {@link SeamPlanes}.
 *
 * <pre>
 *   find  ─▶ rows of a collider and such a neighbour, in blocks of rows
 *   list  ─▶ those of each collider that has two, in row order
 *   join  ─▶ rows that are solved instead of others, behind all rows, in blocks of colliders
 *   solve
 *   part  ─▶ their impulses go to the rows that they stood for
 * </pre>
 *
 * <p>Between join and part, a row that another one stands for has the negative of its number of
 * points, so it is not solved. Simulation thread; allocates only when something grows. A collider
 * with one neighbour is looked at and left alone.
 */
public final class SeamStage implements Stateful {
    private static final int ROWS_PER_BLOCK = 512;
    private static final int GROUPS_PER_BLOCK = 8;

    /** Rows for which there is room from the first group on. */
    private static final int LEAST = 32;

    private final BlockJob findJob = this::findBlock;
    private final BlockJob joinJob = this::joinBlock;
    private final BlockJob partJob = this::partBlock;

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final BoundsStage bounds;
    private final PointStore points;

    /** Twice a row, plus 1 where the touching collider is B; those of a block at its rows. */
    private int[] found = {};

    private int[] foundInBlock = {};

    /** By collider: how many were found, then minus 1 less its group; 0 between ticks. */
    private int[] groupOf = {};

    private int[] touched = {};

    /** By group: the collider; where its members, and where its rows begin; how many of each. */
    private int[] collider = {}, firstMember = {}, firstRow = {}, size = {}, rows = {};

    /** By group: the first group of a part of the same body; the lowest collider of all theirs. */
    private int[] firstPart = {}, base = {};

    private int groups, members, room;
    private int[] member = {};

    /** By row of a group: the first and the number of members that it stands for; see join. */
    private int[] firstHeld = {}, held = {};

    private SeamMemory last = new SeamMemory(), next = new SeamMemory();
    private final PerWorker<SeamPlanes> planes;
    private long tick;
    private double reach;
    private int activeBefore;

    /**
     * A stage.
     *
     * @param colliders whose contacts these are, with their poses at the start of the tick
     * @param contacts the rows
     * @param bounds the margin rule
     */
    public SeamStage(ColliderStore colliders, ContactStore contacts, BoundsStage bounds) {
        this.colliders = colliders;
        this.contacts = contacts;
        this.bounds = bounds;
        points = new PointStore(colliders);
        planes = new PerWorker<>(() -> new SeamPlanes(colliders, contacts, bounds, points));
    }

    /**
     * Joins rows; after the narrow phase and all that looks at its rows, before the solve.
     *
     * @param stepSeconds length of the tick, s
     */
    public void join(double stepSeconds, Jobs jobs) {
        tick++;
        groups = 0;
        contacts.endLoans();
        activeBefore = contacts.activeCount;
        int blocks = Blocks.count(contacts.activeCount, ROWS_PER_BLOCK);
        if (found.length < contacts.bodyA.length) {
            found = new int[contacts.bodyA.length];
            foundInBlock = new int[Blocks.count(found.length, ROWS_PER_BLOCK)];
        }
        jobs.run(findJob, blocks);
        if (blocks > 0) {
            makeRoom(jobs.workers());
        }
        list(blocks);
        if (groups == 0) {
            return;
        }
        points.use(contacts);
        reach = stepSeconds * bounds.speculativeTime;
        ensureWorkers(jobs.workers());
        jobs.run(joinJob, Blocks.count(groups, GROUPS_PER_BLOCK));
        for (int g = 0; g < groups; g++) {
            for (int i = 0; i < rows[g]; i++) {
                contacts.active[contacts.activeCount++] = contacts.count + firstRow[g] + i;
            }
        }
    }

    /** Room for the first groups, from the first contact on: the first seam may come late. */
    private void makeRoom(int workers) {
        ensureWorkers(workers);
        if (held.length < LEAST) {
            held = new int[LEAST];
            firstHeld = new int[LEAST];
        }
        // a heap that is stirred meets its largest number of groups late
        int wanted = Math.max(LEAST, colliders.slotCount / 2);
        if (collider.length < wanted) {
            ensureGroups(Math.max(wanted, 2 * collider.length));
        }
        if (member.length < LEAST) {
            member = new int[LEAST];
        }
        next.ensure(colliders.slotCount, held.length);
        last.ensure(colliders.slotCount, held.length);
    }

    private void ensureGroups(int n) {
        collider = new int[n];
        firstMember = new int[n];
        firstRow = new int[n];
        size = new int[n];
        firstPart = new int[n];
        base = new int[n];
        rows = new int[n];
    }

    /** Gives the rows back what was solved instead of them; after the solve. */
    public void part(Jobs jobs) {
        contacts.activeCount = activeBefore;
        if (groups > 0) {
            jobs.run(partJob, Blocks.count(groups, GROUPS_PER_BLOCK));
            SeamMemory read = last;
            last = next;
            next = read;
        }
    }

    /** Where joined rows ended: the only thing that outlives a tick. */
    @Override
    public void state(StateVisitor s) {
        s.section("seams", this);
        tick = s.value("tick", tick);
        last.state(s, tick);
    }

    private void findBlock(int block, int worker) {
        int begin = Blocks.begin(block, ROWS_PER_BLOCK);
        int end = Blocks.end(block, ROWS_PER_BLOCK, contacts.activeCount);
        int at = begin;
        for (int i = begin; i < end; i++) {
            int row = contacts.active[i];
            if (contacts.isSolved(row)) {
                int side = side(row);
                if (side >= 0) {
                    found[at++] = 2 * row + side;
                }
            }
        }
        foundInBlock[block] = at - begin;
    }

    /** Which collider of a row touches a neighbour of the other kind: 0 for A, 1 for B, or -1. */
    private int side(int row) {
        ContactStore c = contacts;
        int a = c.bodyA[row];
        int b = c.bodyB[row];
        BodyStore s = colliders.bodies;
        boolean movesA = s.kind[a] == BodyStore.DYNAMIC;
        boolean movesB = s.kind[b] == BodyStore.DYNAMIC;
        int side;
        if (movesA && movesB) {
            boolean partsA = colliders.hasParts(a);
            boolean partsB = colliders.hasParts(b);
            if (partsA == partsB) {
                return -1;
            }
            side = partsB ? 0 : 1;
        } else {
            side = movesA ? 0 : 1;
        }
        boolean fits =
                Reach.fits(colliders.shape[c.colliderA[row]])
                        && Reach.fits(colliders.shape[c.colliderB[row]]);
        return fits && (movesA || movesB) ? side : -1;
    }

    private boolean isOneOfParts(int c) {
        return colliders.isChild(c) && colliders.hasParts(colliders.body[c]);
    }

    private int touching(int entry) {
        return (entry & 1) == 0 ? contacts.colliderA[entry >> 1] : contacts.colliderB[entry >> 1];
    }

    private int other(int entry) {
        return (entry & 1) == 0 ? contacts.colliderB[entry >> 1] : contacts.colliderA[entry >> 1];
    }

    /** Lists the colliders with two neighbours, or that had them in the last tick. */
    private void list(int blocks) {
        if (groupOf.length < colliders.slotCount) {
            groupOf = new int[colliders.slotCount + (colliders.slotCount >> 1)];
            touched = new int[groupOf.length];
        }
        int all = 0;
        for (int b = 0; b < blocks; b++) {
            int begin = Blocks.begin(b, ROWS_PER_BLOCK);
            for (int i = begin; i < begin + foundInBlock[b]; i++) {
                int m = touching(found[i]);
                if (groupOf[m]++ == 0) {
                    touched[all++] = m;
                }
            }
        }
        if (all == 0) {
            return;
        }
        open(all);
        if (groups > 0) {
            for (int b = 0; b < blocks; b++) {
                int begin = Blocks.begin(b, ROWS_PER_BLOCK);
                for (int i = begin; i < begin + foundInBlock[b]; i++) {
                    put(found[i]);
                }
            }
        }
        for (int i = 0; i < all; i++) {
            groupOf[touched[i]] = 0;
        }
    }

    private void put(int entry) {
        int m = touching(entry);
        int g = -groupOf[m] - 1;
        if (g < 0) {
            return;
        }
        member[firstMember[g] + size[g]++] = entry;
        if (isOneOfParts(m)) {
            // parts of one body say the same
            int part = firstPart[g];
            base[part] = Math.min(base[part], other(entry));
        }
    }

    /** Opens the groups, and makes room for their rows. */
    private void open(int all) {
        if (collider.length < all) {
            ensureGroups(2 * all);
        }
        members = 0;
        room = 0;
        for (int i = 0; i < all; i++) {
            int m = touched[i];
            if (!isOneOfParts(m)) {
                open(m, groups, 2);
                continue;
            }
            int first = groups;
            int part = colliders.bodies.collider[colliders.body[m]];
            int least = anyCrosses(part) ? 1 : 2;
            for (; part != ColliderStore.NONE; part = colliders.next[part]) {
                open(part, first, least);
            }
        }
        if (member.length < members) {
            member = new int[Math.max(LEAST, 2 * members)];
        }
        if (held.length < room) {
            held = new int[Math.max(LEAST, 2 * room)];
            firstHeld = new int[held.length];
        }
        if (room > 0) {
            next.ensure(colliders.slotCount, held.length);
            next.begin(room);
            contacts.lend(room);
        }
    }

    /** Whether one of the parts from this one on has two neighbours, or had joined rows. */
    private boolean anyCrosses(int first) {
        boolean any = false;
        for (int c = first; c != ColliderStore.NONE; c = colliders.next[c]) {
            any |= groupOf[c] >= 2 || (groupOf[c] == 1 && last.count(c, tick - 1) > 0);
        }
        return any;
    }

    /** Opens the group of a collider, if it was found at least so often and has none yet. */
    private void open(int m, int first, int least) {
        int n = groupOf[m];
        if (n <= 0) {
            return;
        }
        if (n < least && last.count(m, tick - 1) == 0) {
            groupOf[m] = 0;
            return;
        }
        int g = groups++;
        groupOf[m] = -groups;
        collider[g] = m;
        firstPart[g] = first;
        base[g] = Integer.MAX_VALUE;
        firstMember[g] = members;
        firstRow[g] = room;
        size[g] = 0;
        members += n;
        room += Math.min(n, SeamPlanes.MOST);
    }

    private void ensureWorkers(int workers) {
        planes.ensure(workers);
        int most = 1;
        for (int g = 0; g < groups; g++) {
            most = Math.max(most, size[g]);
        }
        for (int w = 0; w < planes.count(); w++) {
            planes.of(w).ensure(most);
        }
    }

    private void joinBlock(int block, int worker) {
        SeamPlanes p = planes.of(worker);
        int end = Blocks.end(block, GROUPS_PER_BLOCK, groups);
        for (int g = Blocks.begin(block, GROUPS_PER_BLOCK); g < end; g++) {
            p.begin(collider[g], member, firstMember[g], size[g], reach);
            p.stand(isOneOfParts(collider[g]) ? base[firstPart[g]] : ColliderStore.NONE);
            p.remember(last, last.count(collider[g], tick - 1));
            rows[g] = p.join(contacts.count + firstRow[g], firstRow[g], firstHeld, held);
        }
    }

    private void partBlock(int block, int worker) {
        SeamPlanes p = planes.of(worker);
        int end = Blocks.end(block, GROUPS_PER_BLOCK, groups);
        for (int g = Blocks.begin(block, GROUPS_PER_BLOCK); g < end; g++) {
            for (int i = firstMember[g]; i < firstMember[g] + size[g]; i++) {
                int row = member[i] >> 1;
                contacts.pointCount[row] = Math.abs(contacts.pointCount[row]);
            }
            for (int r = firstRow[g]; r < firstRow[g] + rows[g]; r++) {
                int row = contacts.count + r;
                int at = firstMember[g] + firstHeld[r];
                boolean isSecond = contacts.colliderB[row] == collider[g];
                next.save(r, contacts, row, isSecond);
                p.spread(next, r, member, at, held[r]);
            }
            next.put(collider[g], tick, firstRow[g], rows[g]);
        }
    }
}
