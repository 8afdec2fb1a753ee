package dev.cairn.physics.shape.decomposition;

import dev.cairn.physics.shape.ConvexHull;

import org.jspecify.annotations.Nullable;

/** A convex part to be. */
final class Part {
    /** What it may be cut further by; null if it was merged of several. */
    final @Nullable Piece piece;

    final ConvexHull hull;

    /** All of which it is the hull, three numbers each, m. */
    final double[] points;

    /** How far a point of it is from the solid, m: the largest distance found. */
    final double beyond;

    /** No point of it is farther, m. */
    final double bound;

    Part(@Nullable Piece piece, ConvexHull hull, double[] points, double beyond, double bound) {
        this.piece = piece;
        this.hull = hull;
        this.points = points;
        this.beyond = beyond;
        this.bound = bound;
    }
}
