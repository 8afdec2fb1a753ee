/**
 * Boxes and convex hulls against each other.
 *
 * <p>Problem: neighbouring axes of two polyhedra separate almost equally well, and a search that
 * starts anew each tick picks now one, now another. The search is also what costs most.
 *
 * <pre>
 *   last tick's features ─▶ certified? ──yes──▶ the same face or edges, clipped anew
 *                               │no
 *                               ▼
 *           fifteen axes, or GJK and EPA ─▶ best face of A, of B, best edges ─▶ hysteresis ─▶ contact
 * </pre>
 *
 * <p>{@link dev.cairn.physics.narrowphase.hull.HullPairs} decides, {@link
 * dev.cairn.physics.narrowphase.hull.HullAxis} searches, and {@link
 * dev.cairn.physics.narrowphase.hull.WarmContact} tries the features of the last tick: they give a
 * lower bound of the signed distance, points of the Minkowski difference give an upper one, and
 * when both are near enough no search is needed. Bounds of an earlier pose hold with the motion
 * since added ({@link dev.cairn.physics.narrowphase.hull.DistanceCertificate}).
 *
 * <p>Invariants: a warm contact is taken only if every decision would fall the same for any signed
 * distance between the bounds. What is remembered at a wrong pose costs time, never correctness.
 *
 * <p>Source: temporal coherence by separating features as in D. Baraff, "Curved surfaces and
 * coherence for non-penetrating rigid body simulation" (1990); the bounds are our own.
 */
@NullMarked
package dev.cairn.physics.narrowphase.hull;

import org.jspecify.annotations.NullMarked;
