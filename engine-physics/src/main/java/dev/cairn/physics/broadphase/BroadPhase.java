package dev.cairn.physics.broadphase;

import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;

import java.util.Arrays;

/**
 * Fat boxes of all colliders in two trees, static and dynamic, and the set of their overlapping
 * pairs. Fixed colliders without end (half-spaces) are in a short list beside the trees. See the
 * package's essay.
 *
 * <p>A tick: {@link #place} for every collider that is new or left its box and {@link #settle} for
 * its body, {@link #findPairs}, the owner reads {@link #newPairs}, drops the rows whose boxes no
 * longer {@link #overlap} by {@link #forget}, and calls {@link #endTick}.
 *
 * <p>Simulation thread; {@link #overlap} and {@link #moved} also from blocks. Allocates only when
 * something grows.
 */
public final class BroadPhase {
    /** Room for new pairs from the first tick on. */
    private static final int LEAST_PAIRS = 1024;

    static final byte OUT = 0;
    static final byte STATIC = 1;
    static final byte DYNAMIC = 2;

    /** Static, and of infinite extent: in no tree, for its area would be no number. */
    static final byte ENDLESS = 3;

    private final AabbTree staticTree = new AabbTree();
    private final AabbTree dynamicTree = new AabbTree();
    private final PairSet pairs = new PairSet();

    private double[] fat = {};
    private int[] leaf = {};
    byte[] where = {};
    private boolean[] moved = {};

    private int[] movedSlots = new int[64];
    private int movedCount;

    private int[] endless = new int[4];
    private int endlessCount;

    private long[] newPairs = new long[64];
    private int newPairCount;

    private final BulkMoves moves = new BulkMoves(dynamicTree);
    private final BulkInserts fixedInserts = new BulkInserts(staticTree);
    private final BulkInserts inserts = new BulkInserts(dynamicTree);
    private final PairFilter filter;
    private final PairSearch search;

    /** Bodies with trees of their own. */
    final CompoundTrees many;

    /** Slots whose filter changed since the last tick; so their pairs may end, or begin. */
    private boolean refiltered;

    /** Without colliders; all pairs are admitted. */
    public BroadPhase() {
        this(new PairFilter(new ColliderStore(new BodyStore())));
    }

    /**
     * Without colliders.
     *
     * @param filter says which boxes that overlap are pairs
     */
    public BroadPhase(PairFilter filter) {
        this.filter = filter;
        search = new PairSearch(this, filter, pairs);
        many = new CompoundTrees(filter.colliders, staticTree, dynamicTree);
    }

    /** Grows the columns; between phases only. */
    public void ensureSlots(int slots) {
        if (slots <= leaf.length) {
            return;
        }
        int n = Math.max(slots, Math.max(64, leaf.length + (leaf.length >> 1)));
        fat = Arrays.copyOf(fat, 6 * n);
        leaf = Arrays.copyOf(leaf, n);
        where = Arrays.copyOf(where, n);
        moved = Arrays.copyOf(moved, n);
    }

    /**
     * Whether a slot has a box.
     *
     * @return true between place and remove
     */
    public boolean contains(int slot) {
        return where[slot] != OUT;
    }

    /**
     * The fat boxes, six numbers to a slot. Read only.
     *
     * @return minX, minY, minZ, maxX, maxY, maxZ of slot s from 6 s on; world, m
     */
    public double[] fatBoxes() {
        return fat;
    }

    /**
     * Gives a slot a fat box, its first or another one, and marks it as moved.
     *
     * @param isStatic whether it goes to the static tree
     */
    public void place(int slot, boolean isStatic, double[] box, int offset) {
        byte target = isStatic ? isEndless(box, offset) ? ENDLESS : STATIC : DYNAMIC;
        if (where[slot] != OUT && where[slot] != target) {
            takeOut(slot);
        }
        System.arraycopy(box, offset, fat, 6 * slot, 6);
        AabbTree tree = isStatic ? staticTree : dynamicTree;
        if (target == ENDLESS) {
            if (where[slot] == OUT) {
                addEndless(slot);
            }
            where[slot] = target;
        } else if (where[slot] == OUT) {
            leaf[slot] = tree.insert(box, offset, slot);
            where[slot] = target;
        } else if (many.root(slot) >= 0) {
            many.setBox(leaf[slot], target == DYNAMIC, box, offset);
        } else {
            tree.move(leaf[slot], box, offset);
        }
        mark(slot);
    }

    /**
     * {@link #place}, maybe together with others, which is cheaper for many.
     *
     * @param withOthers whether the tree may wait for {@link #finishPlaces}
     */
    public void place(int slot, boolean isStatic, double[] box, int offset, boolean withOthers) {
        int body = filter.colliders.body[slot];
        boolean isAlone =
                filter.colliders.bodies.collider[body] == slot
                        && filter.colliders.next[slot] == ColliderStore.NONE;
        boolean isNew = where[slot] == OUT && !(isStatic && isEndless(box, offset));
        boolean isMove = where[slot] == DYNAMIC && !isStatic && !dynamicTree.isPending(leaf[slot]);
        if (!withOthers || !isAlone || !(isNew || isMove)) {
            place(slot, isStatic, box, offset);
            return;
        }
        System.arraycopy(box, offset, fat, 6 * slot, 6);
        if (isNew) {
            leaf[slot] = (isStatic ? fixedInserts : inserts).add(box, offset, slot);
            where[slot] = isStatic ? STATIC : DYNAMIC;
        } else {
            moves.add(leaf[slot]);
        }
        mark(slot);
    }

    /** The trees follow what was placed together; before anything else is done with them. */
    public void finishPlaces() {
        moves.run(fat);
        fixedInserts.run();
        inserts.run();
    }

    /**
     * All shapes of a body have the boxes that they shall have; after {@link #place} of any of
     * them, and before any search.
     */
    public void settle(int body) {
        int first = filter.colliders.bodies.collider[body];
        if (first != body && first != ColliderStore.NONE) {
            many.settle(body, where, leaf);
        }
    }

    private void mark(int slot) {
        if (!moved[slot]) {
            moved[slot] = true;
            if (movedCount == movedSlots.length) {
                movedSlots = Arrays.copyOf(movedSlots, 2 * movedCount);
            }
            movedSlots[movedCount++] = slot;
        }
    }

    /**
     * What a slot's filter says has changed: its pairs are looked at anew, and looked for.
     *
     * @param slot with or without a box
     */
    public void refilter(int slot) {
        if (where[slot] != OUT) {
            refiltered = true;
            mark(slot);
        }
    }

    /**
     * Whether the filters of slots that count as {@link #moved} may have changed.
     *
     * @return true between refilter and endTick
     */
    public boolean isRefiltered() {
        return refiltered;
    }

    /**
     * Whether the filters admit two slots as a pair; asks the user too, so on the simulation thread
     * and in a fixed order.
     *
     * @return true unless a filter refuses the pair
     */
    public boolean admits(int a, int b) {
        return !filter.active || filter.isPair(a, b);
    }

    /**
     * Takes a slot's box out. Its pairs no longer {@link #overlap}; it counts as moved, so that
     * their owner looks.
     */
    public void remove(int slot) {
        if (where[slot] == OUT) {
            return;
        }
        takeOut(slot);
        mark(slot);
    }

    private static boolean isEndless(double[] box, int offset) {
        for (int i = 0; i < 6; i++) {
            if (Double.isInfinite(box[offset + i])) {
                return true;
            }
        }
        return false;
    }

    private void addEndless(int slot) {
        if (endlessCount == endless.length) {
            endless = Arrays.copyOf(endless, 2 * endlessCount);
        }
        endless[endlessCount++] = slot;
    }

    private void takeOut(int slot) {
        if (where[slot] == ENDLESS) {
            int at = 0;
            while (endless[at] != slot) {
                at++;
            }
            // The order of the others stays: it is the order of their pairs.
            System.arraycopy(endless, at + 1, endless, at, --endlessCount - at);
            where[slot] = OUT;
            return;
        }
        if (many.root(slot) >= 0) {
            many.open(slot, where[slot] == DYNAMIC);
        }
        AabbTree tree = where[slot] == STATIC ? staticTree : dynamicTree;
        if (tree.isPending(leaf[slot])) {
            finishPlaces();
        }
        tree.remove(leaf[slot]);
        where[slot] = OUT;
    }

    /** How many slots moved in this tick. */
    public int movedCount() {
        return movedCount;
    }

    /**
     * One of the slots that moved in this tick.
     *
     * @param index 0 to movedCount - 1
     */
    public int movedSlot(int index) {
        return movedSlots[index];
    }

    /**
     * Whether a slot's box changed in this tick.
     *
     * @return true between place or remove, and endTick
     */
    public boolean moved(int slot) {
        return moved[slot];
    }

    /** Whether two slots are a pair: both have boxes, these overlap, not both are static. */
    public boolean overlap(int a, int b) {
        return where[a] != OUT
                && where[b] != OUT
                && (where[a] == DYNAMIC || where[b] == DYNAMIC)
                && AabbTree.overlap(fat, 6 * a, fat, 6 * b);
    }

    /** Finds all pairs that overlap now and were none before, and makes them pairs. */
    public void findPairs(Jobs jobs) {
        newPairCount = 0;
        search.run(jobs);
        merge(search.blocks());
    }

    private void merge(int blocks) {
        long total = 0;
        for (int b = 0; b < blocks; b++) {
            total += search.count(b);
        }
        if (total > Integer.MAX_VALUE - 8) {
            throw new IllegalStateException(
                    total + " new pairs of shapes in one tick; at most 2147483639 are possible");
        }
        if (newPairs.length < total) {
            newPairs =
                    new long
                            [(int)
                                    Math.min(
                                            Integer.MAX_VALUE - 8,
                                            Math.max(LEAST_PAIRS, total + (total >> 2)))];
        }
        for (int b = 0; b < blocks; b++) {
            long[] found = search.found(b);
            for (int i = 0; i < search.count(b); i++) {
                long key = found[i];
                if (filter.active && !filter.passes((int) (key >>> 32), (int) key)) {
                    continue;
                }
                if (pairs.add(key)) {
                    newPairs[newPairCount++] = key;
                }
            }
        }
    }

    /**
     * The keys of the pairs that {@link #findPairs} found, by {@link PairSet#key}. Valid until its
     * next call.
     *
     * @return an array; only the first {@link #newPairCount} count
     */
    public long[] newPairs() {
        return newPairs;
    }

    /** How many nodes of the trees the last {@link #findPairs} looked at; what it cost. */
    public long visits() {
        return search.visits();
    }

    /** How many pairs {@link #findPairs} found. */
    public int newPairCount() {
        return newPairCount;
    }

    /** Ends a pair, so that it can be found again. */
    public void forget(int a, int b) {
        pairs.remove(PairSet.key(a, b));
    }

    /** How many pairs there are. */
    public int pairCount() {
        return pairs.size();
    }

    /**
     * Whether two slots are known as a pair.
     *
     * @return true between findPairs and forget
     */
    public boolean isPair(int a, int b) {
        return pairs.contains(PairSet.key(a, b));
    }

    /**
     * All that lasts from tick to tick; slots have room already.
     *
     * @param slots in use
     */
    public void state(StateVisitor s, int slots) {
        s.section("broadPhase", this);
        staticTree.state(s);
        dynamicTree.state(s);
        many.state(s);
        pairs.state(s);
        s.section("boxes", this);
        fat = s.array("fat", fat, 0, 6 * slots, fat.length, false);
        if (s.isRestoring()) {
            staticTree.fill(fat);
            dynamicTree.fill(fat);
        }
        leaf = s.array("leaf", leaf, 0, slots, leaf.length, false);
        where = s.array("where", where, slots);
        moved = s.array("moved", moved, slots);
        movedCount = s.value("movedCount", movedCount);
        movedSlots = s.array("movedSlots", movedSlots, movedCount);
        endlessCount = s.value("endlessCount", endlessCount);
        endless = s.array("endless", endless, endlessCount);
        refiltered = s.value("refiltered", refiltered);
        newPairCount = s.isRestoring() ? 0 : newPairCount;
    }

    /** Nothing counts as moved any more. */
    public void endTick() {
        for (int i = 0; i < movedCount; i++) {
            moved[movedSlots[i]] = false;
        }
        movedCount = 0;
        newPairCount = 0;
        refiltered = false;
    }

    /** The tree of colliders that never move. */
    public AabbTree staticTree() {
        return staticTree;
    }

    /**
     * Fixed colliders without end, in the order that they came; in no tree.
     *
     * @return an array; only the first {@link #endlessCount} count; read only
     */
    public int[] endless() {
        return endless;
    }

    /** How many fixed colliders without end there are. */
    public int endlessCount() {
        return endlessCount;
    }

    /** The tree of colliders that move. */
    public AabbTree dynamicTree() {
        return dynamicTree;
    }
}
