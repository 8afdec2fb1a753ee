package dev.cairn.physics.broadphase;

import java.util.Arrays;

/**
 * Builds parts of a tree from the top: leaves are cut in two along the longest axis of their
 * centres, where the areas of the two boxes, times the leaves in them, are least in sum. Cuts are
 * tried between sixteen bins of equal width; each side gets a quarter of the leaves at least, so
 * the height stays logarithmic. Where no cut does, halves are made, equal centres by their number.
 *
 * <p>Simulation thread. Allocates only when it grows. Source: I. Wald, "On fast construction of
 * SAH-based bounding volume hierarchies" (2007).
 */
final class TreeBuilder {
    private static final int BINS = 16;

    /** So few leaves are halved: no cut would gain anything. */
    private static final int FEW = 4;

    /** The share of the leaves that each side gets at least is one over this. */
    private static final int UNEVEN = 4;

    private final AabbTree tree;
    private int[] leaf = new int[64];
    private int count;

    /** Twice the least and the greatest centre by axis. */
    private final double[] low = new double[3];

    private final double[] high = new double[3];

    /** Bins to a unit of twice the centre; infinite where all centres are equal: bin 0 then. */
    private double perWidth;

    /** Of each bin: its leaves, and their box; what all bins from it on cost. */
    private final int[] inBin = new int[BINS];

    private final double[] box = new double[6 * BINS];
    private final double[] beyond = new double[BINS];
    private final double[] sum = new double[6];

    TreeBuilder(AabbTree tree) {
        this.tree = tree;
    }

    /** Empties the list of leaves. */
    void begin() {
        count = 0;
    }

    /** Adds a leaf, or a closed part, that is not linked when it is built upon. */
    void add(int node) {
        if (count == leaf.length) {
            leaf = Arrays.copyOf(leaf, 2 * count);
        }
        leaf[count++] = node;
    }

    /** How many were added. */
    int count() {
        return count;
    }

    /** One of those that were added. */
    int leaf(int i) {
        return leaf[i];
    }

    /**
     * Builds over what was added, at least one.
     *
     * @return the root, which is not linked
     */
    int build() {
        return build(0, count);
    }

    private int build(int from, int to) {
        if (to - from == 1) {
            return leaf[from];
        }
        int axis = longest(from, to);
        int middle = to - from > FEW ? cut(from, to, axis) : from;
        if (middle == from) {
            middle = (from + to) >>> 1;
            split(from, to, middle, axis);
        }
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
        Arrays.fill(low, Double.POSITIVE_INFINITY);
        Arrays.fill(high, Double.NEGATIVE_INFINITY);
        for (int i = from; i < to; i++) {
            for (int axis = 0; axis < 3; axis++) {
                double c = centre(leaf[i], axis);
                low[axis] = Math.min(low[axis], c);
                high[axis] = Math.max(high[axis], c);
            }
        }
        double x = high[0] - low[0];
        double y = high[1] - low[1];
        double z = high[2] - low[2];
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }

    /**
     * Puts the leaves before the best cut to the front.
     *
     * @return the first of the others, or {@code from} if no cut leaves enough on both sides
     */
    private int cut(int from, int to, int axis) {
        perWidth = BINS / (high[axis] - low[axis]);
        Arrays.fill(inBin, 0);
        for (int bin = 0; bin < BINS; bin++) {
            empty(box, 6 * bin);
        }
        for (int i = from; i < to; i++) {
            int bin = bin(leaf[i], axis);
            inBin[bin]++;
            unite(box, 6 * bin, tree.bounds, 6 * leaf[i]);
        }
        int best = bestCut(to - from);
        int front = from;
        int back = to;
        while (best > 0 && front < back) {
            if (bin(leaf[front], axis) < best) {
                front++;
            } else {
                swap(front, --back);
            }
        }
        return front;
    }

    /** The bin before which the cut is cheapest, or 0. */
    private int bestCut(int n) {
        empty(sum, 0);
        int leaves = 0;
        for (int bin = BINS - 1; bin > 0; bin--) {
            unite(sum, 0, box, 6 * bin);
            leaves += inBin[bin];
            beyond[bin] = leaves > 0 ? leaves * area(sum) : 0;
        }
        empty(sum, 0);
        leaves = 0;
        int best = 0;
        double bestCost = Double.POSITIVE_INFINITY;
        for (int bin = 1; bin < BINS; bin++) {
            unite(sum, 0, box, 6 * (bin - 1));
            leaves += inBin[bin - 1];
            boolean isEven = UNEVEN * leaves >= n && UNEVEN * (n - leaves) >= n;
            double cost = isEven ? leaves * area(sum) + beyond[bin] : Double.POSITIVE_INFINITY;
            if (cost < bestCost) {
                best = bin;
                bestCost = cost;
            }
        }
        return best;
    }

    private int bin(int node, int axis) {
        return Math.min(BINS - 1, (int) (perWidth * (centre(node, axis) - low[axis])));
    }

    private static void empty(double[] a, int at) {
        Arrays.fill(a, at, at + 3, Double.POSITIVE_INFINITY);
        Arrays.fill(a, at + 3, at + 6, Double.NEGATIVE_INFINITY);
    }

    private static void unite(double[] a, int at, double[] b, int of) {
        for (int k = 0; k < 3; k++) {
            a[at + k] = Math.min(a[at + k], b[of + k]);
            a[at + 3 + k] = Math.max(a[at + 3 + k], b[of + 3 + k]);
        }
    }

    private static double area(double[] a) {
        double x = a[3] - a[0];
        double y = a[4] - a[1];
        double z = a[5] - a[2];
        return x * y + y * z + z * x;
    }

    private double centre(int node, int axis) {
        return tree.bounds[6 * node + axis] + tree.bounds[6 * node + 3 + axis];
    }

    private boolean before(int a, int b, int axis) {
        double x = centre(a, axis);
        double y = centre(b, axis);
        return x < y || (x == y && a < b);
    }

    private void swap(int i, int j) {
        int swapped = leaf[i];
        leaf[i] = leaf[j];
        leaf[j] = swapped;
    }

    /** Puts the lowest of the leaves from to to before the middle (C. A. R. Hoare's FIND). */
    private void split(int from, int to, int middle, int axis) {
        int first = from;
        int last = to - 1;
        while (first < last) {
            int pivot = leaf[middle];
            int i = first;
            int j = last;
            while (i <= j) {
                while (before(leaf[i], pivot, axis)) {
                    i++;
                }
                while (before(pivot, leaf[j], axis)) {
                    j--;
                }
                if (i <= j) {
                    swap(i++, j--);
                }
            }
            if (j < middle) {
                first = i;
            }
            if (middle < i) {
                last = j;
            }
        }
    }
}
