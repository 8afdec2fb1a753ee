/**
 * From a rough separating axis to the exact one.
 *
 * <p>Problem: a disc has no vertices, so GJK and EPA approach its axis for ever and end with noise.
 * But round shapes have features too, only their normals come in families:
 *
 * <pre>
 *   feature     normals               best axis of two features
 *   flat        one                   the normal itself
 *   line        a circle of them      where two circles cross (closed form), or Newton on one
 *   rim, point  a region              Newton on the sphere
 * </pre>
 *
 * <p>{@link dev.cairn.physics.narrowphase.axis.AxisRefinement} tries all features near the rough
 * axis and keeps the axis that separates most; {@link
 * dev.cairn.physics.narrowphase.axis.OptimalityTest} tells whether a better one may be near, and
 * {@link dev.cairn.physics.narrowphase.axis.AxisAscent} goes there.
 *
 * <p>Invariants: each axis is judged by its true separation, a lower bound of the signed distance,
 * so an attempt that fails costs time and nothing else. The order of attempts does not matter. Ties
 * up to rounding go to the flatter features, which tell most about the contact.
 *
 * <p>Source: the separation is concave along the sphere but for the length of n, and is maximised
 * by its supergradients (R. T. Rockafellar, "Convex analysis", 1970).
 */
@NullMarked
package dev.cairn.physics.narrowphase.axis;

import org.jspecify.annotations.NullMarked;
