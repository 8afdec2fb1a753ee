package dev.cairn.physics.solver.row;

import dev.cairn.physics.internal.EdgeSource;

/**
 * A kind of constraint beside contacts: where its edges come from, and its rows in either
 * precision.
 *
 * <p>Kinds are solved in their order, contacts after all others: what must not overlap has the last
 * word. An island with such edges neither starts in static balance nor is it solved directly, and
 * its loads run down over contacts alone.
 *
 * @param source tells the edges of a tick
 * @param floats rows of large islands
 * @param doubles rows of the others
 */
public record ConstraintKind(EdgeSource source, KindRows floats, KindRows doubles) {
    /** The rows of one precision. */
    public KindRows rows(boolean isSingle) {
        return isSingle ? floats : doubles;
    }

    /**
     * The sources of contacts and of some kinds.
     *
     * @param contacts are kind 0
     * @param kinds those beside contacts, in the order in which they are solved
     */
    public static EdgeSource[] sources(EdgeSource contacts, ConstraintKind... kinds) {
        EdgeSource[] sources = new EdgeSource[1 + kinds.length];
        sources[0] = contacts;
        for (int k = 0; k < kinds.length; k++) {
            sources[1 + k] = kinds[k].source;
        }
        return sources;
    }
}
