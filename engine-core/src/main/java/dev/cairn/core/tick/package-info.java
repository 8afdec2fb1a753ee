/**
 * From real time to ticks, and from other threads to the simulation thread.
 *
 * <p><b>Problem.</b> Real time comes in uneven pieces; a simulation that is to give the same bits
 * twice must step by one fixed size. And windows, sockets and tools live on threads of their own,
 * while a world may be touched between two ticks only.
 *
 * <pre>
 *   elapsed   |--------|-----|-------------------|---|------- real time, uneven
 *   steps     |----|----|----|----|----|----|----|----|----|- one size
 *                                                     &lt;-&gt; alpha: where to draw between the last two
 *
 *   any thread --post--> [ inbox ] --drain, in order--> simulation thread, before a step
 * </pre>
 *
 * <p><b>Invariants.</b>
 *
 * <ul>
 *   <li>Every step has the same size; pause and {@linkplain
 *       dev.cairn.core.tick.TickLoop#setTimeScale slow motion} change only how many run per real
 *       second. So the states that a simulation goes through depend on the number of steps and on
 *       what was posted before which step, never on the frame rate.
 *   <li>One {@linkplain dev.cairn.core.tick.TickLoop#advance advance} is bounded: elapsed time is
 *       clamped, time scales are bounded.
 *   <li>A {@linkplain dev.cairn.core.tick.Inbox posted action} runs once, whole, on the simulation
 *       thread, in order of posting, or the poster gets an exception. Nothing is dropped.
 * </ul>
 *
 * <p>The accumulator is that of Fiedler, "Fix your timestep!" (2004); the queue is JCTools'
 * multi-producer single-consumer one.
 */
@NullMarked
package dev.cairn.core.tick;

import org.jspecify.annotations.NullMarked;
