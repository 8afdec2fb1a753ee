/**
 * Islands and sleep: which bodies hang together, which have come to rest, which are woken.
 *
 * <p>Problem: most bodies of most scenes lie still most of the time. They should cost nothing, and
 * nobody should be able to tell from what happens next that they had been left out.
 *
 * <pre>
 *   solve ─▶ RestDetector: is each at rest?     ─▶ Islands: what touches what ─▶ all of an island at rest:
 *            speed, and what is left to travel     union-find, every 4th tick     SleepingBodies.sleep
 *   points ─▶ WakeStage: a new point between an awake body and one asleep ─▶ SleepingBodies.wake, whole island,
 *             its rows collide in the same tick, before the solve; again until nothing more wakes
 * </pre>
 *
 * <p>At rest has no absolute length or speed in it. With inner radius {@code r}, gravity {@code g},
 * and half of the time of quiet as the window: a body is quiet while no point of it is faster than
 * {@code 0.0015 sqrt(g r)} and the user does not push it. Let {@code D1} and {@code D2} be what its
 * surface moved in two windows in a row. It is at rest if its motion fades and what is left of it,
 * were it to fade on as {@code D2/D1}, is small: {@code D2 D2/(D1 - D2) <= 0.002 r}; or if {@code
 * D2 <= 5e-6 r}. What is thin rises from the sag of its contacts, some 70 micrometres at 1/240 s,
 * for seconds; so the bound is at least that sag, but at most {@code 0.01 r}. So a body by itself
 * that moves steadily, however slowly, is not stopped, and one that creeps to rest is stopped only
 * where that does not matter. A body without contacts, or without gravity, sleeps only if it does
 * not move at all.
 *
 * <p>A heap never meets that: hundreds of bodies creep by micrometres, a few rock on two points or
 * roll in a trough for minutes, since nothing in a contact dissipates that. So among others, in an
 * island of two bodies or more, a body that has stayed within {@code min(0.01 r, 0.001 sqrt(g r)
 * T)} of one place for {@code T}, four times the time of quiet, is still. A heap sleeps when all in
 * it are at rest or still, but for one or one in sixteen. Of these, too, sleeps who has stayed
 * about his place for the time of quiet; the others are movers, which stay awake, and those asleep
 * are to them as if fixed.
 *
 * <p>{@link Leaning}: a sleeper remembers the force {@code F0} of each mover that leans on it, and
 * of a mover is remembered where it was and {@code R0}, the force of all that bears it and does not
 * move. The sleeper, of inner radius {@code r}, bears {@code B} along a contact's normal: its
 * weight, or from the side what friction makes of it. It wakes, with its ring, when
 *
 * <pre>
 *   L G + (F0 + G) d/r > max(B, F0)/2,    G = min(max(0, F - F0), |R - R0|)
 * </pre>
 *
 * <p>where {@code d} is how far the mover has gone, and {@code L >= 1} the contact's lever over
 * {@code r}; when a contact opens that bore more than this; and when another of its bodies is
 * touched with a momentum {@code L m v} above half of what {@code B} gives it in a tick, or is
 * overlapped by more than what shows. Why both {@code F} and {@code R}: beside what cannot give way
 * the springs of contacts are stiffer, so what jams between two sleepers is squeezed twice as hard
 * within two ticks, and bears no more than before.
 *
 * <p>Invariants: a ring of sleepers sleeps and wakes as a whole. A body asleep has the kind {@code
 * ASLEEP}, velocity 0, and its rows keep points, impulses and place, but are not active unless the
 * other body is awake. When the solver starts, a row with points between a body awake and a body
 * asleep is one of a mover. The smallest slot names the ring: nothing depends on workers.
 *
 * <p>Sources: sleep by islands and half a second, Box2D and Box3D (Erin Catto); criterion: own.
 */
@NullMarked
package dev.cairn.physics.island;

import org.jspecify.annotations.NullMarked;
