/**
 * Fork-join over blocks: one stage of the step, on all cores, without allocation.
 *
 * <p><b>Problem.</b> A physics step is some hundred stages of a few microseconds each. Waking a
 * thread costs tens of microseconds, a queue of task objects costs garbage, and a result that
 * depends on who ran what costs the promise of the same bits. So stages are not tasks: a
 * {@linkplain dev.cairn.core.job.BlockJob job} is cut into {@linkplain dev.cairn.core.job.Blocks
 * blocks} by counts alone, and {@link dev.cairn.core.job.Jobs} only decides who runs which block.
 *
 * <pre>
 *   simulation thread = worker 0          helpers = workers 1 .. n-1
 *   ----------------------------          ---------------------------------------
 *   beginTick: unpark who is parked  ---> spin on the stage word, then yield
 *   run: write job and blocks (plain)
 *        stage word := (epoch, units) ---> read it (acquire)
 *        claim units from 0 on       &lt;--&gt; claim units from the own share on
 *        wait for the helpers' units &lt;---  run; completed += 1 (release)
 *   endTick: the tick is over        ---> some yields more, then park
 * </pre>
 *
 * <p><b>Claims.</b> Blocks are grouped into at most 32 units per worker. Each unit has a claim slot
 * that holds the stage word under which it was last claimed. A worker that has read stage word
 * {@code w} claims a unit by one compare-and-set from a value {@code v < w}, exactly the one that
 * it saw, to {@code w}. Slots only grow, and the array of slots is made once and never replaced.
 *
 * <p><b>Invariants</b>, each with a jcstress test in the module {@code stress}:
 *
 * <ol>
 *   <li>What the caller wrote before {@code run} is seen by every block; what the blocks wrote is
 *       seen by the caller after it.
 *   <li>Every block runs exactly once, also when blocks fail.
 *   <li>A stage ends only when all its units have been claimed under its word. So a helper that was
 *       delayed across the end finds all slots that its word names at that word or above: its
 *       claims fail, and it never touches the next stage under the old word. Reversed: whoever
 *       claims a unit knows that the stage is still on, so job and blocks may be plain fields.
 *   <li>Progress never depends on a helper: a stage that no helper joins is run by the caller.
 *   <li>No wake-up is lost: a helper raises its parked flag and then looks at the tick, the caller
 *       opens the tick and then looks at the flags, each with a full fence between.
 * </ol>
 *
 * <p>The scheme of one growing sync index with claims by equality is that of bepuphysics2 and of
 * Box3D's solver stages; parked flags that spare the wake-up call are from enkiTS and Rayon.
 */
@NullMarked
package dev.cairn.core.job;

import org.jspecify.annotations.NullMarked;
