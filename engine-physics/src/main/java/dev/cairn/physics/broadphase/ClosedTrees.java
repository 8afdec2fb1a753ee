package dev.cairn.physics.broadphase;

/**
 * Makes a part of a tree that holds some leaves and nothing else, and is <em>closed</em>: to
 * insertions and rotations outside it is one leaf, whose box is the union of all of its. So the
 * leaves of a body of many shapes keep the neighbours that they have in the body, and when it moves
 * only boxes change and one leaf.
 *
 * <p>Its root is an inner node whose item is {@code -1 - size}, with the number of its leaves; its
 * form is that of {@link TreeBuilder}.
 *
 * <p>Simulation thread. Allocates only when something grows.
 */
final class ClosedTrees {
    private final AabbTree tree;
    private final TreeBuilder builder;

    ClosedTrees(AabbTree tree) {
        this.tree = tree;
        builder = new TreeBuilder(tree);
    }

    /** Empties the list of leaves that {@link #close} takes. */
    void begin() {
        builder.begin();
    }

    /** Adds a leaf of the tree that is in no closed part. */
    void add(int node) {
        builder.add(node);
    }

    /**
     * Makes a closed part of the leaves that were added, at least two.
     *
     * @return its root, until it is opened
     */
    int close() {
        for (int i = 0; i < builder.count(); i++) {
            tree.unlink(builder.leaf(i));
        }
        int root = builder.build();
        tree.item[root] = AabbTree.NONE - builder.count();
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
        builder.begin();
        gather(root);
        for (int i = 0; i < builder.count(); i++) {
            tree.link(builder.leaf(i));
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
            builder.add(node);
            return;
        }
        tree.release(node);
        gather(a);
        gather(b);
    }
}
