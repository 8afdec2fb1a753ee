/**
 * Pairs with a cylinder, a cone, a half-space, or a capsule against a polyhedron.
 *
 * <p>Problem: curved sides touch in points, lines or whole discs, and which of these it is changes
 * with an angle that rounding decides. A contact of a line has to have two points and one of a disc
 * four, or the body would roll or spin where it should stand.
 *
 * <pre>
 *   half-space ─▶ closed form ────────────────────────────────┐
 *   segment and box, segment and hull ─▶ candidates ─▶ axis ──┼─▶ flats and lines that face ─▶ manifold
 *   else ─▶ GJK or EPA, coarse ─▶ refinement ────────▶ axis ──┘   each other, else one point
 * </pre>
 *
 * <p>Invariants: {@link dev.cairn.physics.narrowphase.curved.CurvedAxis} tells the axis and by how
 * much the signed distance may be larger; {@link
 * dev.cairn.physics.narrowphase.curved.CurvedContact} gives points whose depth agrees with it, or
 * else one point that does. Tolerances and hysteresis are those of polyhedra. A rim's points stay
 * where they are while the body spins about its axis.
 *
 * <p>Sources: as for {@code gjk}, {@code axis} and {@code clip}; C. Ericson, "Real-time collision
 * detection" (2005), for segments.
 */
@NullMarked
package dev.cairn.physics.narrowphase.curved;

import org.jspecify.annotations.NullMarked;
