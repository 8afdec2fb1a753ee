/**
 * Balls and capsules, whose cores are points and segments.
 *
 * <p>Problem: these pairs are the cheapest and come in the largest numbers, so each has a closed
 * form: the nearest points of two points or segments, of a point and a box, of a point and a hull.
 *
 * <pre>
 *   (   •━━━━━━━•   )   two segments: nearest inside both, or an end of one and a point of the other;
 *       ┊  d            signed distance = d - rA - rB
 *    (  •  )            nearly parallel and level: both ends of the shared part
 * </pre>
 *
 * <p>Invariants: the answer is that of the general way within rounding. What has no direction
 * (cores that touch) or leaves the range of squares is refused, and the general way takes it. A
 * ball keeps one feature id, so that an impulse survives rolling over an edge.
 *
 * <p>Source: C. Ericson, "Real-time collision detection" (2005), section 5.1.9, with all ends tried
 * where segments are nearly parallel.
 */
@NullMarked
package dev.cairn.physics.narrowphase.round;

import org.jspecify.annotations.NullMarked;
