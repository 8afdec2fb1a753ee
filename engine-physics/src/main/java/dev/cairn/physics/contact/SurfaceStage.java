package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactMaterials;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.MovedTurn;
import dev.cairn.physics.internal.PerWorker;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.internal.Surface;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.mesh.ContactList;
import dev.cairn.physics.narrowphase.mesh.MeshContact;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.mesh.Meshed;
import dev.cairn.physics.shape.mesh.TriangleSet;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * The pairs of a convex collider and a surface of triangles: each has a contact for each normal
 * along which something touches, and a row for each contact.
 *
 * <pre>
 *   collide ─▶ contacts of each pair, in blocks of pairs, into the list of the block
 *   count   ─▶ rows that are missing, in the order of pairs, at the end of the store
 *   store   ─▶ each contact into the row that was most like it, in blocks of pairs
 * </pre>
 *
 * <p>Most like: names in common with the row's points, and the nearest normal. So a ball that rolls
 * over facets stays one row, whichever triangle it is on, and keeps its impulses.
 *
 * <p>Simulation thread; allocates only when something grows. A world without such surfaces does not
 * come here.
 */
final class SurfaceStage {
    private static final int PAIRS_PER_BLOCK = 8;

    /** More combinations of contacts and rows than these are joined in their order. */
    private static final int MOST_COMPARED = 1 << 14;

    /** What a name in common weighs, in cosines of the angle between normals. */
    private static final double NAME = 0.5;

    /**
     * Of the share of the inner radius that is looked through beyond where bodies may go: a surface
     * has more points within it than carry.
     */
    private static final double STILL = 0.25;

    /** In place of how many contacts a pair has: those of the last tick. */
    private static final int KEPT = -1;

    private final BlockJob collideJob = this::collideBlock;
    private final BlockJob storeJob = this::storeBlock;
    private final ColliderStore colliders;
    private final BoundsStage bounds;
    private final PointStore points;
    private final PairGroups groups;

    private ContactStore contacts = new ContactStore();
    private double reach, step;

    /** First rows of the groups of this tick, ascending. */
    private int[] first = {};

    private int count;

    /** Of each pair: where its contacts begin in the list of its block; and how many. */
    private int[] begin = {}, size = {};

    private ContactList[] lists = {};
    private final PerWorker<Scratch> scratch;

    SurfaceStage(
            ColliderStore colliders, BoundsStage bounds, PointStore points, PairGroups groups) {
        this.colliders = colliders;
        this.bounds = bounds;
        this.points = points;
        this.groups = groups;
        scratch = new PerWorker<>(() -> new Scratch(new SurfaceRecycler(colliders, groups)));
    }

    /** Collides the pairs with an active row. */
    void run(ContactStore rows, double stepSeconds, double reachSeconds, Jobs jobs) {
        contacts = rows;
        step = stepSeconds;
        reach = reachSeconds;
        if (first.length < rows.bodyA.length) {
            first = new int[rows.bodyA.length];
            begin = new int[first.length];
            size = new int[first.length];
        }
        count = 0;
        for (int i = 0; i < rows.activeCount; i++) {
            if (rows.group[rows.active[i]] > 0) {
                first[count++] = rows.active[i];
            }
        }
        if (count == 0) {
            return;
        }
        groups.chain(rows);
        int blocks = Blocks.count(count, PAIRS_PER_BLOCK);
        prepare(blocks, jobs.workers());
        for (int w = 0; w < scratch.count(); w++) {
            scratch.of(w).recycler.use(rows, step);
        }
        jobs.run(collideJob, blocks);
        addRows();
        jobs.run(storeJob, blocks);
    }

    /**
     * Lists and scratch for so many. All lists are as large as the largest, so that bodies that
     * crowd into one block after the other let them grow once.
     */
    private void prepare(int blocks, int workers) {
        if (lists.length < blocks) {
            int old = lists.length;
            lists = Arrays.copyOf(lists, Math.max(blocks, 2 * old));
            for (int b = old; b < lists.length; b++) {
                lists[b] = new ContactList();
            }
        }
        int largest = 0;
        for (ContactList list : lists) {
            largest = Math.max(largest, list.capacity());
        }
        for (ContactList list : lists) {
            list.ensureCapacity(largest);
        }
        scratch.ensure(workers);
    }

    private void addRows() {
        ContactStore c = contacts;
        for (int i = 0; i < count; i++) {
            int missing = Math.max(0, size[i]);
            for (int row = first[i]; row >= 0; row = groups.next(row)) {
                missing--;
            }
            for (; missing > 0; missing--) {
                int row = c.count;
                c.append(1);
                ContactMaterials.join(
                        c, row, colliders, c.colliderA[first[i]], c.colliderB[first[i]]);
                int group = c.group[first[i]];
                c.group[row] = -group;
                groups.append(c, group, row);
            }
        }
    }

    /** The triangles of a collider's shape, or null. */
    static @Nullable TriangleSet triangles(Shape shape) {
        Shape inner = Surface.unmoved(shape);
        return inner instanceof Meshed m ? TriangleSet.of(m) : null;
    }

    private void collideBlock(int block, int worker) {
        ContactList list = lists[block];
        list.count = 0;
        int end = Blocks.end(block, PAIRS_PER_BLOCK, count);
        for (int i = Blocks.begin(block, PAIRS_PER_BLOCK); i < end; i++) {
            begin[i] = list.count;
            boolean isKept = !collide(first[i], scratch.of(worker), list);
            size[i] = isKept ? KEPT : list.count - begin[i];
        }
    }

    /** Returns false if the pair's rows are renewed as they are. */
    private boolean collide(int row, Scratch own, ContactList out) {
        Poses p = colliders.poses;
        boolean isFirst = triangles(colliders.shape[contacts.colliderA[row]]) != null;
        int s = isFirst ? contacts.colliderA[row] : contacts.colliderB[row];
        int b = isFirst ? contacts.colliderB[row] : contacts.colliderA[row];
        TriangleSet set = triangles(colliders.shape[s]);
        if (set == null) {
            return true; // the shape was replaced, and the rows leave in the next tick
        }
        double[] ahead = bounds.ahead;
        int j = BoundsStage.AHEAD * b;
        int i = BoundsStage.AHEAD * s;
        double vx = reach * (ahead[j] - ahead[i]);
        double vy = reach * (ahead[j + 1] - ahead[i + 1]);
        double vz = reach * (ahead[j + 2] - ahead[i + 2]);
        double still = STILL * bounds.speculativeFraction * colliders.innerRadius[b];
        double within = ahead[j + 3] + ahead[i + 3] + still;
        double most = within + Math.sqrt(vx * vx + vy * vy + vz * vz);
        double face = bounds.margin(s, b, reach, colliders.innerRadius[b]);
        if (colliders.isChild(b)) {
            // what another part of its body strikes may bring it down
            within = face;
            vx = 0;
            vy = 0;
            vz = 0;
        }
        // half of what is looked through beyond where they may go is more than kept pairs move
        if (own.recycler.renew(row, s, b, most, face, 0.5 * still)) {
            return false;
        }
        if (own.recycler.keep(row, s, b, most)) {
            // it may go another way while it is kept
            within = most;
            vx = 0;
            vy = 0;
            vz = 0;
        }
        own.turn(p, s, colliders.shape[s]);
        remember(row, isFirst, own);
        own.mesh.collide(
                set,
                own.qx,
                own.qy,
                own.qz,
                own.qw,
                colliders.shape[b],
                p.orientationX[b],
                p.orientationY[b],
                p.orientationZ[b],
                p.orientationW[b],
                p.apartX(s, b),
                p.apartY(s, b),
                p.apartZ(s, b),
                vx,
                vy,
                vz,
                within,
                face,
                out);
        return true;
    }

    /** Tells what the rows of the pair were. */
    private void remember(int head, boolean isFirst, Scratch own) {
        ContactStore c = contacts;
        int n = 0;
        double sign = isFirst ? 1 : -1;
        for (int row = head; row >= 0; row = groups.next(row)) {
            if (c.pointCount[row] == 0) {
                continue;
            }
            own.ensure(n + 1);
            own.normal[3 * n] = sign * c.normalX(row);
            own.normal[3 * n + 1] = sign * c.normalY(row);
            own.normal[3 * n + 2] = sign * c.normalZ(row);
            int names = 0;
            for (int k = 0; k < c.pointCount[row]; k++) {
                int name = c.feature[ContactStore.POINTS * row + k];
                names |= FeatureIds.hash(isFirst ? name : ContactList.swapped(name)) << (8 * k);
            }
            own.names[n++] = names;
        }
        own.mesh.remember(own.normal, own.names, n);
    }

    // Rows ---------------------------------------------------------------------------------------

    private void storeBlock(int block, int worker) {
        int end = Blocks.end(block, PAIRS_PER_BLOCK, count);
        for (int i = Blocks.begin(block, PAIRS_PER_BLOCK); i < end; i++) {
            if (size[i] != KEPT) {
                store(i, lists[block], scratch.of(worker));
            }
        }
    }

    private void store(int i, ContactList list, Scratch own) {
        int head = first[i];
        int n = 0;
        for (int row = head; row >= 0; row = groups.next(row)) {
            own.ensure(n + 1);
            own.row[n++] = row;
        }
        own.ensure(size[i]);
        Arrays.fill(own.of, 0, n, -1);
        boolean isFirst = triangles(colliders.shape[contacts.colliderA[head]]) != null;
        match(begin[i], size[i], n, isFirst, list, own);
        Poses p = colliders.poses;
        int a = contacts.colliderA[head];
        int b = contacts.colliderB[head];
        for (int k = 0; k < n; k++) {
            Manifold m = own.manifold;
            if (own.of[k] < 0) {
                m.pointCount = 0;
                m.patch = 0;
                m.normalX = contacts.normalX(own.row[k]);
                m.normalY = contacts.normalY(own.row[k]);
                m.normalZ = contacts.normalZ(own.row[k]);
            } else {
                // from the shape's centre to the surface's when that is A
                list.get(own.of[k], isFirst, p.apartX(a, b), p.apartY(a, b), p.apartZ(a, b), m);
            }
            points.store(own.row[k], m, own.points);
            if (own.of[k] >= 0) {
                keep(own.row[k], contacts.keeps[head], isFirst ? a : b, isFirst ? b : a, own);
                touch(own.row[k], list.triangle(own.of[k]));
            }
        }
    }

    private void keep(int row, boolean stays, int surface, int shape, Scratch own) {
        if (stays) {
            own.recycler.keepRow(row, surface, shape, own.manifold);
        }
    }

    /** A row is of a triangle, whose material may be another one than before. */
    private void touch(int row, int triangle) {
        if (contacts.triangle[row] != triangle + 1) {
            contacts.triangle[row] = triangle + 1;
            if (colliders.palettes.any()) {
                ContactMaterials.mix(contacts, row, colliders);
            }
        }
    }

    /** Gives each contact a row: again and again the two that are most alike. */
    private void match(
            int from,
            int contactCount,
            int rowCount,
            boolean isFirst,
            ContactList list,
            Scratch own) {
        Arrays.fill(own.taken, 0, contactCount, false);
        boolean few = (long) contactCount * rowCount <= MOST_COMPARED;
        if (few) {
            compare(from, contactCount, rowCount, isFirst, list, own);
        }
        for (int left = contactCount; few && left > 0; left--) {
            double most = 0;
            int bestRow = -1;
            int best = -1;
            for (int k = 0; k < rowCount; k++) {
                for (int m = 0; own.of[k] < 0 && m < contactCount; m++) {
                    double alike = own.taken[m] ? -1 : own.alike[k * contactCount + m];
                    if (alike > most) {
                        most = alike;
                        bestRow = k;
                        best = m;
                    }
                }
            }
            if (best < 0) {
                break;
            }
            own.of[bestRow] = from + best;
            own.taken[best] = true;
        }
        int k = 0;
        for (int m = 0; m < contactCount; m++) {
            if (own.taken[m]) {
                continue;
            }
            while (own.of[k] >= 0) {
                k++;
            }
            own.of[k] = from + m;
        }
    }

    /** How much each row and each contact are alike. */
    private void compare(
            int from,
            int contactCount,
            int rowCount,
            boolean isFirst,
            ContactList list,
            Scratch own) {
        if (contactCount * rowCount > own.alike.length) {
            own.alike = new double[2 * contactCount * rowCount];
        }
        for (int k = 0; k < rowCount; k++) {
            for (int m = 0; m < contactCount; m++) {
                own.alike[k * contactCount + m] = alike(own.row[k], from + m, isFirst, list);
            }
        }
    }

    /** Above 0.9 for the same normal, more for points in common; at most 0 for others. */
    private double alike(int row, int contact, boolean isFirst, ContactList list) {
        ContactStore c = contacts;
        if (c.pointCount[row] == 0) {
            return 0;
        }
        double dot =
                list.normal(contact, 0) * c.normalX(row)
                        + list.normal(contact, 1) * c.normalY(row)
                        + list.normal(contact, 2) * c.normalZ(row);
        double alike = isFirst ? dot : -dot;
        if (alike <= 0) {
            return 0;
        }
        for (int p = 0; p < list.pointCount(contact); p++) {
            int name = list.feature(contact, p);
            int own = isFirst ? name : ContactList.swapped(name);
            for (int q = 0; q < c.pointCount[row]; q++) {
                alike += c.feature[ContactStore.POINTS * row + q] == own ? NAME : 0;
            }
        }
        return alike;
    }

    /** What one worker needs. */
    private static final class Scratch {
        final SurfaceRecycler recycler;
        final MeshContact mesh = new MeshContact(new NarrowPhase());
        final Manifold manifold = new Manifold();
        final PointStore.Scratch points = new PointStore.Scratch();
        double[] normal = new double[3 * 16];
        int[] names = new int[16];
        int[] row = new int[16];

        /** The contact that each row gets, or -1. */
        int[] of = new int[16];

        boolean[] taken = new boolean[16];

        /** Of each row and each contact. */
        double[] alike = new double[256];

        double qx, qy, qz, qw;

        Scratch(SurfaceRecycler recycler) {
            this.recycler = recycler;
        }

        void ensure(int need) {
            if (need > row.length) {
                int n = 2 * need;
                normal = Arrays.copyOf(normal, 3 * n);
                names = Arrays.copyOf(names, n);
                row = Arrays.copyOf(row, n);
                of = Arrays.copyOf(of, n);
                taken = Arrays.copyOf(taken, n);
            }
        }

        /** The orientation of a surface, with its own turn if it has one. */
        void turn(Poses p, int s, Shape shape) {
            qx = p.orientationX[s];
            qy = p.orientationY[s];
            qz = p.orientationZ[s];
            qw = p.orientationW[s];
            if (shape instanceof Moved m) {
                double rx = MovedTurn.x(m, qx, qy, qz, qw);
                double ry = MovedTurn.y(m, qx, qy, qz, qw);
                double rz = MovedTurn.z(m, qx, qy, qz, qw);
                qw = MovedTurn.w(m, qx, qy, qz, qw);
                qx = rx;
                qy = ry;
                qz = rz;
            }
        }
    }
}
