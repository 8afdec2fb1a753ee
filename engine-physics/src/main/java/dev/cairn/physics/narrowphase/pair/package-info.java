/**
 * Two shapes in one frame, and the words in which all chapters speak of them.
 *
 * <p>Problem: every algorithm of the narrow phase asks the same questions of a pair (supports,
 * faces, separation along an axis) and gives the same answers (a manifold, feature ids, a
 * warm-start key). What they share has to be one thing, or contacts of different kinds of pairs
 * would differ where they should not.
 *
 * <pre>
 *          w                r, d
 *   world ◀── frame of A ◀────── frame of B
 *              n: from A to B
 * </pre>
 *
 * <p>Invariants: a {@link dev.cairn.physics.narrowphase.pair.Pair} is in A's frame, whose origin is
 * A's centre of mass; axes are unit vectors from A to B; a separation along any axis is a lower
 * bound of the signed distance, so the largest is the best. {@link
 * dev.cairn.physics.narrowphase.pair.ContactTolerances} are fractions of the smaller inner radius.
 * This package knows nothing of the others.
 *
 * <p>Source: S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree" (1996), for the fifteen axes of two
 * boxes.
 */
@NullMarked
package dev.cairn.physics.narrowphase.pair;

import org.jspecify.annotations.NullMarked;
