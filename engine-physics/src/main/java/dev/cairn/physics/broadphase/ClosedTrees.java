package dev.cairn.physics.broadphase;

import java.util.Arrays;

/**
 * Makes a part of a tree that holds some leaves and nothing else, and is <em>closed</em>: to
 * insertions and rotations outside it is one leaf, whose box is the union of all of its. So the
 * leaves of a body of many shapes keep the neighbours that they have in the body, and when it moves
 * only boxes change and one leaf.
 *
 * <p>Its root is an inner node whose item is {@code -1 - size}, with the number of its leaves. The
 * form is a balanced one: halves along the longest axis of the leaves' centres, equal ones by their
 * number.
 *
 * <p>Simulation thread. Allocates only when something grows.
 */
final class ClosedTrees {
    private final AabbTree tree;
    private int[] leaf = new int[64];
    private int count;

    ClosedTrees(AabbTree tree) {
        this.tree = tree;
    }

    /** Empties the list of leaves that {@link #close} takes. */
    void begin() {
        count = 0;
    }

    /** Adds a leaf of the tree that is in no closed part. */
    void add(int node) {
        if (count == leaf.length) {
            leaf = Arrays.copyOf(leaf, 2 * count);
        }
        leaf[count++] = node;
    }

    /**
     * Makes a closed part of the leaves that were added, at least two.
     *
     * @return its root, until it is opened
     */
    int close() {
        for (int i = 0; i < count; i++) {
            tree.unlink(leaf[i]);
        }
        int root = build(0, count);
        tree.item[root] = AabbTree.NONE - count;
        tree.link(root);
        tree.changed();
        return root;
    }

    /** How many leaves a closed part has. */
    int size(int root) {
        return AabbTree.NONE - tree.item[root];
    }

    /** The leaves' boxes have changed: those above them follow. */
    void refit(int root) {
        tree.unlink(root);
        pull(root);
        tree.link(root);
        tree.changed();
    }

    /** Its leaves are leaves of the tree as others are. */
    void open(int root) {
        tree.unlink(root);
        count = 0;
        gather(root);
        for (int i = 0; i < count; i++) {
            tree.link(leaf[i]);
        }
        tree.changed();
    }

    /** Recursion is as deep as a balanced tree. */
    private void pull(int node) {
        if (tree.left[node] != AabbTree.NONE) {
            pull(tree.left[node]);
            pull(tree.right[node]);
            tree.pull(node);
        }
    }

    private void gather(int node) {
        int a = tree.left[node];
        int b = tree.right[node];
        if (a == AabbTree.NONE) {
            add(node);
            return;
        }
        tree.release(node);
        gather(a);
        gather(b);
    }

    private int build(int from, int to) {
        if (to - from == 1) {
            return leaf[from];
        }
        int middle = (from + to) >>> 1;
        split(from, to, middle, longest(from, to));
        int a = build(from, middle);
        int b = build(middle, to);
        int node = tree.allocate();
        tree.left[node] = a;
        tree.right[node] = b;
        tree.item[node] = AabbTree.NONE;
        tree.parent[a] = node;
        tree.parent[b] = node;
        tree.pull(node);
        return node;
    }

    private int longest(int from, int to) {
        int best = 0;
        double most = -1;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = from; i < to; i++) {
                double c = centre(leaf[i], axis);
                low = Math.min(low, c);
                high = Math.max(high, c);
            }
            if (high - low > most) {
                most = high - low;
                best = axis;
            }
        }
        return best;
    }

    private double centre(int node, int axis) {
        return tree.bounds[6 * node + axis] + tree.bounds[6 * node + 3 + axis];
    }

    private boolean before(int a, int b, int axis) {
        double x = centre(a, axis);
        double y = centre(b, axis);
        return x < y || (x == y && a < b);
    }

    /** Puts the lowest of the leaves from to to before the middle (C. A. R. Hoare's FIND). */
    private void split(int from, int to, int middle, int axis) {
        int low = from;
        int high = to - 1;
        while (low < high) {
            int pivot = leaf[middle];
            int i = low;
            int j = high;
            while (i <= j) {
                while (before(leaf[i], pivot, axis)) {
                    i++;
                }
                while (before(pivot, leaf[j], axis)) {
                    j--;
                }
                if (i <= j) {
                    int swapped = leaf[i];
                    leaf[i++] = leaf[j];
                    leaf[j--] = swapped;
                }
            }
            if (j < middle) {
                low = i;
            }
            if (middle < i) {
                high = j;
            }
        }
    }
}
