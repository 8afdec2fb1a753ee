/**
 * From two convex shapes and their poses to a contact manifold.
 *
 * <p>Problem: the solver needs a normal, up to four points with exact separations, and an id for
 * each point that stays the same from tick to tick. Iterative algorithms give an axis with noise in
 * it, and noise is what keeps piles awake. So the iterations only choose features, and the numbers
 * come from the features.
 *
 * <pre>
 *   GJK (distance) ─┐
 *                   ├▶ axis ─▶ features ─▶ hysteresis ─▶ clip ─▶ reduce to 4 ─▶ feature ids
 *   EPA (depth)   ──┘          separations recomputed from true planes
 * </pre>
 *
 * <p>{@link dev.cairn.physics.narrowphase.NarrowPhase} is the entry for one pair. The chapters,
 * each of which knows only earlier ones:
 *
 * <ol>
 *   <li>{@code pair}: the two shapes in one frame, separating axes, manifold, ids, tolerances;
 *   <li>{@code gjk}: distance, penetration depth and witness points by iteration;
 *   <li>{@code axis}: the exact axis near a rough one, for round shapes;
 *   <li>{@code clip}: faces clipped against each other, and the choice of four points;
 *   <li>{@code hull}, {@code round}, {@code curved}: polyhedra; balls and capsules; all other
 *       pairs;
 *   <li>{@code wide}: kernels with a pair to a lane, and {@code box}: batches of boxes.
 * </ol>
 *
 * <p>Invariants: all maths is in double, in the frame of shape A, from the relative offset only, so
 * far from the origin is like at the origin. No length is compared with a constant; every tolerance
 * is a fraction of the pair's size. All scratch belongs to one worker, and nothing is allocated
 * once the largest face was seen. The answer is a function of shapes, poses, margin and the
 * warm-start key; the key may choose between answers that are equally right, it never makes a wrong
 * one.
 */
@NullMarked
package dev.cairn.physics.narrowphase;

import org.jspecify.annotations.NullMarked;
