/**
 * Questions about shapes at given poses: rays, moving shapes, distances and overlaps.
 *
 * <p>Problem: games, sensors and tools ask what a ray meets or how far things are, with the same
 * answers as the contacts have, and without allocation.
 *
 * <pre>
 *   signed distance s along n ─▶ s &lt;= 0 ? hit : advance by s / (v . n) ─▶ again
 * </pre>
 *
 * <p>All questions are answered by the signed distance of {@code NarrowPhase} in double. A ray is a
 * point that moves, and what moves is advanced until the separating plane of the present place is
 * reached: it never jumps over anything, ends exactly on flat faces and converges quadratically on
 * round ones.
 *
 * <p>Invariants: one {@link dev.cairn.physics.query.ShapeQueries} per thread; results are objects
 * of the caller that are filled again and again; nothing is allocated. Numbers that are not finite
 * are refused by name.
 *
 * <p>Sources: B. Mirtich, "Impulse-based dynamic simulation of rigid body systems" (1996), for
 * conservative advancement; G. van den Bergen, "Ray casting against general convex objects with
 * application to continuous collision detection" (2004), for the jump to the separating plane.
 */
@NullMarked
package dev.cairn.physics.query;

import org.jspecify.annotations.NullMarked;
