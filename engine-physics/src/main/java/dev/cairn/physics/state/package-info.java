/**
 * The state of a world as a whole: when the ECS has changed it, and whether two are the same.
 *
 * <p>Problem: a world is equal to another one if the next ticks of both are equal to the bit. That
 * depends on more than poses: impulses that warm-start, what the solver has learnt of loads, what
 * is remembered of rest. All of it lies in columns of the stores.
 *
 * <p>Invariants: a {@link dev.cairn.physics.state.Digest} depends on the state alone, in slot and
 * row order, never on workers, lanes or where arrays have grown to; the {@link
 * dev.cairn.physics.state.BodyIndex} asks chunks for versions, not rows.
 */
@NullMarked
package dev.cairn.physics.state;

import org.jspecify.annotations.NullMarked;
