/**
 * Which pairs of bodies are near each other.
 *
 * <p>Problem: of n bodies almost none of the n²/2 pairs is near, and from tick to tick almost
 * nothing changes. So each body has a <i>fat box</i>, larger than it needs by a margin relative to
 * its size and along its velocity; a box tree finds what overlaps a box in logarithmic time; and
 * only bodies that left their fat box ask.
 *
 * <pre>
 *   needed box (tight, swept over the tick)     fat box in the tree
 *          ┌──┐                                 ┌────────┐
 *          │  │─▶ v      inside: nothing to do  │ ┌──┐   │
 *          └──┘          outside: moved         │ └──┘   │
 *                                               └────────┘
 *   moved proxies, in blocks ─▶ query dynamic tree, static tree ─▶ one buffer a block ─▶ merge in block order
 * </pre>
 *
 * <p>Invariants: every pair of fat boxes that overlap, not both static, is in the pair set after
 * the pairs phase, exactly once; nothing is dropped at a capacity: a buffer that was too small says
 * how much it lacked, grows between phases, and its block runs again. An idle static body costs
 * nothing. Pairs come in the order of the bodies that asked, those of one body in the order of
 * slots: on the tree's shape nothing hangs. The pair set is asked for membership and never
 * iterated.
 *
 * <p>Sources: the insertion by surface area and the rotations of box trees follow E. Catto,
 * "Dynamic bounding volume hierarchies" (GDC 2019), and D. Goldsmith and J. Salmon, "Automatic
 * creation of object hierarchies for ray tracing" (1987).
 */
@NullMarked
package dev.cairn.physics.broadphase;

import org.jspecify.annotations.NullMarked;
