package dev.cairn.physics.broadphase;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.internal.ColliderStore;

import java.util.Arrays;

/**
 * Bodies of many shapes have trees of their own within the world's, see {@link ClosedTrees}: of n
 * shapes that move together the world's tree sees one leaf. A body has one from {@link #LEAST}
 * shapes on; below, the world's tree is as good.
 *
 * <p>Simulation thread; {@link #root} also from blocks. Allocates only when something grows.
 */
final class CompoundTrees implements Stateful {
    /** From so many shapes on a body has a tree of its own. */
    static final int LEAST = 32;

    private final ColliderStore colliders;
    private final AabbTree[] trees;
    private final ClosedTrees[] closed;

    /** By collider: one more than the root of the closed tree that it is in, or 0. */
    private int[] rootOf = {};

    /**
     * Without bodies.
     *
     * @param still tree of what never moves
     * @param moving tree of what moves
     */
    CompoundTrees(ColliderStore colliders, AabbTree still, AabbTree moving) {
        this.colliders = colliders;
        trees = new AabbTree[] {still, moving};
        closed = new ClosedTrees[] {new ClosedTrees(still), new ClosedTrees(moving)};
    }

    /** Root of the closed tree that a collider is in, or {@link AabbTree#NONE}. */
    int root(int collider) {
        return collider < rootOf.length ? rootOf[collider] - 1 : AabbTree.NONE;
    }

    /** How many shapes are in the closed tree of a collider that is in one. */
    int size(int collider, boolean moves) {
        return closed[moves ? 1 : 0].size(root(collider));
    }

    /** Another box of a collider in a closed tree; {@link #settle} follows. */
    void setBox(int node, boolean moves, double[] box, int offset) {
        System.arraycopy(box, offset, trees[moves ? 1 : 0].bounds, 6 * node, 6);
    }

    /** A collider leaves its closed tree, and all with it: they are leaves like others. */
    void open(int collider, boolean moves) {
        closed[moves ? 1 : 0].open(root(collider));
        int body = colliders.body[collider];
        rootOf[collider] = 0; // it may have left the body's list
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            forget(c);
        }
    }

    private void forget(int collider) {
        if (collider < rootOf.length) {
            rootOf[collider] = 0;
        }
    }

    /**
     * The boxes of a body's shapes have changed, or their number: its tree follows.
     *
     * @param where by collider: which tree it is in
     * @param leaf by collider: its leaf
     */
    void settle(int body, byte[] where, int[] leaf) {
        byte kind = BroadPhase.OUT;
        int count = 0;
        int known = 0;
        int root = AabbTree.NONE;
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            kind = kind == BroadPhase.OUT && where[c] != BroadPhase.ENDLESS ? where[c] : kind;
            if (kind != BroadPhase.OUT && where[c] == kind) {
                count++;
                root = Math.max(root, root(c));
                known += root(c) >= 0 ? 1 : 0;
            }
        }
        boolean moves = kind == BroadPhase.DYNAMIC;
        if (root >= 0 && known == count) {
            closed[moves ? 1 : 0].refit(root);
        } else if (count >= LEAST) {
            if (root >= 0) {
                closed[moves ? 1 : 0].open(root);
            }
            close(body, kind, moves, where, leaf);
        }
    }

    private void close(int body, byte kind, boolean moves, byte[] where, int[] leaf) {
        ClosedTrees of = closed[moves ? 1 : 0];
        of.begin();
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            if (where[c] == kind) {
                of.add(leaf[c]);
            }
        }
        int root = of.close();
        if (rootOf.length < where.length) {
            rootOf = Arrays.copyOf(rootOf, where.length);
        }
        for (int c = colliders.bodies.collider[body];
                c != ColliderStore.NONE;
                c = colliders.next[c]) {
            rootOf[c] = where[c] == kind ? root + 1 : 0;
        }
    }

    @Override
    public void state(StateVisitor s) {
        s.section("manyShapes", this);
        int length = s.count("length", rootOf.length);
        if (length != rootOf.length) {
            rootOf = Arrays.copyOf(rootOf, length);
        }
        rootOf = s.array("rootOf", rootOf, length);
    }
}
