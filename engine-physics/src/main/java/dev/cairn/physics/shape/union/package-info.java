/**
 * What several convex shapes make together, where that is convex too: the way back from a cut.
 *
 * <p>Problem: users make bodies of boxes, and hulls come from tools that cut. Where pieces continue
 * each other, the faces between them are no surface: the body is the one shape.
 *
 * <pre>
 *   boxes of one set of axes ─▶ all that fill the box around them, or twos that continue each other ({@code BoxUnion})
 *   hulls, with what is left ─▶ all whose hull has their volume, or twos that share a face          ({@code HullUnion})
 * </pre>
 *
 * <p>Invariants: a union is convex; its pieces are in none other; a box is told as a box, with axes
 * turned as little as possible. The same pieces in the same order make the same bits.
 */
@NullMarked
package dev.cairn.physics.shape.union;

import org.jspecify.annotations.NullMarked;
