package dev.cairn.physics.broadphase;

import java.util.Arrays;

/**
 * Leaves that come in the same tick. A few are put in one by one, each beside its best sibling.
 * Where at least as many come as there are, as in the first tick of a scene, the tree is built anew
 * over all of them by {@link TreeBuilder}; closed parts stay as they are.
 *
 * <p>Simulation thread; allocates only when it grows.
 */
final class BulkInserts {
    /** Fewer are not worth another form of the tree. */
    private static final int FEW = 16;

    private final AabbTree tree;
    private final TreeBuilder builder;
    private int[] leaves = new int[64];
    private int count;

    /** Insertions into a tree. */
    BulkInserts(AabbTree tree) {
        this.tree = tree;
        builder = new TreeBuilder(tree);
    }

    /**
     * A new leaf, see {@link AabbTree#insert}; it is found, moved and removed after {@link #run}.
     */
    int add(double[] box, int offset, int item) {
        if (count == leaves.length) {
            leaves = Arrays.copyOf(leaves, 2 * count);
        }
        int leaf = tree.add(box, offset, item);
        leaves[count++] = leaf;
        return leaf;
    }

    /** Links all of them. */
    void run() {
        if (count >= FEW && 2 * count >= tree.leafCount()) {
            builder.begin();
            if (tree.root != AabbTree.NONE) {
                gather(tree.root);
            }
            for (int i = 0; i < count; i++) {
                builder.add(leaves[i]);
            }
            tree.root = builder.build();
            tree.parent[tree.root] = AabbTree.NONE;
        } else {
            for (int i = 0; i < count; i++) {
                tree.link(leaves[i]);
            }
        }
        count = 0;
    }

    /** Recursion is as deep as the tree, whose height is bounded. */
    private void gather(int node) {
        if (tree.isEnd(node)) {
            builder.add(node);
            return;
        }
        int a = tree.left[node];
        int b = tree.right[node];
        tree.release(node);
        gather(a);
        gather(b);
    }
}
