package dev.cairn.physics.solver.row;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;

import java.util.Arrays;

/**
 * The edges of a tick: which constraint binds which two bodies, contacts first, then the other
 * kinds one after the other; those of a kind in the order of their bodies. And where the row of
 * each edge is: among those of floats or those of doubles.
 *
 * <p>Simulation thread; read by all. Allocates only when a store has grown.
 */
public final class EdgeList implements Stateful {
    /** Rows of contacts. */
    public final ConstraintRows floats;

    public final ConstraintRows doubles;

    /** The kinds beside contacts; kind {@code k} of the edges is the one before. */
    public final ConstraintKind[] kinds;

    /** Edges of all kinds. */
    public int count;

    /** How many of them are contacts: the first ones. */
    public int contacts;

    /** By kind: its first edge; one more for the end of the last. */
    public final int[] first;

    /** By edge: its row in the store of its kind. */
    public int[] source = {};

    /** By edge: slots of its bodies, -1 for one that nothing moves. One of them is moved. */
    public int[] slotA = {};

    public int[] slotB = {};

    /**
     * By edge: slot of its kinematic body that moves, or -1; and where that lies among the bodies
     * of the solver, or 0.
     */
    public int[] carrier = {};

    public int[] side = {};

    /**
     * By edge: which of the kernels of its kind it needs; within a colour those of one variant lie
     * side by side. Of a contact: its points.
     */
    public int[] variant = {};

    /** By edge: the sum of its normal impulses at the end of the last tick, N s; contacts only. */
    public double[] impulse = {};

    /** By edge: the place of its row among those of its kind and precision. */
    public int[] place = {};

    /** Whether the row is one of floats. */
    public boolean[] isSingle = {};

    /** One row to a vector, which suits scalar sweeps and windows. */
    public EdgeList() {
        this(1, 1, 1, 1);
    }

    /**
     * A list whose rows lie in groups.
     *
     * @param floatLanes of the rows of floats, see {@link ConstraintRows#lanes}
     * @param floatGroup see {@link ConstraintRows#group}
     * @param doubleLanes of the rows of doubles
     * @param doubleGroup of the rows of doubles
     * @param kinds beside contacts
     */
    public EdgeList(
            int floatLanes,
            int floatGroup,
            int doubleLanes,
            int doubleGroup,
            ConstraintKind... kinds) {
        floats = new ConstraintRows(floatLanes, floatGroup, true, this);
        doubles = new ConstraintRows(doubleLanes, doubleGroup, false, this);
        this.kinds = kinds;
        first = new int[kinds.length + 2];
    }

    /** The rows among which that of contact {@code m} is. */
    public ConstraintRows rows(int m) {
        return isSingle[m] ? floats : doubles;
    }

    /** The rows of a kind, of one precision. */
    public EdgePlaces places(int kind, boolean isSingle) {
        return kind == 0 ? isSingle ? floats : doubles : kinds[kind - 1].rows(isSingle);
    }

    /** The edges of the last tick; where the rows lie is found anew. */
    @Override
    public void state(StateVisitor s) {
        s.section("edges", this);
        s.rows(count);
        count = s.count("count", count);
        contacts = s.value("contacts", contacts);
        s.array("first", first, first.length);
        ensureCapacity(count);
        source = s.array("source", source, 0, count, source.length, false);
        slotA = s.array("slotA", slotA, 0, count, source.length, false);
        slotB = s.array("slotB", slotB, 0, count, source.length, false);
        carrier = s.array("carrier", carrier, 0, count, source.length, false);
    }

    /** Slot of a body of an edge that moves. */
    public int mover(int m) {
        return slotA[m] >= 0 ? slotA[m] : slotB[m];
    }

    /** Whether both bodies of an edge move. */
    public boolean isBetweenMovers(int m) {
        return (slotA[m] | slotB[m]) >= 0;
    }

    public void ensureCapacity(int edges) {
        if (edges > source.length) {
            int n = Math.max(edges, Math.max(64, source.length + (source.length >> 1)));
            source = Arrays.copyOf(source, n);
            slotA = Arrays.copyOf(slotA, n);
            slotB = Arrays.copyOf(slotB, n);
            carrier = Arrays.copyOf(carrier, n);
            side = Arrays.copyOf(side, n);
            variant = Arrays.copyOf(variant, n);
            impulse = Arrays.copyOf(impulse, n);
            place = Arrays.copyOf(place, n);
            isSingle = Arrays.copyOf(isSingle, n);
        }
    }
}
