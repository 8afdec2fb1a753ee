/**
 * What a drawing thread may see of a world: whole ticks, by value.
 *
 * <h2>Problem</h2>
 *
 * <p>The simulation steps at a fixed rate, the screen at another, on another thread. Drawing from
 * live columns would show half a tick; waiting for each other would couple the rates.
 *
 * <h2>Picture</h2>
 *
 * <pre>
 *   simulation thread                             drawing thread
 *   step, publish ---&gt; [writing] [spare] [reading] ---&gt; latest
 *                         one atomic swap each
 *
 *   alpha = time since the tick / length of the tick, in [0, 1]
 *   drawn = previous + alpha * (current - previous)
 * </pre>
 *
 * <h2>Rules</h2>
 *
 * <ul>
 *   <li>A row is an entity with a {@link dev.cairn.core.snapshot.Pose} and a {@link
 *       dev.cairn.core.snapshot.Visual}; rows come in the order of the world's chunks.
 *   <li>Poses are matched by entity, so rows may move between ticks.
 *   <li>What is new, or was teleported ({@code jumps} differs), has previous = current: nothing
 *       smears across the scene.
 *   <li>The reader never waits, never sees a tick in the making, and never an older tick after a
 *       newer one; it may miss some.
 *   <li>Nothing is allocated but when the number of entities grows.
 * </ul>
 *
 * <h2>Sources</h2>
 *
 * <p>Fixed steps with interpolation after G. Fiedler, "Fix your timestep!", 2004; the triple buffer
 * is the lock-free one of graphics drivers, with one atomic index.
 */
@NullMarked
package dev.cairn.core.snapshot;

import org.jspecify.annotations.NullMarked;
