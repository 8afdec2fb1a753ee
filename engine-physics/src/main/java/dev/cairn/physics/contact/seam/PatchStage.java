package dev.cairn.physics.contact.seam;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.PerWorker;
import dev.cairn.physics.internal.Surface;

/**
 * Sees all contacts between two bodies of which one has parts. Contacts of several parts along one
 * normal are one patch: where its corners are at most four, one row is solved instead of the
 * parts', see {@link PatchRows}. So two boxes on a body are the box that they make.
 *
 * <pre>
 *   find  ─▶ rows of bodies with parts, in blocks of rows
 *   list  ─▶ those of each body that has two, in row order
 *   join  ─▶ rows that are solved instead of others, behind all rows, in blocks of bodies
 *   solve
 *   part  ─▶ their impulses go to the points that they stood for
 * </pre>
 *
 * <p>Works on what {@link SeamStage} leaves to be solved, its own rows included, so parts of a body
 * on several tiles come to one row, too. Nothing outlives a tick but what the points hold.
 *
 * <p>Between join and part, a row that another one stands for has the negative of its number of
 * points, so it is not solved. Simulation thread; allocates only when something grows. A world
 * without bodies with parts does not come here.
 */
public final class PatchStage {
    private static final int ROWS_PER_BLOCK = 512;
    private static final int BODIES_PER_BLOCK = 8;

    private final BlockJob findJob = this::findBlock;
    private final BlockJob joinJob = this::joinBlock;
    private final BlockJob partJob = this::partBlock;

    private final ColliderStore colliders;
    private final ContactStore contacts;

    /** Rows found in a block, at the block's rows; and how many. */
    private int[] found = {};

    private int[] foundInBlock = {};

    /** By body: how many were found, then minus 1 less its group; 0 between ticks. */
    private int[] groupOf = {};

    private int[] touched = {};

    /** By group: the body; where its members, and where its rows begin; how many of each. */
    private int[] owner = {}, firstMember = {}, firstRow = {}, size = {}, rows = {};

    private int groups, members, room, base;
    private int[] member = {};

    /** By row of a group: the first and the number of members that it stands for. */
    private int[] firstHeld = {}, held = {};

    /** By row of a group and corner: the point that the row's point is. */
    private int[] corner = {};

    /** By member and point: see {@link PatchRows#join}. */
    private byte[] share = {};

    private final PerWorker<PatchRows> patches;
    private int activeBefore;

    /**
     * A stage.
     *
     * @param colliders whose contacts these are, with their poses at the start of the tick
     * @param contacts the rows
     */
    public PatchStage(ColliderStore colliders, ContactStore contacts) {
        this.colliders = colliders;
        this.contacts = contacts;
        patches = new PerWorker<>(() -> new PatchRows(colliders, contacts));
    }

    /** Joins rows; after {@link SeamStage#join}, before the solve. */
    public void join(Jobs jobs) {
        groups = 0;
        activeBefore = contacts.activeCount;
        if (!contacts.compounds) {
            return;
        }
        int blocks = Blocks.count(contacts.activeCount, ROWS_PER_BLOCK);
        if (found.length < contacts.activeCount) {
            found = new int[contacts.bodyA.length];
            foundInBlock = new int[Blocks.count(found.length, ROWS_PER_BLOCK)];
        }
        jobs.run(findJob, blocks);
        list(blocks);
        if (groups == 0) {
            return;
        }
        ensureWorkers(jobs.workers());
        base = contacts.lend(room);
        jobs.run(joinJob, Blocks.count(groups, BODIES_PER_BLOCK));
        for (int g = 0; g < groups; g++) {
            for (int i = 0; i < rows[g]; i++) {
                contacts.active[contacts.activeCount++] = base + firstRow[g] + i;
            }
        }
    }

    /** Gives the rows back what was solved instead of them; after the solve. */
    public void part(Jobs jobs) {
        contacts.activeCount = activeBefore;
        if (groups > 0) {
            jobs.run(partJob, Blocks.count(groups, BODIES_PER_BLOCK));
        }
    }

    private void findBlock(int block, int worker) {
        int begin = Blocks.begin(block, ROWS_PER_BLOCK);
        int end = Blocks.end(block, ROWS_PER_BLOCK, contacts.activeCount);
        int at = begin;
        for (int i = begin; i < end; i++) {
            if (isOfParts(contacts.active[i])) {
                found[at++] = contacts.active[i];
            }
        }
        foundInBlock[block] = at - begin;
    }

    private boolean isOfParts(int row) {
        ContactStore c = contacts;
        return c.isSolved(row)
                && (colliders.hasParts(c.bodyA[row]) || colliders.hasParts(c.bodyB[row]))
                && Surface.isFlat(c.surfaceA[row])
                && Surface.isFlat(c.surfaceB[row]);
    }

    /** The body whose contacts are seen together: one that moves. */
    private int owner(int row) {
        int a = contacts.bodyA[row];
        return colliders.bodies.kind[a] == BodyStore.DYNAMIC ? a : contacts.bodyB[row];
    }

    /** Lists the bodies with two rows. */
    private void list(int blocks) {
        if (groupOf.length < colliders.bodies.slotCount) {
            groupOf = new int[colliders.bodies.slotCount + (colliders.bodies.slotCount >> 1)];
            touched = new int[groupOf.length];
        }
        int all = 0;
        for (int b = 0; b < blocks; b++) {
            int begin = Blocks.begin(b, ROWS_PER_BLOCK);
            for (int i = begin; i < begin + foundInBlock[b]; i++) {
                int body = owner(found[i]);
                if (groupOf[body]++ == 0) {
                    touched[all++] = body;
                }
            }
        }
        open(all);
        for (int b = 0; groups > 0 && b < blocks; b++) {
            int begin = Blocks.begin(b, ROWS_PER_BLOCK);
            for (int i = begin; i < begin + foundInBlock[b]; i++) {
                int g = -groupOf[owner(found[i])] - 1;
                if (g >= 0) {
                    member[firstMember[g] + size[g]++] = found[i];
                }
            }
        }
        for (int i = 0; i < all; i++) {
            groupOf[touched[i]] = 0;
        }
    }

    /** Opens the groups, and makes room for their rows. */
    private void open(int all) {
        if (owner.length < all) {
            int n = 2 * all;
            owner = new int[n];
            firstMember = new int[n];
            firstRow = new int[n];
            size = new int[n];
            rows = new int[n];
        }
        members = 0;
        room = 0;
        for (int i = 0; i < all; i++) {
            int body = touched[i];
            int n = groupOf[body];
            if (n < 2) {
                groupOf[body] = 0;
                continue;
            }
            int g = groups++;
            groupOf[body] = -groups;
            owner[g] = body;
            firstMember[g] = members;
            firstRow[g] = room;
            size[g] = 0;
            members += n;
            room += n / 2;
        }
        if (member.length < members) {
            member = new int[2 * members];
            share = new byte[ContactStore.POINTS * member.length];
        }
        if (held.length < room) {
            held = new int[2 * room];
            firstHeld = new int[held.length];
            corner = new int[ContactStore.POINTS * held.length];
        }
    }

    private void ensureWorkers(int workers) {
        patches.ensure(workers);
        int most = 1;
        for (int g = 0; g < groups; g++) {
            most = Math.max(most, size[g]);
        }
        for (int w = 0; w < patches.count(); w++) {
            patches.of(w).ensure(most);
        }
    }

    private void joinBlock(int block, int worker) {
        PatchRows p = patches.of(worker);
        int end = Blocks.end(block, BODIES_PER_BLOCK, groups);
        for (int g = Blocks.begin(block, BODIES_PER_BLOCK); g < end; g++) {
            int made = 0;
            int last = firstMember[g] + size[g];
            for (int from = firstMember[g]; from < last; ) {
                int to = p.gather(owner[g], member, from, last);
                int at = firstRow[g] + made;
                if (to - from > 1
                        && p.join(
                                owner[g],
                                base + at,
                                corner,
                                ContactStore.POINTS * at,
                                member,
                                from,
                                to,
                                share)) {
                    firstHeld[at] = from;
                    held[at] = to - from;
                    made++;
                }
                from = to;
            }
            rows[g] = made;
        }
    }

    private void partBlock(int block, int worker) {
        PatchRows p = patches.of(worker);
        int end = Blocks.end(block, BODIES_PER_BLOCK, groups);
        for (int g = Blocks.begin(block, BODIES_PER_BLOCK); g < end; g++) {
            for (int at = firstRow[g]; at < firstRow[g] + rows[g]; at++) {
                int from = firstHeld[at];
                p.part(
                        base + at,
                        corner,
                        ContactStore.POINTS * at,
                        member,
                        from,
                        from + held[at],
                        share);
            }
        }
    }
}
