/**
 * Islands and sleep: who hangs together, who has come to rest, who is woken.
 *
 * <p>Problem: most bodies of most scenes lie still most of the time. They should cost nothing, and
 * nobody should be able to tell from what happens next that they had been left out.
 *
 * <pre>
 *   solve ─▶ RestDetector: is each at rest?     ─▶ Islands: who touches whom ─▶ all of an island at rest:
 *            speed, and what is left to travel     union-find, every 4th tick     Sleepers.sleep
 *   points ─▶ WakeStage: a point between an awake body and one asleep ─▶ Sleepers.wake, whole island,
 *             its rows collide in the same tick, before the solve; again until nothing more wakes
 * </pre>
 *
 * <p>At rest has no absolute length or speed in it. With inner radius {@code r}, gravity {@code g},
 * and half of the time of quiet as the window: a body is quiet while no point of it is faster than
 * {@code 0.0015 sqrt(g r)} and the user does not push it. Let {@code D1} and {@code D2} be what its
 * surface moved in two windows in a row. It is at rest if its motion fades and what is left of it,
 * were it to fade on as {@code D2/D1}, is small: {@code D2 D2/(D1 - D2) <= 0.002 r}; or if {@code
 * D2 <= 5e-6 r}. So a body that moves steadily, however slowly, is not stopped, and one that creeps
 * to rest is stopped only where that does not matter. A body without contacts, or without gravity,
 * sleeps only if it does not move at all.
 *
 * <p>Invariants: an island sleeps and wakes as a whole. A body asleep has the kind {@code ASLEEP},
 * velocity 0, and its rows keep points, impulses and place, but are not active unless the other
 * body is awake. No row with points has a body awake and a body asleep when the solver starts. The
 * smallest slot names the island: nothing depends on workers.
 *
 * <p>Sources: sleep by islands and half a second, Box2D and Box3D (Erin Catto); criterion: own.
 */
@NullMarked
package dev.cairn.physics.island;

import org.jspecify.annotations.NullMarked;
