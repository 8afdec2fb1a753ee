package dev.cairn.physics.broadphase;

import java.util.Arrays;

/**
 * Visits the leaves of a tree nearest first: depth first, the child that is entered earlier before
 * the other. What "earlier" means is up to the subclass; nothing is visited that is entered after
 * the caller's limit, which may shrink on the way.
 *
 * <p>One thread; the tree must not change meanwhile. Allocates only while the stack grows.
 */
public abstract sealed class TreeTraversal permits BoxTraversal, RayTraversal {
    private int[] nodes = new int[64];
    private double[] entries = new double[64];
    private int top;
    private AabbTree tree = new AabbTree();

    /** Over an empty tree. */
    TreeTraversal() {}

    /**
     * When a box is entered.
     *
     * @param bounds array that holds the box
     * @param at where it begins in it
     * @return at least 0, or infinity if never; no larger for a box that holds another
     */
    abstract double entry(double[] bounds, int at);

    /** Begins at the root. */
    final void begin(AabbTree over) {
        tree = over;
        top = 0;
        if (over.root != AabbTree.NONE) {
            push(over.root, entry(over.bounds, 6 * over.root));
        }
    }

    /**
     * Goes on to the next leaf.
     *
     * @param limit leaves that are entered after it are left out
     * @return the leaf's item, or {@link AabbTree#NONE} at the end
     */
    public final int next(double limit) {
        while (top > 0) {
            int node = nodes[--top];
            if (!(entries[top] <= limit)) {
                continue;
            }
            int a = tree.left[node];
            if (a == AabbTree.NONE) {
                return tree.item[node];
            }
            int b = tree.right[node];
            double enterA = entry(tree.bounds, 6 * a);
            double enterB = entry(tree.bounds, 6 * b);
            if (enterA <= enterB) {
                push(b, enterB);
                push(a, enterA);
            } else {
                push(a, enterA);
                push(b, enterB);
            }
        }
        return AabbTree.NONE;
    }

    private void push(int node, double entry) {
        if (entry == Double.POSITIVE_INFINITY) {
            return;
        }
        if (top == nodes.length) {
            nodes = Arrays.copyOf(nodes, 2 * top);
            entries = Arrays.copyOf(entries, 2 * top);
        }
        nodes[top] = node;
        entries[top++] = entry;
    }
}
