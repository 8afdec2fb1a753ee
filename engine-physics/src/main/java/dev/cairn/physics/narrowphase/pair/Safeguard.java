package dev.cairn.physics.narrowphase.pair;

/**
 * What keeps answers true where a textbook search would err, as far as it can be left out to see
 * what it costs. For measuring alone: without one of them answers may be wrong, and are.
 */
public enum Safeguard {
    /** A support point that is known already ends the search. */
    KNOWN_POINTS,
    /** Points that GJK ended with start the polytope only as far as they are independent. */
    INDEPENDENT_START,
    /** A polytope grows only when the horizon is one loop. */
    ONE_LOOP,
    /** A normal of the polytope is formed across the shortest side, whose digits count most. */
    SHORTEST_SIDE,
    /** Axes that rounding cannot tell from the best one are snapped too. */
    OTHER_AXES,
    /** The axis is snapped to features, and the separation along each is computed anew. */
    FEATURES,
    /** The face of the last tick stays while it is nearly the best. */
    CALM_FACE,
    /** A face contact whose points tell another depth is replaced. */
    DEPTH_OF_POINTS,
    /** What the last tick's features tell is taken only when a second bound agrees. */
    SECOND_BOUND
}
