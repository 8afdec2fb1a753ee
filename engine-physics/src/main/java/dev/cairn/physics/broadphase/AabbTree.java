package dev.cairn.physics.broadphase;

import dev.cairn.core.state.StateException;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;

import java.util.Arrays;

/**
 * A binary tree of axis-aligned boxes. Leaves hold an item, a number of the owner; the box of an
 * inner node is the union of its children's. A leaf's id is stable until it is removed.
 *
 * <p>Insertion descends to the sibling that adds the least surface area; on the way up, a rotation
 * that shrinks an inner box is taken. Ties go to the lower subtree, so that many equal boxes make a
 * balanced tree.
 *
 * <p>A part of the tree may be <em>closed</em>, see {@link ClosedTrees}: to insertions and
 * rotations outside it is a leaf. A search for leaves walks through it as through any other part.
 *
 * <p>One thread changes it; any number may read it between changes. Allocates only when it grows.
 */
public final class AabbTree implements Stateful {
    /** No node. */
    public static final int NONE = -1;

    /** Parent of a leaf that is not linked yet. */
    private static final int PENDING = -2;

    /** How much higher one child may be than the other for the sake of area. */
    private static final int MAX_LEAN = 16;

    /** Six numbers to a node: minX, minY, minZ, maxX, maxY, maxZ; world, m. */
    double[] bounds = new double[6 * 16];

    /** Parent, or for a free node the next free one. */
    int[] parent = new int[16];

    /** First child; {@link #NONE} for a leaf. */
    int[] left = new int[16];

    /** Second child; {@link #NONE} for a leaf. */
    int[] right = new int[16];

    /** 0 for a leaf, else one more than the higher child's. */
    int[] height = new int[16];

    /** Item of a leaf; {@link #NONE} for an inner node, or for a closed one less than that. */
    int[] item = new int[16];

    int root = NONE;
    private int free = NONE;
    private int used;
    private int leaves;
    private long changes;

    /** How often a box of an inner node was made anew; what a change costs, for tests. */
    private long unions;

    /** An empty tree. */
    public AabbTree() {}

    /** How many leaves there are. */
    public int leafCount() {
        return leaves;
    }

    /** The height of the root; 0 for no leaf or one leaf. */
    public int height() {
        return root == NONE ? 0 : height[root];
    }

    /**
     * How often the tree was changed since it was made.
     *
     * @return insertions, removals and moves
     */
    public long changes() {
        return changes;
    }

    /**
     * How many boxes of inner nodes were made anew since the tree was made.
     *
     * @return what insertions, removals and moves cost, in nodes
     */
    public long unions() {
        return unions;
    }

    /** Counts a change that was made from outside. */
    void changed() {
        changes++;
    }

    /** Whether insertions and rotations go no deeper: a leaf, or a closed part. */
    boolean isEnd(int node) {
        return left[node] == NONE || item[node] < NONE;
    }

    /**
     * Adds a leaf.
     *
     * @param box array that holds the box: minX, minY, minZ, maxX, maxY, maxZ; world, m
     * @param leafItem the owner's number
     */
    public int insert(double[] box, int offset, int leafItem) {
        int leaf = add(box, offset, leafItem);
        link(leaf);
        return leaf;
    }

    /** A leaf that is not linked yet, see {@link BulkInserts}. */
    int add(double[] box, int offset, int leafItem) {
        int leaf = allocate();
        System.arraycopy(box, offset, bounds, 6 * leaf, 6);
        parent[leaf] = PENDING;
        left[leaf] = NONE;
        right[leaf] = NONE;
        height[leaf] = 0;
        item[leaf] = leafItem;
        leaves++;
        changes++;
        return leaf;
    }

    /** Takes a leaf out. */
    public void remove(int leaf) {
        unlink(leaf);
        release(leaf);
        leaves--;
        changes++;
    }

    /** Gives a leaf another box. */
    public void move(int leaf, double[] box, int offset) {
        boolean isLinked = !isPending(leaf);
        if (isLinked) {
            unlink(leaf);
        }
        System.arraycopy(box, offset, bounds, 6 * leaf, 6);
        if (isLinked) {
            link(leaf);
        }
        changes++;
    }

    /** Whether a leaf waits to be linked. */
    boolean isPending(int leaf) {
        return parent[leaf] == PENDING;
    }

    /** Whether two boxes overlap; touching counts. */
    static boolean overlap(double[] a, int i, double[] b, int j) {
        return a[i] <= b[j + 3]
                && b[j] <= a[i + 3]
                && a[i + 1] <= b[j + 4]
                && b[j + 1] <= a[i + 4]
                && a[i + 2] <= b[j + 5]
                && b[j + 2] <= a[i + 5];
    }

    void link(int leaf) {
        if (root == NONE) {
            root = leaf;
            parent[leaf] = NONE;
            return;
        }
        int sibling = bestSibling(leaf);
        int node = allocate();
        int above = parent[sibling];
        parent[node] = above;
        left[node] = sibling;
        right[node] = leaf;
        item[node] = NONE;
        parent[sibling] = node;
        parent[leaf] = node;
        if (above == NONE) {
            root = node;
        } else if (left[above] == sibling) {
            left[above] = node;
        } else {
            right[above] = node;
        }
        refit(node);
    }

    void unlink(int leaf) {
        if (leaf == root) {
            root = NONE;
            return;
        }
        int node = parent[leaf];
        int sibling = left[node] == leaf ? right[node] : left[node];
        int above = parent[node];
        parent[sibling] = above;
        release(node);
        if (above == NONE) {
            root = sibling;
        } else {
            if (left[above] == node) {
                left[above] = sibling;
            } else {
                right[above] = sibling;
            }
            // nothing is rotated: what is put in again, as moved leaves are, does that on its way
            while (above != NONE && pull(above)) {
                above = parent[above];
            }
        }
    }

    /**
     * Greedy descent. With the leaf as sibling of a node, the cost is the new inner box plus what
     * all ancestors grow by; a subtree cannot cost less than that growth plus the leaf's own area.
     * Never beside a subtree that is so high that the new node would lean.
     */
    private int bestSibling(int leaf) {
        double own = area(leaf);
        int node = root;
        double direct = unionArea(node, leaf);
        double inherited = 0;
        int best = node;
        double bestCost = height[node] > MAX_LEAN ? Double.POSITIVE_INFINITY : direct;
        while (!isEnd(node)) {
            inherited += direct - area(node);
            int a = left[node];
            int b = right[node];
            double directA = unionArea(a, leaf);
            double directB = unionArea(b, leaf);
            if (directA + inherited < bestCost && height[a] <= MAX_LEAN) {
                best = a;
                bestCost = directA + inherited;
            }
            if (directB + inherited < bestCost && height[b] <= MAX_LEAN) {
                best = b;
                bestCost = directB + inherited;
            }
            double lowA = inherited + directA + Math.min(own - area(a), 0);
            double lowB = inherited + directB + Math.min(own - area(b), 0);
            if (isEnd(a)) {
                lowA = directA + inherited;
            }
            if (isEnd(b)) {
                lowB = directB + inherited;
            }
            if (bestCost < lowA && bestCost < lowB) {
                break;
            }
            boolean toA = lowA != lowB ? lowA < lowB : height[a] <= height[b];
            node = toA ? a : b;
            direct = toA ? directA : directB;
            // On equal cost the deeper place wins: that keeps a heap of equal boxes balanced.
            if (direct + inherited <= bestCost && height[node] <= MAX_LEAN) {
                best = node;
                bestCost = direct + inherited;
            }
        }
        return best;
    }

    private void refit(int from) {
        for (int node = from; node != NONE; node = parent[node]) {
            pull(node);
            rotate(node);
        }
    }

    /** Box and height of an inner node from its children; whether they are others than before. */
    boolean pull(int node) {
        unions++;
        double[] box = bounds;
        int n = 6 * node;
        int a = 6 * left[node];
        int b = 6 * right[node];
        int tall = 1 + Math.max(height[left[node]], height[right[node]]);
        boolean changes = tall != height[node];
        height[node] = tall;
        for (int k = 0; k < 3; k++) {
            double low = Math.min(box[a + k], box[b + k]);
            double high = Math.max(box[a + 3 + k], box[b + 3 + k]);
            changes |= low != box[n + k] || high != box[n + 3 + k];
            box[n + k] = low;
            box[n + 3 + k] = high;
        }
        return changes;
    }

    /**
     * Swaps a child with a grandchild on the other side, if that shrinks the other child's box the
     * most of the four ways; or if it shrinks nothing but makes a lopsided pair of equal cost more
     * even. A node that leans too much is set upright whatever its area: boxes one in another would
     * otherwise make a list.
     */
    void rotate(int node) {
        int b = left[node];
        int c = right[node];
        int tall = height[b] > height[c] ? b : c;
        if (Math.abs(height[b] - height[c]) > MAX_LEAN && !isEnd(tall)) {
            boolean first = height[left[tall]] >= height[right[tall]];
            swap(node, tall == b ? c : b, first ? left[tall] : right[tall]);
            return;
        }
        double bestGain = 0;
        int low = NONE;
        int high = NONE;
        if (!isEnd(c)) {
            double now = area(c);
            boolean even = height[c] > height[b] + 1;
            double gainLeft = now - unionArea(b, right[c]);
            double gainRight = now - unionArea(b, left[c]);
            if (gainLeft > bestGain || (even && gainLeft == 0 && height[left[c]] > height[b])) {
                bestGain = gainLeft;
                low = left[c];
                high = b;
            }
            if (gainRight > bestGain
                    || (even && low == NONE && gainRight == 0 && height[right[c]] > height[b])) {
                bestGain = gainRight;
                low = right[c];
                high = b;
            }
        }
        if (!isEnd(b)) {
            double now = area(b);
            boolean even = height[b] > height[c] + 1;
            double gainLeft = now - unionArea(c, right[b]);
            double gainRight = now - unionArea(c, left[b]);
            if (gainLeft > bestGain
                    || (even && low == NONE && gainLeft == 0 && height[left[b]] > height[c])) {
                bestGain = gainLeft;
                low = left[b];
                high = c;
            }
            if (gainRight > bestGain
                    || (even && low == NONE && gainRight == 0 && height[right[b]] > height[c])) {
                low = right[b];
                high = c;
            }
        }
        if (low != NONE) {
            swap(node, high, low);
        }
    }

    /**
     * Exchanges {@code high}, a child of {@code node}, with {@code low}, a child of the other
     * child.
     */
    private void swap(int node, int high, int low) {
        int other = parent[low];
        if (left[node] == high) {
            left[node] = low;
        } else {
            right[node] = low;
        }
        if (left[other] == low) {
            left[other] = high;
        } else {
            right[other] = high;
        }
        parent[low] = node;
        parent[high] = other;
        pull(other);
        height[node] = 1 + Math.max(height[left[node]], height[right[node]]);
    }

    double area(int node) {
        double[] box = bounds;
        int n = 6 * node;
        double x = box[n + 3] - box[n];
        double y = box[n + 4] - box[n + 1];
        double z = box[n + 5] - box[n + 2];
        return x * y + y * z + z * x;
    }

    private double unionArea(int a, int b) {
        double[] box = bounds;
        int i = 6 * a;
        int j = 6 * b;
        double x = Math.max(box[i + 3], box[j + 3]) - Math.min(box[i], box[j]);
        double y = Math.max(box[i + 4], box[j + 4]) - Math.min(box[i + 1], box[j + 1]);
        double z = Math.max(box[i + 5], box[j + 5]) - Math.min(box[i + 2], box[j + 2]);
        return x * y + y * z + z * x;
    }

    /** All but the boxes, which follow from those of the items: see {@link #fill}. */
    @Override
    public void state(StateVisitor s) {
        s.section("tree", this);
        root = s.value("root", root);
        free = s.value("free", free);
        used = s.count("used", used);
        leaves = s.value("leaves", leaves);
        changes = s.value("changes", changes);
        if (used > parent.length) {
            grow(used);
        }
        parent = s.array("parent", parent, 0, used, used, false);
        left = s.array("left", left, 0, used, used, false);
        right = s.array("right", right, 0, used, used, false);
        height = s.array("height", height, 0, used, used, false);
        item = s.array("item", item, 0, used, used, false);
    }

    /**
     * Makes the boxes of all nodes anew after restoring, children first.
     *
     * @param boxes of items, six numbers to each
     * @throws StateException if the nodes are no tree
     */
    void fill(double[] boxes) {
        int node = root;
        int from = NONE;
        for (long way = 0; node != NONE; way++) {
            if (way > 3L * used) {
                throw new StateException(
                        "tree: its " + used + " nodes go round in a circle; the state is damaged");
            }
            int next = parent[node];
            if (left[node] == NONE) {
                System.arraycopy(boxes, 6 * item[node], bounds, 6 * node, 6);
            } else if (from == left[node]) {
                next = right[node];
            } else if (from == right[node]) {
                pull(node);
            } else {
                next = left[node];
            }
            from = node;
            node = next;
        }
    }

    private void grow(int nodes) {
        bounds = Arrays.copyOf(bounds, 6 * nodes);
        parent = Arrays.copyOf(parent, nodes);
        left = Arrays.copyOf(left, nodes);
        right = Arrays.copyOf(right, nodes);
        height = Arrays.copyOf(height, nodes);
        item = Arrays.copyOf(item, nodes);
    }

    int allocate() {
        if (free != NONE) {
            int node = free;
            free = parent[node];
            return node;
        }
        if (used == parent.length) {
            grow(2 * used);
        }
        return used++;
    }

    void release(int node) {
        parent[node] = free;
        height[node] = NONE;
        free = node;
    }

    /**
     * Checks every invariant of the tree. For tests: cost is linear.
     *
     * @throws IllegalStateException naming the node that breaks one
     */
    public void validate() {
        int count = root == NONE ? 0 : validate(root, NONE);
        if (count != leaves) {
            throw new IllegalStateException("tree reaches " + count + " leaves of " + leaves);
        }
    }

    private int validate(int node, int above) {
        if (parent[node] != above) {
            throw new IllegalStateException("node " + node + " has a wrong parent");
        }
        if (left[node] == NONE) {
            if (height[node] != 0 || right[node] != NONE) {
                throw new IllegalStateException("leaf " + node + " looks like an inner node");
            }
            return 1;
        }
        int count = validate(left[node], node) + validate(right[node], node);
        if (pull(node)) {
            throw new IllegalStateException("node " + node + " is not the union of its children");
        }
        return count;
    }
}
