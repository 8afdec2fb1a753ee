package dev.cairn.physics.broadphase;

import java.util.Arrays;

/** The leaves of a tree. */
final class Leaves {
    private Leaves() {}

    /** The items of all leaves whose box overlaps a box. */
    static int[] touching(AabbTree tree, double[] box, int offset) {
        BoxTraversal search = new BoxTraversal();
        search.start(tree, Arrays.copyOfRange(box, offset, offset + 6));
        int[] found = new int[tree.leafCount()];
        int count = 0;
        for (int item = search.next(0); item != AabbTree.NONE; item = search.next(0)) {
            found[count++] = item;
        }
        return Arrays.copyOf(found, count);
    }
}
