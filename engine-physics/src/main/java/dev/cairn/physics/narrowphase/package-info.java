/**
 * From two convex shapes and their poses to a contact manifold.
 *
 * <p>Problem: the solver needs a normal, up to four points with exact separations, and a name for
 * each point that stays the same from tick to tick. Iterative algorithms give an axis with noise in
 * it, and noise is what keeps piles awake. So the iterations only choose features, and the numbers
 * come from the features.
 *
 * <pre>
 *   GJK (distance) ─┐
 *                   ├▶ axis ─▶ snap: best face of A, of B, best edge pair ─▶ hysteresis ─▶ clip ─▶ reduce to 4 ─▶ ids
 *   EPA (depth)   ──┘           separations recomputed from true planes
 * </pre>
 *
 * <p>Pairs with a capsule, cylinder or cone take the same two iterations to a rough axis and then
 * {@link dev.cairn.physics.narrowphase.axis.AxisRefinement} to the exact one: round shapes have
 * features too (flats, lines with a circle of normals, rims), only their normals are found by
 * Newton instead of being listed. Half-spaces are a closed form.
 *
 * <p>Invariants: all maths is in double, in the frame of shape A, from the relative offset only, so
 * far from the origin is like at the origin. No length is compared with a constant; every tolerance
 * is a fraction of the pair's size. A {@link dev.cairn.physics.narrowphase.NarrowPhase} owns all
 * scratch of one worker and allocates nothing once it has seen the largest face. The answer is a
 * function of shapes, poses, margin and the warm-start key; the key may choose between answers that
 * are equally right, it never makes a wrong one.
 *
 * <p>Sources: E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A fast procedure for computing the
 * distance between complex objects in three-dimensional space" (1988); M. Montanari, N. Petrinic,
 * E. Barbieri, "Improving the GJK algorithm for faster and more reliable distance queries between
 * convex objects" (2017); G. van den Bergen, "Proximity queries and penetration depth computation
 * on 3D game objects" (2001); S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree" (1996), for the
 * fifteen axes of two boxes; I. E. Sutherland, G. W. Hodgman, "Reentrant polygon clipping" (1974).
 */
@NullMarked
package dev.cairn.physics.narrowphase;

import org.jspecify.annotations.NullMarked;
