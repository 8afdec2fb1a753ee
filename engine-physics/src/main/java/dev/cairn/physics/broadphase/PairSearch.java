package dev.cairn.physics.broadphase;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;

import java.util.Arrays;

/**
 * Looks for the pairs of the colliders whose boxes moved: each asks the trees, in blocks; a body of
 * many shapes asks once for all of them, by descending its own tree and the world's at once, so
 * that what is apart of it is passed over together.
 *
 * <p>Each block has a buffer; one that was too small says how much it lacked, grows, and its block
 * runs again. Simulation thread, and blocks of {@link #run}. Allocates only when something grows.
 */
final class PairSearch {
    /** Moved proxies of a block: small enough to balance, large enough to hide the dispatch. */
    private static final int PROXIES_PER_BLOCK = 32;

    /** Up to so many pairs the library's sort makes no object. */
    private static final int FEW = 40;

    /** First capacity of a block's buffer; a pile's collider meets about ten others. */
    private static final int FIRST_CAPACITY = 256;

    /** A body asks once for all its shapes if one in so many moved. */
    private static final int SHARE = 8;

    private final BroadPhase boxes;
    private final PairFilter filter;
    private final PairSet pairs;
    private final BlockJob job = this::block;

    private long[][] found = {};
    private int[] foundCount = {};
    private int[] visits = {};
    private boolean[] again = {};
    private boolean secondPass;
    private int[][] stacks = {};
    private int proxyBlocks;
    private int blocks;

    /** By body: how many of its shapes moved; 0 between searches. */
    private int[] movedShapes = {};

    /** A collider of each body that asks for all its shapes at once. */
    private int[] askers = {};

    private int askerCount;

    PairSearch(BroadPhase boxes, PairFilter filter, PairSet pairs) {
        this.boxes = boxes;
        this.filter = filter;
        this.pairs = pairs;
    }

    /** Fills the buffers; pairs that are known are left out. */
    void run(Jobs jobs) {
        gatherAskers();
        proxyBlocks = Blocks.count(boxes.movedCount(), PROXIES_PER_BLOCK);
        blocks = proxyBlocks + askerCount;
        if (blocks == 0) {
            return;
        }
        prepare(jobs.workers());
        secondPass = false;
        jobs.run(job, blocks);
        if (growBuffers()) {
            secondPass = true;
            jobs.run(job, blocks);
        }
        for (int i = 0; i < boxes.movedCount() && movedShapes.length > 0; i++) {
            int body = filter.body(boxes.movedSlot(i));
            if (body < movedShapes.length) {
                movedShapes[body] = 0;
            }
        }
    }

    /** How many buffers there are. */
    int blocks() {
        return blocks;
    }

    /** How many pairs are in a buffer. */
    int count(int block) {
        return foundCount[block];
    }

    /** The pairs of a block, by {@link PairSet#key}. */
    long[] found(int block) {
        return found[block];
    }

    /** How many nodes and pairs of nodes the last search looked at. */
    long visits() {
        long sum = 0;
        for (int b = 0; b < blocks; b++) {
            sum += visits[b];
        }
        return sum;
    }

    private void gatherAskers() {
        askerCount = 0;
        for (int i = 0; i < boxes.movedCount(); i++) {
            int c = boxes.movedSlot(i);
            if (boxes.many.root(c) < 0) {
                continue;
            }
            int body = filter.body(c);
            if (movedShapes.length <= body) {
                movedShapes = Arrays.copyOf(movedShapes, boxes.where.length);
            }
            int limit = boxes.many.size(c, boxes.where[c] == BroadPhase.DYNAMIC) / SHARE;
            if (++movedShapes[body] == limit + 1) {
                if (askerCount == askers.length) {
                    askers = Arrays.copyOf(askers, Math.max(8, 2 * askerCount));
                }
                askers[askerCount++] = c;
            }
        }
        for (int i = 0; i < askerCount; i++) {
            movedShapes[filter.body(askers[i])] = Integer.MAX_VALUE;
        }
    }

    /** Whether the body of a collider asks for it. */
    private boolean isAskedFor(int c) {
        return boxes.many.root(c) >= 0 && movedShapes[filter.body(c)] == Integer.MAX_VALUE;
    }

    private void prepare(int workers) {
        if (found.length < blocks) {
            int old = found.length;
            found = Arrays.copyOf(found, Math.max(blocks, 2 * old));
            for (int b = old; b < found.length; b++) {
                found[b] = new long[FIRST_CAPACITY];
            }
            foundCount = new int[found.length];
            visits = new int[found.length];
            again = new boolean[found.length];
        }
        int depth = Math.max(boxes.staticTree().height(), boxes.dynamicTree().height()) + 2;
        int room = 4 * depth; // a pair of trees: two nodes for each step down in either
        if (stacks.length < workers || stacks[0].length < room) {
            stacks = new int[Math.max(workers, stacks.length)][2 * room + 16];
        }
    }

    private boolean growBuffers() {
        boolean any = false;
        for (int b = 0; b < blocks; b++) {
            again[b] = foundCount[b] > found[b].length;
            if (again[b]) {
                found[b] = new long[2 * foundCount[b]];
                any = true;
            }
        }
        return any;
    }

    /**
     * A collider's pairs are told in the order of slots: the tree's shape follows from the rounding
     * of boxes, and would make another order of the same scene elsewhere.
     */
    private void block(int block, int worker) {
        if (secondPass && !again[block]) {
            return;
        }
        visits[block] = 0;
        int[] stack = stacks[worker];
        if (block >= proxyBlocks) {
            askAll(block, askers[block - proxyBlocks], stack);
            return;
        }
        int end = Blocks.end(block, PROXIES_PER_BLOCK, boxes.movedCount());
        int count = 0;
        for (int i = Blocks.begin(block, PROXIES_PER_BLOCK); i < end; i++) {
            int slot = boxes.movedSlot(i);
            int first = count;
            byte where = boxes.where[slot];
            boolean alone = !isAskedFor(slot);
            if (where == BroadPhase.DYNAMIC) {
                if (alone) {
                    count = query(boxes.dynamicTree(), slot, block, count, stack);
                    count = query(boxes.staticTree(), slot, block, count, stack);
                }
                count = queryEndless(slot, found[block], count);
            } else if (where != BroadPhase.OUT && alone) {
                count = query(boxes.dynamicTree(), slot, block, count, stack);
            }
            sort(block, first, count);
        }
        foundCount[block] = count;
    }

    private void sort(int block, int first, int count) {
        int n = count - first;
        if (n > 1 && count <= found[block].length) {
            if (n <= FEW) {
                Arrays.sort(found[block], first, count);
            } else {
                heapSort(found[block], first, n);
            }
        }
    }

    /** J. Williams, 1964; the library's sort makes an object for each partition. */
    private static void heapSort(long[] keys, int first, int n) {
        for (int i = n / 2 - 1; i >= 0; i--) {
            sink(keys, first, i, n);
        }
        for (int end = n - 1; end > 0; end--) {
            long most = keys[first];
            keys[first] = keys[first + end];
            keys[first + end] = most;
            sink(keys, first, 0, end);
        }
    }

    private static void sink(long[] keys, int first, int from, int n) {
        long key = keys[first + from];
        int at = from;
        for (int child = 2 * at + 1; child < n; child = 2 * at + 1) {
            child += child + 1 < n && keys[first + child + 1] > keys[first + child] ? 1 : 0;
            if (keys[first + child] <= key) {
                break;
            }
            keys[first + at] = keys[first + child];
            at = child;
        }
        keys[first + at] = key;
    }

    /** The same for all shapes of a body that moved. */
    private void askAll(int block, int member, int[] stack) {
        boolean moves = boxes.where[member] == BroadPhase.DYNAMIC;
        AabbTree own = moves ? boxes.dynamicTree() : boxes.staticTree();
        int root = boxes.many.root(member);
        int count = descend(own, root, boxes.dynamicTree(), block, 0, stack);
        if (moves) {
            count = descend(own, root, boxes.staticTree(), block, count, stack);
        }
        sort(block, 0, count);
        foundCount[block] = count;
    }

    /**
     * Walks one tree; stores what fits and counts all. Of two moved slots of a tree the lower one
     * reports.
     */
    private int query(AabbTree tree, int slot, int block, int before, int[] stack) {
        int count = before;
        if (tree.root == AabbTree.NONE) {
            return count;
        }
        double[] bounds = tree.bounds;
        double[] fat = boxes.fatBoxes();
        int[] left = tree.left;
        int box = 6 * slot;
        int top = 0;
        int seen = 0;
        stack[top++] = tree.root;
        while (top > 0) {
            int node = stack[--top];
            seen++;
            if (!AabbTree.overlap(bounds, 6 * node, fat, box)) {
                continue;
            }
            if (left[node] != AabbTree.NONE) {
                stack[top++] = tree.right[node];
                stack[top++] = left[node];
                continue;
            }
            count = report(slot, tree.item[node], found[block], count);
        }
        visits[block] += seen;
        return count;
    }

    /** Walks down two trees at once, of two nodes whose boxes overlap into the larger one. */
    private int descend(
            AabbTree own, int root, AabbTree other, int block, int before, int[] stack) {
        int count = before;
        int top = 0;
        int seen = 0;
        if (other.root != AabbTree.NONE) {
            stack[top++] = root;
            stack[top++] = other.root;
        }
        while (top > 0) {
            int b = stack[--top];
            int a = stack[--top];
            seen++;
            if ((own == other && b == root)
                    || !AabbTree.overlap(own.bounds, 6 * a, other.bounds, 6 * b)) {
                continue;
            }
            boolean leafA = own.left[a] == AabbTree.NONE;
            boolean leafB = other.left[b] == AabbTree.NONE;
            if (leafA && leafB) {
                if (boxes.moved(own.item[a])) {
                    count = report(own.item[a], other.item[b], found[block], count);
                }
            } else if (leafB || (!leafA && own.area(a) >= other.area(b))) {
                top = push(stack, push(stack, top, own.right[a], b), own.left[a], b);
            } else {
                top = push(stack, push(stack, top, a, other.right[b]), a, other.left[b]);
            }
        }
        visits[block] += seen;
        return count;
    }

    private static int push(int[] stack, int top, int a, int b) {
        stack[top] = a;
        stack[top + 1] = b;
        return top + 2;
    }

    private int report(int slot, int other, long[] out, int count) {
        if (other == slot
                || (boxes.moved(other) && !reports(slot, other))
                || (filter.active && !filter.admits(slot, other))) {
            return count;
        }
        return note(PairSet.key(slot, other), out, count);
    }

    private int note(long key, long[] out, int count) {
        if (pairs.contains(key)) {
            return count;
        }
        if (count < out.length) {
            out[count] = key;
        }
        return count + 1;
    }

    /** A moving collider reports its pairs with what is everywhere; no tree is needed for a few. */
    private int queryEndless(int slot, long[] out, int before) {
        int count = before;
        double[] fat = boxes.fatBoxes();
        int[] endless = boxes.endless();
        for (int i = 0; i < boxes.endlessCount(); i++) {
            if (AabbTree.overlap(fat, 6 * slot, fat, 6 * endless[i])
                    && (!filter.active || filter.admits(slot, endless[i]))) {
                count = note(PairSet.key(slot, endless[i]), out, count);
            }
        }
        return count;
    }

    /** Which of two moved slots reports the pair: the dynamic one, else the lower one. */
    private boolean reports(int slot, int other) {
        byte[] where = boxes.where;
        return where[slot] != where[other] ? where[slot] == BroadPhase.DYNAMIC : slot < other;
    }
}
