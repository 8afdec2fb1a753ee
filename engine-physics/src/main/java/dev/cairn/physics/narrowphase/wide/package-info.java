/**
 * Many pairs at once, a pair to a lane of the Vector API.
 *
 * <p>Problem: a pile spends more of its time colliding than solving, and most of its pairs are
 * boxes, balls or capsules. What decides these has no branches, so lanes of pairs pay most there;
 * what follows (other polygons, ids) branches by pair and stays scalar.
 *
 * <pre>
 *   column   ┌ pair 0 ┬ pair 1 ┬ ... ┬ pair 31 ┐
 *   HALF_A   │  hx    │  hx    │     │  hx     │   one array, entry i of column c at c + i
 *   HALF_B   │  ...   └────────┴──── one vector ┘
 * </pre>
 *
 * <p>Invariants: a kernel and its scalar twin form each number by the same operations in the same
 * order, so the number of lanes does not show in the result. Vectors have one size in a process.
 * Kernels are used once they are compiled; until then their vectors would be objects on the heap.
 *
 * <p>Source: structure-of-arrays batches as in the contact solver of Box2D 3 (E. Catto).
 */
@NullMarked
package dev.cairn.physics.narrowphase.wide;

import org.jspecify.annotations.NullMarked;
