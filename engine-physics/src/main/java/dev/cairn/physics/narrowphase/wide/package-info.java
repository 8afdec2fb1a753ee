/**
 * Many pairs at once, a pair to a lane of the Vector API.
 *
 * <p>A pile spends more of its time colliding than solving, and most of its pairs are boxes. What
 * decides whether and how two boxes touch, the fifteen axes, has no branches, so lanes of pairs pay
 * most there; what follows (clipping, names) branches by pair and stays scalar.
 */
@org.jspecify.annotations.NullMarked
package dev.cairn.physics.narrowphase.wide;
