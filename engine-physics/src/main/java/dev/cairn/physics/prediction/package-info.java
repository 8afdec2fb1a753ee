/**
 * What a state of a world tells twice, so that deltas need not.
 *
 * <p>Problem: where ten bodies of a thousand move, a tick changes hundreds of doubles, each in all
 * of its digits. But a body's pose is in its slot and in its entity; its velocity at the start of
 * the tick is the one at the end of the tick before; and the points of a contact of two polyhedra
 * follow from their poses at the start of the tick and from which features touch:
 *
 * <pre>
 *   entity ── is ──▶ slot      pose, velocity
 *   start of the tick ── was ──▶ end of the tick before
 *   poses at the start, features ── give ──▶ normal, points, separations
 * </pre>
 *
 * <p>None of this is used by the step, nor is it a promise: a guess that fails costs room. What is
 * guessed from must be in both states, so all is guessed within one state; and guesses are made
 * with + - * / and sqrt only, so that each machine makes the same.
 */
@NullMarked
package dev.cairn.physics.prediction;

import org.jspecify.annotations.NullMarked;
