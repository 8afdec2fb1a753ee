/**
 * Distance and penetration depth of two cores by iteration on their Minkowski difference.
 *
 * <p>Problem: how far apart are two convex sets of which only support points are known, and if they
 * overlap, which shortest move separates them? With D = B - A the first is the distance of D from
 * the origin, the second the distance of the origin from the surface of D.
 *
 * <pre>
 *         D           GJK: a simplex in D          EPA: a polytope in D that holds the
 *      ╱─────╲        walks towards the            origin grows where its surface is
 *     ╱       ╲       origin                       nearest to it
 *     ╲   o───┤ d
 *      ╲─────╱
 * </pre>
 *
 * <p>Invariants: both end with a lower and an upper bound, so a caller knows by how much the answer
 * may be off, also when a cap was met. A search that is warm-started ends at the same features as a
 * cold one; {@link dev.cairn.physics.narrowphase.gjk.NearestFeatures} then computes the distance
 * from those alone, so the last bits do not tell where the search came from.
 *
 * <p>Sources: E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A fast procedure for computing the
 * distance between complex objects in three-dimensional space" (1988); M. Montanari, N. Petrinic,
 * E. Barbieri, "Improving the GJK algorithm for faster and more reliable distance queries between
 * convex objects" (2017); G. van den Bergen, "Proximity queries and penetration depth computation
 * on 3D game objects" (2001).
 */
@NullMarked
package dev.cairn.physics.narrowphase.gjk;

import org.jspecify.annotations.NullMarked;
