package dev.cairn.physics.solver.row;

/** Rows of one kind of constraint and one precision, as far as the colouring places them. */
public interface EdgePlaces {
    /** Rows that a colour is padded to multiples of. */
    int group();

    /**
     * Makes room; allocates only when there were never so many.
     *
     * @param places of rows, padding included
     */
    void ensurePlaces(int places);

    /**
     * The row at a place belongs to an edge.
     *
     * @param source row in the kind's own store
     * @param offsetA of the first body in the solver's state; 0 for one that does not move
     * @param offsetB of the second body
     * @param variant see {@link EdgeList#variant}
     */
    void bind(int place, int source, int offsetA, int offsetB, int variant);

    /** The row at a place binds nothing to nothing: it fills its colour's last group. */
    void pad(int place);
}
