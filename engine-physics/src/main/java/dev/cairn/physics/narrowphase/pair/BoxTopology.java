package dev.cairn.physics.narrowphase.pair;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/** The features of every box: their numbers do not depend on the extents. */
public final class BoxTopology {

    private static final int[] SLOT_VERTEX = new int[24],
            SLOT_EDGE = new int[24],
            SIDE_AXIS = new int[24],
            EDGE_AT = new int[24];
    private static final boolean[] SIDE_POSITIVE = new boolean[24];

    static {
        Polyhedron box = Polyhedron.of(Box.cubeOfHalfExtent(1));
        for (int s = 0; s < 24; s++) {
            SLOT_VERTEX[s] = box.slotVertex(s);
            SLOT_EDGE[s] = box.slotEdge(s);
            SIDE_AXIS[s] = box.sideX(s) != 0 ? 0 : box.sideY(s) != 0 ? 1 : 2;
            SIDE_POSITIVE[s] = box.sideX(s) + box.sideY(s) + box.sideZ(s) > 0;
        }
        for (int e = 0; e < 12; e++) {
            int from = box.edgeFrom(e);
            int to = box.edgeTo(e);
            int axis = Integer.numberOfTrailingZeros(from ^ to);
            EDGE_AT[3 * from + axis] = e;
            EDGE_AT[3 * to + axis] = e;
        }
    }

    private BoxTopology() {}

    /** The corner at a slot. */
    public static int slotVertex(int slot) {
        return SLOT_VERTEX[slot];
    }

    /** The edge from the corner at a slot to the next corner of the face. */
    public static int slotEdge(int slot) {
        return SLOT_EDGE[slot];
    }

    /** The axis that the side plane at a slot looks along or against, 0 to 2. */
    public static int sideAxis(int slot) {
        return SIDE_AXIS[slot];
    }

    /** Whether the side plane at a slot looks along its axis. */
    public static boolean isSidePositive(int slot) {
        return SIDE_POSITIVE[slot];
    }

    /** The edge from a vertex along an axis, at 3 vertex + axis. */
    public static int edge(int at) {
        return EDGE_AT[at];
    }
}
