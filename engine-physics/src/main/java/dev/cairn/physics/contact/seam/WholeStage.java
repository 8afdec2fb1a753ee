package dev.cairn.physics.contact.seam;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactMaterials;
import dev.cairn.physics.internal.ContactStore;

import java.util.Arrays;

/**
 * Parts of a body that make one convex shape are solved as that shape: its row, which no other
 * stage sees, stands for those of its parts. So two boxes on a body are the box that they make: its
 * corners and no others, its margin and its inner radius, and what contacts remember from tick to
 * tick.
 *
 * <pre>
 *   points ─▶ rows of wholes are collided as all are; hidden
 *   join   ─▶ each row of parts is listed with the rows of its whole; these are shown, and it is hidden
 *   sweep
 *   see    ─▶ the other way round: hooks and speeds of approach are those of parts
 *   choose ─▶ wholes again; where a hook has chosen among the parts, they are solved themselves
 *   solve
 *   part   ─▶ impulses of the whole go to its parts' points
 * </pre>
 *
 * <p>A row that is hidden has the negative of its number of points. Where the user's filter refuses
 * one of its parts, a whole has no row, and the parts are solved.
 *
 * <p>Simulation thread; allocates only when something grows. A world without wholes does not come
 * here.
 */
public final class WholeStage {
    private static final int GROUPS_PER_BLOCK = 8;

    /** Of the inner radius of a part: its point is as deep as the whole's. */
    private static final double FLUSH = 0x1p-15;

    private final BlockJob partJob = this::partBlock;
    private final ColliderStore colliders;
    private final ContactStore contacts;

    /** Open addressing: pair of colliders that are solved, 0 for none; its group. */
    private long[] keys = new long[64];

    private int[] groupAt = new int[64];

    /** By group: where its rows of wholes and of parts begin, and end. */
    private int[] firstWhole = {}, firstPart = {}, endWhole = {}, endPart = {};

    /** By group: how many rows of parts had points before the hook; whether parts are solved. */
    private int[] before = {};

    private boolean[] isParted = {};

    private int groups, listed;

    /** Rows, as they were found, with their groups; then in order of groups. */
    private int[] row = {}, group = {}, ordered = {};

    /** By worker and point of the rows of a whole: how many points share in its impulse. */
    private int[][] sharers = {};

    /**
     * A stage.
     *
     * @param colliders whose contacts these are
     * @param contacts the rows
     */
    public WholeStage(ColliderStore colliders, ContactStore contacts) {
        this.colliders = colliders;
        this.contacts = contacts;
    }

    /**
     * Rows of wholes instead of those of parts; after the narrow phase.
     *
     * @param broadPhase says of a pair that is none whether it may become one
     */
    public void join(BroadPhase broadPhase) {
        groups = 0;
        if (!colliders.wholes) {
            return;
        }
        find(broadPhase);
        if (groups > 0) {
            order();
            show(true);
        }
    }

    /** Rows of parts instead of those of wholes: for those who look as users do. */
    public void see() {
        if (groups > 0) {
            show(false);
        }
    }

    /**
     * Rows of wholes again, before the solve.
     *
     * @param isHooked whether a hook may have changed rows of parts since {@link #see}
     */
    public void choose(boolean isHooked) {
        if (groups == 0) {
            return;
        }
        show(true);
        for (int g = 0; isHooked && g < groups; g++) {
            choose(g);
        }
    }

    /** After the solve: what the wholes did is what their parts did. */
    public void part(Jobs jobs) {
        if (groups > 0) {
            makeRoom(jobs.workers());
            jobs.run(partJob, Blocks.count(groups, GROUPS_PER_BLOCK));
        }
    }

    // Groups --------------------------------------------------------------------------------------

    /** Lists the rows of wholes, then those of parts whose whole has one. */
    private void find(BroadPhase broadPhase) {
        ContactStore c = contacts;
        Arrays.fill(keys, 0);
        if (row.length < c.activeCount) {
            row = new int[c.bodyA.length];
            group = new int[row.length];
            ordered = new int[row.length];
        }
        listed = 0;
        for (int i = 0; i < c.activeCount; i++) {
            int r = c.active[i];
            if (colliders.isWhole(c.colliderA[r]) || colliders.isWhole(c.colliderB[r])) {
                list(r, open(key(c.colliderA[r], c.colliderB[r])));
            }
        }
        for (int i = 0; i < c.activeCount; i++) {
            int r = c.active[i];
            int a = colliders.standIn(c.colliderA[r]);
            int b = colliders.standIn(c.colliderB[r]);
            if (a != c.colliderA[r] || b != c.colliderB[r]) {
                // boxes of parts may be found first: the whole is not in reach yet
                int at = find(key(a, b));
                if (keys[at] != 0 || broadPhase.admits(a, b)) {
                    list(r, open(key(a, b)));
                }
            }
        }
    }

    private void list(int r, int g) {
        row[listed] = r;
        group[listed++] = g;
    }

    private static long key(int a, int b) {
        return (long) Math.min(a, b) << 32 | Math.max(a, b);
    }

    private int find(long key) {
        int at = (int) ((key * 0x9E3779B97F4A7C15L) >>> 33) & (keys.length - 1);
        while (keys[at] != 0 && keys[at] != key) {
            at = (at + 1) & (keys.length - 1);
        }
        return at;
    }

    private int open(long key) {
        int at = find(key);
        if (keys[at] == 0) {
            if (2 * (groups + 1) > keys.length) {
                grow();
                at = find(key);
            }
            if (groups == before.length) {
                int n = Math.max(32, 2 * groups);
                firstWhole = Arrays.copyOf(firstWhole, n);
                firstPart = Arrays.copyOf(firstPart, n);
                endWhole = Arrays.copyOf(endWhole, n);
                endPart = Arrays.copyOf(endPart, n);
                before = Arrays.copyOf(before, n);
                isParted = Arrays.copyOf(isParted, n);
            }
            keys[at] = key;
            groupAt[at] = groups++;
        }
        return groupAt[at];
    }

    private void grow() {
        long[] old = keys;
        int[] of = groupAt;
        keys = new long[2 * old.length];
        groupAt = new int[keys.length];
        for (int i = 0; i < old.length; i++) {
            if (old[i] != 0) {
                int at = find(old[i]);
                keys[at] = old[i];
                groupAt[at] = of[i];
            }
        }
    }

    private boolean isOfWhole(int r) {
        return colliders.isWhole(contacts.colliderA[r]) || colliders.isWhole(contacts.colliderB[r]);
    }

    /** Puts the rows in order of groups, those of wholes first. */
    private void order() {
        Arrays.fill(endWhole, 0, groups, 0);
        Arrays.fill(endPart, 0, groups, 0);
        Arrays.fill(before, 0, groups, 0);
        Arrays.fill(isParted, 0, groups, false);
        for (int i = 0; i < listed; i++) {
            int[] count = isOfWhole(row[i]) ? endWhole : endPart;
            count[group[i]]++;
        }
        int at = 0;
        for (int g = 0; g < groups; g++) {
            firstWhole[g] = at;
            at += endWhole[g];
            endWhole[g] = firstWhole[g];
            firstPart[g] = at;
            at += endPart[g];
            endPart[g] = firstPart[g];
        }
        for (int i = 0; i < listed; i++) {
            boolean isOfWhole = isOfWhole(row[i]);
            int[] end = isOfWhole ? endWhole : endPart;
            ordered[end[group[i]]++] = row[i];
            if (!isOfWhole && contacts.isSolved(row[i])) {
                before[group[i]]++;
            }
        }
    }

    private void show(boolean wholes) {
        for (int g = 0; g < groups; g++) {
            show(g, wholes);
        }
    }

    private void show(int g, boolean wholes) {
        int[] points = contacts.pointCount;
        for (int i = firstWhole[g]; i < endPart[g]; i++) {
            int some = Math.abs(points[ordered[i]]);
            points[ordered[i]] = i < endWhole[g] == wholes ? some : -some;
        }
    }

    /** What a hook did to all parts alike is done to the whole; else the parts are solved. */
    private void choose(int g) {
        ContactStore c = contacts;
        int first = -1;
        int left = 0;
        boolean alike = true;
        for (int i = firstPart[g]; i < endPart[g]; i++) {
            int r = ordered[i];
            if (c.pointCount[r] != 0) {
                first = first < 0 ? r : first;
                alike &= ContactMaterials.isAlike(c, first, r);
                left++;
            }
        }
        isParted[g] = left != before[g] || !alike;
        if (isParted[g]) {
            show(g, false);
        } else if (first >= 0) {
            for (int i = firstWhole[g]; i < endWhole[g]; i++) {
                ContactMaterials.frictionOf(c, ordered[i], first);
            }
        }
    }

    // Impulses ------------------------------------------------------------------------------------

    private void partBlock(int block, int worker) {
        int end = Blocks.end(block, GROUPS_PER_BLOCK, groups);
        for (int g = Blocks.begin(block, GROUPS_PER_BLOCK); g < end; g++) {
            if (!isParted[g]) {
                spread(g, sharers[worker]);
            }
            show(g, false);
        }
    }

    private void makeRoom(int workers) {
        int most = 0;
        for (int g = 0; g < groups; g++) {
            most = Math.max(most, ContactStore.POINTS * (endWhole[g] - firstWhole[g]));
        }
        if (sharers.length < workers || sharers[0].length < most) {
            sharers = new int[Math.max(workers, sharers.length)][Math.max(32, 2 * most)];
        }
    }

    /**
     * Points of parts that are nearest to a point of the whole, and as deep, share its impulse; if
     * there is none, the nearest point has all of it. Friction goes to the first of them.
     */
    private void spread(int g, int[] shares) {
        ContactStore c = contacts;
        Arrays.fill(shares, 0, ContactStore.POINTS * (endWhole[g] - firstWhole[g]), 0);
        int first = -1;
        for (int i = firstPart[g]; i < endPart[g]; i++) {
            int r = ordered[i];
            c.rest(r);
            first = first < 0 && c.pointCount[r] != 0 ? r : first;
            for (int p = 0; p < Math.abs(c.pointCount[r]); p++) {
                int k = sharesIn(g, r, ContactStore.POINTS * r + p);
                if (k >= 0) {
                    shares[k]++;
                }
            }
        }
        if (first < 0) {
            return;
        }
        for (int i = firstPart[g]; i < endPart[g]; i++) {
            int r = ordered[i];
            for (int p = ContactStore.POINTS * r;
                    p < ContactStore.POINTS * r + Math.abs(c.pointCount[r]);
                    p++) {
                int k = sharesIn(g, r, p);
                if (k >= 0) {
                    give(p, wholePoint(g, k), shares[k]);
                }
            }
        }
        for (int i = firstWhole[g]; i < endWhole[g]; i++) {
            int r = ordered[i];
            for (int p = 0; p < c.pointCount[r]; p++) {
                if (shares[ContactStore.POINTS * (i - firstWhole[g]) + p] == 0) {
                    give(
                            nearestPart(g, r, ContactStore.POINTS * r + p),
                            ContactStore.POINTS * r + p,
                            1);
                }
            }
            c.addFriction(first, r, c.bodyA[first] == c.bodyA[r] ? 1 : -1);
        }
    }

    private void give(int to, int from, int sharers) {
        ContactStore c = contacts;
        c.normalImpulse[to] += c.normalImpulse[from] / sharers;
        c.preload[to] += c.preload[from] / sharers;
        c.totalNormalImpulse[to] += c.totalNormalImpulse[from] / sharers;
    }

    private int wholePoint(int g, int k) {
        int r = ordered[firstWhole[g] + k / ContactStore.POINTS];
        return ContactStore.POINTS * r + k % ContactStore.POINTS;
    }

    /** The point of the whole in whose impulse a part's point shares, or -1. */
    private int sharesIn(int g, int r, int point) {
        ContactStore c = contacts;
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int i = firstWhole[g]; i < endWhole[g]; i++) {
            int w = ordered[i];
            for (int p = 0; p < c.pointCount[w]; p++) {
                double square = apart(r, point, w, ContactStore.POINTS * w + p);
                if (square < least) {
                    least = square;
                    best = ContactStore.POINTS * (i - firstWhole[g]) + p;
                }
            }
        }
        double slack =
                FLUSH
                        * Math.min(
                                colliders.innerRadius[c.colliderA[r]],
                                colliders.innerRadius[c.colliderB[r]]);
        boolean shares =
                best >= 0 && c.separation[point] <= c.separation[wholePoint(g, best)] + slack;
        return shares ? best : -1;
    }

    private int nearestPart(int g, int w, int point) {
        ContactStore c = contacts;
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int i = firstPart[g]; i < endPart[g]; i++) {
            int r = ordered[i];
            for (int p = 0; p < Math.abs(c.pointCount[r]); p++) {
                double square = apart(r, ContactStore.POINTS * r + p, w, point);
                if (square < least) {
                    least = square;
                    best = ContactStore.POINTS * r + p;
                }
            }
        }
        return best;
    }

    /** Square of the distance of a row's point from another row's of the same two bodies, m². */
    private double apart(int r, int p, int w, int q) {
        ContactStore c = contacts;
        int from = ContactStore.anchor(p) + (c.bodyA[r] == c.bodyA[w] ? 0 : 3);
        int to = ContactStore.anchor(q);
        double x = c.anchors[from] - c.anchors[to];
        double y = c.anchors[from + 1] - c.anchors[to + 1];
        double z = c.anchors[from + 2] - c.anchors[to + 2];
        return x * x + y * y + z * z;
    }
}
