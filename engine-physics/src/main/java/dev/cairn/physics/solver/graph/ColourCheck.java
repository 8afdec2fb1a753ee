package dev.cairn.physics.solver.graph;

import dev.cairn.physics.solver.row.EdgeList;

import java.util.Arrays;

/** What colours promise, for an assertion: no two edges of one move the same body. */
final class ColourCheck {
    /** By place of a kind: its edge. */
    private int[] edge = {};

    /** By slot: the last colour, counted here, that had an edge of the body. */
    private int[] last = {};

    private int seen;

    /**
     * Whether no colour has two edges of a body.
     *
     * @param doubles the first colour of rows of doubles
     * @param slots how many bodies there may be
     */
    boolean areDisjoint(Colouring colours, EdgeList list, int doubles, int slots) {
        if (last.length < slots) {
            last = new int[slots + slots / 2];
        }
        boolean disjoint = true;
        for (int kind = 0; kind + 1 < list.first.length; kind++) {
            place(list, kind, true);
            for (int c = 0; c < doubles; c++) {
                disjoint &= colours.kind[c] != kind || isDisjoint(colours, list, c);
            }
            place(list, kind, false);
            for (int c = doubles; c < colours.colours; c++) {
                disjoint &= colours.kind[c] != kind || isDisjoint(colours, list, c);
            }
        }
        return disjoint;
    }

    private void place(EdgeList list, int kind, boolean isSingle) {
        for (int m = list.first[kind]; m < list.first[kind + 1]; m++) {
            int at = list.place[m];
            if (list.isSingle[m] == isSingle) {
                if (at >= edge.length) {
                    edge = Arrays.copyOf(edge, Math.max(at + 1, 2 * edge.length));
                }
                edge[at] = m;
            }
        }
    }

    private boolean isDisjoint(Colouring colours, EdgeList list, int c) {
        seen++;
        for (int j = colours.start[c]; j < colours.start[c] + colours.size[c]; j++) {
            int m = edge[j];
            for (int side = 0; side < 2; side++) {
                int slot = side == 0 ? list.slotA[m] : list.slotB[m];
                if (slot >= 0 && last[slot] == seen) {
                    return false;
                }
                if (slot >= 0) {
                    last[slot] = seen;
                }
            }
        }
        return true;
    }
}
