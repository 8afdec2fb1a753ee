/**
 * When two shapes that move and turn meet first.
 *
 * <p>Problem: what is fast or spins passes through what is thin between two looks at it. The first
 * meeting of two convex shapes is looked for along their paths, and none is jumped over.
 *
 * <pre>
 *   Flight (place, velocity, acceleration, spin) ─┐
 *                                                 ├─▶ TimeOfImpact ─▶ time, axis, or never
 *   Flight of the other ─────────────────────────┘
 * </pre>
 *
 * <p>Invariants: a span of time is passed only with a proof that nothing touches in it; numbers are
 * sums, products, quotients and roots, so they have the same bits everywhere; nothing is allocated.
 *
 * <p>Source: B. Mirtich, "Impulse-based dynamic simulation of rigid body systems" (1996), for
 * conservative advancement.
 */
@NullMarked
package dev.cairn.physics.sweep;

import org.jspecify.annotations.NullMarked;
