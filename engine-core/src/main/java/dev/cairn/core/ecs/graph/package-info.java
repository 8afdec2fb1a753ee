/**
 * From declarations to the levels of a tick.
 *
 * <h2>Problem</h2>
 *
 * <p>Systems are registered in any order, by people who do not know each other. The order in which
 * they run, and with it every bit of the result, must follow from what they declare, or the
 * schedule must say what is open.
 *
 * <h2>Picture</h2>
 *
 * <pre>
 *   wind   out(Force)            level 0   wind, heat       chunks in parallel
 *   drag   next(Force)     -&gt;    level 1   drag             after wind: Force
 *   heat   out(Warmth)           level 2   physics          runs alone
 *   physics (alone), after drag
 * </pre>
 *
 * <h2>Rules</h2>
 *
 * <ul>
 *   <li>Edges come from {@code next} and from what was asked for by name; nothing else orders.
 *   <li>Two that write one component of the same entities, two that give commands, and two that run
 *       alone, need an order. Where none follows, there is no schedule: names never settle it.
 *   <li>The depth of a system is its longest path; a circle is told system by system.
 * </ul>
 *
 * <p>Internal. It works on {@linkplain dev.cairn.core.ecs.access.Access declarations}, and has
 * never seen a system run.
 */
@NullMarked
package dev.cairn.core.ecs.graph;

import org.jspecify.annotations.NullMarked;
