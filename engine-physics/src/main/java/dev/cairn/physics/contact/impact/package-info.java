/**
 * Fast bodies meet within a tick: the impact is struck at the time and place of the meeting, and
 * the rest of the tick goes on from there.
 *
 * <p>Problem: a contact has the points and the normal of one moment. A body that turns by a radian
 * in a sub-step, or meets several others in a tick, is struck with wrong levers, and what it meets
 * after the first impact is not in the list of pairs.
 *
 * <pre>
 *   first meetings ─▶ {@link dev.cairn.physics.contact.impact.ImpactQueue}, earliest first
 *                        │
 *                        ▼
 *   {@link dev.cairn.physics.contact.impact.ImpactStage}: pose of that moment ─▶ {@link dev.cairn.physics.contact.impact.Impact}: impulse ─▶ other velocities, start moved
 *                        ▲                                                        │
 *                        └──── meetings of the struck with whatever is ahead ◀────┘
 * </pre>
 *
 * <p>A change of velocity dv at the time t is the same way as a change now and a shift of the start
 * by -t dv, so the solver flies the whole tick, and no time is lost. A body that stays in touch is
 * left to the solver, with the contact of that moment.
 *
 * <p>Invariants: impacts are struck in the order of their times, then of colliders, on one thread;
 * an impact changes no momentum and adds no energy. A tick in which nothing fast meets does not
 * come here.
 *
 * <p>Source: B. Mirtich, "Timewarp rigid body simulation" (SIGGRAPH 2000), for the order of events.
 */
@NullMarked
package dev.cairn.physics.contact.impact;

import org.jspecify.annotations.NullMarked;
