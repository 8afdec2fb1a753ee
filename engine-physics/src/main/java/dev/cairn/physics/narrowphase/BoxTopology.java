package dev.cairn.physics.narrowphase;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Polyhedron;

/** The features of every box: their numbers do not depend on the extents. */
final class BoxTopology {
    /** By slot: its corner, its edge, and the axis that its side plane looks along or against. */
    static final int[] SLOT_VERTEX = new int[24], SLOT_EDGE = new int[24], SIDE_AXIS = new int[24];

    /** The side plane at a slot looks along {@link #SIDE_AXIS}, or against it. */
    static final boolean[] SIDE_POSITIVE = new boolean[24];

    /** The edge from a vertex along an axis, at 3 vertex + axis. */
    static final int[] EDGE_AT = new int[24];

    static {
        Polyhedron h = Box.cube(1).polyhedron();
        for (int s = 0; s < 24; s++) {
            SLOT_VERTEX[s] = h.slotVertex(s);
            SLOT_EDGE[s] = h.slotEdge(s);
            SIDE_AXIS[s] = h.sideX(s) != 0 ? 0 : h.sideY(s) != 0 ? 1 : 2;
            SIDE_POSITIVE[s] = h.sideX(s) + h.sideY(s) + h.sideZ(s) > 0;
        }
        for (int e = 0; e < 12; e++) {
            int from = h.edgeFrom(e);
            int to = h.edgeTo(e);
            int axis = Integer.numberOfTrailingZeros(from ^ to);
            EDGE_AT[3 * from + axis] = e;
            EDGE_AT[3 * to + axis] = e;
        }
    }

    private BoxTopology() {}
}
