package dev.cairn.physics.narrowphase.clip;

import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * In which order the sides of a face cut: that of its loop; of a parallelogram by pairs, and first
 * the pair that looks more along x, or else along y. Soft corners make the order matter, and of a
 * box a mirror shares this one.
 */
final class SideOrder {
    private int begin;

    /** How the sides of a parallelogram are ordered; -1 of other faces. */
    private int turn;

    /** Chooses a face by the slot that it begins with. */
    void set(Polyhedron h, int begin, int sides) {
        this.begin = begin;
        turn = -1;
        if (sides == 4 && areOpposite(h, begin) && areOpposite(h, begin + 1)) {
            double x = Math.abs(h.sideX(begin)) - Math.abs(h.sideX(begin + 1));
            double y = Math.abs(h.sideY(begin)) - Math.abs(h.sideY(begin + 1));
            turn = x > 0 || (x == 0 && y > 0) ? 0 : 1;
        }
    }

    private static boolean areOpposite(Polyhedron h, int slot) {
        return h.sideX(slot) == -h.sideX(slot + 2)
                && h.sideY(slot) == -h.sideY(slot + 2)
                && h.sideZ(slot) == -h.sideZ(slot + 2);
    }

    /** The slot of the side that cuts after so many others. */
    int slot(int k) {
        return begin + (turn < 0 ? k : ((k & 1) << 1 | k >> 1) ^ turn);
    }
}
